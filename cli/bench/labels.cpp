#include "cli/bench/labels.hpp"

#include <algorithm>
#include <cmath>

namespace mmverify::cli {
namespace {

using bench::picture::Panel;
using bench::picture::Point;
using bench::picture::Series;

// Pixels, of the labels' font, measured generously.
constexpr double letter = 7.1, line_height = 15;

/// The places that a label may take beside its mark, the nearest first.
std::vector<Box> places(double x, double y, double text_width) {
  std::vector<Box> all;
  const auto at = [&](double left, double middle) {
    all.push_back({left, left + text_width, middle - line_height / 2, middle + line_height / 2});
  };
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

}  // namespace

std::vector<PlacedLabel> place_labels(const Panel& panel, const Axes& axes, std::vector<Box> taken) {
  std::vector<PlacedLabel> labels;
  for (const Series& series : panel.series)
    for (const Point& point : series.points) {
      const double x = axes.pixel_x(point.x), y = axes.pixel_y(point.y);
      if (series.marks) taken.push_back({x - 7, x + 7, y - 7, y + 7});
      if (!point.label.empty()) labels.push_back({point.label, series.colour, {}, x, y});
    }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const PlacedLabel& a, const PlacedLabel& b) { return a.mark_x < b.mark_x; });
  for (PlacedLabel& label : labels) {
    const double text_width = letter * static_cast<double>(label.text.size());
    for (const Box& box : places(label.mark_x, label.mark_y, text_width)) {
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
