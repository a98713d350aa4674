// The law that a figure follows from level to level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace mmverify::bench {

/// A figure at a level.
struct LevelValue {
  std::uint32_t level;
  double value;
};

/// A straight line through points, and its distance from them.
struct Line {
  double slope = 0, intercept = 0;
  double residual = 0;  ///< root of the mean squared difference, in units of y
};

enum class GrowthLaw : std::uint8_t {
  none,         ///< no value above zero
  too_few,      ///< above zero on fewer than three levels, too few for a line
  flat,         ///< less than a factor of two over the whole range
  exponential,  ///< value = 2^(intercept + slope level)
  power,        ///< value = 2^intercept level^slope
};

struct Growth {
  GrowthLaw law = GrowthLaw::none;
  std::size_t levels = 0;             ///< the number of levels that the lines fit
  std::uint32_t first = 0, last = 0;  ///< the first and last of them
  Line exponential;                   ///< log2(value) against level
  Line power;                         ///< log2(value) against log2(level)
};

/// Fits lines by least squares to log2(value), against level and against log2(level).  A law that grows or
/// shrinks is the one with the smaller residual; a power law only if the last level is at least four times
/// the first.
/// Domain: at most one value a level.  Values of zero and level 0 are left out, since they have no logarithm.
Growth fit_growth(std::span<const LevelValue> values);

/// "doubles each level", "x1.41 each level", "as level^2.0", "flat", "none found" or "too few to fit".
std::string to_string(const Growth& growth);

}  // namespace mmverify::bench
