#include "scene/flip/filters.hpp"

#include <cmath>
#include <numbers>

#include "scene/flip/colour.hpp"

namespace mmverify::flip::detail {
namespace {

constexpr double square(double x) { return x * x; }

/// The sum of a filter's weights on both sides.
double sum_of(const std::vector<double>& half) {
  double sum = half[0];
  for (std::size_t k = 1; k < half.size(); ++k) sum += 2 * half[k];
  return sum;
}

Half divided(const std::vector<double>& half, double by) {
  Half result;
  for (const double w : half) result.push_back(static_cast<float>(w / by));
  return result;
}

}  // namespace

SpatialFilters spatial_filters(double pixels_per_degree) {
  constexpr double pi = std::numbers::pi;
  constexpr double widest = 0.04;
  SpatialFilters all;
  all.radius = static_cast<std::size_t>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
  const auto gaussian = [&](double factor, double b) {
    std::vector<double> half;
    for (std::size_t k = 0; k <= all.radius; ++k)
      half.push_back(factor * std::exp(-square(pi * static_cast<double>(k) / pixels_per_degree) / b));
    return half;
  };
  const auto alone = [&](double b) {
    const std::vector<double> half = gaussian(1, b);
    return divided(half, sum_of(half));
  };
  all.luminance = alone(0.0047);
  all.red_green = alone(0.0053);
  const auto factor = [](double a, double b) { return std::sqrt(a * std::sqrt(pi / b)); };
  const std::vector<double> wide = gaussian(factor(34.1, widest), widest),
                            narrow = gaussian(factor(13.5, 0.025), 0.025);
  const double both = std::sqrt(square(sum_of(wide)) + square(sum_of(narrow)));
  all.blue_yellow[0] = divided(wide, both);
  all.blue_yellow[1] = divided(narrow, both);
  return all;
}

FeatureFilters feature_filters(double pixels_per_degree) {
  const double s = feature_width / 2 * pixels_per_degree;
  FeatureFilters all;
  all.radius = static_cast<std::size_t>(std::ceil(3 * s));
  std::vector<double> smooth, edge, point;
  double side = 0, positive = 0, negative = 0;
  for (std::size_t k = 0; k <= all.radius; ++k) {
    const double x = static_cast<double>(k), g = std::exp(-square(x / s) / 2);
    smooth.push_back(g);
    edge.push_back(x * g);
    point.push_back((square(x / s) - 1) * g);
    side += edge.back();
    (point.back() > 0 ? positive : negative) += (k == 0 ? 1 : 2) * point.back();
  }
  for (double& w : point) w /= w > 0 ? positive : -negative;
  all.smooth = divided(smooth, sum_of(smooth));
  all.edge = divided(edge, side);
  all.point = divided(point, 1);
  return all;
}

}  // namespace mmverify::flip::detail
