// Vectors of a VQ4 map as sets of regions, and the block of a codebook of such sets.  Internal to impl/vq.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq::detail {

/// A vector as a set: bit k of the low half if region k is T, of the high half if it is O; else the region is C.  An
/// entry is usable for a vector if it is a subset, and keeps as many regions as it has.
using Set4 = std::uint32_t;

inline constexpr Set4 all_t = 0xffff, all_o = 0xffff0000;
constexpr bool uniform(Set4 v) noexcept { return v == 0 || v == all_t || v == all_o; }
constexpr std::uint32_t size(Set4 v) noexcept { return static_cast<std::uint32_t>(std::popcount(v)); }

using Vectors4 = std::array<Set4, 64>;  ///< vector (X, Y) at X + 8Y
Vectors4 vectors_of(const Map4& map);

constexpr std::uint32_t quadrant_of_vector4(std::uint32_t vector) noexcept {
  return (vector % 8 < 4 ? 0 : 1) + (vector < 32 ? 2 : 0);
}

/// The set without O beside T in an aligned 2x2: the lesser part becomes C, O if they are equal, for no code has both.
Set4 codable(Set4 v) noexcept;

/// A vector as it is stored in the codebook, for each of the transforms.
std::array<Set4, 8> stored(Set4 v) noexcept;

/// The transforms of TR, BL and BR from a number below 512, three bits each.
using Transforms = std::array<std::uint8_t, 4>;
constexpr Transforms combination(std::uint32_t number) noexcept {
  return {0, static_cast<std::uint8_t>(number & 7), static_cast<std::uint8_t>(number >> 3 & 7),
          static_cast<std::uint8_t>(number >> 6 & 7)};
}

inline constexpr std::size_t stored_entries = 13;  ///< the indices 3..15 are stored

/// The entry of each of the indices 3..15, such that its code can write it (table 2); -1 none.  Nothing if there are
/// more than 13 entries, or more that need a generic code than there are such codes.
using Places = std::array<std::int8_t, stored_entries>;
std::optional<Places> places_of(const std::vector<Set4>& entries);

/// While the entries have no places, makes one of them smaller: the one, and in the way, after which the sources keep
/// most.  Domain: at most 13 entries, each codable.
void fit_places(std::vector<Set4>& entries, std::span<const Set4> sources);

/// The block of a codebook with places; each vector takes the entry that keeps most of it.
Encoded4 written(const Vectors4& vectors, const Transforms& transforms, const std::vector<Set4>& entries);

}  // namespace mmverify::impl::vq::detail
