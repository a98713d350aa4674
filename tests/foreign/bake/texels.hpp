// The texels as they are stored.
#pragma once

#include <cstddef>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

/// All texels of a mip, and the border, as whole numbers over one scale: numerators and the power of two.
struct Stored {
  std::vector<Big> values;
  int exponent = 0;  // alpha = value 2^exponent / full
  Big full = 1;
};

Stored read_texels(const mmverify_bake_case_t& c, const unsigned char* from, std::size_t count,
                   bool later_mip);

}  // namespace mmverify::tests::foreign::bake
