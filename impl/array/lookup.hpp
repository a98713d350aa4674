// A built array as a ray sees it: the state at a point, and the counts of a geometry's references.
#pragma once

#include <optional>

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// The state that a hit of a triangle meets at the barycentrics (u, v) of the second and third vertex: the special
/// index's, else that of micro-triangle index::from_barycentrics(u, v, level) of the triangle's record.
/// None where the part has no such triangle, where its code names no record (target(), outside clusters), and where the
/// record has another format than 1 and 2, a level above 12, or bytes outside the data.  Any u and v; see the index.
/// Memory: none is allocated.
/// Test: impl_array_lookup_test
std::optional<State> state_at(const micromap::Array& array, const Part& part, std::uint64_t triangle, float u,
                              float v) noexcept;

/// The counts of the triangles that refer to records, by level and format, none of them zero: VkMicromapUsageEXT of a
/// geometry.  A geometry that has a slice of an array's indices is a Part with that slice.
/// Errors: std::invalid_argument for a code that names no record, with its triangle.
/// Test: impl_array_lookup_test
std::vector<UsageCount> geometry_counts(std::span<const micromap::Record> records, const Part& part);

}  // namespace mmverify::impl::array
