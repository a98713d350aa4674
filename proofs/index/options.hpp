// Options of a run for laws about points.
#pragma once

#include "proofs/engine/option.hpp"

namespace mmverify::proofs::index {

/// Runs no cell that lies on a grid line: for a subject that promises nothing about points there.
inline constexpr Option interiors_only{"those inside micro-triangles only", true};

/// Fixed point instead of rationals, in laws that have both.
inline constexpr Option in_fixed_point_alone{};

}  // namespace mmverify::proofs::index
