// Attribute micromaps: the levels of a mesh's triangles, so that neighbours differ by one at most.
//
// Each triangle wants a level, the lowest that keeps its error.  Edges allow a step of one (decimation), so a triangle
// raises those around it, one less with each edge crossed:
//   level(t) = max over s of wanted(s) - distance(s, t),   the distance in edges crossed
// The result is the least graded one that is nowhere below the wanted levels.
// Source: Color and Attribute Micromaps, 3.2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "spec/number.hpp"

namespace mmverify::spec::attribute {

/// The neighbours of a triangle with vertices 0, 1, 2 across edge 0-1, 1-2 and 2-0, or no_neighbour.
inline constexpr std::int32_t no_neighbour = -1;
using Neighbours = std::array<std::int32_t, 3>;

/// The level(t) of each triangle.  Domain: as many triangles as wanted levels; mutual neighbours.
/// It takes all shortest paths (Floyd, Algorithm 97), which suits reading and small meshes.
inline std::vector<Level> graded(const std::vector<Level>& wanted,
                                 const std::vector<Neighbours>& neighbours) {
  const std::size_t n = wanted.size();
  constexpr std::uint32_t far = std::numeric_limits<std::uint32_t>::max() / 2;
  std::vector<std::uint32_t> distances(n * n, far);
  const auto distance = [&](std::size_t s, std::size_t t) -> std::uint32_t& { return distances[s * n + t]; };
  for (std::size_t t = 0; t < n; ++t) {
    distance(t, t) = 0;
    for (const std::int32_t s : neighbours[t])
      if (s >= 0 && static_cast<std::size_t>(s) != t) distance(t, static_cast<std::size_t>(s)) = 1;
  }
  for (std::size_t via = 0; via < n; ++via)
    for (std::size_t s = 0; s < n; ++s)
      for (std::size_t t = 0; t < n; ++t)
        distance(s, t) = std::min(distance(s, t), distance(s, via) + distance(via, t));
  std::vector<Level> levels(n, 0);
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t s = 0; s < n; ++s)
      if (wanted[s] > distance(s, t)) levels[t] = std::max(levels[t], wanted[s] - distance(s, t));
  return levels;
}

/// The edges to decimate: bit k if the neighbour across edge k has one level less.
inline std::uint8_t decimated_edges(const std::vector<Level>& levels, const Neighbours& neighbours,
                                    std::size_t t) {
  std::uint8_t flags = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (neighbours[k] >= 0 && levels[static_cast<std::size_t>(neighbours[k])] + 1 == levels[t])
      flags = static_cast<std::uint8_t>(flags | 1u << k);
  return flags;
}

}  // namespace mmverify::spec::attribute
