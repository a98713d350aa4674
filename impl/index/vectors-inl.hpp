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

// Points are located in signed words: every value fits, and x86 converts only these.
struct Located {
  IntVec iu, iv, row, u_ceil;
};

HWY_INLINE FloatVec clamped(FloatVec x) {
  const Floats d;
  return hn::Min(hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), x), hn::Set(d, 1.0f));
}

// 1 where the mask holds: a mask is all ones, which is -1.
HWY_INLINE IntVec one_if(hn::Mask<Ints> mask) {
  const Ints di;
  return hn::Sub(hn::Zero(di), hn::VecFromMask(di, mask));
}
HWY_INLINE IntVec one_if_float(hn::Mask<Floats> mask) { return one_if(hn::RebindMask(Ints(), mask)); }

// The argument for exactness is the scalar one's.
HWY_INLINE Located locate(FloatVec u, FloatVec v, Level n) {
  const Floats d;
  const Ints di;
  const auto side = hn::Set(d, static_cast<float>(std::int32_t{1} << n));
  const auto last = hn::Set(di, (std::int32_t{1} << n) - 1);
  const auto un = hn::Mul(clamped(u), side), vn = hn::Mul(clamped(v), side);
  const auto iu = hn::ConvertTo(di, un), iv = hn::ConvertTo(di, vn);
  const auto uf = hn::Sub(un, hn::ConvertTo(d, iu)), vf = hn::Sub(vn, hn::ConvertTo(d, iv));
  const auto carry = one_if_float(hn::Ge(hn::Min(uf, vf), hn::Sub(hn::Set(d, 1.0f), hn::Max(uf, vf))));
  const auto row = hn::Min(last, hn::Add(hn::Add(iu, iv), carry));
  return {iu, iv, row, hn::Add(iu, one_if_float(hn::Gt(uf, hn::Zero(d))))};
}

HWY_INLINE WordVec xor_from_above(WordVec x) {
  x = hn::Xor(x, hn::ShiftRight<1>(x));
  x = hn::Xor(x, hn::ShiftRight<2>(x));
  x = hn::Xor(x, hn::ShiftRight<4>(x));
  return hn::Xor(x, hn::ShiftRight<8>(x));
}

template <int shift>
HWY_INLINE WordVec part(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftLeft<shift>(x)), hn::Set(Words(), mask));
}

HWY_INLINE WordVec spread(WordVec x) {
  return part<1>(part<2>(part<4>(part<8>(x, 0x00ff00ff), 0x0f0f0f0f), 0x33333333), 0x55555555);
}

template <int shift>
HWY_INLINE WordVec join(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftRight<shift>(x)), hn::Set(Words(), mask));
}

HWY_INLINE WordVec gather(WordVec x) {
  x = hn::And(x, hn::Set(Words(), 0x55555555));
  return join<8>(join<4>(join<2>(join<1>(x, 0x33333333), 0x0f0f0f0f), 0x00ff00ff), 0x0000ffff);
}

// Root in binary32, put right in whole numbers.  The two halves convert exactly; their sum rounds once and
// the root once more.  Rounding keeps order and the rounded root of a rounded square k^2 is k again, so the
// guess never falls below the row.  Nor can it be two above: the whole error is less than 65536 * 2^-23.
HWY_INLINE WordVec row_of(WordVec index) {
  const Floats d;
  const Ints di;
  const Words dw;
  const auto high = hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<16>(index)));
  const auto low = hn::ConvertTo(d, hn::BitCast(di, hn::And(index, hn::Set(dw, 0xffff))));
  const auto root = hn::Sqrt(hn::Add(hn::Mul(high, hn::Set(d, 65536.0f)), low));
  const auto guess = hn::ConvertTo(di, root);
  const auto row = hn::BitCast(dw, guess);
  // Negative just when the guess is too high.  Its size stays below 2^18, so the sign survives the wrap,
  // even of the square of 65536.
  const auto rest = hn::BitCast(di, hn::Sub(index, hn::Mul(row, row)));
  return hn::BitCast(dw, hn::Sub(guess, one_if(hn::Lt(rest, hn::Zero(di)))));
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::index
HWY_AFTER_NAMESPACE();

#endif
