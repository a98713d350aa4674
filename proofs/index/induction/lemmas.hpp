// The lemmas of index.all_levels, each written by running the specification's own templates on names.
// No level occurs in them: M = 2^n and m = M/2 are variables.
#pragma once

#include "proofs/index/induction/formula.hpp"
#include "proofs/index/induction/relation.hpp"
#include "proofs/induction/symbolic.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Answer;
using proofs::induction::Statement;

/// Coordinates of the current triangle, times M: the unit of the side is M itself.
struct UnitSide {
  static Term times(std::uint32_t k) {
    using namespace proofs::induction;
    const Term M = to_real(Term("M", integer));
    if (k == 1) return M;
    return k == 0 ? to_real(whole_number(0)) : apply("*", {to_real(whole_number(k)), M}, real);
  }
};
using OnTriangle = proofs::induction::Real<UnitSide>;
using OnGrid = proofs::induction::Real<proofs::induction::UnitOne>;

inline Term truth(bool b) { return {b ? "true" : "false", proofs::induction::boolean}; }

/// The lemma that on [0,1] the clamp changes nothing.
Statement clamp_lemma();
/// The induction's base: at M = 1, no bit is left.
Statement base_lemma();
/// Statements that some case fulfils the hypotheses: of the opening, of the transition from each place, of the base
/// in each.
std::vector<Statement> witnesses();

/// The lemma that at places from n up, at which `low`, iu and iv have no bit, the formula gives no bit.
template <class Formula>
Statement beyond_lemma() {
  using namespace proofs::induction;
  Script script("beyond", Answer::unsat,
                "At the places above the highest of a level, where iu and iv (below M) and the mask have no "
                "bit, whatever iw has there: spec::index::curve_bits gives 0 and 0, and t is 0. So the index "
                "has no digit there, and the prefix XOR begins with nothing.");
  const Bit bw(script.declare("bw", boolean)), none(truth(false));
  Term t = truth(true);
  const auto bits = Formula::bits(Quantised<Bit>{none, none, bw}, none, [&](const Bit& of) {
    t = of.term;
    return none ^ of;
  });
  const Term b0 = script.define("b0", bits.b0.term), b1 = script.define("b1", bits.b1.term);
  return script.denying({no(b0), no(b1), no(t)});
}

/// The lemma that the beginnings of both algorithms are related, at every M >= 1.
template <class Formula>
Statement opening_lemma() {
  using namespace proofs::induction;
  Script script("opening", Answer::unsat,
                "At level n, M = 2^n, for every point of the closed triangle: the state that the recursion "
                "opens with and the words that the reference quantises to are related, nothing flipped, no "
                "bit done, no digit yet.\niw is negative, and its low n bits are those of iw + M, which is "
                "in [0, M). Holds for every M >= 1, powers of two or not.");
  define_relation(script);
  script.comment("The point, times M.");
  const Term M = script.declare("M", integer), u = script.declare("u", real), v = script.declare("v", real);
  script.require(apply("<=", {whole_number(1), M}, boolean));
  script.require(apply("<=", {Term("0.0", real), u}, boolean));
  script.require(apply("<=", {Term("0.0", real), v}, boolean));
  script.require(apply("<=", {apply("+", {u, v}, real), to_real(M)}, boolean));
  script.comment("The reference: spec::index::quantise_scaled.");
  const auto squares =
      every_path([&] { return Formula::template quantise<Integer>(OnGrid(u), OnGrid(v), Integer(M)); });
  using Square = Quantised<Integer>;
  const Term iu = script.define("iu", as_formula(squares, [](const Square& q) { return q.iu.term; }));
  const Term iv = script.define("iv", as_formula(squares, [](const Square& q) { return q.iv.term; }));
  const Term iw = script.define("iw", as_formula(squares, [](const Square& q) { return q.iw.term; }));
  script.comment("The recursion: spec::index::first_step.");
  const auto first = spec::index::first_step<OnTriangle, Integer>({OnTriangle(u), OnTriangle(v)});
  const Term w = script.define("w", first.w.term), index = script.define("index", first.index.term);
  script.comment("Denied: they are related.");
  const State state{first.u.term,          first.v.term, w,  truth(first.mid_flip),
                    truth(first.top_flip), iu,           iv, apply("+", {iw, M}, integer),
                    truth(false)};
  return script.denying({related(M, state), equal(index, whole_number(0))});
}

/// One digit of the reference on the highest bits of a state's words, and what is left of them.
struct ReferenceStep {
  Term digit, iu, iv, iw, above;
};
template <class Formula>
ReferenceStep reference_step(proofs::induction::Script& script, const Term& m, const State& s) {
  using namespace proofs::induction;
  script.comment(
      "The reference: the highest bit of each word, then spec::index::curve_bits on one bit, where\n"
      "the prefix XOR is that of the bits above, XOR the bit itself; then what is left of each word.");
  const auto bit = [&](const char* what, const Term& word) {
    return Bit(script.define(what, apply("<=", {m, word}, boolean)));
  };
  const Quantised<Bit> q{bit("bu", s.iu), bit("bv", s.iv), bit("bw", s.iw)};
  Term t = truth(false);
  const auto bits = Formula::bits(q, Bit(truth(true)), [&](const Bit& of) {
    t = of.term;
    return Bit(s.above) ^ of;
  });
  const Term b0 = script.define("b0", bits.b0.term), b1 = script.define("b1", bits.b1.term);
  const Term above = script.define("next_above", apply("xor", {s.above, t}, boolean));
  const auto rest = [&](const char* what, const Bit& b, const Term& word) {
    return script.define(what, choose(b.term, apply("-", {word, m}, integer), word));
  };
  const Term iu = rest("next_iu", q.iu, s.iu), iv = rest("next_iv", q.iv, s.iv),
             iw = rest("next_iw", q.iw, s.iw);
  const auto one_if = [](const Term& b) { return choose(b, whole_number(1), whole_number(0)); };
  const Term digit = script.define(
      "digit", apply("+", {one_if(b0), apply("*", {whole_number(2), one_if(b1)}, integer)}, integer));
  return {digit, iu, iv, iw, above};
}

/// The lemma that out of one place, both algorithms give the same digit and are related again, on a triangle half as
/// wide.
template <class Formula, spec::index::Reading reading>
Statement transition_lemma(Place place) {
  using namespace proofs::induction;
  Script script(std::string("transition_") + name(place), Answer::unsat,
                std::string("One step from a related state, ") + name(place) +
                    ", with M = 2m: the recursion's digit is the reference's, and the new state is related "
                    "at scale m.");
  define_relation(script);
  script.comment("The state, and the index so far.");
  const Term m = script.declare("m", integer);
  const Term M = script.define("M", apply("*", {whole_number(2), m}, integer));
  const State s = declare_state(script);
  const Term index = script.declare("index", integer);
  script.require(apply("<=", {whole_number(1), m}, boolean));
  script.require(in_place(place, M, s));

  script.comment(
      "The recursion: spec::index::next_step. A coordinate is held times M, so 1 is written M;\nthe new ones "
      "come out times M and are halved to be times m.");
  using Step = spec::index::Step<OnTriangle, Integer>;
  const auto steps = every_path([&] {
    return spec::index::next_step<reading>(Step{OnTriangle(s.u), OnTriangle(s.v), OnTriangle(s.w),
                                                Integer(index), decided(s.mid), decided(s.top)});
  });
  const auto halved = [](const OnTriangle& q) { return apply("/", {q.term, Term("2.0", real)}, real); };
  const auto defined = [&](const char* what, auto project) {
    return script.define(what, as_formula(steps, project));
  };
  const Term next_index = defined("next_index", [](const Step& n) { return n.index.term; });
  const Term u = defined("next_u", [&](const Step& n) { return halved(n.u); });
  const Term v = defined("next_v", [&](const Step& n) { return halved(n.v); });
  const Term w = defined("next_w", [&](const Step& n) { return halved(n.w); });
  const Term mid = defined("next_mid", [](const Step& n) { return truth(n.mid_flip); });
  const Term top = defined("next_top", [](const Step& n) { return truth(n.top_flip); });

  const ReferenceStep reference = reference_step<Formula>(script, m, s);

  script.comment("Denied: the digit is the same, and the new state is related at scale m.");
  const Term appended = equal(
      next_index, apply("+", {apply("*", {whole_number(4), index}, integer), reference.digit}, integer));
  return script.denying(
      {appended, related(m, {u, v, w, mid, top, reference.iu, reference.iv, reference.iw, reference.above})});
}

/// All statements: the theorem that the reading of Algorithm 4 is the formula at every level.
template <class Formula, spec::index::Reading reading>
std::vector<Statement> all_levels_statements() {
  std::vector<Statement> all{clamp_lemma(), opening_lemma<Formula>(), beyond_lemma<Formula>()};
  for (const Place place : places) all.push_back(transition_lemma<Formula, reading>(place));
  all.push_back(base_lemma());
  for (Statement& s : witnesses()) all.push_back(std::move(s));
  return all;
}

}  // namespace mmverify::proofs::index::induction
