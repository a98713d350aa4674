// Orders of vertices and faces in vectors, for the kernels of order.cpp and lookup.cpp.  Compiled once for each target.
#include <hwy/highway.h>

#include "impl/attribute/order.hpp"
#include "impl/index/vectors-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_ATTRIBUTE_ORDER_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_ATTRIBUTE_ORDER_INL_HPP_
#undef MMVERIFY_IMPL_ATTRIBUTE_ORDER_INL_HPP_
#else
#define MMVERIFY_IMPL_ATTRIBUTE_ORDER_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace iv = mmverify::impl::index::HWY_NAMESPACE;

using Floats = iv::Floats;
using Ints = iv::Ints;
using Words = iv::Words;
using FloatVec = iv::FloatVec;
using IntVec = iv::IntVec;
using WordVec = iv::WordVec;

HWY_INLINE WordVec word(std::uint32_t x) { return hn::Set(Words(), x); }
HWY_INLINE IntVec as_ints(WordVec x) { return hn::BitCast(Ints(), x); }
HWY_INLINE WordVec as_words(IntVec x) { return hn::BitCast(Words(), x); }
HWY_INLINE hn::Mask<Words> is_zero(WordVec x) { return hn::Eq(x, hn::Zero(Words())); }
/// a < b, lane by lane.  Domain: a - b fits 31 bits and a sign.
HWY_INLINE hn::Mask<Words> below(WordVec a, WordVec b) {
  return hn::RebindMask(Words(), hn::Lt(as_ints(hn::Sub(a, b)), hn::Zero(Ints())));
}

/// detail::triangular: r(r+1)/2 in 32 bits.
HWY_INLINE WordVec triangular(WordVec r) {
  const auto one = word(1);
  return hn::Mul(hn::ShiftRight<1>(hn::Add(r, one)), hn::Or(r, one));
}

/// detail::triangular_root.  The root is taken in binary32 and corrected in whole numbers: 2x and the root have a
/// relative error of 2^-23 at most, so the guess is off by less than 65537 2^-23 before it is cut, and by 1 after.
HWY_INLINE WordVec triangular_root(WordVec x) {
  const Floats d;
  const Ints di;
  const auto high = hn::ConvertTo(d, as_ints(hn::ShiftRight<16>(x)));
  const auto low = hn::ConvertTo(d, as_ints(hn::And(x, word(0xffff))));
  const auto doubled = hn::Add(hn::Mul(high, hn::Set(d, 131072.0f)), hn::Add(low, low));
  const auto root = hn::Sub(hn::Sqrt(hn::Add(doubled, hn::Set(d, 0.25f))), hn::Set(d, 0.5f));
  const auto guess = hn::ConvertTo(di, root);
  const auto rest = as_ints(hn::Sub(x, triangular(as_words(guess))));
  const auto too_high = iv::one_if(hn::Lt(rest, hn::Zero(di))), too_low = iv::one_if(hn::Gt(rest, guess));
  return as_words(hn::Add(hn::Sub(guess, too_high), too_low));
}

/// detail::curve_number.
HWY_INLINE WordVec curve_number(WordVec iu, WordVec iv_, WordVec row) {
  const auto b0 = hn::Xor(iu, row), t = hn::And(hn::Xor(iu, iv_), b0);
  const auto b1 = hn::Or(hn::AndNot(b0, hn::Xor(iv::xor_from_above(t), iu)), t);
  return hn::Or(iv::spread(b0), hn::ShiftLeft<1>(iv::spread(b1)));
}

struct VertexVecs {
  WordVec i, j;
};
struct FaceVecs {
  WordVec iu, iv, upper;
};

/// detail::curve_square.
HWY_INLINE FaceVecs curve_square(WordVec b0, WordVec b1) {
  const auto t = hn::And(b0, b1), f = iv::xor_from_above(t), m = iv::xor_from_above(hn::AndNot(b1, b0));
  const auto inverted = hn::ShiftRight<1>(m);
  return {hn::Or(hn::And(b0, inverted), hn::AndNot(b0, hn::Xor(b1, f))), hn::Xor(inverted, t),
          hn::And(m, word(1))};
}

// Vertex -> index, by order.

struct WMinorIndex {
  explicit WMinorIndex(Level) {}
  HWY_INLINE WordVec operator()(WordVec i, WordVec j) const { return hn::Add(triangular(hn::Add(i, j)), j); }
};

struct UMajorIndex {
  explicit UMajorIndex(Level level) : side(std::uint32_t{1} << level), last(vertex_count(level) - 1) {}
  HWY_INLINE WordVec operator()(WordVec i, WordVec j) const {
    const auto r = hn::Sub(word(side), i);
    return hn::Add(hn::Sub(hn::Sub(word(last), triangular(r)), r), j);
  }
  std::uint32_t side, last;
};

struct BirdIndex {
  explicit BirdIndex(Level level) : side(std::uint32_t{1} << level) {}
  HWY_INLINE WordVec operator()(WordVec i, WordVec j) const {
    const Floats d;
    const Ints di;
    const auto one = word(1);
    // 2^s, the lowest bit of i, j and N; division by it is exact in binary32, which holds numbers up to 2^16.
    const auto any = hn::Or(hn::Or(i, j), word(side));
    const auto lowest = hn::And(any, hn::Sub(hn::Zero(Words()), any));
    // The exponents of 2^s and 2^-s add up to twice that of 1.
    const auto power = hn::BitCast(Words(), hn::ConvertTo(d, as_ints(lowest)));
    const auto over = hn::BitCast(d, hn::Sub(word(2 * 0x3f800000u), power));
    const auto divided = [&](WordVec x) HWY_ATTR {
      return as_words(hn::ConvertTo(di, hn::Mul(hn::ConvertTo(d, as_ints(x)), over)));
    };
    const auto im = divided(i), jm = divided(j), M = hn::ShiftRight<1>(divided(word(side)));
    const auto a = hn::ShiftRight<1>(im), b = hn::ShiftRight<1>(jm);
    const auto i_odd = hn::And(im, one), j_odd = hn::And(jm, one);
    // 0, 1 and 2 for (even, odd), (odd, odd) and (odd, even).
    const auto e = hn::Add(i_odd, hn::AndNot(j_odd, i_odd));
    const auto before = hn::ShiftRight<1>(hn::Add(curve_number(a, b, hn::Add(a, b)), b));
    const auto count = triangular(hn::Add(M, one));
    const auto index = hn::Add(count, hn::Add(hn::Add(before, hn::Add(before, before)), e));
    const auto corner =
        hn::Add(hn::And(word(1), as_words(hn::VecFromMask(di, hn::Gt(as_ints(i), hn::Zero(di))))),
                hn::And(word(2), as_words(hn::VecFromMask(di, hn::Gt(as_ints(j), hn::Zero(di))))));
    return hn::IfThenElse(is_zero(M), corner, index);
  }
  std::uint32_t side;
};

// Index -> vertex.

struct WMinorVertex {
  explicit WMinorVertex(Level) {}
  HWY_INLINE VertexVecs operator()(WordVec index) const {
    const auto r = triangular_root(index), j = hn::Sub(index, triangular(r));
    return {hn::Sub(r, j), j};
  }
};

struct UMajorVertex {
  explicit UMajorVertex(Level level) : side(std::uint32_t{1} << level), last(vertex_count(level) - 1) {}
  HWY_INLINE VertexVecs operator()(WordVec index) const {
    const auto y = hn::Sub(word(last), index), r = triangular_root(y), c = hn::Sub(y, triangular(r));
    return {hn::Sub(word(side), r), hn::Sub(r, c)};
  }
  std::uint32_t side, last;
};

struct BirdVertex {
  explicit BirdVertex(Level level) : n(level) {}

  /// floor(x / 3) without wider words: 2^16 = 3 * 21845 + 1 and 2^8 = 3 * 85 + 1, and for what is left, below 768,
  /// floor(43691 y / 2^17).
  static HWY_INLINE WordVec third(WordVec x) {
    const auto high = hn::ShiftRight<16>(x), sum = hn::Add(high, hn::And(x, word(0xffff)));
    const auto middle = hn::ShiftRight<8>(sum), left = hn::Add(middle, hn::And(sum, word(0xff)));
    return hn::Add(hn::Add(hn::Mul(high, word(21845)), hn::Mul(middle, word(85))),
                   hn::ShiftRight<17>(hn::Mul(left, word(43691))));
  }

  /// 2^e.  Domain: e in 0..30.
  static HWY_INLINE WordVec power(WordVec e) {
    const auto bits = hn::ShiftLeft<23>(hn::Add(e, word(127)));
    return as_words(hn::ConvertTo(Ints(), hn::BitCast(Floats(), bits)));
  }

  HWY_INLINE VertexVecs operator()(WordVec index) const {
    const Floats d;
    const auto one = word(1), zero = hn::Zero(Words());
    // d = floor(log2(2 index) / 2) from the exponent of index / 2.  Its conversion may round up to one too many, which
    // is corrected below like the one too many that the bound allows.
    const auto half = hn::Max(as_ints(hn::ShiftRight<1>(index)), as_ints(one));
    const auto exponent =
        hn::Sub(hn::ShiftRight<23>(hn::BitCast(Words(), hn::ConvertTo(d, half))), word(127 - 2));
    auto D = hn::ShiftRight<1>(exponent);
    D = hn::Sub(D, hn::IfThenElseZero(below(index, triangular(hn::Add(power(D), one))), one));
    const auto S0 = power(D);
    const auto from = hn::Sub(index, triangular(hn::Add(S0, one)));
    auto k = third(from);
    const auto e = hn::Sub(from, hn::Add(k, hn::Add(k, k)));
    // If level l is above D, the walk takes child 0 there.
    auto b0 = zero, b1 = zero, upside_down = zero;  // all ones or zero
    for (Level l = n == 0 ? 0 : n - 1; l-- > 0;) {
      const std::uint32_t S = std::uint32_t{1} << l;
      const auto first =
          hn::Xor(hn::And(upside_down, word((S * S + S) / 2 ^ (S * S - S) / 2)), word((S * S + S) / 2));
      const auto not_high = hn::VecFromMask(Words(), below(k, word(S * S)));
      k = hn::Sub(k, hn::AndNot(not_high, word(S * S)));
      const auto not_low = hn::VecFromMask(Words(), below(k, first));
      k = hn::Sub(k, hn::AndNot(not_low, first));
      b1 = hn::Or(hn::Add(b1, b1), hn::AndNot(not_high, one));
      b0 = hn::Or(hn::Add(b0, b0), hn::AndNot(not_low, one));
      upside_down = hn::Xor(upside_down, hn::AndNot(not_low, not_high));
    }
    const FaceVecs t = curve_square(b0, b1);
    const auto not_w_v = hn::AndNot(hn::VecFromMask(Words(), is_zero(e)), one);
    const auto not_w_u = hn::Sub(one, hn::ShiftRight<1>(e));
    // 2^(n-D-1) = N / (2 S0); for a corner's index it is not used.
    const auto scale = power(hn::Sub(word(n == 0 ? 0 : n - 1), hn::Min(D, word(n == 0 ? 0 : n - 1))));
    const auto i = hn::Mul(hn::Add(hn::Add(t.iu, t.iu), not_w_v), scale);
    const auto j = hn::Mul(hn::Add(hn::Add(t.iv, t.iv), not_w_u), scale);
    const auto corner = is_zero(hn::ShiftRight<2>(hn::Add(index, one)));  // index < 3
    const auto side = word(std::uint32_t{1} << n);
    return {hn::IfThenElse(corner, hn::IfThenElseZero(hn::Eq(index, one), side), i),
            hn::IfThenElse(corner, hn::IfThenElseZero(hn::Eq(index, word(2)), side), j)};
  }
  Level n;
};

// Face -> index, and back.

struct CurveFaceIndex {
  explicit CurveFaceIndex(Level) {}
  HWY_INLINE WordVec operator()(WordVec iu, WordVec iv_, WordVec upper) const {
    return curve_number(iu, iv_, hn::Add(hn::Add(iu, iv_), upper));
  }
};

struct RowFaceIndex {
  explicit RowFaceIndex(Level) {}
  HWY_INLINE WordVec operator()(WordVec iu, WordVec iv_, WordVec upper) const {
    const auto row = hn::Add(hn::Add(iu, iv_), upper);
    return hn::Add(hn::Mul(row, row), hn::Add(hn::Add(iv_, iv_), upper));
  }
};

struct UMajorFaceIndex {
  explicit UMajorFaceIndex(Level level)
      : side(std::uint32_t{1} << level), all(static_cast<std::uint32_t>(std::uint64_t{1} << (2 * level))) {}
  HWY_INLINE WordVec operator()(WordVec iu, WordVec iv_, WordVec upper) const {
    const auto left = hn::Sub(word(side), iu);
    return hn::Add(hn::Sub(word(all), hn::Mul(left, left)), hn::Add(hn::Add(iv_, iv_), upper));
  }
  std::uint32_t side, all;  // 4^16 wraps to 0, and the difference back
};

struct CurveFace {
  explicit CurveFace(Level level) : low((std::uint32_t{1} << level) - 1) {}
  HWY_INLINE FaceVecs operator()(WordVec index) const {
    const auto mask = word(low);
    return curve_square(hn::And(iv::gather(index), mask),
                        hn::And(iv::gather(hn::ShiftRight<1>(index)), mask));
  }
  std::uint32_t low;
};

struct RowFace {
  explicit RowFace(Level) {}
  HWY_INLINE FaceVecs operator()(WordVec index) const {
    const auto row = iv::row_of(index), c = hn::Sub(index, hn::Mul(row, row)), upper = hn::And(c, word(1));
    const auto half = hn::ShiftRight<1>(c);
    return {hn::Sub(row, hn::Add(half, upper)), half, upper};
  }
};

struct UMajorFace {
  explicit UMajorFace(Level level)
      : side(std::uint32_t{1} << level), all(static_cast<std::uint32_t>(std::uint64_t{1} << (2 * level))) {}
  HWY_INLINE FaceVecs operator()(WordVec index) const {
    const auto left = hn::Add(iv::row_of(hn::Sub(word(all - 1), index)), word(1));
    const auto c = hn::Sub(index, hn::Sub(word(all), hn::Mul(left, left)));
    return {hn::Sub(word(side), left), hn::ShiftRight<1>(c), hn::And(c, word(1))};
  }
  std::uint32_t side, all;
};

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute
HWY_AFTER_NAMESPACE();

#endif
