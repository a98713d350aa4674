// Bird indices of levels 1 to 8 in words of 16 bits, two vertices in a lane of 32.  Compiled once for each target.
#include <hwy/highway.h>

#include <cstdint>

#include "impl/attribute/order-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_ATTRIBUTE_BIRD_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_ATTRIBUTE_BIRD_INL_HPP_
#undef MMVERIFY_IMPL_ATTRIBUTE_BIRD_INL_HPP_
#else
#define MMVERIFY_IMPL_ATTRIBUTE_BIRD_INL_HPP_
#endif

// A single lane cannot be taken apart.
#if HWY_TARGET != HWY_SCALAR

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute {
namespace HWY_NAMESPACE {

using Halves = hn::Repartition<std::uint16_t, Words>;
using Bytes = hn::Repartition<std::uint8_t, Words>;
using HalfVec = hn::Vec<Halves>;
using ByteVec = hn::Vec<Bytes>;

HWY_INLINE HalfVec half(std::uint16_t x) { return hn::Set(Halves(), x); }

/// Two vectors of words below 2^16 in one, and back.
HWY_INLINE HalfVec paired(WordVec a, WordVec b) {
  return hn::BitCast(Halves(), hn::Or(a, hn::ShiftLeft<16>(b)));
}
HWY_INLINE WordVec first_of(HalfVec x) { return hn::And(hn::BitCast(Words(), x), word(0xffff)); }
HWY_INLINE WordVec second_of(HalfVec x) { return hn::ShiftRight<16>(hn::BitCast(Words(), x)); }

/// bird_index: let s be the lowest set bit of i, j and N/2, and f = 2^(15-s).  The division by 2^(s+1) is the upper
/// half of the product with f, and bit s is the highest bit of the lower half.
/// At the corners s is that of N/2, and i and j are even after the shift by s: (x + b)/2, the number of upright
/// micro-triangles of level 1 before theirs, is then 0, 1 and 2, the corner's own index.
class BirdHalves {
 public:
  static constexpr Level least_level = 1, last_level = 8;

  explicit BirdHalves(Level level) : side_(static_cast<std::uint16_t>(std::uint32_t{1} << level)) {}

  HWY_INLINE HalfVec operator()(HalfVec i, HalfVec j) const {
    const auto f = factor(hn::Or(hn::Or(i, j), half(side_ >> 1)));
    const auto a = hn::MulHigh(i, f), b = hn::MulHigh(j, f), M = hn::MulHigh(half(side_), f);
    // Each is all ones or zero.
    const auto i_odd = spread_sign(hn::Mul(i, f)), j_odd = spread_sign(hn::Mul(j, f));
    const auto row = hn::Add(a, b), b0 = hn::Xor(a, row), t = hn::And(hn::Xor(a, b), b0);
    const auto b1 = hn::Or(hn::AndNot(b0, hn::Xor(xor_from_above(t), a)), t);
    const auto twice_before = hn::Add(hn::Or(spread(b0, spread_), spread(b1, doubled_)), b);
    const auto count = hn::ShiftRight<1>(hn::Mul(M, hn::Add(M, half(3))));  // V(m-1) - 1
    const auto e = hn::Add(hn::Sub(j_odd, i_odd), half(2));                 // e + 1
    const auto rest = hn::Add(hn::Add(twice_before, count), e);
    return hn::Add(hn::ShiftRight<1>(twice_before), hn::And(rest, hn::Or(i_odd, j_odd)));
  }

 private:
  static HWY_INLINE HalfVec spread_sign(HalfVec x) {
    const hn::RebindToSigned<Halves> d;
    return hn::BitCast(Halves(), hn::ShiftRight<15>(hn::BitCast(d, x)));
  }
  static HWY_INLINE HalfVec looked_up(ByteVec table, HalfVec index) {
    return hn::BitCast(Halves(), hn::TableLookupBytes(table, hn::BitCast(Bytes(), index)));
  }
  /// x ^ x >> 1 ^ x >> 2 ^ ...  Domain: lanes below 2^8.
  static HWY_INLINE HalfVec xor_from_above(HalfVec x) {
    x = hn::Xor(x, hn::ShiftRight<1>(x));
    x = hn::Xor(x, hn::ShiftRight<2>(x));
    return hn::Xor(x, hn::ShiftRight<4>(x));
  }
  static HWY_INLINE HalfVec spread(HalfVec x, ByteVec table) {
    return looked_up(table, hn::And(hn::Or(x, hn::ShiftLeft<4>(x)), half(0x0f0f)));
  }
  /// 2^(15-s), s the lowest bit of the lower byte, which is not 0.
  HWY_INLINE HalfVec factor(HalfVec any) const {
    const auto low = hn::ShiftLeft<8>(hn::And(any, half(0x0f)));
    const auto high = hn::And(hn::ShiftLeft<4>(any), half(0x0f00));
    const auto of_low = hn::BitCast(Bytes(), looked_up(lowest_, low)),
               of_high = hn::BitCast(Bytes(), looked_up(lowest_above_, high));
    return hn::BitCast(Halves(), hn::Max(of_low, of_high));
  }

  static HWY_INLINE ByteVec table(const std::uint8_t (&bytes)[16]) { return hn::LoadDup128(Bytes(), bytes); }

  // Tables by a nibble: 2^7 and 2^3 shifted down by its lowest bit; its bits at even places, and at odd ones.
  alignas(16) static constexpr std::uint8_t
      lowest_bytes[16] = {0, 128, 64, 128, 32, 128, 64, 128, 16, 128, 64, 128, 32, 128, 64, 128},
      lowest_above_bytes[16] = {0, 8, 4, 8, 2, 8, 4, 8, 1, 8, 4, 8, 2, 8, 4, 8},
      spread_bytes[16] = {0, 1, 4, 5, 16, 17, 20, 21, 64, 65, 68, 69, 80, 81, 84, 85},
      doubled_bytes[16] = {0, 2, 8, 10, 32, 34, 40, 42, 128, 130, 136, 138, 160, 162, 168, 170};
  std::uint16_t side_;
  ByteVec lowest_ = table(lowest_bytes), lowest_above_ = table(lowest_above_bytes),
          spread_ = table(spread_bytes), doubled_ = table(doubled_bytes);
};

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute
HWY_AFTER_NAMESPACE();

#endif  // HWY_TARGET

#endif
