// Alpha at the corners and centroids of a node's four children, in vectors of binary64.  Internal to impl/bake.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl::bake::detail {

/// Places of samples: the six corners of a node's children, p0 p01 p02 p1 p12 p2, then the children's centroids.
struct FourPlaces {
  static constexpr std::size_t centroids = 6, count = 10, room = 16;
  alignas(64) std::array<double, room> x{}, y{};
};
/// The places of each child's corners, in its order.
inline constexpr std::array<std::array<std::size_t, 3>, 4> four_corners{
    {{0, 1, 2}, {2, 4, 1}, {1, 3, 4}, {4, 2, 5}}};
/// The places of each child's corners and centroid, a bit each.
inline constexpr std::array<std::uint32_t, 4> four_places = [] {
  std::array<std::uint32_t, 4> bits{};
  for (std::size_t c = 0; c < 4; ++c) {
    bits[c] = 1u << (FourPlaces::centroids + c);
    for (const std::size_t corner : four_corners[c]) bits[c] |= 1u << corner;
  }
  return bits;
}();

/// The texels about places, and how g is judged; impl/bake/judge/filter.hpp defines g and its bound.
struct FourWindow {
  const void* texels;  ///< the texel (left, top); 4 bytes from each texel of the window on can be read
  std::int32_t pitch;
  double left, top;
  double threshold, gap, lean, bound;
};

/// g at each place; and a bit for each place where it proves a mark, and where its lean is certain, and to opaque.
struct FourSamples {
  alignas(64) std::array<double, FourPlaces::room> g;
  std::uint32_t below = 0, opaque = 0, leans = 0, leans_to_opaque = 0;
};

/// Takes the samples as BilinearFilter::g() does, with the same roundings or fewer.
/// Texel: std::uint8_t or std::uint16_t.
/// Domain: a window of less than 2^31 bytes holds the four texels about each place.
/// Test: impl_bake_cells_test
template <class Texel>
FourSamples sampled(const FourWindow& window, const FourPlaces& places);

}  // namespace mmverify::impl::bake::detail
