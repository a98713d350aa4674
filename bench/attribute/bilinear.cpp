// Bilinear sampling of many points, compiled once for each SIMD target and chosen at run time.
#include <cstddef>

#include "bench/attribute/obvious.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/attribute/bilinear.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using WordVec = hn::Vec<Words>;

template <int shift>
HWY_INLINE FloatVec channel(WordVec c) {
  const auto byte =
      shift == 24 ? hn::ShiftRight<24>(c) : hn::And(hn::ShiftRight<shift>(c), hn::Set(Words(), 0xffu));
  return hn::ConvertTo(Floats(), hn::BitCast(Ints(), byte));
}

struct Mixed {
  FloatVec w0, w1, w2, w3;
  WordVec c0, c1, c2, c3;

  template <int shift>
  HWY_INLINE WordVec part() const {
    const auto near = hn::Add(hn::Mul(w0, channel<shift>(c0)), hn::Mul(w1, channel<shift>(c1)));
    const auto far = hn::Add(hn::Mul(w2, channel<shift>(c2)),
                             hn::Add(hn::Mul(w3, channel<shift>(c3)), hn::Set(Floats(), 0.5f)));
    return hn::ShiftLeft<shift>(hn::BitCast(Words(), hn::ConvertTo(Ints(), hn::Add(near, far))));
  }
};

HWY_INLINE WordVec sampled(const std::uint32_t* texels, std::uint32_t level, FloatVec u, FloatVec v) {
  const Floats d;
  const Ints di;
  const Words dw;
  const auto last = hn::Set(di, (std::int32_t{1} << level) - 1), one = hn::Set(di, 1);
  const auto side = hn::Set(d, static_cast<float>(1 << level)), half = hn::Set(d, 0.5f);
  const auto x = hn::Add(hn::Mul(u, side), half), y = hn::Add(hn::Mul(v, side), half);
  const auto right = hn::ConvertTo(di, x), below = hn::ConvertTo(di, y);
  const auto f = hn::Sub(x, hn::ConvertTo(d, right)), g = hn::Sub(y, hn::ConvertTo(d, below));
  const auto x1 = hn::And(right, last), x0 = hn::And(hn::Sub(right, one), last);
  const auto row = [&](IntVec at)
                       HWY_ATTR { return hn::ShiftLeftSame(hn::And(at, last), static_cast<int>(level)); };
  const auto y1 = row(below), y0 = row(hn::Sub(below, one));
  Mixed m;
  m.w3 = hn::Mul(f, g);
  m.w2 = hn::Sub(g, m.w3);
  m.w1 = hn::Sub(f, m.w3);
  m.w0 = hn::Sub(hn::Sub(hn::Set(d, 1.0f), f), m.w2);
  m.c0 = hn::GatherIndex(dw, texels, hn::Add(y0, x0));
  m.c1 = hn::GatherIndex(dw, texels, hn::Add(y0, x1));
  m.c2 = hn::GatherIndex(dw, texels, hn::Add(y1, x0));
  m.c3 = hn::GatherIndex(dw, texels, hn::Add(y1, x1));
  return hn::Or(hn::Or(m.part<0>(), m.part<8>()), hn::Or(m.part<16>(), m.part<24>()));
}

/// Samples whole vectors of points, and returns the number of sampled points.
std::size_t run_bilinear(const std::uint32_t* texels, std::uint32_t level, const float* u, const float* v,
                         std::uint32_t* out, std::size_t count) {
  const Floats d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t k = 0;
  for (; count - k >= lanes; k += lanes)
    hn::StoreU(sampled(texels, level, hn::LoadU(d, u + k), hn::LoadU(d, v + k)), Words(), out + k);
  return k;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::bench {
namespace {

HWY_EXPORT(run_bilinear);

}  // namespace

void bilinear_rgba8(const SquareTexture& t, std::span<const float> u, std::span<const float> v,
                    std::span<std::uint32_t> out) {
  std::size_t k = HWY_DYNAMIC_DISPATCH(run_bilinear)(t.texels.data(), t.level, u.data(), v.data(), out.data(),
                                                     out.size());
  for (; k < out.size(); ++k) out[k] = bilinear_rgba8(t, u[k], v[k]);
}

}  // namespace mmverify::bench
#endif  // HWY_ONCE
