// Encoders of square maps, written from the paper, with what a search may leave out.
#pragma once

#include <compare>
#include <cstdint>

#include "tests/foreign/inside/vq.hpp"

namespace mmverify::tests::foreign {

/// Restrictions of a search for a block of 16x16 regions; by default there are none.
struct Search2 {
  bool identity_alone = false;              ///< tries no other transform
  bool shared_in_turn = false;              ///< each shared entry the best beside those before it
  bool own_in_turn = false;                 ///< likewise the second entry of a quadrant
  bool whole_vectors = false;               ///< entries are vectors of the map, not parts of them
  bool mirrored = false;                    ///< takes Reflect X=Y for Reflect X=-Y while it searches
  std::uint32_t quadrant = 4, untried = 8;  ///< the transform that is not tried in that quadrant
  auto operator<=>(const Search2&) const = default;
};

struct Solved2 {
  proofs::vq::Vq2 block;
  std::uint32_t lost = 0;  ///< O and T that became C
};

/// The block that keeps the most O and T of those that are searched.
Solved2 solved(const proofs::vq::Map<proofs::vq::Vq2>& map, const Search2& search);

/// Restrictions of a search for a block of 32x32 regions.
struct Search4 {
  bool identity_alone = false;
  std::uint32_t quadrant = 4, untried = 8;
  std::uint32_t unused_in = 4, unused = 16;  ///< the index that no vector of that quadrant takes
  auto operator<=>(const Search4&) const = default;
};

struct Solved4 {
  proofs::vq::Vq4 block;
  std::uint32_t lost = 0;
};

/// Entries one after the other, each the best beside those before it; and of each quadrant's transforms, one
/// quadrant after the other, the best.
Solved4 solved(const proofs::vq::Map<proofs::vq::Vq4>& map, const Search4& search);

}  // namespace mmverify::tests::foreign
