// A hit's micro-triangle, the indices of its three vertices, the hit's weights, and the RGBA8 value that they
// interpolate.
//
// Each function has two forms, which give the same bits: inline for a single point; for spans, in SIMD chosen at run
// time.
// IEEE arithmetic must be rounded to nearest without contraction (-ffp-contract=off for the inline ones).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/attribute/order.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute {

/// The point's barycentrics on its micro-triangle, in the order of corners_of.
using Weights = std::array<float, 3>;

/// A micro-triangle and the weights of a point there.
struct Located {
  MicroTriangle at;
  Weights weights;
};

/// The micro-triangle that holds (u, v), with Vulkan's rule for ties, and the weights there, by the uniform pattern:
/// with fu = uN - iu, fv = vN - iv and a = 1 - fv,
///   lower (a - fu, fu, fv);  upper (fu - a, 1 - fu, a)
/// Domain: every bit pattern.  u and v are clamped to [0,1] one by one; NaN counts as 0.  level in 0..16, more is 16.
/// For finite u, v >= 0 with u+v <= 1 the micro-triangle is exact, no weight is negative, and none is off by more than
/// 2^-24 at any level: fu and fv are exact, a and 1-fu round once, the differences twice.  Beyond the hypotenuse fu
/// becomes a: the point goes along u to the edge.
/// Source: Color and Attribute Micromaps, 4.1; VK_EXT_opacity_micromap, appendix "Reference Code"; the weights are ours.
/// Law: attribute.weights_on_floats, attribute.triplets_on_floats
inline Located locate(float u, float v, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const index::detail::GridSquare p = index::detail::locate(u, v, n);
  const std::uint32_t last = (std::uint32_t{1} << n) - 1;
  const std::uint32_t iv = std::min(p.iv, last), iu = std::min(p.iu, last - iv);
  const bool upper = p.row != iu + iv;
  const float side = static_cast<float>(std::int32_t{1} << n);
  const float fu = index::detail::clamped(u) * side - static_cast<float>(static_cast<std::int32_t>(iu));
  const float fv = index::detail::clamped(v) * side - static_cast<float>(static_cast<std::int32_t>(iv));
  const float a = 1.0f - fv;
  if (upper) return {{iu, iv, true}, {fu - a, 1.0f - fu, a}};
  const float kept = std::min(fu, a);
  return {{iu, iv, false}, {a - kept, kept, fv}};
}

/// Indices of the three vertices around (u, v): triplet(order, locate(u, v, level).at, level).
/// Law: attribute.triplets_on_floats
inline std::array<std::uint32_t, 3> triplet(VertexOrder order, float u, float v, Level level) noexcept {
  return triplet(order, locate(u, v, level).at, level);
}

/// An RGBA8 value between those of three vertices, channel by channel: floor(w0 c0 + w1 c1 + w2 c2 + 1/2).
/// Units: a value is r | g << 8 | b << 16 | a << 24.  Domain: weights of `locate`.  The sum is off by less than 2^-13.
/// Law: attribute.interpolates_rgba8
inline std::uint32_t mixed_rgba8(const Weights& w, std::uint32_t c0, std::uint32_t c1,
                                 std::uint32_t c2) noexcept {
  std::uint32_t out = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto channel = [shift](std::uint32_t c) {
      return static_cast<float>(static_cast<std::int32_t>(c >> shift & 0xff));
    };
    const float sum = w[0] * channel(c0) + w[1] * channel(c1) + (w[2] * channel(c2) + 0.5f);
    out |= static_cast<std::uint32_t>(static_cast<std::int32_t>(sum)) << shift;
  }
  return out;
}

/// The RGBA8 value at (u, v) of a vertex map.
/// Domain: map has V(level) values in the order; u, v and level as in `locate`.
/// Source: Color and Attribute Micromaps, 4.1, steps 1 to 5.
/// Law: attribute.interpolates_rgba8
inline std::uint32_t interpolated_rgba8(VertexOrder order, std::span<const std::uint32_t> map, float u,
                                        float v, Level level) noexcept {
  const Located p = locate(u, v, level);
  const auto x = triplet(order, p.at, level);
  return mixed_rgba8(p.weights, map[x[0]], map[x[1]], map[x[2]]);
}

/// Weights of many points: weight c of point k is w<c>[k].
struct WeightSpans {
  std::span<float> w0, w1, w2;
};

/// The triplets, and the weights, of the points (u[k], v[k]).
/// Domain: any length, any alignment; all spans have one length, or std::invalid_argument is thrown and nothing is
/// written.  No span of out may overlap another.
/// Law: attribute.triplets_on_floats, attribute.weights_on_floats
void triplets(VertexOrder order, std::span<const float> u, std::span<const float> v, Level level,
              const TripletSpans& out);
void weights(std::span<const float> u, std::span<const float> v, Level level, const WeightSpans& out);

/// The values of many points: out[k] = interpolated_rgba8(order, map, u[k], v[k], level).
/// Domain: as above; map has V(level) values, or std::invalid_argument is thrown.
/// Law: attribute.interpolates_rgba8
void interpolated_rgba8(VertexOrder order, std::span<const std::uint32_t> map, std::span<const float> u,
                        std::span<const float> v, Level level, std::span<std::uint32_t> out);

}  // namespace mmverify::impl::attribute
