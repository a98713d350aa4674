// What a run may choose of laws about points.
#pragma once

#include "proofs/engine/option.hpp"

namespace mmverify::proofs::index {

/// Leave out the cells on lines: for who promises nothing there.
inline constexpr Option interiors_only{"those inside micro-triangles only", true};

/// Fixed point in the place of rationals, where a law has both.
inline constexpr Option in_fixed_point_alone{};

}  // namespace mmverify::proofs::index
