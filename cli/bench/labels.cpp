#include "cli/bench/labels.hpp"

#include <algorithm>
#include <cmath>

namespace mmverify::cli {
namespace {

using bench::picture::Panel;
using bench::picture::Point;
using bench::picture::Series;

// Size of the labels' font in pixels, rounded up.
constexpr double letter = 7.1, line_height = 15;

double width_of(const std::string& text) { return letter * static_cast<double>(text.size()); }

/// Places for a label beside its mark, the nearest first.
std::vector<Box> places(const std::string& text, double x, double y) {
  std::vector<Box> all;
  const double text_width = width_of(text);
  const auto at = [&](double left, double middle) { all.push_back(label_box(text, left, middle)); };
  for (int ring = 0; ring < 12; ++ring) {
    const double away = ring * line_height;
    for (const double dy : {-away, away}) {
      at(x + 11, y + dy);
      at(x - 11 - text_width, y + dy);
      at(x - text_width / 2, y + dy + (dy < 0 ? -1 : 1) * line_height);
    }
  }
  return all;
}

bool inside(const Box& box, const Box& frame) {
  return box.left > frame.left + 4 && box.right < frame.right - 4 && box.top > frame.top + 2 &&
         box.bottom < frame.bottom - 2;
}

/// Adds boxes along the lines of a series.
void take_lines(const Series& series, const Axes& axes, std::vector<Box>& taken) {
  constexpr double step = 6;
  for (std::size_t k = 1; series.joined && k < series.points.size(); ++k) {
    const Point &from = series.points[k - 1], &to = series.points[k];
    const double x = axes.pixel_x(from.x), y = axes.pixel_y(from.y);
    const double dx = axes.pixel_x(to.x) - x, dy = axes.pixel_y(to.y) - y;
    const int steps = static_cast<int>(std::hypot(dx, dy) / step) + 1;
    for (int j = 0; j <= steps; ++j) {
      const double along = static_cast<double>(j) / steps;
      taken.push_back({x + along * dx - 1, x + along * dx + 1, y + along * dy - 1, y + along * dy + 1});
    }
  }
}

}  // namespace

Box label_box(const std::string& text, double left, double middle) {
  return {left, left + width_of(text), middle - line_height / 2, middle + line_height / 2};
}

std::vector<PlacedLabel> place_labels(const Panel& panel, const Axes& axes, std::vector<Box> taken) {
  std::vector<PlacedLabel> labels;
  for (const Series& series : panel.series) {
    take_lines(series, axes, taken);
    for (const Point& point : series.points) {
      const double x = axes.pixel_x(point.x), y = axes.pixel_y(point.y);
      if (series.marks) taken.push_back({x - 7, x + 7, y - 7, y + 7});
      if (!point.label.empty()) labels.push_back({point.label, series.colour, {}, x, y});
    }
  }
  // A label goes to the right of its mark if it can, so of two marks side by side the right one is placed
  // first.
  std::stable_sort(labels.begin(), labels.end(),
                   [](const PlacedLabel& a, const PlacedLabel& b) { return a.mark_x > b.mark_x; });
  for (PlacedLabel& label : labels) {
    for (const Box& box : places(label.text, label.mark_x, label.mark_y)) {
      label.box = box;
      if (inside(box, axes.frame) &&
          std::none_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(box); }))
        break;
    }
    taken.push_back(label.box);
    label.away = std::abs((label.box.top + label.box.bottom) / 2 - label.mark_y) > line_height;
  }
  return labels;
}

}  // namespace mmverify::cli
