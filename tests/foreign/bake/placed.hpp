// A base triangle's place among the texels of a mip.
#pragma once

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

/// A base triangle in the texels of one mip, as seen from texel `origin`, in units of 1/unit texel: the
/// micro-vertex (a, b) lies at start + a along_u + b along_v.
struct Placed {
  Big start[2], along_u[2], along_v[2], unit, margin[2];
  Index origin[2];
  int size_bits;
};

/// Whether a corner lies more than 1000 repeats from the origin.
bool is_far(const mmverify_bake_case_t& c);

Placed place(const mmverify_bake_case_t& c, Index width, Index height, unsigned mip, bool nearest);

}  // namespace mmverify::tests::foreign::bake
