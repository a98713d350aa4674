// VQ4: a codebook of vectors, and the words of its entries.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/foreign/vq/vectors.hpp"

namespace mmverify::tests::foreign::vq {

/// The regions of the four 2x2 of a vector.
inline constexpr std::array<std::uint32_t, 4> minis{0x0033, 0x00cc, 0x3300, 0xcc00};

inline bool one_palette(const Vector& v, std::uint32_t part) {
  return (v.t & part) == 0 || (v.o & part) == 0;
}
inline bool vq4_uniform(const Vector& v) { return v == Vector{} || v.t == 0xffff || v.o == 0xffff; }

/// Whether a generic entry can hold v.
bool generic(const Vector& v);

/// Entries of a codebook by index; nothing where an entry is unused.
using Vq4Book = std::array<std::optional<Vector>, 16>;

/// A book that has all of `vectors`, each generic, if table 2's kinds allow one.
std::optional<Vq4Book> vq4_book(const std::vector<Vector>& vectors);

/// The bits that a block stores for v as the entry of an index.
unsigned vq4_word_of(unsigned index, const Vector& v);

}  // namespace mmverify::tests::foreign::vq
