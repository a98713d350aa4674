// The vectors of a map that an encoder looks at, and the indices that may stand for them.
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/foreign/vq/blocks.hpp"

namespace mmverify::tests::foreign::vq {

/// A vector: a bit a region in `t` for T, in `o` for O; C where neither has one.
struct Vector {
  std::uint32_t t = 0, o = 0;
  auto operator<=>(const Vector&) const = default;
};

/// The regions that a vector keeps if `e` stands for it; -1 if it may not, as e says O or T where v does not.
inline int kept(const Vector& e, const Vector& v) {
  if ((e.t & ~v.t) != 0 || (e.o & ~v.o) != 0) return -1;
  return std::popcount(e.t | e.o);
}

/// Regions in which two vectors differ.
inline int distance(const Vector& a, const Vector& b) { return std::popcount((a.t ^ b.t) | (a.o ^ b.o)); }

/// A map's vectors by place, X + 8 Y, as they show.
using Vectors = std::array<Vector, 64>;
Vectors vectors_of(const Format& f, const std::uint8_t* map);

/// An index, the vector that it stands for, as it is stored.
struct Choice {
  unsigned index;
  Vector vector;
};

/// The index that keeps most of v, the first of several: uniform T, C, O, then entries.
unsigned best_choice(const Format& f, const std::vector<Choice>& entries, const Vector& v, int quadrant);

/// The places of a quadrant, X + 8 Y.
std::array<std::size_t, 16> places_of(int quadrant);

/// A quadrant's vectors under each transform.
using Turned = std::array<std::array<std::array<Vector, 16>, 8>, 4>;
Turned turned(const Format& f, const Vectors& shown);

using Transforms = std::array<unsigned, 4>;
void write_transforms(const Format& f, std::uint8_t* block, Transforms transforms, bool exact);
void write_index(const Format& f, std::uint8_t* block, std::size_t place, unsigned index);

}  // namespace mmverify::tests::foreign::vq
