// The lemmas of index.wide_is_vulkan: the reference in 64-bit words is that in 32-bit words up to level 16,
// and that in words without bounds up to level 31.
#pragma once

#include "impl/index/wide.hpp"
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

using impl::index::detail::Square;

/// The formula of impl in its two parts, so that a mutant can have one of them wrong.
struct Implemented {
  template <class Word>
  static Square<Word> square(const Word& iu, const Word& iv, bool carry, const Word& N) {
    return impl::index::detail::square<Word>(iu, iv, carry, N);
  }
  template <class Word>
  static Word curve(const Square<Word>& q) {
    return impl::index::detail::wide_curve<Word>(q);
  }
};

/// Declares N, a power of two up to impl's 2^30, and iu, iv up to N, all of 64 bits.
GridWords declare_wide_grid_words(Script& script);
Statement wide_square_witness();

/// The square: impl's iu, iv and row are the specification's iu, iv and NOT iw.
template <class Formula>
Statement wide_square_lemma() {
  using namespace proofs::induction;
  using W = Word<64>;
  Script script("square", Answer::unsat,
                "For every N = 2^n, n <= 30, all iu = floor(uN) and iv = floor(vN) in [0, N], and both "
                "halves of the square, in 64-bit words: impl's square has the specification's iu and iv, and "
                "its row is the low n bits of NOT iw.\n"
                "impl::index::detail::square; spec::index::grid_square.");
  const GridWords g = declare_wide_grid_words(script);
  const Term upper = script.declare("upper_half", boolean);
  script.comment("The specification.");
  const Quantised<W> q = square_of<Specified, 64>(g.iu, g.iv, upper, g.N);
  const Term iu = script.define("spec_iu", q.iu.term), iv = script.define("spec_iv", q.iv.term),
             row = script.define("spec_row", (~q.iw & (W(g.N) - 1)).term);
  script.comment("impl.");
  const auto paths =
      every_path([&] { return Formula::template square<W>(W(g.iu), W(g.iv), decided(upper), W(g.N)); });
  const Term impl_iu = script.define("impl_iu", as_formula(paths, [](const auto&s) { return s.iu.term; })),
             impl_iv = script.define("impl_iv", as_formula(paths, [](const auto&s) { return s.iv.term; })),
             impl_row = script.define("impl_row", as_formula(paths, [](const auto&s) { return s.row.term; }));
  script.comment("Denied: they are the same, and below N.");
  const Term last = (W(g.N) - 1).term;
  return script.denying({equal(iu, impl_iu), equal(iv, impl_iv), equal(row, impl_row), at_most(iu, last),
                         at_most(iv, last), at_most(row, last)});
}

/// The bits: from such a square on, the same index.
template <class Formula>
Statement wide_bits_lemma() {
  using namespace proofs::induction;
  using W = Word<64>;
  Script script("bits", Answer::unsat,
                "For every N = 2^n, n <= 30, all iu, iv and row below N and any iw whose low n bits are "
                "those of NOT row, in 64-bit words: impl's index is the specification's.\n"
                "impl::index::detail::wide_curve; spec::index::curve.");
  const GridWords g = declare_wide_grid_words(script);
  const Term low = script.define("low", (W(g.N) - 1).term);
  const Term row = script.declare("row", word_sort(64)), iw = script.declare("iw", word_sort(64));
  for (const Term& word : {g.iu, g.iv, row}) script.require(at_most(word, low));
  script.require(equal((W(iw) & W(low)).term, (~W(row) & W(low)).term));
  const Term wanted =
      script.define("wanted", spec::index::curve(Quantised<W>{W(g.iu), W(g.iv), W(iw)}, W(low)).term);
  const Term got = script.define("got", Formula::template curve<W>({W(g.iu), W(g.iv), W(row)}).term);
  return script.denying({equal(wanted, got)});
}

template <class Formula>
std::vector<Statement> impl_statements() {
  return {wide_square_lemma<Formula>(), wide_bits_lemma<Formula>(), wide_square_witness()};
}

/// impl's formula on points, its whole parts and carry taken exactly.  Domain: the closed triangle, n in
/// 0..16.
template <class Formula>
struct ByImplFormula {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    const Q un = times(spec::side(n), p.u), vn = times(spec::side(n), p.v);
    const std::uint32_t iu = whole(un), iv = whole(vn);
    const bool carry = !(un - Q(iu) + (vn - Q(iv)) < Q(1));
    return static_cast<std::uint32_t>(Formula::template curve<std::uint64_t>(
        Formula::template square<std::uint64_t>(iu, iv, carry, std::uint64_t{spec::side(n)})));
  }
};

}  // namespace mmverify::proofs::index::induction
