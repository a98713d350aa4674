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

#include "impl/index/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::index {
namespace HWY_NAMESPACE {

struct FromBarycentrics {
  Level n;

  WordVec operator()(FloatVec u, FloatVec v) const {
    const GridPoint p = find(u, v, n);
    return curve(square(p.iu, p.iv, p.carry, hn::Set(Ints(), std::int32_t{1} << n)));
  }
};

struct WMinor {
  Level n;

  WordVec operator()(FloatVec u, FloatVec v) const {
    const Words dw;
    const GridPoint p = find(u, v, n);
    const auto N = hn::Set(Ints(), std::int32_t{1} << n), last = hn::Set(Ints(), (std::int32_t{1} << n) - 1);
    const RowPlace place = row_place(p.iu, p.iv, p.carry, p.beyond, N);
    const auto along = hn::Add(place.col, hn::Add(place.row, hn::Sub(place.dia, last)));
    const auto row = hn::BitCast(dw, place.row);
    return hn::Add(hn::Mul(row, row), hn::BitCast(dw, along));
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
  CornerVecs operator()(WordVec index) const {
    const Words dw;
    const auto one = hn::Set(dw, 1);
    const auto row = row_of(index), col = hn::Sub(index, hn::Mul(row, row));
    const auto c = hn::ShiftRight<1>(col), odd = hn::And(col, one), i = hn::Sub(row, c);
    return {i, c, hn::Add(i, hn::Xor(odd, one)), hn::Add(c, odd), hn::Sub(i, odd), hn::Add(c, one)};
  }
};

// Calls `kernel` on whole vectors in place.  The rest goes through buffers, since a vector must not touch memory beyond
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
