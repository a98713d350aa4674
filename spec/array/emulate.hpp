// Emulation of a level that a device does not support, by lossy substitution; and the palettes of DGF.
#pragma once

#include <set>

#include "spec/array/resolve.hpp"
#include "spec/micromap/level.hpp"

namespace mmverify::spec::array {

/// The map at the highest level that the device supports: T for a block of T, O for a block of O, else unknown, by
/// micromap::down() level after level.  A map of that level or below stays the same.
/// Domain: 4-state; else std::invalid_argument.  Source: the KHR slides, "Lossy Micromaps": a driver may so emulate
/// levels above maxOpacity4StateSubdivisionLevel, up to maxOpacityLossy4StateSubdivisionLevel.
inline Map emulated(const Map& map, Level most) {
  if (map.format != Format::four_state)
    throw std::invalid_argument("array::emulated: 4-state alone is lossy");
  Map out = map;
  for (; out.level > most; --out.level) out.states = micromap::down(out.states);
  return out;
}

/// The states that traversal then reads at each micro-triangle of the original level.  Domain: level >= map.level.
inline States seen_at(const Map& map, Level level) {
  States states = map.states;
  for (Level n = map.level; n < level; ++n) states = micromap::up(states);
  return states;
}

/// DGF: the triangles in order, cut into blocks of at most `most` distinct codes; the result is each block's size.  A
/// block is as long as possible, which makes the fewest blocks: any other cut's k-th block ends no later.
inline std::vector<std::uint64_t> blocks(std::span<const std::uint32_t> codes, std::uint64_t most = 7) {
  std::vector<std::uint64_t> sizes;
  std::set<std::uint32_t> palette;
  for (const std::uint32_t c : codes) {
    if (sizes.empty() || (!palette.contains(c) && palette.size() == most)) {
      sizes.push_back(0);
      palette.clear();
    }
    palette.insert(c);
    ++sizes.back();
  }
  return sizes;
}

}  // namespace mmverify::spec::array
