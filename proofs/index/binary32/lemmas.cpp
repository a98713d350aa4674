#include "proofs/index/binary32/lemmas.hpp"

#include <iterator>

#include "proofs/index/binary32/scaled.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;
using induction::at_most;
using induction::declare_grid_words;
using induction::GridWords;
using spec::index::Quantised;

namespace {

using W = Word<32>;

Term word_constant(std::uint64_t k) { return W(k).term; }

/// The bits of 1, of 2^30, and of 2^n.
const Term one_bits = word_constant(0x3f800000), highest_bits = word_constant(0x4e800000);

/// A level n as a byte, 0..30, and the bits of 2^n.
struct LevelTerms {
  Term n, side_bits;
};
LevelTerms declare_level(Script& script) {
  const Term n = script.declare("n", word_sort(8));
  script.require(at_most(n, Word<8>(30).term));
  return {n, script.define("side_bits", apply("concat",
                                              {Term("#b0", word_sort(1)), (Word<8>(n) + Word<8>(127)).term,
                                               Term("(_ bv0 23)", word_sort(23))},
                                              word_sort(32)))};
}

Term below(const Term& word, const Term& bound) { return apply("bvult", {word, bound}, boolean); }

void declare_free(Script& script, const Steps& steps) {
  for (const std::string& name : steps.free) script.declare(name, boolean);
}

/// Bits that stand for a float: there are some for each, and for NaN many.
Term bits_of(Script& script, const std::string& name, const Term& number) {
  const Term bits = script.declare(name, word_sort(32));
  script.require(equal(Binary32::of_bits(bits).term, number));
  return bits;
}

Term word_of(const Term& condition) { return choose(condition, word_constant(1), word_constant(0)); }

Statement scale_lemma(const Steps& steps) {
  Script script(steps.name + "_scale", Answer::unsat,
                "For each of the 2^32 bit patterns and every N = 2^n, n <= 30: clamped to [0,1] and times N "
                "it is, without any rounding, x 2^n of the number x that the bits stand for; 0 for a sign or "
                "a NaN, N for a number above 1. It is no more than N.");
  define_binary32(script);
  const LevelTerms level = declare_level(script);
  const Term bits = script.declare("x_bits", word_sort(32));
  declare_free(script, steps);
  const Term limited = script.define(
      "limited", choose(apply("bvugt", {bits, word_constant(0x7fffffff)}, boolean), word_constant(0),
                        choose(apply("bvugt", {bits, word_constant(0x7f800000)}, boolean), word_constant(0),
                               choose(apply("bvugt", {bits, one_bits}, boolean), one_bits, bits))));
  const Term N = script.define("N", Binary32::of_bits(level.side_bits).term);
  const Term got = script.define("got", steps.scaled(Binary32::of_bits(bits).term, N));
  const Term got_bits = bits_of(script, "got_bits", got);
  return script.denying({at_most(got_bits, level.side_bits),
                         equal(exact_times(got_bits, Word<8>(0).term), exact_times(limited, level.n))});
}

Statement parts_lemma(const Steps& steps) {
  Script script(steps.name + "_parts", Answer::unsat,
                "For every N = 2^n, n <= 30, and every binary32 number y in [0, N]: what is cut off as whole "
                "is in [0, N], the rest is a number in [0, 1), and exactly y = whole + rest.");
  define_binary32(script);
  const LevelTerms level = declare_level(script);
  const Term bits = script.declare("y_bits", word_sort(32));
  script.require(at_most(bits, level.side_bits));
  const CutTerms cut = steps.cut(Binary32::of_bits(bits).term);
  const Term whole = script.define("whole", cut.whole);
  const Term rest = bits_of(script, "rest_bits", script.define("rest", cut.part));
  return script.denying(
      {at_most(whole, apply("bvshl", {word_constant(1), apply("(_ zero_extend 24)", {level.n}, W::sort())},
                            W::sort())),
       below(rest, one_bits), equal(exactly(bits), (Exact(W(whole)) + Exact(exactly(rest))).term)});
}

/// Whether uf + vf >= 1 exactly is what the code says of `seen(uf)` and `seen(vf)`.
template <class Seen>
Statement reach_one_lemma(const Steps& steps, const std::string& name, const std::string& claim, Seen seen) {
  Script script(steps.name + name, Answer::unsat,
                "For every two binary32 numbers uf and vf in [0, 1): " + claim);
  define_binary32(script);
  const Term uf = script.declare("uf_bits", word_sort(32)), vf = script.declare("vf_bits", word_sort(32));
  for (const Term& x : {uf, vf}) script.require(below(x, one_bits));
  declare_free(script, steps);
  const Term got = script.define("got", steps.reach_one(seen(uf), seen(vf)));
  const Exact sum = Exact(exactly(uf)) + Exact(exactly(vf));
  return script.denying({equal(got, word_of(no(is_less(sum, Exact(1)))))});
}

Statement carry_lemma(const Steps& steps) {
  return reach_one_lemma(steps, "_carry", "the answer is 1 where uf + vf >= 1 exactly, and 0 elsewhere.",
                         [](const Term& x) { return Binary32::of_bits(x).term; });
}

Statement flush_lemma(const Steps& steps) {
  return reach_one_lemma(
      steps, "_flush",
      "with 0 in the place of what is below 2^-96, the answer is still whether uf + vf >= 1 exactly.\nA "
      "processor that takes numbers below 2^-126 for 0 loses less, even times 2^30.",
      [](const Term& x) {
        return Binary32::of_bits(choose(below(x, word_constant(0x0f800000)), word_constant(0), x)).term;
      });
}

Statement square_lemma(const Steps& steps) {
  Script script(steps.name + "_square", Answer::unsat,
                "For every N = 2^n, n <= 16, all iu = floor(uN) and iv = floor(vN) in [0, N], and both "
                "halves of the square: iu and iv as limited are the specification's, and the row is the low "
                "n bits of its NOT iw. All three are below N.\nspec::index::grid_square.");
  const GridWords g = declare_grid_words(script);
  const Term upper = script.declare("upper_half", boolean);
  script.comment("The specification.");
  const auto q = induction::square_of<induction::Specified, 32>(g.iu, g.iv, upper, g.N);
  const Term last = script.define("last", (W(g.N) - 1).term);
  const Term iu = script.define("spec_iu", q.iu.term), iv = script.define("spec_iv", q.iv.term),
             row = script.define("spec_row", (~q.iw & W(last)).term);
  script.comment("impl.");
  const SquareTerms square = steps.square(g.iu, g.iv, upper, g.N);
  const Term impl_iu = script.define("impl_iu", square.iu), impl_iv = script.define("impl_iv", square.iv),
             impl_row = script.define("impl_row", square.row);
  return script.denying({equal(iu, impl_iu), equal(iv, impl_iv), equal(row, impl_row), at_most(iu, last),
                         at_most(iv, last), at_most(row, last)});
}

Statement curve_lemma(const Steps& steps) {
  Script script(steps.name + "_curve", Answer::unsat,
                "For every N = 2^n, n <= 16, all iu, iv and row below N and any iw whose low n bits are "
                "those of NOT row: the index is the specification's.\nspec::index::curve.");
  const GridWords g = declare_grid_words(script);
  const Term low = script.define("low", (W(g.N) - 1).term);
  const Term row = script.declare("row", W::sort()), iw = script.declare("iw", W::sort());
  for (const Term& word : {g.iu, g.iv, row}) script.require(at_most(word, low));
  script.require(equal((W(iw) & W(low)).term, (~W(row) & W(low)).term));
  const Term wanted =
      script.define("wanted", spec::index::curve(Quantised<W>{W(g.iu), W(g.iv), W(iw)}, W(low)).term);
  const Term got = script.define("got", steps.curve({g.iu, g.iv, row}));
  return script.denying({equal(wanted, got)});
}

Statement side_lemma() {
  Script script("side", Answer::unsat,
                "For n <= 30: the word 1 << n as a float is the number 2^n, which `scale` supposes.");
  const LevelTerms level = declare_level(script);
  const SignedWord N(
      apply("bvshl", {word_constant(1), apply("(_ zero_extend 24)", {level.n}, W::sort())}, W::sort()));
  return script.denying({equal(Binary32(N).term, Binary32::of_bits(level.side_bits).term)});
}

template <unsigned bits>
Statement reference_lemma(std::uint64_t most) {
  using Wide = Word<bits>;
  const std::string size = std::to_string(bits);
  Script script(
      "reference_" + size, Answer::unsat,
      "For all uN = iu + uf and vN = iv + vf, iu and iv in [0, N], uf and vf any multiples of 2^-149 in [0, "
      "1): the specification's square is that of iu, iv and uf + vf >= 1, in words of " +
          size + " bits.\nspec::index::quantise_scaled, which takes floors of its own.");
  const Scaled s = declare_scaled<bits>(script, most);
  const auto by_floors = every_path([&] {
    return spec::index::quantise_scaled<Wide>(ExactIn<bits>(s.un), ExactIn<bits>(s.vn), Wide(s.N));
  });
  const Term upper = script.define("upper_half", no(is_less(Exact(s.uf) + Exact(s.vf), Exact(1))));
  const auto by_parts = every_path(
      [&] { return spec::index::grid_square<Wide>(Wide(s.iu), Wide(s.iv), decided(upper), Wide(s.N)); });
  std::vector<Term> claims;
  const auto claim = [&](auto project) {
    claims.push_back(equal(as_formula(by_floors, project), as_formula(by_parts, project)));
  };
  claim([](const Quantised<Wide>& q) { return q.iu.term; });
  claim([](const Quantised<Wide>& q) { return q.iv.term; });
  claim([](const Quantised<Wide>& q) { return q.iw.term; });
  return script.denying(std::move(claims));
}

Statement scale_witness() {
  Script script("witness_scale", Answer::sat,
                "Not vacuous: `scale` supposes a level alone; there is one, above a number below 2^-126.");
  define_binary32(script);
  const LevelTerms level = declare_level(script);
  const Term bits = script.declare("x_bits", word_sort(32));
  script.require(both({equal(level.n, Word<8>(30).term), below(bits, word_constant(0x00800000)),
                       below(word_constant(0), bits)}));
  return script.finish();
}

Statement parts_witness() {
  Script script("witness_parts", Answer::sat,
                "Not vacuous: some number fulfils what `parts` supposes, above 1 and not whole.");
  define_binary32(script);
  const LevelTerms level = declare_level(script);
  const Term bits = script.declare("y_bits", word_sort(32));
  script.require(at_most(bits, level.side_bits));
  const Term y = Binary32::of_bits(bits).term;
  script.require(below(one_bits, bits));
  script.require(no(equal(apply("fp.roundToIntegral RTZ", {y}, proofs::induction::binary32), y)));
  return script.finish();
}

Statement carry_witness() {
  Script script(
      "witness_carry", Answer::sat,
      "Not vacuous: some uf and vf fulfil what `carry` supposes, and their sum is below 1 and rounds to 1.");
  define_binary32(script);
  const Term uf = script.declare("uf_bits", word_sort(32)), vf = script.declare("vf_bits", word_sort(32));
  for (const Term& x : {uf, vf}) script.require(below(x, one_bits));
  script.require(is_less(Exact(exactly(uf)) + Exact(exactly(vf)), Exact(1)));
  script.require(equal((Binary32::of_bits(uf) + Binary32::of_bits(vf)).term, Binary32(1.0f).term));
  return script.finish();
}

Statement reference_witness() {
  Script script("witness_reference", Answer::sat,
                "Not vacuous: some uN and vN fulfil what `reference_64` supposes, strictly inside the "
                "highest level and in the upper half of a square.");
  const Scaled s = declare_scaled<64>(script, std::uint64_t{1} << 30);
  script.require(equal(s.N, Word<64>(std::uint64_t{1} << 30).term));
  for (const Term& word : {s.iu, s.iv}) script.require(below(word, s.N));
  script.require(is_less(Exact(1), Exact(s.uf) + Exact(s.vf)));
  return script.finish();
}

Statement curve_witness() {
  Script script("witness_curve", Answer::sat,
                "Not vacuous: some words fulfil what `curve` supposes, at the highest level.");
  const GridWords g = declare_grid_words(script);
  script.require(equal(g.N, word_constant(std::uint64_t{1} << 16)));
  const Term low = script.define("low", (W(g.N) - 1).term);
  const Term row = script.declare("row", W::sort()), iw = script.declare("iw", W::sort());
  for (const Term& word : {g.iu, g.iv, row}) script.require(at_most(word, low));
  script.require(equal((W(iw) & W(low)).term, (~W(row) & W(low)).term));
  return script.finish();
}

Statement named(Statement s, const char* name) {
  s.name = name;
  return s;
}

}  // namespace

std::vector<Statement> first_statements_about(const Steps& steps) {
  return {scale_lemma(steps), parts_lemma(steps), carry_lemma(steps), flush_lemma(steps)};
}

std::vector<Statement> statements_about(const Steps& steps) {
  std::vector<Statement> all = first_statements_about(steps);
  all.push_back(square_lemma(steps));
  all.push_back(curve_lemma(steps));
  return all;
}

std::vector<Statement> first_common_statements() {
  return {side_lemma(), scale_witness(), parts_witness(), carry_witness()};
}

std::vector<Statement> common_statements() {
  return {side_lemma(),
          reference_lemma<32>(std::uint64_t{1} << 16),
          reference_lemma<64>(std::uint64_t{1} << 30),
          named(induction::wide_square_lemma<induction::Implemented>(), "wide_square"),
          named(induction::wide_bits_lemma<induction::Implemented>(), "wide_curve"),
          scale_witness(),
          parts_witness(),
          carry_witness(),
          reference_witness(),
          named(induction::grid_words_witness(), "witness_square"),
          curve_witness(),
          named(induction::wide_square_witness(), "witness_wide_square")};
}

std::vector<Statement> statements_of(const Steps& scalar, const Steps& lanes) {
  std::vector<Statement> all;
  for (std::vector<Statement> some : {statements_about(scalar), statements_about(lanes), common_statements()})
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return all;
}

}  // namespace mmverify::proofs::index::binary32
