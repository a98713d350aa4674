// The lemmas of index.wide_is_vulkan: the reference in 64-bit words is that in 32-bit words up to level 16,
// and that in words without bounds up to level 31.
#pragma once

#include "proofs/index/induction/formula.hpp"
#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Answer;
using proofs::induction::Script;
using proofs::induction::Statement;
using proofs::induction::Term;
using proofs::induction::Word;

Term bv(const char* head, std::vector<Term> of, unsigned bits);
Term at_most(const Term& word, const Term& bound);
/// Declares N, a power of two up to 2^16, and iu, iv up to N: what floor(uN) and floor(vN) can be.
struct GridWords {
  Term N, iu, iv;
};
GridWords declare_grid_words(Script& script);
Statement grid_words_witness();

/// grid_square as one formula a field, run on given words.
template <class Formula, unsigned bits>
Quantised<Word<bits>> square_of(const Term& iu, const Term& iv, const Term& upper_half, const Term& N) {
  using namespace proofs::induction;
  using W = Word<bits>;
  const auto paths =
      every_path([&] { return Formula::template grid_square<W>(W(iu), W(iv), decided(upper_half), W(N)); });
  return {W(as_formula(paths, [](const Quantised<W>& q) { return q.iu.term; })),
          W(as_formula(paths, [](const Quantised<W>& q) { return q.iv.term; })),
          W(as_formula(paths, [](const Quantised<W>& q) { return q.iw.term; }))};
}

/// The index in 64-bit words is that in 32-bit words, from the whole parts on.
template <class Formula>
Statement agreement_lemma() {
  using namespace proofs::induction;
  Script script("agreement", Answer::unsat,
                "For every N = 2^n, n <= 16, all iu = floor(uN) and iv = floor(vN) in [0, N], and both "
                "halves of the square: the index in 32-bit words is that in 64-bit words.\n"
                "spec::index::grid_square and curve, run on both.");
  const GridWords g = declare_grid_words(script);
  const Term upper = script.declare("upper_half", boolean);
  const auto widened = [](const Term& t) { return apply("(_ zero_extend 32)", {t}, word_sort(64)); };
  const auto named = [&](const char* prefix, auto q) {
    using W = decltype(q.iu);
    const std::string p = prefix;
    return Quantised<W>{W(script.define(p + "_iu", q.iu.term)), W(script.define(p + "_iv", q.iv.term)),
                        W(script.define(p + "_iw", q.iw.term))};
  };
  script.comment("In 32-bit words.");
  const auto narrow = named("narrow", square_of<Specified, 32>(g.iu, g.iv, upper, g.N));
  const Term low = script.define("narrow_low", (Word<32>(g.N) - 1).term);
  const Term index = script.define("narrow_index", spec::index::curve(narrow, Word<32>(low)).term);
  script.comment("In 64-bit words.");
  const auto wide = named("wide", square_of<Formula, 64>(widened(g.iu), widened(g.iv), upper, widened(g.N)));
  const Term wide_low = script.define("wide_low", (Word<64>(widened(g.N)) - 1).term);
  const Term wide_index = script.define("wide_index", curve<Formula>(wide, Word<64>(wide_low)).term);
  script.comment("Denied: the indices are the same.");
  return script.denying({equal(widened(index), wide_index)});
}

/// xor_from_above over the lower half of a word of `bits`: f_i = t_i XOR f_{i+1}, and nothing above.
template <class Formula, unsigned bits>
Statement prefix_xor_lemma(const char* name) {
  using namespace proofs::induction;
  Script script(
      name, Answer::unsat,
      "For every t below 2^" + std::to_string(bits / 2) +
          ": f = xor_from_above(t) has f = t XOR (f >> 1), that is f_i = t_i XOR f_{i+1} at every place, "
          "with 0 above the highest. So, from the top down, f_i is the XOR of t_j for all j >= i.");
  const Term t = script.declare("t", word_sort(bits));
  script.require(at_most(t, Word<bits>((std::uint64_t{1} << bits / 2) - 1).term));
  const Word<bits> f(script.define("f", Formula::prefix_xor(Word<bits>(t)).term));
  return script.denying({equal(f.term, (Word<bits>(t) ^ f >> 1).term),
                         at_most(f.term, Word<bits>((std::uint64_t{1} << bits / 2) - 1).term)});
}

/// spread: bit i goes to 2i, and every odd bit is zero.
template <class Formula, unsigned bits>
Statement spread_lemma(const char* name) {
  using namespace proofs::induction;
  using W = Word<bits>;
  Script script(name, Answer::unsat,
                "For every x below 2^" + std::to_string(bits / 2) + " and every place i below " +
                    std::to_string(bits / 2) + ": bits 2i and 2i+1 of spread(x) are bit i of x and 0.");
  const Term x = script.declare("x", word_sort(bits)), i = script.declare("i", word_sort(bits));
  script.require(at_most(x, W((std::uint64_t{1} << bits / 2) - 1).term));
  script.require(at_most(i, W(bits / 2 - 1).term));
  const Term s = script.define("s", Formula::spread(W(x)).term);
  const W pair = W(bv("bvlshr", {s, bv("bvadd", {i, i}, bits)}, bits)) & W(3);
  const W bit = W(bv("bvlshr", {x, i}, bits)) & W(1);
  return script.denying({equal(pair.term, bit.term)});
}

/// Up to level 31 the 64-bit words of grid_square are those without bounds; iw, negative there, is 2^64 more.
Statement unbounded_lemma();

/// All of them, for the reference in 64-bit words by a formula.
template <class Formula>
std::vector<Statement> wide_statements() {
  return {agreement_lemma<Formula>(),
          prefix_xor_lemma<Specified, 32>("prefix_xor_32"),
          prefix_xor_lemma<Formula, 64>("prefix_xor_64"),
          spread_lemma<Specified, 32>("spread_32"),
          spread_lemma<Formula, 64>("spread_64"),
          unbounded_lemma(),
          grid_words_witness()};
}

}  // namespace mmverify::proofs::index::induction
