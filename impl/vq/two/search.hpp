// The search for the best codebook of VQ2.  Internal to impl/vq.
//
// An entry keeps a set of regions as T or as O, and has C elsewhere.  It is usable for a source vector if that set lies
// within the vector's own T or O, and keeps as many regions as it has.  Of several usable entries the vector takes the
// one that keeps most.  With 16 vectors a quadrant, "entry e keeps at least j regions of vector k", j = 1, 2, 3, is a
// set of 48 bits, and a codebook keeps as many regions as the union of its entries' sets has bits.  So the two own
// entries of a quadrant bring no more than the two greatest single gains over the shared ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::impl::vq::detail {

/// The number of entries: 14 sets of regions, neither none nor all four, as T; and the same as O.
inline constexpr std::size_t entries = 28;  // check-magic: 28 == 2 * (2 ** 4 - 2)
using Entry = std::uint8_t;

/// The regions that each entry keeps in a quadrant under a transform, as a set of bits.
using Kept = std::array<std::uint64_t, entries>;

struct Sources {
  std::array<std::array<Kept, 8>, 4> kept;   ///< by quadrant and transform; TL has the identity alone
  std::vector<Entry> useful;                 ///< entries that keep anything anywhere; at least one
  std::array<std::uint32_t, 4> of_quadrant;  ///< its regions, kept without loss
  std::uint32_t all;                         ///< their sum
};

struct Choice {
  std::array<Entry, 3> shared{};
  std::array<std::array<Entry, 2>, 4> own{};
  std::array<std::uint8_t, 4> transform{};
  std::uint32_t kept = 0;
};

/// A choice that keeps as many regions as any.
Choice best_choice(const Sources& sources);

}  // namespace mmverify::impl::vq::detail
