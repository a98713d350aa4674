// The sides of the cutoff that a closed triangle is on, in binary64, with a bound on every error: where it
// cannot tell, it says so.  Internal to impl/bake*.
//
// Corners are within `delta` of the true ones along either axis.  A point computed on the triangle (its
// corners, and where its sides cross lines) is within 2 delta of a point of the true triangle, since it lies
// between two corners up to a rounding; it may lie elsewhere along the side than the true crossing, but not
// off it.
//   a witness    a computed point whose g = 255 (alpha - cutoff) is beyond the bound E: the true point near
//   by
//                is on that side, as alpha changes by at most 1 a texel along either axis;
//   a proof      that all g on the part of the triangle within a cell is beyond E: the part is taken within
//   the
//                cell grown by eta, far more than delta, so that what is left out is none of the cell's.
//                On the grown cell the cell's own g is judged, whose extremes are at the corners and at the
//                sides' standstills; as a witness it may differ from alpha by what 2 eta make.
// E = 2^12 delta + 2^-36: 4 delta times 255 a texel and axis, and 2^-53 of 255 times the handful of
// operations, many times over.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "impl/bake_sides.hpp"

namespace mmverify::impl::bake::detail {

struct Spot {
  double x, y;
};

/// floor, without a call where the processor has no instruction for it.  Domain: |x| < 2^62.
inline std::int64_t floored(double x) noexcept {
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

class Filter {
 public:
  Filter(const Sides& sides, double delta)
      : sides_(sides),
        delta_(delta),
        eta_(std::max(0x1p-28, 16 * delta)),
        bound_(0x1p12 * delta + 0x1p-36),
        witness_bound_(bound_ + 0x1p12 * eta_) {}

  /// Where coordinates are too large for binary64, nothing is certain.
  bool usable() const noexcept { return witness_bound_ < 0.25; }
  double delta() const noexcept { return delta_; }

  /// 255 (alpha - cutoff).
  double g(Spot p) const noexcept {
    const std::int64_t i = floored(p.x), j = floored(p.y);
    const double fx = p.x - static_cast<double>(i), fy = p.y - static_cast<double>(j);
    const Sides::Four f = sides_.four(i, j);
    const double top = f.a + fx * (f.right - f.a), under = f.below + fx * (f.across - f.below);
    return top + fy * (under - top) - sides_.threshold;
  }
  /// The side that g proves; none if it is too close.
  Marks side(double g) const noexcept { return g > bound_ ? opaque : g < -bound_ ? below : Marks{0}; }

  /// The sides, if certain; none if not.  `seen`: what is known already.
  Marks sides(const std::array<Spot, 3>& p, Marks seen) const noexcept {
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    const std::int64_t first = floored(low - delta_), last = floored(high + delta_);
    Marks possible = 0;
    bool mixed_rows = false;
    for (std::int64_t j = first; j <= last; ++j) {
      const Run cells = run(p, static_cast<double>(j), static_cast<double>(j + 1));
      if (cells.empty) continue;
      const Marks row = sides_.of(floored(cells.from), floored(cells.to) + 1, j, j + 1);
      possible = static_cast<Marks>(possible | row);
      mixed_rows = mixed_rows || row == both;
      if (row == both && sides_.clearance > bound_) {
        seen = static_cast<Marks>(seen | centres(p, j));
        if (seen == both) return both;
      }
    }
    if (!mixed_rows && possible != both) return possible;
    possible = 0;
    for (std::int64_t j = first; j <= last; ++j) {
      const Run cells = run(p, static_cast<double>(j), static_cast<double>(j + 1));
      if (cells.empty) continue;
      const std::int64_t from = floored(cells.from), to = floored(cells.to);
      const Marks row = sides_.of(from, to + 1, j, j + 1);
      if (row != both) {
        possible = static_cast<Marks>(possible | row);
        continue;
      }
      for (std::int64_t i = from; i <= to; ++i) {
        const Sides::Four four = sides_.four(i, j);
        const Marks texels = sides_.of(four);
        if (texels != both) {
          possible = static_cast<Marks>(possible | texels);
          continue;
        }
        part(p, four, i, j, possible, seen);
        if (seen == both) return both;
      }
    }
    return possible == both ? Marks{0} : possible;
  }

 private:
  struct Run {
    double from = 0, to = 0;
    bool empty = true;
  };

  /// x of what lies between two levels of y, both and the run grown by eta.
  Run run(const std::array<Spot, 3>& p, double low, double high) const noexcept {
    low -= eta_;
    high += eta_;
    Run r{1e300, -1e300, true};
    const auto take = [&r](double x) {
      r.from = std::min(r.from, x);
      r.to = std::max(r.to, x);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const Spot a = p[k], b = p[k == 2 ? 0 : k + 1];
      if (a.y >= low && a.y <= high) take(a.x);
      const double slope = (b.x - a.x) / (b.y - a.y);
      for (const double level : {low, high})
        if ((a.y < level && b.y > level) || (a.y > level && b.y < level))
          take(std::clamp(a.x + (level - a.y) * slope, std::min(a.x, b.x), std::max(a.x, b.x)));
    }
    r.empty = r.from > r.to;
    r.from -= eta_;
    r.to += eta_;
    return r;
  }

  /// Of the centres on row j that the triangle holds, to within what clearance allows.
  Marks centres(const std::array<Spot, 3>& p, std::int64_t j) const noexcept {
    const auto level = static_cast<double>(j);
    double from = 1e300, to = -1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const Spot a = p[k], b = p[k == 2 ? 0 : k + 1];
      if (!((a.y <= level && b.y > level) || (a.y > level && b.y <= level))) continue;
      const double x = std::clamp(a.x + (level - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(a.x, b.x),
                                  std::max(a.x, b.x));
      from = std::min(from, x);
      to = std::max(to, x);
    }
    const std::int64_t first = -floored(-from), last = floored(to);
    return from > to || first > last ? Marks{0} : sides_.of(first, last, j, j);
  }

  struct Part {
    std::array<Spot, 8> corner;
    int count = 0;
    void add(Spot s) noexcept { corner[static_cast<std::size_t>(count++)] = s; }
  };

  /// The part with (a coordinate) >= level, or <=.
  template <bool along_x, bool keep_above>
  static Part clipped(const Part& of, double level) noexcept {
    Part part;
    const auto height = [level](Spot s) {
      const double h = (along_x ? s.x : s.y) - level;
      return keep_above ? h : -h;
    };
    for (int k = 0; k < of.count; ++k) {
      const Spot a = of.corner[static_cast<std::size_t>(k)],
                 b = of.corner[static_cast<std::size_t>(k + 1 == of.count ? 0 : k + 1)];
      const double h = height(a), next = height(b);
      if (h >= 0) part.add(a);
      if ((h > 0 && next < 0) || (h < 0 && next > 0)) {
        const double t = h / (h - next);
        part.add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
    return part;
  }

  void part(const std::array<Spot, 3>& p, const Sides::Four& four, std::int64_t i, std::int64_t j,
            Marks& possible, Marks& seen) const noexcept {
    Part local;
    for (const Spot& s : p) local.add({s.x - static_cast<double>(i), s.y - static_cast<double>(j)});
    local = clipped<true, true>(local, -eta_);
    local = clipped<true, false>(local, 1 + eta_);
    local = clipped<false, true>(local, -eta_);
    local = clipped<false, false>(local, 1 + eta_);
    if (local.count == 0) return;
    const double a = four.a - sides_.threshold, b = four.right - four.a, c = four.below - four.a,
                 d = four.a - four.right - four.below + four.across;
    const auto at = [&](Spot s) { return a + b * s.x + c * s.y + d * (s.x * s.y); };
    double least = 1e300, greatest = -1e300;
    const auto take = [&](double value) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    };
    for (int k = 0; k < local.count; ++k) {
      const Spot s = local.corner[static_cast<std::size_t>(k)],
                 e = local.corner[static_cast<std::size_t>(k + 1 == local.count ? 0 : k + 1)];
      take(at(s));
      const double x = e.x - s.x, y = e.y - s.y, q = d * x * y, l = b * x + c * y + d * (s.x * y + s.y * x);
      if (l * q < 0 && std::fabs(l) < 2 * std::fabs(q)) {
        const double t = -l / (2 * q);
        take(at({s.x + t * x, s.y + t * y}));
      }
    }
    if (least > bound_) {
      possible = static_cast<Marks>(possible | opaque);
    } else if (greatest < -bound_) {
      possible = static_cast<Marks>(possible | below);
    } else {
      possible = both;
    }
    if (greatest > witness_bound_) seen = static_cast<Marks>(seen | opaque);
    if (least < -witness_bound_) seen = static_cast<Marks>(seen | below);
  }

  const Sides& sides_;
  double delta_, eta_, bound_, witness_bound_;
};

}  // namespace mmverify::impl::bake::detail
