// The parts of a triangle that lie in each texel, in binary64.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mmverify::bench {

struct Point2 {
  double x, y;
};

/// Calls visit(x, y) for each texel of a triangle's box.
template <class Visit>
void each_texel(const std::array<Point2, 3>& p, Visit visit) {
  const auto ends = [&](double Point2::*axis) { return std::minmax({p[0].*axis, p[1].*axis, p[2].*axis}); };
  const auto [left, right] = ends(&Point2::x);
  const auto [top, bottom] = ends(&Point2::y);
  for (auto y = static_cast<std::int64_t>(std::floor(top)); y <= static_cast<std::int64_t>(bottom); ++y)
    for (auto x = static_cast<std::int64_t>(std::floor(left)); x <= static_cast<std::int64_t>(right); ++x)
      visit(x, y);
}

class Clipping {
 public:
  /// Calls visit(x, y, area) for each texel whose part of the triangle has an area; the areas are doubled.
  template <class Visit>
  void each_area(const std::array<Point2, 3>& p, Visit visit) {
    each_texel(p, [&](std::int64_t x, std::int64_t y) {
      polygon_.assign(p.begin(), p.end());
      const auto left = static_cast<double>(x), top = static_cast<double>(y);
      cut(&Point2::x, left, 1);
      cut(&Point2::x, left + 1, -1);
      cut(&Point2::y, top, 1);
      cut(&Point2::y, top + 1, -1);
      double area = 0;
      for (std::size_t k = 2; k < polygon_.size(); ++k)
        area += (polygon_[k - 1].x - polygon_[0].x) * (polygon_[k].y - polygon_[0].y) -
                (polygon_[k - 1].y - polygon_[0].y) * (polygon_[k].x - polygon_[0].x);
      if (area != 0) visit(x, y, std::fabs(area));
    });
  }

 private:
  /// Cuts the polygon down to the part with sign (axis - at) >= 0.
  void cut(double Point2::*axis, double at, double sign) {
    room_.clear();
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const Point2 &p = polygon_[k], &q = polygon_[(k + 1) % polygon_.size()];
      const double h = sign * (p.*axis - at), next = sign * (q.*axis - at);
      if (h >= 0) room_.push_back(p);
      if ((h > 0 && next < 0) || (h < 0 && next > 0)) {
        const double f = h / (h - next);
        room_.push_back({p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)});
      }
    }
    polygon_.swap(room_);
  }

  std::vector<Point2> polygon_ = {}, room_ = {};
};

}  // namespace mmverify::bench
