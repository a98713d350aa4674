// Arrays with geometries, as the laws of changes and of files take them: made of the specification's builds.
#pragma once

#include "proofs/array/cases.hpp"

namespace mmverify::proofs::array {

/// The array that the specification builds of a case, and its one geometry.
Bundle bundle_of(const BuildCase& c);

/// Any array with any geometries, its numbers drawn one by one: up to 45 records, or 600 of level 0, of maps of levels up to
/// n, each at bytes of its own in any order and with gaps; none to eight geometries, each of any encoding, base triangle and
/// up to 40 triangles, of special indices and of records in any order.  Sample k of a seed is the same everywhere.
Bundle sample_bundle(Level n, std::uint64_t seed, std::uint64_t k);

/// Where two bundles have not as many parts or triangles, or one resolves to something else: what was, and what is.
std::optional<std::pair<std::string, std::string>> resolved_differently(const Bundle& was, const Bundle& is);

}  // namespace mmverify::proofs::array
