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
  /// Rectangles below this size are asked row by row.
  static constexpr std::int64_t few = 28;

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

  /// The texels of the cells that the box about a triangle meets, ends included.
  struct Box {
    std::int64_t left, right, top, bottom;
  };
  Box box(const Triangle& p) const noexcept {
    return {floored(std::min(std::min(p[0].x, p[1].x), p[2].x) - delta_),
            floored(std::max(std::max(p[0].x, p[1].x), p[2].x) + delta_) + 1,
            floored(std::min(std::min(p[0].y, p[1].y), p[2].y) - delta_),
            floored(std::max(std::max(p[0].y, p[1].y), p[2].y) + delta_) + 1};
  }

  /// Of all those texels, exactly.
  Marks texels(const Box& box) const noexcept {
    return box.right - box.left < few && box.bottom - box.top < few
               ? sides_.of_few(box.left, box.right, box.top, box.bottom)
               : sides_.of(box.left, box.right, box.top, box.bottom);
  }

  /// Of a closed edge with g at its ends: halves, until a box settles them or they cross few lines.
  Marks edge(Spot p, Spot q, double at_p, double at_q) const noexcept {
    const double d = 4 * delta_;
    const Box box{floored(std::min(p.x, q.x) - d), floored(std::max(p.x, q.x) + d) + 1,
                  floored(std::min(p.y, q.y) - d), floored(std::max(p.y, q.y) + d) + 1};
    const Marks all = texels(box);
    if (all != both) return all;
    if (box.right - box.left + box.bottom - box.top <= 10) return walked(p, q, at_p, at_q);
    const Spot m = middle(p, q);
    const double at_m = g(m);
    const Marks first = edge(p, m, at_p, at_m);
    if ((first & both) == both) return both;
    const Marks all_of_it = static_cast<Marks>(first | edge(m, q, at_m, at_q));
    return (all_of_it & both) == both ? both : all_of_it;
  }

  /// Of the centres within, or none where they add nothing to what is seen; `box` is the triangle's.
  Marks centres(const Triangle& p, const Box& box, Marks seen) const noexcept {
    // The cells' outer texels are not within.
    if (box.left + 1 >= box.right || box.top + 1 >= box.bottom) return 0;
    const Marks about = texels({box.left + 1, box.right - 1, box.top + 1, box.bottom - 1});
    if ((seen | about) == seen) return 0;
    Marks marks = 0;
    for (std::int64_t j = box.top + 1; j < box.bottom && marks != both; ++j)
      marks = static_cast<Marks>(marks | centres(p, j));
    return marks;
  }
  bool centres_are_clear() const noexcept { return centres_are_clear_; }

 private:
  /// From cell to cell.  Where it enters a column or row of centres, g is a mean of two texels; in a cell, a
  /// share s of the way from v to w,
  ///   g = v + (w - v) s - K s (1 - s),   K = d dx dy of the piece,
  /// which stands still at s = (1 - (w - v) / K) / 2 if |w - v| < |K|.
  /// dx is 0 or, coordinates being products of 39 bits less 1/2 and halved 12 times, well above 2^-100, so
  /// that 1/dx is finite; dy likewise.
  Marks walked(Spot p, Spot q, double at_p, double at_q) const noexcept {
    const double dx = q.x - p.x, dy = q.y - p.y;
    std::int64_t i = floored(p.x), j = floored(p.y);
    const std::int64_t step_x = dx < 0 ? -1 : 1, step_y = dy < 0 ? -1 : 1;
    const double per_x = dx == 0 ? 4 : 1 / std::fabs(dx), per_y = dy == 0 ? 4 : 1 / std::fabs(dy);
    double next_x = dx == 0 ? 4 : std::fabs(static_cast<double>(dx < 0 ? i : i + 1) - p.x) * per_x,
           next_y = dy == 0 ? 4 : std::fabs(static_cast<double>(dy < 0 ? j : j + 1) - p.y) * per_y;
    double least = std::min(at_p, at_q), greatest = std::max(at_p, at_q), t = 0, v = at_p;
    while (true) {
      const Sides::Four f = sides_.four(i, j);
      const double d = f.a - f.right - f.below + f.across, from = t;
      double w = at_q;
      const std::int64_t i_here = i, j_here = j;
      if (next_x >= 1 && next_y >= 1) {
        t = 1;
      } else if (next_x <= next_y) {
        t = next_x;
        const double low = dx < 0 ? f.a : f.right, high = dx < 0 ? f.below : f.across;
        w = low + (p.y + t * dy - static_cast<double>(j_here)) * (high - low) - sides_.threshold;
        next_x += per_x;
        i += step_x;
      } else {
        t = next_y;
        const double low = dy < 0 ? f.a : f.below, high = dy < 0 ? f.right : f.across;
        w = low + (p.x + t * dx - static_cast<double>(i_here)) * (high - low) - sides_.threshold;
        next_y += per_y;
        j += step_y;
      }
      least = std::min(least, w);
      greatest = std::max(greatest, w);
      const double K = d * (dx * (t - from)) * (dy * (t - from)), rise = w - v;
      if (std::fabs(rise) < std::fabs(K)) {
        const double s = 0.5 - rise / (2 * K), still = v + rise * s - K * s * (1 - s);
        least = std::min(least, still);
        greatest = std::max(greatest, still);
      }
      if (least < -bound_ && greatest > bound_) return both;
      if (t == 1) break;
      v = w;
    }
    if (least > bound_) return opaque;
    if (greatest < -bound_) return below;
    return static_cast<Marks>((greatest > bound_ ? opaque : 0) | (least < -bound_ ? below : 0) | uncertain);
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
