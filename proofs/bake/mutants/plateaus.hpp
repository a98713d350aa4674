// A baker that looks at the rows about the middle of a micro-triangle alone.
#pragma once

#include <cmath>

#include "proofs/bake/domains/threshold.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::bake {

/// The corners of a micro-triangle in texels, rounded.
inline std::array<std::array<double, 2>, 3> rounded_corners(const Case& one, Level n, std::uint32_t index) {
  std::array<std::array<double, 2>, 3> corners{};
  std::size_t k = 0;
  for (const auto& corner : spec::index::corners(index, n)) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double from = one.uv[axis], e = one.uv[2 + axis] - from, f = one.uv[4 + axis] - from;
      corners[k][axis] = (axis == 0 ? one.width : one.height) *
                         (from + std::ldexp(corner.i * e + corner.j * f, -static_cast<int>(n)));
    }
    ++k;
  }
  return corners;
}

/// Calls an unknown micro-triangle opaque, if its box has no texel below the cutoff within four rows of its middle
/// corner.
inline void looks_at_middle_rows(const Case& one, Level n, std::vector<State>& states) {
  constexpr double rows = 4;
  const double cutoff = static_cast<double>(one.cutoff.numerator) / one.cutoff.denominator;
  const auto is_below = [&](double i, double j) {
    const auto x = spec::bake::wrapped(one.wrap_u, static_cast<std::int64_t>(i), one.width),
               y = spec::bake::wrapped(one.wrap_v, static_cast<std::int64_t>(j), one.height);
    const std::uint32_t stored = x && y ? one.alpha[*x + std::size_t{one.width} * *y] : one.border;
    return value_of(one.texel, stored) * one.factor * one.vertex_factor < cutoff;
  };
  for (std::uint32_t k = 0; k < states.size(); ++k) {
    auto corners = rounded_corners(one, n, k);
    const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
    std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
    if (one.blend || !spec::micromap::unknown(states[k]) || corners[2][1] - corners[0][1] < 2 * rows)
      continue;
    bool below = false;
    for (double j = std::floor(corners[1][1] - rows); j <= corners[1][1] + rows; ++j)
      for (double i = std::floor(left); i <= right; ++i) below = below || is_below(i, j);
    if (!below) states[k] = State::O;
  }
}

}  // namespace mmverify::proofs::bake
