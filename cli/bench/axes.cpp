#include "cli/bench/axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmverify::cli {
namespace {

using bench::picture::Axis;
using bench::picture::Panel;
using bench::picture::Point;
using bench::picture::Series;

// Marks at a smaller distance, in pixels, cover one another.
constexpr double mark = 13;

double power_of_ten(double x, bool up) {
  const double exponent = std::log10(x);
  return std::pow(10.0, up ? std::ceil(exponent) : std::floor(exponent));
}

/// Room at either end of an axis, so that no mark lies on the frame.
constexpr double log_room = 1.1, linear_room = 0.06;

Scale scale_of(const Axis& axis, const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  bool zero = false;
  for (const double value : values) {
    zero = zero || value == 0;
    if (axis.logarithmic && value == 0) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) least = most = 1;
  if (!axis.logarithmic) {
    const double room = most > least ? linear_room * (most - least) : 1;
    return {axis.least.value_or(least - room), axis.most.value_or(most + room), false};
  }
  if (axis.least) least = std::min(least, *axis.least);
  Scale scale{axis.least && !zero ? least : power_of_ten(least / log_room, false),
              axis.most ? std::max(*axis.most, most) : power_of_ten(most * log_room, true), true};
  if (zero) {
    // The line for 0 is one decade below any value, with room below it for stacked marks.
    scale.none = power_of_ten(least, false) / 10;
    scale.least = scale.none / 30;
  }
  return scale;
}

}  // namespace

double Scale::place(double value) const {
  if (!logarithmic) return (value - least) / (most - least);
  return std::log((value == 0 ? none : value) / least) / std::log(most / least);
}

double Scale::value(double place) const {
  return logarithmic ? least * std::pow(most / least, place) : least + place * (most - least);
}

Axes axes_of(const Panel& panel, const Box& frame) {
  std::vector<double> x, y;
  for (const Series& series : panel.series)
    for (const Point& point : series.points) {
      x.push_back(point.x);
      y.push_back(point.y);
    }
  for (const auto& threshold : panel.thresholds) y.push_back(threshold.y);
  return {frame, scale_of(panel.x, x), scale_of(panel.y, y)};
}

Panel placed(Panel panel, const Axes& axes) {
  if (!axes.y.logarithmic || axes.y.none == 0) return panel;
  std::vector<Point*> stacked;
  for (Series& series : panel.series)
    for (Point& point : series.points)
      if (point.y == 0) stacked.push_back(&point);
  std::stable_sort(stacked.begin(), stacked.end(),
                   [](const Point* a, const Point* b) { return a->x < b->x; });
  // Height has no meaning on that line.
  const double step = mark / (axes.frame.bottom - axes.frame.top);
  for (std::size_t k = 0; k < stacked.size(); ++k) {
    double place = axes.y.place(axes.y.none);
    for (std::size_t other = 0; other < k; ++other)
      if (std::abs(axes.pixel_x(stacked[k]->x) - axes.pixel_x(stacked[other]->x)) < mark &&
          std::abs(place - axes.y.place(stacked[other]->y)) < 0.99 * step)
        place = axes.y.place(stacked[other]->y) + step;
    stacked[k]->y = axes.y.value(place);
  }
  return panel;
}

}  // namespace mmverify::cli
