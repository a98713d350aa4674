// The maps of a geometry in an array.  Internal to this project: array::build() is the library's way to build.
#pragma once

#include "impl/micromap/array.hpp"

namespace mmverify::impl::micromap {

/// The input of a geometry's build beside the array.
struct Geometry {
  Bytes indices;                   ///< one code a triangle, tightly packed, little-endian
  std::vector<UsageCount> counts;  ///< after indirection, special indices left out
};

/// The options of append().
struct Options {
  Encoding encoding = Encoding::u32;
  std::uint32_t base_triangle = 0;
  bool deduplicate = true;  ///< equal level, format and states share one record
  bool special = true;      ///< a uniform map becomes a special index and needs no record
};

/// Adds a geometry's maps, in their order, to an array; linear in all bytes.
/// With `special`, a uniform map becomes a special index.  With `deduplicate`, another map takes the first equal record
/// from base_triangle on.  Else it gets a new record at the end, its bytes at the end of the data.  A triangle's index
/// is its record less base_triangle.
/// Domain: base_triangle at most the number of records, maps as PackedMap has them, else std::invalid_argument.  An
/// index that the encoding cannot hold, or data beyond 2^32 bytes: std::length_error, naming the triangle.  After an
/// error the array is as before.
/// Law: micromap.build, micromap.build_on_samples
Geometry append(Array& array, std::span<const PackedMap> maps, const Options& options);

}  // namespace mmverify::impl::micromap
