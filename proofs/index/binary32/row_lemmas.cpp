#include "proofs/index/binary32/row_lemmas.hpp"

#include <iterator>

#include "proofs/index/binary32/lemmas.hpp"
#include "proofs/index/binary32/scaled.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;

namespace {

using W = Word<32>;

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

Statement rows_lemma(const Steps& steps) {
  Script script(
      steps.name + "_rows", Answer::unsat,
      "For every N in 1..2^16, and all uN = iu + uf and vN = iv + vf in [0, N], uf and vf any multiples of "
      "2^-149 in [0, 1): from iu, iv, uf + vf >= 1 and uf > 0 on, the row and how far along it are the "
      "specification's, and the row is below N.\nspec::index::w_minor_place, which takes floors of (1-w)N, "
      "vN "
      "and (1-u)N.");
  const Scaled s = declare_scaled_in_square(script);
  script.comment("The specification.");
  const auto places = every_path([&] {
    const ExactIn<32> un(s.un), vn(s.vn), N{W(s.N)};
    return spec::index::w_minor_place<W>(un + vn, vn, N - un, W(s.N));
  });
  const Term row = script.define("spec_row", as_formula(places, [](const auto& p) { return p.row.term; }));
  const Term along = script.define("spec_along", as_formula(places, [&](const auto& p) {
                                     return spec::index::along_row(p, W(s.N)).term;
                                   }));
  script.comment("impl.");
  const Term carry = script.define("carry", no(is_less(Exact(s.uf) + Exact(s.vf), Exact(1)))),
             beyond = script.define("beyond", is_less(Exact(0), Exact(s.uf)));
  const RowTerms place = steps.row_place(s.iu, s.iv, carry, beyond, s.N);
  return script.denying({equal(row, script.define("impl_row", place.row)),
                         equal(along, script.define("impl_along", place.along)), is_below(W(row), W(s.N))});
}

Statement rows_witness() {
  Script script(
      "witness_rows", Answer::sat,
      "Not vacuous: some uN and vN fulfil what `rows` supposes, at the highest level, not on the grid.");
  const Scaled s = declare_scaled_in_square(script);
  script.require(equal(s.N, W(std::uint64_t{1} << 16).term));
  for (const Term& part : {s.uf, s.vf}) script.require(is_less(Exact(0), Exact(part)));
  return script.finish();
}

}  // namespace

std::vector<Statement> own_row_statements(const Steps& scalar, const Steps& lanes) {
  return {more_lemma(scalar), rows_lemma(scalar), more_lemma(lanes), rows_lemma(lanes), rows_witness()};
}

std::vector<Statement> row_statements_of(const Steps& scalar, const Steps& lanes) {
  std::vector<Statement> all;
  for (std::vector<Statement> some : {first_statements_about(scalar), first_statements_about(lanes),
                                      first_common_statements(), own_row_statements(scalar, lanes)})
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return all;
}

}  // namespace mmverify::proofs::index::binary32
