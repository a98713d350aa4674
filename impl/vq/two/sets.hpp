// Vectors of a VQ2 map as sets of regions, the regions that an entry keeps, and the block of a choice of entries.
// Internal to impl/vq.
#pragma once

#include <array>
#include <cstdint>

#include "impl/vq/two/layout.hpp"
#include "impl/vq/two/search.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq::detail {

/// The number of regions in a set of four.
constexpr std::uint32_t size(std::uint32_t set) noexcept {
  return (set & 1) + (set >> 1 & 1) + (set >> 2 & 1) + (set >> 3 & 1);
}

/// The regions of a vector that are T, and those that are O, a bit each.
struct Sets {
  std::uint32_t t = 0, o = 0;
  bool uniform() const noexcept { return t == 15 || o == 15 || (t | o) == 0; }
};

using Vectors2 = std::array<Sets, 64>;  ///< vector (X, Y) at X + 8Y
Vectors2 vectors_of(const Map2& map);

/// A vector as it is stored in the codebook, before the transform.
Sets stored(std::uint32_t transform, const Sets& v) noexcept;

constexpr std::uint32_t quadrant_of_vector(std::uint32_t vector) noexcept {
  return quadrant(2 * (vector % 8), 2 * (vector / 8));
}

constexpr std::uint32_t set_of(Entry e) noexcept { return e % 14u + 1; }
constexpr bool opaque(Entry e) noexcept { return e >= 14; }

/// The entry that is T, or O, in a set and C elsewhere.  Domain: neither none nor all four.
constexpr Entry entry_of(std::uint32_t set, bool opaque) noexcept {
  return static_cast<Entry>(set - 1 + (opaque ? 14 : 0));
}

/// The number of regions that an entry keeps of a vector as stored in the codebook; 0 if it is not usable.
constexpr std::uint32_t keeps(Entry e, const Sets& v) noexcept {
  return (set_of(e) & ~(opaque(e) ? v.o : v.t)) == 0 ? size(set_of(e)) : 0;
}

/// The block of a choice; each vector takes the entry that keeps most of it.
Encoded2 written(const Vectors2& vectors, const Choice& choice);

}  // namespace mmverify::impl::vq::detail
