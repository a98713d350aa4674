#include "proofs/index/binary32/published_lemmas.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;

namespace {

using Word32 = Word<32>;
using Square = spec::index::Quantised<Word32>;

Term constant(std::uint64_t k) { return Word32(k).term; }
/// The bits of |x|.
Term size_of(const Term& bits) { return (Word32(bits) & Word32(0x7fffffff)).term; }

/// The condition, on its bits, that a number lies in [-0, 1).
Term in_rest(const Term& bits) {
  return both({apply("bvult", {size_of(bits), constant(0x3f800000)}, boolean),
               induction::at_most(bits, constant(0x80000000))});
}

Term declare_level_up_to(Script& script, unsigned highest) {
  const Term n = script.declare("n", word_sort(8));
  script.require(induction::at_most(n, Word<8>(highest).term));
  return n;
}
Term side_bits_of(Script& script, const Term& n) {
  return script.define("side_bits", apply("concat",
                                          {Term("#b0", word_sort(1)), (Word<8>(n) + Word<8>(127)).term,
                                           Term("(_ bv0 23)", word_sort(23))},
                                          word_sort(32)));
}

Statement published_scale_lemma() {
  Script script("scale", Answer::unsat,
                "For every pattern of 32 bits that is no NaN, and every N = 2^n, n <= 16: clamped to [0,1] "
                "and times N in binary32 it is x 2^n exactly of the number x that the bits stand for; 0 or "
                "-0 for a sign, N for a number above 1.\nspec::index::within_unit on binary32.");
  define_binary32(script);
  const Term n = declare_level_up_to(script, 16), side_bits = side_bits_of(script, n);
  const Term bits = script.declare("x_bits", word_sort(32));
  script.require(induction::at_most(size_of(bits), constant(0x7f800000)));
  const Term limited = script.define(
      "limited",
      choose(apply("bvugt", {bits, constant(0x7fffffff)}, boolean), constant(0),
             choose(apply("bvugt", {bits, constant(0x3f800000)}, boolean), constant(0x3f800000), bits)));
  const auto paths = every_path([&] { return spec::index::within_unit(Rounded(Binary32::of_bits(bits))); });
  const Term clamped =
      script.define("clamped", as_formula(paths, [](const Rounded& q) { return q.number.term; }));
  const Term product = script.define("product", (Binary32::of_bits(side_bits) * Binary32(clamped)).term);
  const Term got = script.declare("got_bits", word_sort(32));
  script.require(equal(Binary32::of_bits(got).term, product));
  return script.denying(
      {induction::at_most(size_of(got), side_bits), equal(exactly(size_of(got)), exact_times(limited, n))});
}

/// The index by grid_square and curve, for given whole parts.
Term index_of(const Term& iu, const Term& iv, bool upper, const Term& N, const Term& low) {
  const auto paths =
      every_path([&] { return spec::index::grid_square<Word32>(Word32(iu), Word32(iv), upper, Word32(N)); });
  const Square q{Word32(as_formula(paths, [](const Square& s) { return s.iu.term; })),
                 Word32(as_formula(paths, [](const Square& s) { return s.iv.term; })),
                 Word32(as_formula(paths, [](const Square& s) { return s.iw.term; }))};
  return spec::index::curve(q, Word32(low)).term;
}

Statement halves_lemma() {
  Script script(
      "halves", Answer::unsat,
      "For every N = 2^n, n <= 16, and all iu = floor(uN) and iv = floor(vN) in [0, N]: the two halves of "
      "the square have different indices just where iu + iv < N-1.\nspec::index::grid_square and curve.");
  const induction::GridWords g = induction::declare_grid_words(script);
  const Term low = script.define("low", (Word32(g.N) - 1).term);
  const Term lower = script.define("lower", index_of(g.iu, g.iv, false, g.N, low)),
             upper = script.define("upper", index_of(g.iu, g.iv, true, g.N, low));
  const Term inside = apply("bvult", {(Word32(g.iu) + Word32(g.iv)).term, low}, boolean);
  return script.denying({equal(inside, no(equal(lower, upper)))});
}

Statement published_parts_lemma() {
  Script script("parts", Answer::unsat,
                "For every N = 2^n, n <= 16, and every binary32 number y in [-0, N]: the whole part is y's, "
                "in [0, N], and what is left in binary32 is the rest exactly, in [-0, 1).\n"
                "whole and the difference of spec::index::quantise_scaled on binary32.");
  define_binary32(script);
  const Term n = declare_level_up_to(script, 16), side_bits = side_bits_of(script, n);
  const Term bits = script.declare("y_bits", word_sort(32));
  script.require(
      both({induction::at_most(size_of(bits), side_bits), induction::at_most(bits, constant(0x80000000))}));
  const Rounded y(Binary32::of_bits(bits));
  const Word32 cut(script.define("whole", whole(y).term));
  const Term rest = script.declare("rest_bits", word_sort(32));
  script.require(equal(Binary32::of_bits(rest).term, (y - Rounded(cut)).number.term));
  const Term N =
      apply("bvshl", {constant(1), apply("(_ zero_extend 24)", {n}, word_sort(32))}, word_sort(32));
  return script.denying({induction::at_most(cut.term, N), in_rest(rest),
                         equal(exactly(size_of(bits)), (Exact(cut) + Exact(exactly(size_of(rest)))).term)});
}

Statement published_witness() {
  Script script("witness_square", Answer::sat,
                "Not vacuous: some squares and rests fulfil what `square` supposes, and the published code "
                "errs there: uf + vf < 1, not below 1 - 2^-25, and iu + iv < N-1.");
  const PublishedInput in = declare_published_input(script);
  script.require(is_less(Exact(exactly(size_of(in.uf))) + Exact(exactly(size_of(in.vf))), Exact(1)));
  script.require(reaches_published_one(in));
  script.require(apply("bvult", {(Word32(in.iu) + Word32(in.iv) + Word32(1)).term, in.N}, boolean));
  return script.finish();
}

}  // namespace

PublishedInput declare_published_input(Script& script) {
  define_binary32(script);
  const Term N = script.declare("N", word_sort(32)), iu = script.declare("iu", word_sort(32)),
             iv = script.declare("iv", word_sort(32));
  script.require(induction::at_most(N, constant(1 << 16)));
  for (const Term& word : {iu, iv}) script.require(induction::at_most(word, N));
  const Term uf = script.declare("uf_bits", word_sort(32)), vf = script.declare("vf_bits", word_sort(32));
  for (const Term& part : {uf, vf}) script.require(in_rest(part));
  return {N, iu, iv, uf, vf};
}

Term reaches_published_one(const PublishedInput& in) {
  // 2^-25 is 2^124 units.
  const Exact hair(apply("bvshl", {Word<Exact::bits>(1).term, Word<Exact::bits>(124).term}, Exact::sort()));
  return no(is_less(Exact(exactly(size_of(in.uf))) + Exact(exactly(size_of(in.vf))), Exact(1) - hair));
}

std::vector<Statement> statements_of_published_numbers() {
  return {published_scale_lemma(), published_parts_lemma(), halves_lemma(), published_witness()};
}

}  // namespace mmverify::proofs::index::binary32
