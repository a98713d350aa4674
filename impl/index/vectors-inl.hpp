// Points, bits and roots in vectors, for the kernels of index and attribute.
// Compiled once for each target.
#include <hwy/highway.h>

#include <cstdint>

#include "impl/index/index.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_INDEX_VECTORS_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_INDEX_VECTORS_INL_HPP_
#undef MMVERIFY_IMPL_INDEX_VECTORS_INL_HPP_
#else
#define MMVERIFY_IMPL_INDEX_VECTORS_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::index {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using WordVec = hn::Vec<Words>;

#include "impl/index/lanes-inl.hpp"

// The grid squares (iu, iv) of points, their rows and ceil(uN).
struct GridSquare {
  IntVec iu, iv, row, u_ceil;
};

HWY_INLINE GridSquare locate(FloatVec u, FloatVec v, Level n) {
  const GridPoint p = find(u, v, n);
  const auto N = hn::Set(Ints(), std::int32_t{1} << n);
  return {p.iu, p.iv, row_of(p.iu, p.iv, p.carry, N), hn::Add(p.iu, p.beyond)};
}

template <int shift>
HWY_INLINE WordVec join(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftRight<shift>(x)), hn::Set(Words(), mask));
}

HWY_INLINE WordVec gather(WordVec x) {
  x = hn::And(x, hn::Set(Words(), 0x55555555));
  return join<8>(join<4>(join<2>(join<1>(x, 0x33333333), 0x0f0f0f0f), 0x00ff00ff), 0x0000ffff);
}

// floor(sqrt(index)): the root in binary32, corrected in whole numbers.  The two halves convert exactly; their sum
// rounds once and the root once more.  Rounding is monotonic and the rounded root of a rounded square k^2 is k again,
// so the guess never falls below the row.  Nor can it be two above: the whole error is less than 65536 * 2^-23.
HWY_INLINE WordVec row_of(WordVec index) {
  const Floats d;
  const Ints di;
  const Words dw;
  const auto high = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<16>(index)));
  const auto low = hn::ConvertTo(d, hn::BitCast(di, hn::And(index, hn::Set(dw, 0xffff))));
  const auto root = hn::Sqrt(hn::Add(hn::Mul(high, hn::Set(d, 65536.0f)), low));
  const auto guess = hn::ConvertTo(di, root);
  const auto row = hn::BitCast(dw, guess);
  // The rest is negative just if the guess is too high.  Its size stays below 2^18, so the sign survives the wrap, even
  // for the square of 65536.
  const auto rest = hn::BitCast(di, hn::Sub(index, hn::Mul(row, row)));
  return hn::BitCast(dw, hn::Sub(guess, one_if(hn::Lt(rest, hn::Zero(di)))));
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::index
HWY_AFTER_NAMESPACE();

#endif
