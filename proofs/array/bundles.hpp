// Arrays with geometries for the laws of changes and of files, made from the specification's builds.
#pragma once

#include "proofs/array/cases.hpp"

namespace mmverify::proofs::array {

/// The array and the geometry that the specification builds from a case.
Bundle bundle_of(const BuildCase& c);

/// Any array with any geometries.  It has up to 45 records of maps of levels up to n, or up to 600 of level 0.  Each
/// map has bytes of its own, in any order and with gaps.  None to eight geometries have any encoding and base
/// triangle, and up to 40 triangles each, with special indices and records in any order.  Sample k of a seed is the
/// same everywhere.
Bundle sample_bundle(Level n, std::uint64_t seed, std::uint64_t k);

/// The first difference of two bundles in geometries, triangles or targets, as words for `was` and for `is`.
std::optional<std::pair<std::string, std::string>> resolved_differently(const Bundle& was, const Bundle& is);

}  // namespace mmverify::proofs::array
