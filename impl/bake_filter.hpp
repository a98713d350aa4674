// The sides of the cutoff that a closed triangle is on, in binary64, with a bound on every error: where it
// cannot tell, it says so.  Internal to impl/bake*.
//
// What is judged is the triangle T' whose corners are the computed ones, each within `delta` of those of the
// true T along either axis.  g = 255 (alpha - cutoff) changes by at most 255 a texel along either axis, so
// the ranges of g over T and T' differ by less than 2^9 delta.  Over T', g is least and greatest on an edge
// or at a centre within (bake_exact.hpp), and rounding moves no computed point off its edge by more than
// delta:
//   edges    are cut where they cross rows and columns of centres; a piece is judged by the cell of its
//   middle.
//            A cut that is off by a rounding, or a piece that is lost to one, is no longer than some delta,
//            over which g and the neighbouring cell's g differ by no more than the bound below.
//   centres  that rounding leaves out, or takes in, are within delta of an edge.  Left out, the edge has
//   spoken
//            for them, to within the bound; taken in, they count as seen only if all texels are farther from
//            the cutoff than the bound.
// The bound is 2^12 delta + 2^-36: eight times what delta makes, and 2^-53 of 255 for each of the handful of
// operations, many times over.
// Boxes are grown by delta and asked of whole texels: what they say is exact.
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
using Triangle = std::array<Spot, 3>;

/// floor, without a call where the processor has no instruction for it.  Domain: |x| < 2^62.
inline std::int64_t floored(double x) noexcept {
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

inline Spot middle(Spot a, Spot b) noexcept { return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5}; }

/// Beside the marks of sides that are certain: there may be others.
inline constexpr Marks uncertain = 4;

class Filter {
 public:
  Filter(const Sides& sides, double delta) noexcept
      : sides_(sides),
        delta_(delta),
        bound_(0x1p12 * delta + 0x1p-36),
        centres_are_clear_(sides.clearance > bound_) {}

  /// Where coordinates are too large for binary64, nothing is certain.
  bool usable() const noexcept { return bound_ < 0.25; }
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
  Marks side(double g) const noexcept {
    return static_cast<Marks>((g > bound_ ? opaque : 0) | (g < -bound_ ? below : 0));
  }

  /// Of all texels of the cells that a box meets, exactly.
  Marks box(double left, double right, double top, double bottom) const noexcept {
    return sides_.of(floored(left - delta_), floored(right + delta_) + 1, floored(top - delta_),
                     floored(bottom + delta_) + 1);
  }
  Marks box(const Triangle& p) const noexcept {
    return box(std::min(std::min(p[0].x, p[1].x), p[2].x), std::max(std::max(p[0].x, p[1].x), p[2].x),
               std::min(std::min(p[0].y, p[1].y), p[2].y), std::max(std::max(p[0].y, p[1].y), p[2].y));
  }

  /// Of a closed edge: halves, until a box settles them or they cross two lines at most.
  Marks edge(Spot p, Spot q) const noexcept {
    const double d = 4 * delta_;
    const std::int64_t left = floored(std::min(p.x, q.x) - d), right = floored(std::max(p.x, q.x) + d),
                       top = floored(std::min(p.y, q.y) - d), bottom = floored(std::max(p.y, q.y) + d);
    const Marks all = sides_.of(left, right + 1, top, bottom + 1);
    if (all != both) return all;
    if (right - left + bottom - top <= 2) return pieces(p, q, left, right, top, bottom);
    const Spot m = middle(p, q);
    const Marks first = edge(p, m);
    return (first & both) == both ? both : static_cast<Marks>(first | edge(m, q));
  }

  /// Of the centres within.
  Marks centres(const Triangle& p) const noexcept {
    const double low = std::min(std::min(p[0].y, p[1].y), p[2].y),
                 high = std::max(std::max(p[0].y, p[1].y), p[2].y);
    Marks marks = 0;
    const std::int64_t last = floored(high);
    for (std::int64_t j = -floored(-low); j <= last && marks != both; ++j)
      marks = static_cast<Marks>(marks | centres(p, j));
    return marks;
  }
  bool centres_are_clear() const noexcept { return centres_are_clear_; }

 private:
  Marks pieces(Spot p, Spot q, std::int64_t left, std::int64_t right, std::int64_t top,
               std::int64_t bottom) const noexcept {
    const double dx = q.x - p.x, dy = q.y - p.y;
    double cut[4] = {0, 1, 1, 1};
    int n = 1;
    const auto cross = [&](double t) {
      if (t > 0 && t < 1) cut[n++] = t;
    };
    for (std::int64_t i = left + 1; i <= right; ++i) cross((static_cast<double>(i) - p.x) / dx);
    for (std::int64_t j = top + 1; j <= bottom; ++j) cross((static_cast<double>(j) - p.y) / dy);
    if (n == 3 && cut[2] < cut[1]) std::swap(cut[1], cut[2]);
    Marks marks = 0;
    for (int k = 0; k < n; ++k)
      marks = static_cast<Marks>(marks | piece(p, dx, dy, cut[k], k + 1 == n ? 1 : cut[k + 1]));
    return (marks & both) == both ? both : marks;
  }

  /// Of p + t (dx, dy), t in [from, to]: m + l t + k t^2 in the cell of the middle.
  Marks piece(Spot p, double dx, double dy, double from, double to) const noexcept {
    const double half = (from + to) * 0.5;
    const std::int64_t i = floored(p.x + half * dx), j = floored(p.y + half * dy);
    const Sides::Four f = sides_.four(i, j);
    const double x = p.x - static_cast<double>(i), y = p.y - static_cast<double>(j);
    const double b = f.right - f.a, c = f.below - f.a, d = f.a - f.right - f.below + f.across;
    const double m = f.a - sides_.threshold + b * x + c * y + d * (x * y),
                 l = b * dx + c * dy + d * (x * dy + y * dx), k = d * (dx * dy);
    const double first = m + from * (l + from * k), last = m + to * (l + to * k);
    double least = std::min(first, last), greatest = std::max(first, last);
    // The slope changes sign.
    if ((l + 2 * k * from) * (l + 2 * k * to) < 0) {
      const double t = -l / (2 * k), still = m + t * (l + t * k);
      least = std::min(least, still);
      greatest = std::max(greatest, still);
    }
    if (least > bound_) return opaque;
    if (greatest < -bound_) return below;
    const Marks certain =
        static_cast<Marks>((greatest > bound_ ? opaque : 0) | (least < -bound_ ? below : 0));
    return certain == both ? both : static_cast<Marks>(certain | uncertain);
  }

  /// Of the centres on row j.
  Marks centres(const Triangle& p, std::int64_t j) const noexcept {
    const auto level = static_cast<double>(j);
    double from = 1e300, to = -1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const Spot a = p[k], b = p[k == 2 ? 0 : k + 1];
      if ((a.y <= level) == (b.y <= level)) continue;
      const double x = std::clamp(a.x + (level - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(a.x, b.x),
                                  std::max(a.x, b.x));
      from = std::min(from, x);
      to = std::max(to, x);
    }
    if (from > to) return 0;
    const std::int64_t first = -floored(-from), last = floored(to);
    return first > last ? Marks{0} : sides_.of(first, last, j, j);
  }

  const Sides& sides_;
  double delta_, bound_;
  bool centres_are_clear_;
};

}  // namespace mmverify::impl::bake::detail
