// The micro-vertices, edges and micro-triangles of a node of sixteen, by number.  Internal to impl/bake*.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "impl/index.hpp"

namespace mmverify::impl::bake::detail {

struct SixteenLanes {
  using Floats = std::array<float, 16>;
  using Ints = std::array<std::int32_t, 16>;

  Floats vertex_i{}, vertex_j{};           ///< micro-vertex v is at (i, j), of 1
  Floats centroid_i{}, centroid_j{};       ///< of micro-triangle k, on the curve
  std::array<Ints, 3> corner{};            ///< its micro-vertices
  Ints at_vertex{};                        ///< bit k: micro-vertex v is micro-triangle k's
  std::array<std::int32_t, 32> at_edge{};  ///< bit k: edge e is
  std::uint32_t turned = 0;                ///< bit k: micro-triangle k is, as seen from the node
  /// Edge e is between these micro-vertices; there are 30, and two more, of no length, to fill vectors.
  std::array<std::int32_t, 32> from{}, to{};

  constexpr SixteenLanes() {
    const auto number = [](std::uint32_t i, std::uint32_t j) {
      return static_cast<std::int32_t>(j * 5 - j * (j - 1) / 2 + i);
    };
    std::size_t e = 0;
    const auto edge = [&](std::int32_t a, std::int32_t b) {
      from[e] = a;
      to[e++] = b;
    };
    for (std::uint32_t j = 0; j <= 4; ++j)
      for (std::uint32_t i = 0; i + j <= 4; ++i) {
        vertex_i[static_cast<std::size_t>(number(i, j))] = static_cast<float>(i) / 4;
        vertex_j[static_cast<std::size_t>(number(i, j))] = static_cast<float>(j) / 4;
        if (i + j == 4) continue;
        edge(number(i, j), number(i + 1, j));
        edge(number(i, j), number(i, j + 1));
        edge(number(i + 1, j), number(i, j + 1));
      }
    for (std::uint32_t k = 0; k < 16; ++k) {
      const index::Corners c = index::corners(k, 2);
      std::uint32_t i = 0, j = 0;
      for (std::size_t n = 0; n < 3; ++n) {
        corner[n][k] = number(c[n].i, c[n].j);
        at_vertex[static_cast<std::size_t>(corner[n][k])] |= 1 << k;
        i += c[n].i;
        j += c[n].j;
      }
      // Of (a, b) (a+1, b) (a, b+1), or of (a+1, b) (a, b+1) (a+1, b+1).
      if (i % 3 == 2) turned |= std::uint32_t{1} << k;
      centroid_i[k] = static_cast<float>(i) / 12;
      centroid_j[k] = static_cast<float>(j) / 12;
      const auto has = [&](std::int32_t v) {
        return corner[0][k] == v || corner[1][k] == v || corner[2][k] == v;
      };
      for (e = 0; e < 30; ++e)
        if (has(from[e]) && has(to[e])) at_edge[e] |= 1 << k;
    }
  }
};
inline constexpr SixteenLanes sixteen_lanes;

}  // namespace mmverify::impl::bake::detail
