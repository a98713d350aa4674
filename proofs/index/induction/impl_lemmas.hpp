// The lemma of index.impl_wide_is_wide: impl's index in 64-bit words, from the whole parts of uN and vN on,
// is that of the specification.
#pragma once

#include "impl/index/wide.hpp"
#include "proofs/index/induction/word_lemmas.hpp"

namespace mmverify::proofs::index::induction {

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
