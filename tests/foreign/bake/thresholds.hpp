// The thresholds of alpha, and the texels compared with one.
#pragma once

#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/field.hpp"
#include "tests/foreign/bake/numbers.hpp"
#include "tests/foreign/bake/texels.hpp"

namespace mmverify::tests::foreign::bake {

/// A comparison of alpha: factors x texel against numerator / denominator.
struct Threshold {
  Big numerator, denominator;
  bool is_mask = false;
};

/// MASK: one for all.  BLEND: O, T, and the centroid's.  Texels are counted in `full`ths.
std::vector<Threshold> thresholds_of(const mmverify_bake_case_t& c, const Big& full);

/// The texels against one threshold.
Field field_of(const mmverify_bake_case_t& c, const Stored& s, const Threshold& t, bool at_centroid);

}  // namespace mmverify::tests::foreign::bake
