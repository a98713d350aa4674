// Integers of a statement that stand under a name, and the premises of lemmas on r(r+1)/2 and r^2.
#pragma once

#include <functional>

#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"

namespace mmverify::proofs::attribute::induction {

using proofs::induction::Answer;
using proofs::induction::apply;
using proofs::induction::boolean;
using proofs::induction::both;
using proofs::induction::choose;
using proofs::induction::equal;
using proofs::induction::integer;
using proofs::induction::no;
using proofs::induction::Script;
using proofs::induction::Statement;
using proofs::induction::Term;

/// An unbounded integer.  triangular(r) is (T r) and square(r) is (S r), functions of which a statement knows its
/// premises only.  So everything but products by N stays linear.
class Counted {
 public:
  Counted(long long k) : term(proofs::induction::whole_number(k)) {}
  explicit Counted(Term t) : term(std::move(t)) {}
  Term term;

  friend Counted operator+(const Counted& a, const Counted& b) { return make("+", a, b); }
  friend Counted operator-(const Counted& a, const Counted& b) { return make("-", a, b); }
  friend Counted operator*(const Counted& a, const Counted& b) { return make("*", a, b); }
  /// SMT-LIB's div and mod by a positive number round down.
  friend Counted operator/(const Counted& a, const Counted& b) { return make("div", a, b); }
  friend Counted operator%(const Counted& a, const Counted& b) { return make("mod", a, b); }
  friend bool operator<(const Counted& a, const Counted& b) {
    return proofs::induction::decided(truth("<", a, b));
  }
  friend bool operator>(const Counted& a, const Counted& b) { return b < a; }
  friend bool operator==(const Counted& a, const Counted& b) {
    return proofs::induction::decided(truth("=", a, b));
  }
  friend Counted triangular(const Counted& r) {
    return Counted(proofs::induction::apply("T", {r.term}, integer));
  }
  friend Counted square(const Counted& r) {
    return Counted(proofs::induction::apply("S", {r.term}, integer));
  }

  static Term truth(const char* head, const Counted& a, const Counted& b) {
    return apply(head, {a.term, b.term}, boolean);
  }

 private:
  static Counted make(const char* head, const Counted& a, const Counted& b) {
    return Counted(apply(head, {a.term, b.term}, integer));
  }
};

inline Term less(const Counted& a, const Counted& b) { return Counted::truth("<", a, b); }
inline Term at_most(const Counted& a, const Counted& b) { return Counted::truth("<=", a, b); }
inline Term same(const Counted& a, const Counted& b) { return Counted::truth("=", a, b); }
inline Term within(const Counted& low, const Counted& x, const Counted& beyond) {
  return proofs::induction::both({at_most(low, x), less(x, beyond)});
}
inline Term implies(const Term& a, const Term& b) { return apply("=>", {a, b}, boolean); }
inline Term truth(bool b) { return {b ? "true" : "false", boolean}; }

inline Counted whole(Script& script, const std::string& name) {
  return Counted(script.declare(name, integer));
}
inline Counted named(Script& script, const std::string& name, const Counted& formula) {
  return Counted(script.define(name, formula.term));
}

/// Defines a name as the result of a program, over every path that its branches can take.
template <class Program, class Project>
Counted outcome(Script& script, const std::string& name, Program program, Project project) {
  const auto paths = proofs::induction::every_path(program);
  return Counted(script.define(
      name, proofs::induction::as_formula(paths, [&](const auto& found) { return project(found).term; })));
}

/// The claims of a lemma, under the premises that it has written into a script.
struct Lemma {
  std::vector<Term> claims;
  Term occasion;  ///< the premise of a witness: a case that is no border case
};

/// Adds two statements: no case denies the claims; some case fulfils the premises.
void add(std::vector<Statement>& all, const std::string& name, const std::string& says,
         const std::function<Lemma(Script&)>& write);

// ---- T(r) = r(r+1)/2: the facts that triangular_step and triangular_ordered prove, as premises on single numbers

/// Declares T, T(0) = 0.
void suppose_triangular(Script& script);
/// T(r+1) = T(r) + r + 1.
void suppose_step(Script& script, const Counted& r);
/// 2 T(r) = r(r+1), for r >= 0.
void suppose_twice(Script& script, const Counted& r);
/// 0 <= r < q: T(q) >= T(r) + r + 1, which is T(r+1).
void suppose_ordered(Script& script, const Counted& r, const Counted& q);

// ---- S(r) = r^2: square_step, square_ordered

/// Declares S, S(0) = 0.
void suppose_square(Script& script);
/// S(r+1) = S(r) + 2r + 1.
void suppose_square_step(Script& script, const Counted& r);
/// S(r) = r r.
void suppose_square_product(Script& script, const Counted& r);
/// 0 <= r < q: S(q) >= S(r) + 2r + 1, which is S(r+1).
void suppose_square_ordered(Script& script, const Counted& r, const Counted& q);

}  // namespace mmverify::proofs::attribute::induction
