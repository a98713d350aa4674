// Builds an array, a geometry's indices and both histograms from the maps of many triangles.
#pragma once

#include <optional>

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// The options of a build.
struct BuildOptions {
  Api api = Api::KHR;
  Encoding encoding = Encoding::u32;
  std::uint32_t base = 0;  ///< the record that index 0 names, at most before.size()
  bool special = true;     ///< a uniform map becomes a special index
  bool share = true;       ///< equal level, format and states share a record
  std::uint32_t bound =
      0;  ///< near-duplicate merging: micro-triangles that may differ; above 0 it shares, too
};

/// The result of a build: the array, the geometry that refers to it, both histograms.
struct Built {
  micromap::Array array;
  Part part;
  std::vector<UsageCount> array_counts;
  std::optional<std::vector<UsageCount>> geometry_counts;  ///< if the API takes them
};

/// Appends a geometry's maps, in their order, to an array that has one record for each map of `before`.
///   With `share`, a map takes the first equal record, from record `base` on.  With bound > 0, a 4-state map without an
///   equal record joins the first record of its level, made by this build, that can be joined.  Where the two differ,
///   the joined record is unknown: an unknown state replaces a known one, and T beside O becomes UO.  UT beside UO
///   cannot be joined, nor can maps whose record would differ from one of them in more than `bound` micro-triangles.
/// Time: linear in the bytes if bound = 0.  Else each map is compared with each record of its level, mostly by the
/// first words alone.
/// Domain: maps as PackedMap has them, levels up to 12, base at most before.size(), an encoding that the API takes; else
/// std::invalid_argument.  An index that the encoding cannot hold: std::length_error, naming the triangle.
/// Law: array.resolves, array.shares, array.merging, array.on_samples
Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps, const BuildOptions& options);

}  // namespace mmverify::impl::array
