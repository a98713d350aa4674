#include "proofs/index/induction/lemmas.hpp"

namespace mmverify::proofs::index::induction {

using namespace proofs::induction;

namespace {

Term at_least(const char* bound, const Term& x) { return apply("<=", {Term(bound, x.sort()), x}, boolean); }

Statement opening_witness() {
  Script script("witness_opening", Answer::sat,
                "Not vacuous: some point fulfils what the opening supposes, off the grid and inside.");
  const Term M = script.declare("M", integer), u = script.declare("u", real), v = script.declare("v", real);
  script.require(at_least("1", M));
  script.require(both({at_least("0.0", u), at_least("0.0", v)}));
  script.require(apply("<", {apply("+", {u, v}, real), to_real(M)}, boolean));
  for (const Term& x : {u, v})
    script.require(apply("<", {to_real(apply("to_int", {x}, integer)), x}, boolean));
  return script.finish();
}

Statement transition_witness(Place place) {
  Script script(std::string("witness_transition_") + name(place), Answer::sat,
                std::string("Not vacuous: some related state, ") + name(place) +
                    ", at an even scale; the two flips may each be what they can be there.");
  define_relation(script);
  const Term m = script.declare("m", integer);
  const Term M = script.define("M", apply("*", {whole_number(2), m}, integer));
  const State s = declare_state(script);
  script.require(at_least("1", m));
  script.require(in_place(place, M, s));
  return script.finish();
}

Statement base_witness(Place place) {
  Script script(std::string("witness_base_") + name(place), Answer::sat,
                std::string("Not vacuous: some related state, ") + name(place) + ", at scale 1.");
  define_relation(script);
  const Term M = script.define("M", whole_number(1));
  script.require(in_place(place, M, declare_state(script)));
  return script.finish();
}

}  // namespace

Statement clamp_lemma() {
  Script script("clamp", Answer::unsat,
                "The reference's clamp, spec::index::within_unit, changes no number of [0,1]: on the closed "
                "triangle u and v are scaled as they are.");
  const Term q = script.declare("q", real);
  script.require(at_least("0.0", q));
  script.require(apply("<=", {q, Term("1.0", real)}, boolean));
  const auto clamped = every_path([&] { return spec::index::within_unit(OnGrid(q)); });
  return script.denying(
      {equal(script.define("clamped", as_formula(clamped, [](const OnGrid& x) { return x.term; })), q)});
}

Statement base_lemma() {
  Script script("base", Answer::unsat,
                "The induction's base, scale M = 1 (level 0, or all levels done): the reference's words have "
                "no bit left, and the recursion takes no step: neither index gets another digit.");
  define_relation(script);
  const Term M = script.define("M", whole_number(1));
  const State s = declare_state(script);
  script.require(related(M, s));
  return script.denying(
      {equal(s.iu, whole_number(0)), equal(s.iv, whole_number(0)), equal(s.iw, whole_number(0))});
}

std::vector<Statement> witnesses() {
  std::vector<Statement> all{opening_witness()};
  for (const Place place : places) all.push_back(transition_witness(place));
  for (const Place place : places) all.push_back(base_witness(place));
  return all;
}

}  // namespace mmverify::proofs::index::induction
