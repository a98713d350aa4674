// A case's properties in words: what a diagnosis counts by.
#pragma once

#include <string>
#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

struct Property {
  const char* of;     ///< "filter"
  std::string value;  ///< "nearest"
};

/// Filter, addressing along u and v, sizes, signs of texture coordinates, kind of triangle, texels, alpha mode, mips,
/// factors and margin, the same ones in the same order of every case.
std::vector<Property> properties_of(const Case& one, Level n);

}  // namespace mmverify::proofs::bake
