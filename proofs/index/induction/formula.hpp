// The Vulkan bit formula in its parts, so that a mutant can have one of them wrong: as the specification has
// it, here.
#pragma once

#include "spec/index/index.hpp"

namespace mmverify::proofs::index::induction {

using spec::times;  // found beside the numbers' own, whatever the number
using spec::whole;
using spec::index::CurveBits;
using spec::index::Quantised;

struct Specified {
  template <class Word>
  static Quantised<Word> grid_square(const Word& iu, const Word& iv, bool upper_half, const Word& N) {
    return spec::index::grid_square<Word>(iu, iv, upper_half, N);
  }
  template <class Word, class Q>
  static Quantised<Word> quantise(const Q& un, const Q& vn, const Word& N) {
    return spec::index::quantise_scaled<Word>(un, vn, N);
  }
  template <class Word, class PrefixXor>
  static CurveBits<Word> bits(const Quantised<Word>& q, const Word& low, PrefixXor prefix_xor) {
    return spec::index::curve_bits(q, low, prefix_xor);
  }
  template <class Word>
  static Word prefix_xor(const Word& t) {
    return spec::index::xor_from_above<spec::index::word_bits<Word> / 2>(t);
  }
  template <class Word>
  static Word spread(const Word& x) {
    return spec::index::spread(x);
  }
};

/// The curve's index by a formula.  Domain: as spec::index::curve.
template <class Formula, class Word>
Word curve(const Quantised<Word>& q, const Word& low) {
  const CurveBits<Word> bits = Formula::bits(q, low, [](const Word& t) { return Formula::prefix_xor(t); });
  return Formula::spread(bits.b0) | Formula::spread(bits.b1) << 1;
}

/// A formula as an algorithm of 64-bit words on points.  Domain: the closed triangle, n in 0..16.
template <class Formula>
struct ByFormula {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    const std::uint64_t N = spec::side(n);
    const auto scaled = [n](const Q& q) { return times(spec::side(n), spec::index::within_unit(q)); };
    const auto q = Formula::template quantise<std::uint64_t>(scaled(p.u), scaled(p.v), N);
    return static_cast<std::uint32_t>(curve<Formula>(q, N - 1));
  }
};

}  // namespace mmverify::proofs::index::induction
