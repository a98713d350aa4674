// The law on floats of topic tree, and the laws that it runs beside.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::tree {

/// A lookup by barycentrics on binary32 numbers that are hard to place.
Law point_exact_on_floats_law();

/// The law, which asks for states at points k/4N: its domain says so, and the law on floats is its companion.
Law with_points_on_floats(Law law);

}  // namespace mmverify::proofs::tree
