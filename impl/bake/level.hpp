// The highest useful level of a triangle on a texture.
#pragma once

#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake {

/// A level, and whether a limit made it coarser.
struct UsefulLevel {
  std::uint32_t level = 0;
  bool limited = false;  ///< the useful level is above the limit
  friend constexpr bool operator==(const UsefulLevel&, const UsefulLevel&) = default;
};

/// The highest useful level: the smallest at which no edge of a micro-triangle is longer than a texel,
///   min { n : 4^n >= max |e|^2 },  e over the three edges in texels; at most min(max_bake_level, limit)
/// Exact: floats decide where their error bound lets them, else whole numbers.  Memory: none is allocated.
/// Domain: finite coordinates; width and height in 1..16384.
/// Source: succinct opacity micromaps, 3.1.1, equation (1).  It prints the quotient as >= 1 and its logarithm as <= n;
/// this is the reading that fits the text above it.
/// Test: impl_bake_level_test
UsefulLevel useful_level(const BaseTriangle& uv, std::uint32_t width, std::uint32_t height,
                         std::uint32_t limit = max_bake_level) noexcept;

}  // namespace mmverify::impl::bake
