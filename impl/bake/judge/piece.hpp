// Alpha along a piece of an edge within one cell, in binary64.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "impl/bake/plane/spot.hpp"

namespace mmverify::impl::bake::detail {

/// g from the least to the greatest of what has been seen.
struct Extremes {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  void take(double g) noexcept {
    least = std::min(least, g);
    greatest = std::max(greatest, g);
  }
};

/// g = a + fx b + fy (c + fx d) - threshold on one cell.
template <class Texel>
struct CellAlpha {
  double a, b, c, d;

  CellAlpha(const Texel* texels, std::size_t pitch, std::int32_t i, std::int32_t j,
            double threshold) noexcept {
    const Texel* const row = texels + static_cast<std::size_t>(j) * pitch + static_cast<std::size_t>(i);
    const double right = row[1], below = row[pitch], across = row[pitch + 1];
    a = row[0];
    b = right - a;
    c = below - a;
    d = across - below - b;
    a -= threshold;
  }
  double at(double fx, double fy) const noexcept { return a + fx * b + fy * (c + fx * d); }
};

/// An edge from P to Q.
class Edge {
 public:
  Edge(Spot p, Spot q) noexcept : p_(p), dx_(q.x - p.x), dy_(q.y - p.y) {
    // Finite: see BilinearFilter::walked.
    per_x_ = dx_ == 0 ? 0 : 1 / dx_;
    per_y_ = dy_ == 0 ? 0 : 1 / dy_;
  }

  /// What of it is in cell (i, j), grown by `more`, which is among those that it may meet.
  template <class Texel>
  void piece(const CellAlpha<Texel>& cell, std::int32_t i, std::int32_t j, double more,
             Extremes& seen) const noexcept {
    double from = 0, to = 1;
    const auto cut = [&from, &to, more](double p, double d, double per, double low) {
      if (d == 0) {
        if (p < low - more || p > low + 1 + more) to = -1;
        return;
      }
      const double one = (low - more - p) * per, other = (low + 1 + more - p) * per;
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    };
    const double x = i, y = j;
    cut(p_.x, dx_, per_x_, x);
    cut(p_.y, dy_, per_y_, y);
    if (!(from <= to)) return;
    const auto at = [&](double t) { return cell.at(p_.x + t * dx_ - x, p_.y + t * dy_ - y); };
    const double v = at(from), w = at(to);
    seen.take(v);
    seen.take(w);
    const double K = cell.d * (dx_ * (to - from)) * (dy_ * (to - from)), rise = w - v;
    if (std::fabs(rise) < std::fabs(K)) {
      const double s = 0.5 - rise / (2 * K);
      seen.take(v + rise * s - K * s * (1 - s));
    }
  }

 private:
  Spot p_;
  double dx_, dy_, per_x_, per_y_;
};

}  // namespace mmverify::impl::bake::detail
