// Arrays with geometries, as the laws of changes and of files take them: made of the specification's builds.
#pragma once

#include "proofs/array/cases.hpp"

namespace mmverify::proofs::array {

/// The array that the specification builds of a case, and its one geometry.
Bundle bundle_of(const BuildCase& c);

/// Where two bundles have not as many parts or triangles, or one resolves to something else: what was, and what is.
std::optional<std::pair<std::string, std::string>> resolved_differently(const Bundle& was, const Bundle& is);

}  // namespace mmverify::proofs::array
