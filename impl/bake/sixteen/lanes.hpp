// The micro-vertices, edges and micro-triangles of a node of sixteen, by number.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "impl/index/index.hpp"

namespace mmverify::impl::bake::detail {

struct SixteenLanes {
  using Floats = std::array<float, 16>;
  using Ints = std::array<std::int32_t, 16>;

  Floats vertex_i{}, vertex_j{};      ///< micro-vertex v is at (i, j), the node's sides being 1
  Floats centroid_i{}, centroid_j{};  ///< centroid of micro-triangle k, on the curve
  Floats micro_i{}, micro_j{};        ///< the least i and j of its corners
  std::array<Ints, 3> corner{};       ///< numbers of its micro-vertices
  Ints at_vertex{};                   ///< bit k: micro-triangle k has micro-vertex v
  std::uint32_t turned = 0;           ///< bit k: micro-triangle k is turned, as seen from the node
  /// The 30 edges, and two more of no micro-triangle, to fill vectors.  Bit k: micro-triangle k has the edge; from bit
  /// 16 on, its first corner; from bit 24 on, its direction (SixteenShape); bits 20 to 23 are free.
  std::array<std::int32_t, 32> edges{};

  constexpr SixteenLanes() {
    const auto number = [](std::uint32_t i, std::uint32_t j) {
      return static_cast<std::int32_t>(j * 5 - j * (j - 1) / 2 + i);
    };
    for (std::uint32_t j = 0; j <= 4; ++j)
      for (std::uint32_t i = 0; i + j <= 4; ++i) {
        vertex_i[static_cast<std::size_t>(number(i, j))] = static_cast<float>(i) / 4;
        vertex_j[static_cast<std::size_t>(number(i, j))] = static_cast<float>(j) / 4;
      }
    for (std::uint32_t k = 0; k < 16; ++k) {
      const index::Corners c = index::corners(k, 2);
      std::uint32_t i = 0, j = 0, low_i = 4, low_j = 4;
      for (std::size_t n = 0; n < 3; ++n) {
        corner[n][k] = number(c[n].i, c[n].j);
        at_vertex[static_cast<std::size_t>(corner[n][k])] |= 1 << k;
        i += c[n].i;
        j += c[n].j;
        low_i = std::min(low_i, c[n].i);
        low_j = std::min(low_j, c[n].j);
      }
      micro_i[k] = static_cast<float>(low_i) / 4;
      micro_j[k] = static_cast<float>(low_j) / 4;
      // An upright one has the corners (a, b) (a+1, b) (a, b+1), a turned one (a+1, b) (a, b+1) (a+1, b+1).
      if (i % 3 == 2) turned |= std::uint32_t{1} << k;
      centroid_i[k] = static_cast<float>(i) / 12;
      centroid_j[k] = static_cast<float>(j) / 12;
    }
    std::size_t e = 0;
    const auto edge = [&](std::uint32_t i, std::uint32_t j, std::int32_t to, std::uint32_t direction) {
      std::uint32_t of = static_cast<std::uint32_t>(number(i, j)) << 16 | direction << 24;
      for (std::uint32_t k = 0; k < 16; ++k) {
        const auto has = [&](std::int32_t v) {
          return corner[0][k] == v || corner[1][k] == v || corner[2][k] == v;
        };
        if (has(number(i, j)) && has(to)) of |= std::uint32_t{1} << k;
      }
      edges[e++] = static_cast<std::int32_t>(of);
    };
    for (std::uint32_t j = 0; j < 4; ++j)
      for (std::uint32_t i = 0; i + j < 4; ++i) {
        edge(i, j, number(i + 1, j), 0);
        edge(i, j, number(i, j + 1), 1);
        edge(i + 1, j, number(i, j + 1), 2);
      }
  }
};
inline constexpr SixteenLanes sixteen_lanes;

/// The edges of several micro-triangles, bit e for edge e, from the low and the high byte of the micro-triangles' bits.
struct SixteenEdges {
  std::array<std::uint32_t, 256> low{}, high{};

  constexpr SixteenEdges() {
    for (std::uint32_t byte = 0; byte < 256; ++byte)
      for (std::size_t e = 0; e < 32; ++e) {
        const auto of = static_cast<std::uint32_t>(sixteen_lanes.edges[e]);
        low[byte] |= std::uint32_t{(of & byte) != 0} << e;
        high[byte] |= std::uint32_t{(of >> 8 & byte) != 0} << e;
      }
  }
};
inline constexpr SixteenEdges micro_edges;

}  // namespace mmverify::impl::bake::detail
