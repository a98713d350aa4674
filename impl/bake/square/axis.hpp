// The positions of regions' edges among the centres of texels, along one axis.  Internal to impl/bake.
//
// Positions are whole multiples of 1/D texel, D = 2 side, counted from the centre of texel 0: the edge i of a
// box's `side` regions is at D x + 2 i width - side, the centre of texel k at D k.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::impl::bake::detail {

/// floor(a / b).  Domain: b > 0.
constexpr std::int64_t floor_of(std::int64_t a, std::int64_t b) noexcept {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// A position between the centres of the texels k and k + 1: f / unit of the way, 0 <= f < unit.
struct Between {
  std::int64_t k, f;
};

constexpr Between between(std::int64_t position, std::int64_t unit) noexcept {
  const std::int64_t k = floor_of(position, unit);
  return {k, position - k * unit};
}

struct Axis {
  std::int64_t d;      ///< D, the unit: positions are multiples of 1/D texel
  std::int64_t step;   ///< distance of edges: 2 width
  std::int64_t first;  ///< position of edge 0
  std::int64_t texels;

  std::vector<Between> edges;  ///< edges among the centres: divided once, used in every row

  /// The axis of `side` regions over the texels [begin, begin + size) of `all`.
  Axis(std::uint32_t begin, std::uint32_t size, std::uint32_t all, std::uint32_t side)
      : d(2 * std::int64_t{side}), step(2 * std::int64_t{size}), first(d * begin - side), texels(all) {
    for (std::int64_t i = 0; i <= side; ++i) edges.push_back(between(edge(i), d));
  }

  std::int64_t edge(std::int64_t i) const noexcept { return first + step * i; }
  const Between& at_edge(std::int64_t i) const noexcept { return edges[static_cast<std::size_t>(i)]; }
  /// The texels whose centres lie in region i, less those on its low edge (the edge's own points), are
  /// [centres(i), centres(i + 1)).
  std::int64_t centres(std::int64_t i) const noexcept { return at_edge(i).k + 1; }
  /// The index clamped to the texture's edge.
  std::int64_t wrapped(std::int64_t k) const noexcept { return std::clamp<std::int64_t>(k, 0, texels - 1); }
};

}  // namespace mmverify::impl::bake::detail
