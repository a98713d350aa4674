#include "proofs/attribute/induction/names.hpp"

namespace mmverify::proofs::attribute::induction {

using namespace proofs::induction;

void add(std::vector<Statement>& all, const std::string& name, const std::string& says,
         const std::function<Lemma(Script&)>& write) {
  Script script(name, Answer::unsat, says);
  const Lemma lemma = write(script);
  script.comment("Denied:");
  all.push_back(script.denying(lemma.claims));

  Script witness("witness_" + name, Answer::sat,
                 "Not vacuous: some case fulfils what " + name + " supposes.");
  witness.require(write(witness).occasion);
  all.push_back(witness.finish());
}

void suppose_triangular(Script& script) {
  script.comment("T(r) = r(r+1)/2, by triangular_step and triangular_ordered.");
  script.raw("(declare-fun T (Int) Int)\n(assert (= (T 0) 0))\n");
}
void suppose_step(Script& script, const Counted& r) {
  script.require(same(triangular(r + 1), triangular(r) + r + 1));
}
void suppose_twice(Script& script, const Counted& r) {
  script.require(implies(at_most(0, r), same(2 * triangular(r), r * (r + 1))));
}
void suppose_ordered(Script& script, const Counted& r, const Counted& q) {
  script.require(implies(within(0, r, q), at_most(triangular(r) + r + 1, triangular(q))));
}

void suppose_square(Script& script) {
  script.comment("S(r) = r r, by square_step and square_ordered.");
  script.raw("(declare-fun S (Int) Int)\n(assert (= (S 0) 0))\n");
}
void suppose_square_step(Script& script, const Counted& r) {
  script.require(same(square(r + 1), square(r) + 2 * r + 1));
}
void suppose_square_product(Script& script, const Counted& r) { script.require(same(square(r), r * r)); }
void suppose_square_ordered(Script& script, const Counted& r, const Counted& q) {
  script.require(implies(within(0, r, q), at_most(square(r) + 2 * r + 1, square(q))));
}

}  // namespace mmverify::proofs::attribute::induction
