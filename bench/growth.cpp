#include "bench/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace mmverify::bench {
namespace {

// Over less than two octaves of levels the two laws look alike, and noise would choose.
constexpr std::uint32_t least_spread = 4;

// A slope within 0.15 of 1 counts as doubling: 2^0.15 is a factor between 1.8 and 2.2.
constexpr double near_doubling = 0.15;

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t k = 0; k < x.size(); ++k) mean_x += x[k] / n, mean_y += y[k] / n;
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  Line line;
  line.slope = xy / xx;
  line.intercept = mean_y - line.slope * mean_x;
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    squares += std::pow(y[k] - (line.intercept + line.slope * x[k]), 2);
  line.residual = std::sqrt(squares / n);
  return line;
}

}  // namespace

Growth fit_growth(std::span<const LevelValue> values) {
  std::vector<double> levels, log_levels, logs;
  Growth growth;
  for (const auto& [level, value] : values) {
    if (level == 0 || !(value > 0)) continue;
    levels.push_back(level);
    log_levels.push_back(std::log2(level));
    logs.push_back(std::log2(value));
  }
  growth.levels = levels.size();
  if (levels.empty()) return growth;
  const auto [first, last] = std::minmax_element(levels.begin(), levels.end());
  growth.first = static_cast<std::uint32_t>(*first);
  growth.last = static_cast<std::uint32_t>(*last);
  growth.law = GrowthLaw::too_few;
  if (levels.size() < 3) return growth;
  growth.exponential = fit_line(levels, logs);
  growth.power = fit_line(log_levels, logs);
  const bool wide = growth.last >= least_spread * growth.first;
  if (std::abs(growth.exponential.slope) * (*last - *first) < 1)
    growth.law = GrowthLaw::flat;
  else if (wide && growth.power.residual < growth.exponential.residual)
    growth.law = GrowthLaw::power;
  else
    growth.law = GrowthLaw::exponential;
  return growth;
}

std::string to_string(const Growth& growth) {
  std::array<char, 64> text{};
  const double slope = growth.exponential.slope;
  switch (growth.law) {
    case GrowthLaw::none: return "none found";
    case GrowthLaw::too_few: return "too few to fit";
    case GrowthLaw::flat: return "flat";
    case GrowthLaw::exponential:
      if (std::abs(slope - 1) < near_doubling) return "doubles each level";
      if (std::abs(slope + 1) < near_doubling) return "halves each level";
      std::snprintf(text.data(), text.size(), "x%.2f each level", std::exp2(slope));
      return text.data();
    case GrowthLaw::power: break;
  }
  std::snprintf(text.data(), text.size(), "as level^%.1f", growth.power.slope);
  return text.data();
}

}  // namespace mmverify::bench
