// The work of FLIP on a piece of a row, in vectors.
#pragma once

#include <array>
#include <cstddef>

#include "scene/flip/filters.hpp"

namespace mmverify::flip::detail {

/// Texels of a piece: a whole number of vectors of any target.
inline constexpr std::size_t piece = 128;

/// The channels of a texel, relative to white: Y, X - Y and Y - Z.
/// FLIP's opponent space is 116 Y - 16, 500 (X - Y), 200 (Y - Z).  Its factors and its offset are left out:
/// filters of sum 1 keep them, and the next step would remove them.
enum Opponent : std::size_t { opponent_y, opponent_xy, opponent_yz, opponents };

/// Two pictures a and b as their middle (a + b)/2 and half their difference (a - b)/2.  Filters are linear,
/// so they may filter these instead, and a small difference is not lost in the rounding of two sums.
enum Part : std::size_t { middle, difference, parts };

/// The results of the filters along x.
enum Filtered : std::size_t {
  spatial_y,
  spatial_xy,
  spatial_yz_wide,
  spatial_yz_narrow,
  smooth_y,
  edge_y,
  point_y,
  filtered
};

struct Filters {
  SpatialFilters spatial;
  FeatureFilters feature;
};

/// Filters a piece along x.  `rows` point to the first texel of the piece; each can be read from -radius to
/// piece + radius.
void filter_along_x(const Filters& filters, const std::array<const float*, opponents>& rows,
                    float (*out)[piece]);

/// The rows of one part around a row, each filtered along x: row k is rows[radius + k], -radius <= k <=
/// radius, for the larger of both radii.
using Window = const float (*const*)[piece];

/// The errors of a piece of a row: the filters along y, then the steps texel by texel.
void errors_of_piece(const Filters& filters, const std::array<Window, parts>& windows, std::size_t radius,
                     float* errors);

}  // namespace mmverify::flip::detail
