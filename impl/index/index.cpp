// The span functions of impl/index/index.hpp, compiled once for each SIMD target and chosen at run time.
#include "impl/index/index.hpp"

#include <cstddef>
#include <cstring>
#include <stdexcept>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/index/index.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

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

FloatVec clamped(FloatVec x) {
  const Floats d;
  return hn::Min(hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), x), hn::Set(d, 1.0f));
}

// 1 where the mask holds: a mask is all ones, which is -1.
IntVec one_if(hn::Mask<Ints> mask) {
  const Ints di;
  return hn::Sub(hn::Zero(di), hn::VecFromMask(di, mask));
}
IntVec one_if_float(hn::Mask<Floats> mask) { return one_if(hn::RebindMask(Ints(), mask)); }

// The argument for exactness is the scalar one's.
Located locate(FloatVec u, FloatVec v, Level n) {
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

WordVec xor_from_above(WordVec x) {
  x = hn::Xor(x, hn::ShiftRight<1>(x));
  x = hn::Xor(x, hn::ShiftRight<2>(x));
  x = hn::Xor(x, hn::ShiftRight<4>(x));
  return hn::Xor(x, hn::ShiftRight<8>(x));
}

template <int shift>
WordVec part(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftLeft<shift>(x)), hn::Set(Words(), mask));
}

WordVec spread(WordVec x) {
  return part<1>(part<2>(part<4>(part<8>(x, 0x00ff00ff), 0x0f0f0f0f), 0x33333333), 0x55555555);
}

template <int shift>
WordVec join(WordVec x, std::uint32_t mask) {
  return hn::And(hn::Or(x, hn::ShiftRight<shift>(x)), hn::Set(Words(), mask));
}

WordVec gather(WordVec x) {
  x = hn::And(x, hn::Set(Words(), 0x55555555));
  return join<8>(join<4>(join<2>(join<1>(x, 0x33333333), 0x0f0f0f0f), 0x00ff00ff), 0x0000ffff);
}

struct FromBarycentrics {
  Level n;

  WordVec operator()(FloatVec u, FloatVec v) const {
    const Ints di;
    const Words dw;
    const Located p = locate(u, v, n);
    const auto last = hn::Set(di, (std::int32_t{1} << n) - 1);
    const auto iv = hn::Min(p.iv, last);
    const auto i = hn::BitCast(dw, hn::Min(p.iu, hn::Sub(last, iv)));
    const auto b0 = hn::Xor(i, hn::BitCast(dw, p.row));
    const auto t = hn::And(hn::Xor(i, hn::BitCast(dw, iv)), b0);
    const auto b1 = hn::Or(hn::AndNot(b0, hn::Xor(xor_from_above(t), i)), t);
    return hn::Or(spread(b0), hn::ShiftLeft<1>(spread(b1)));
  }
};

struct WMinor {
  Level n;

  WordVec operator()(FloatVec u, FloatVec v) const {
    const Ints di;
    const Words dw;
    const Located p = locate(u, v, n);
    const auto last = hn::Set(di, (std::int32_t{1} << n) - 1);
    const auto side = hn::Set(di, std::int32_t{1} << n);
    const auto col = hn::Min(p.row, p.iv), dia = hn::Min(last, hn::Sub(side, p.u_ceil));
    const auto in_row = hn::Add(col, hn::Add(p.row, hn::Sub(dia, last)));
    const auto row = hn::BitCast(dw, p.row);
    return hn::Add(hn::Mul(row, row), hn::BitCast(dw, in_row));
  }
};

struct CornerVecs {
  WordVec i0, j0, i1, j1, i2, j2;
};

struct CurveCorners {
  Level n;

  CornerVecs operator()(WordVec index) const {
    const Words dw;
    const auto low = hn::Set(dw, (std::uint32_t{1} << n) - 1), one = hn::Set(dw, 1);
    const auto b0 = hn::And(gather(index), low), b1 = hn::And(gather(hn::ShiftRight<1>(index)), low);
    const auto t = hn::And(b0, b1), f = xor_from_above(t), m = xor_from_above(hn::AndNot(b1, b0));
    const auto inverted = hn::ShiftRight<1>(m);
    const auto iu = hn::Or(hn::And(b0, inverted), hn::AndNot(b0, hn::Xor(b1, f))), iv = hn::Xor(inverted, t);
    const auto f0 = hn::And(f, one), m0 = hn::And(m, one);
    const auto j01 = hn::Add(iv, m0);
    return {hn::Add(iu, f0),
            j01,
            hn::Add(iu, hn::Xor(f0, one)),
            j01,
            hn::Add(iu, m0),
            hn::Add(iv, hn::Xor(m0, one))};
  }
};

struct RowCorners {
  // Root in binary32, put right in whole numbers.  The two halves convert exactly; their sum rounds once and
  // the root once more.  Rounding keeps order and the rounded root of a rounded square k^2 is k again, so the
  // guess never falls below the row.  Nor can it be two above: the whole error is less than 65536 * 2^-23.
  WordVec row_of(WordVec index) const {
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

  CornerVecs operator()(WordVec index) const {
    const Words dw;
    const auto one = hn::Set(dw, 1);
    const auto row = row_of(index), col = hn::Sub(index, hn::Mul(row, row));
    const auto c = hn::ShiftRight<1>(col), odd = hn::And(col, one), i = hn::Sub(row, c);
    return {i, c, hn::Add(i, hn::Xor(odd, one)), hn::Add(c, odd), hn::Sub(i, odd), hn::Add(c, one)};
  }
};

// Whole vectors in place; what is left over goes through buffers, as a vector must not touch memory beyond
// the spans.
template <class Kernel>
void each_point(const float* u, const float* v, std::uint32_t* out, std::size_t count, Kernel kernel) {
  const Floats d;
  const Words dw;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t k = 0;
  for (; count - k >= lanes; k += lanes)
    hn::StoreU(kernel(hn::LoadU(d, u + k), hn::LoadU(d, v + k)), dw, out + k);
  if (k == count) return;
  const std::size_t bytes = (count - k) * sizeof(float);
  HWY_ALIGN float u_left[hn::MaxLanes(d)] = {}, v_left[hn::MaxLanes(d)] = {};
  HWY_ALIGN std::uint32_t out_left[hn::MaxLanes(dw)];
  std::memcpy(u_left, u + k, bytes);
  std::memcpy(v_left, v + k, bytes);
  hn::Store(kernel(hn::Load(d, u_left), hn::Load(d, v_left)), dw, out_left);
  std::memcpy(out + k, out_left, bytes);
}

template <class Kernel>
void each_index(const std::uint32_t* index, const CornerSpans& out, std::size_t count, Kernel kernel) {
  const Words dw;
  const std::size_t lanes = hn::Lanes(dw);
  std::size_t k = 0;
  for (; count - k >= lanes; k += lanes) {
    const CornerVecs c = kernel(hn::LoadU(dw, index + k));
    hn::StoreU(c.i0, dw, out.i0.data() + k);
    hn::StoreU(c.j0, dw, out.j0.data() + k);
    hn::StoreU(c.i1, dw, out.i1.data() + k);
    hn::StoreU(c.j1, dw, out.j1.data() + k);
    hn::StoreU(c.i2, dw, out.i2.data() + k);
    hn::StoreU(c.j2, dw, out.j2.data() + k);
  }
  if (k == count) return;
  const std::size_t bytes = (count - k) * sizeof(std::uint32_t);
  HWY_ALIGN std::uint32_t left[hn::MaxLanes(dw)] = {};
  std::memcpy(left, index + k, bytes);
  const CornerVecs c = kernel(hn::Load(dw, left));
  const auto store = [&](WordVec x, std::span<std::uint32_t> to) HWY_ATTR {
    hn::Store(x, dw, left);
    std::memcpy(to.data() + k, left, bytes);
  };
  store(c.i0, out.i0);
  store(c.j0, out.j0);
  store(c.i1, out.i1);
  store(c.j1, out.j1);
  store(c.i2, out.i2);
  store(c.j2, out.j2);
}

void run_from_barycentrics(const float* u, const float* v, std::uint32_t* out, std::size_t count, Level n) {
  each_point(u, v, out, count, FromBarycentrics{n});
}

void run_w_minor(const float* u, const float* v, std::uint32_t* out, std::size_t count, Level n) {
  each_point(u, v, out, count, WMinor{n});
}

void run_corners(const std::uint32_t* index, const CornerSpans& out, std::size_t count, Level n) {
  each_index(index, out, count, CurveCorners{n});
}

void run_w_minor_corners(const std::uint32_t* index, const CornerSpans& out, std::size_t count) {
  each_index(index, out, count, RowCorners{});
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::index
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::index {
namespace {

HWY_EXPORT(run_from_barycentrics);
HWY_EXPORT(run_w_minor);
HWY_EXPORT(run_corners);
HWY_EXPORT(run_w_minor_corners);

void require_one_length(const char* message, std::size_t length, std::initializer_list<std::size_t> others) {
  for (const std::size_t other : others)
    if (other != length) throw std::invalid_argument(message);
}

}  // namespace

void from_barycentrics(std::span<const float> u, std::span<const float> v, Level level,
                       std::span<std::uint32_t> out) {
  require_one_length("index::from_barycentrics: u, v and out differ in length", out.size(),
                     {u.size(), v.size()});
  HWY_DYNAMIC_DISPATCH(run_from_barycentrics)
  (u.data(), v.data(), out.data(), out.size(), std::min(level, max_level));
}

void w_minor(std::span<const float> u, std::span<const float> v, Level level, std::span<std::uint32_t> out) {
  require_one_length("index::w_minor: u, v and out differ in length", out.size(), {u.size(), v.size()});
  HWY_DYNAMIC_DISPATCH(run_w_minor)
  (u.data(), v.data(), out.data(), out.size(), std::min(level, max_level));
}

void corners(std::span<const std::uint32_t> index, Level level, const CornerSpans& out) {
  require_one_length(
      "index::corners: index and the spans of out differ in length", index.size(),
      {out.i0.size(), out.j0.size(), out.i1.size(), out.j1.size(), out.i2.size(), out.j2.size()});
  HWY_DYNAMIC_DISPATCH(run_corners)(index.data(), out, index.size(), std::min(level, max_level));
}

void w_minor_corners(std::span<const std::uint32_t> index, const CornerSpans& out) {
  require_one_length(
      "index::w_minor_corners: index and the spans of out differ in length", index.size(),
      {out.i0.size(), out.j0.size(), out.i1.size(), out.j1.size(), out.i2.size(), out.j2.size()});
  HWY_DYNAMIC_DISPATCH(run_w_minor_corners)(index.data(), out, index.size());
}

}  // namespace mmverify::impl::index
#endif  // HWY_ONCE
