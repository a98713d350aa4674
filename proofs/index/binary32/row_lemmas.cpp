#include <iterator>

#include "proofs/index/binary32/lemmas.hpp"
#include "proofs/index/binary32/scaled.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;

namespace {

using W = Word<32>;
using induction::at_most;

/// A coordinate of which the floor alone is known: the statements about floors say what it is.
struct ByFloor {
  W floor;
  explicit ByFloor(std::uint32_t k) : floor(k) {}
  explicit ByFloor(W w) : floor(std::move(w)) {}
  friend ByFloor operator+(const ByFloor& a, const ByFloor& b) { return ByFloor(a.floor + b.floor); }
  friend ByFloor operator-(const ByFloor& a, const ByFloor& b) { return ByFloor(a.floor - b.floor); }
  friend ByFloor times(std::uint32_t k, const ByFloor& a) {
    return ByFloor(W(apply("bvmul", {W(k).term, a.floor.term}, W::sort())));
  }
  friend bool operator<(const ByFloor& a, const ByFloor& b) { return a.floor < b.floor; }
  friend bool operator==(const ByFloor& a, const ByFloor& b) {
    return decided(equal(a.floor.term, b.floor.term));
  }
  friend W whole(const ByFloor& a) { return a.floor; }
};

Term one_where(const Term& condition) { return choose(condition, W(1).term, W(0).term); }
Term is_below(const W& word, const W& bound) { return apply("bvult", {word.term, bound.term}, boolean); }

Statement more_lemma(const Steps& steps) {
  Script script(
      steps.name + "_more", Answer::unsat,
      "For every binary32 number uf in [0, 1): the answer is 1 where uf > 0 exactly, and 0 elsewhere.");
  define_binary32(script);
  const Term uf = script.declare("uf_bits", word_sort(32));
  script.require(apply("bvult", {uf, W(0x3f800000).term}, boolean));
  const Term got = script.define("got", steps.is_more_than_none(Binary32::of_bits(uf).term));
  return script.denying({equal(got, choose(is_less(Exact(0), Exact(exactly(uf))), W(1).term, W(0).term))});
}

/// A point of the square [0, N]^2, whose sum may be beyond the hypotenuse.
Scaled declare_scaled_in_square(Script& script) {
  const Scaled s = declare_scaled<32>(script, std::uint64_t{1} << 16);
  script.require(is_below(W(0), W(s.N)));
  for (const Term& x : {s.un, s.vn}) script.require(no(is_less(Exact(W(s.N)), Exact(x))));
  return s;
}

// (1-w)N, vN and (1-u)N as the specification has them.  Two statements: in one, a prover takes a hundred times as long.

Statement floors_of_sum_lemma() {
  Script script(
      "floors_of_sum", Answer::unsat,
      "For every N in 1..2^16, and all uN = iu + uf and vN = iv + vf in [0, N], uf and vf any multiples of "
      "2^-149 in [0, 1): floor(uN + vN) is iu + iv, one more where uf + vf >= 1; floor(vN) is iv.");
  const Scaled s = declare_scaled_in_square(script);
  const ExactIn<32> un(s.un), vn(s.vn);
  const Term carry = no(is_less(Exact(s.uf) + Exact(s.vf), Exact(1)));
  return script.denying({equal(whole(un + vn).term, (W(s.iu) + W(s.iv) + W(one_where(carry))).term),
                         equal(whole(vn).term, s.iv)});
}

Statement floor_of_rest_lemma() {
  Script script("floor_of_rest", Answer::unsat,
                "For every N in 1..2^16, and every uN = iu + uf in [0, N], uf any multiple of 2^-149 in [0, "
                "1): floor(N - uN) is N - iu, one less where uf > 0.");
  const Scaled s = declare_scaled_in_square(script);
  const ExactIn<32> un(s.un), N{W(s.N)};
  const Term beyond = is_less(Exact(0), Exact(s.uf));
  return script.denying({equal(whole(N - un).term, (W(s.N) - (W(s.iu) + W(one_where(beyond)))).term)});
}

Statement rows_lemma(const Steps& steps) {
  Script script(
      steps.name + "_rows", Answer::unsat,
      "For every N in 1..2^16, all iu = floor(uN) and iv = floor(vN) in [0, N], whether uf + vf >= 1, and "
      "whether uf > 0, which no u = 1 has: with the floors of `floors_of_sum` and `floor_of_rest`, row, col "
      "and dia are the specification's, and the row is below N.\nspec::index::w_minor_place.");
  const Term N = script.declare("N", W::sort()), iu = script.declare("iu", W::sort()),
             iv = script.declare("iv", W::sort()), carry = script.declare("carry", boolean),
             beyond = script.declare("beyond", boolean);
  script.require(at_most(N, W(std::uint64_t{1} << 16).term));
  script.require(is_below(W(0), W(N)));
  for (const Term& word : {iu, iv}) script.require(at_most(word, N));
  script.require(no(both({equal(iu, N), beyond})));
  script.comment("The specification.");
  const auto places = every_path([&] {
    return spec::index::w_minor_place<W>(ByFloor(W(iu) + W(iv) + W(one_where(carry))), ByFloor(W(iv)),
                                         ByFloor(W(N) - (W(iu) + W(one_where(beyond)))), W(N));
  });
  const auto field = [&](const char* name, auto of) { return script.define(name, as_formula(places, of)); };
  const Term row = field("spec_row", [](const auto&p) { return p.row.term; }),
             col = field("spec_col", [](const auto&p) { return p.col.term; }),
             dia = field("spec_dia", [](const auto&p) { return p.dia.term; });
  script.comment("impl.");
  const RowTerms place = steps.row_place(iu, iv, carry, beyond, N);
  return script.denying(
      {equal(row, place.row), equal(col, place.col), equal(dia, place.dia), is_below(W(row), W(N))});
}

Statement floors_witness() {
  Script script("witness_floors", Answer::sat,
                "Not vacuous: some uN and vN fulfil what `floors_of_sum` supposes, at the highest level, not "
                "on the grid.");
  const Scaled s = declare_scaled_in_square(script);
  script.require(equal(s.N, W(std::uint64_t{1} << 16).term));
  for (const Term& part : {s.uf, s.vf}) script.require(is_less(Exact(0), Exact(part)));
  return script.finish();
}

}  // namespace

std::vector<Statement> own_row_statements(const Steps& scalar, const Steps& lanes) {
  return {floors_of_sum_lemma(), floor_of_rest_lemma(), more_lemma(scalar), rows_lemma(scalar),
          more_lemma(lanes),     rows_lemma(lanes),     floors_witness()};
}

std::vector<Statement> row_statements_of(const Steps& scalar, const Steps& lanes) {
  std::vector<Statement> all;
  for (std::vector<Statement> some : {first_statements_about(scalar), first_statements_about(lanes),
                                      first_common_statements(), own_row_statements(scalar, lanes)})
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return all;
}

}  // namespace mmverify::proofs::index::binary32
