// Many triangles' maps to an array, a geometry's indices, and both histograms.
#pragma once

#include <optional>

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// How maps become an array.
struct BuildOptions {
  Api api = Api::KHR;
  Encoding encoding = Encoding::u32;
  std::uint32_t base = 0;   ///< at most the number of records that are there before
  bool special = true;      ///< a uniform map becomes a special index
  bool share = true;        ///< equal level, format and states share a record
  std::uint32_t bound = 0;  ///< of near-duplicate merging: micro-triangles a triangle; 0: none.  It shares
};

/// What a build gives: the array, the geometry that refers to it, both histograms.
struct Built {
  micromap::Array array;
  Part part;
  std::vector<UsageCount> array_counts;
  std::optional<std::vector<UsageCount>> geometry_counts;  ///< where the API takes them
};

/// Builds a geometry's maps, in their order, behind an array in which each map of `before` has a record of its own.
///   What is equal is shared where that is wanted, the first such record from base on.  With a bound, a 4-state map
///   that has no equal joins the first record of this build and of its level that it can: T and O give way to unknown
///   states, T beside O is UO, UT beside UO cannot be joined, and no triangle may differ from its map in more than
///   `bound` micro-triangles.
/// Time: linear in the bytes without a bound; with one each map is held against each record of its level, most of them
/// by their first words.
/// Domain: maps as PackedMap has them, levels up to 12, base at most before.size(), an encoding that the API takes; else
/// std::invalid_argument.  An index that the encoding cannot hold: std::length_error, naming the triangle.
Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps, const BuildOptions& options);

}  // namespace mmverify::impl::array
