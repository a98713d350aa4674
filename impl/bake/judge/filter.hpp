// The marks that a closed triangle bears in bilinear alpha, in binary64, with a bound on every error; if it cannot
// decide it says so.  Internal to impl/bake.
//
// The judged triangle T' has the computed corners, each within `delta` of those of the true triangle T along either
// axis.  Let g be sampled stored numbers less the threshold (impl/bake/texture/properties.hpp), all of them within R of
// each other and of 0.  g changes by at most R a texel along either axis, so the ranges of g over T and T' differ by
// less than 2 R delta.  Over T', g is least and greatest on an edge or at a centre within (impl/bake/exact/seen.hpp),
// and rounding moves no computed point off its edge by more than delta:
//   edges    are cut where they cross rows and columns of centres; a piece is judged by the cell of its
//            middle.  A cut that is off by a rounding, or a piece that is lost to one, is no longer than some
//            delta, over which g and the neighbouring cell's g differ by no more than the bound below.
//   centres  that rounding leaves out, or takes in, are within delta of an edge.  If one is left out, the edge
//            bears its mark, to within the bound.  If one is taken in, it counts as seen only if all texels that
//            bear the mark are farther from its limit than the bound.
// The bound is R (2^5 delta + 2^-43): eight times the effect of delta, and 2^-53 of R for each of the handful of
// operations, the rounded threshold's among them, many times over.
// Boxes are grown by delta and hold whole texels: their marks are exact.
//
// Dilated, the same holds for T' + [-m, m] x [-n, n], whose edges are segments as in impl/bake/exact/seen.hpp; moving a
// corner by m or n rounds once more, which delta has room for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "impl/bake/judge/bends.hpp"
#include "impl/bake/judge/codes.hpp"
#include "impl/bake/plane/points.hpp"
#include "impl/bake/texture/properties.hpp"
#include "impl/bake/texture/rows.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class BilinearFilter {
 public:
  BilinearFilter(const TexturePropertiesOf<Texel>& sides, double delta, const Dilation& dilation) noexcept
      : sides_(sides),
        delta_(delta),
        dilation_(dilation),
        reach_{delta + dilation.x, delta + dilation.y},
        bound_(sides.scale * (0x1p5 * delta + 0x1p-43)),
        transparent_(sides.gap + bound_),
        across_(sides.across()),
        down_(sides.down()),
        usable_(0x1p5 * delta < 0x1p-10),
        clear_(static_cast<Marks>((sides.clear_below > bound_ ? below : 0) |
                                  (sides.clear_opaque > bound_ ? opaque : 0))) {}

  /// False if coordinates are too large for binary64: then nothing is certain.
  bool usable() const noexcept { return usable_; }
  double delta() const noexcept { return delta_; }
  const Dilation& dilation() const noexcept { return dilation_; }
  double bound() const noexcept { return bound_; }

  /// The sampled stored number at p, less the threshold.
  double g(PlanePoint p) const noexcept {
    const std::int64_t i = floored(p.x), j = floored(p.y);
    const double fx = p.x - static_cast<double>(i), fy = p.y - static_cast<double>(j);
    const auto f = sides_.four(i, j);
    const double top = f.a + fx * (f.right - f.a), under = f.below + fx * (f.across - f.below);
    return top + fy * (under - top) - sides_.threshold;
  }
  /// The marks that a value of g proves; there may be others if it is close to a limit.
  Marks side(double g) const noexcept { return range(g, g); }
  /// The marks that all g from the least to the greatest prove.  Domain: both occur.
  Marks range(double least, double greatest) const noexcept {
    return static_cast<Marks>((greatest > bound_ - sides_.gap ? opaque : 0) | (least < -bound_ ? below : 0));
  }
  /// The same, with `uncertain` unless there are no others.
  Marks range_or_uncertain(double least, double greatest) const noexcept {
    const bool is_below = least<-bound_, is_opaque = greatest> bound_ - sides_.gap;
    const bool sure = (is_below || least > bound_) && (is_opaque || greatest < -transparent_);
    return static_cast<Marks>((is_opaque ? opaque : 0) | (is_below ? below : 0) | (sure ? 0 : uncertain));
  }

  /// The texels of the cells that the box about a triangle meets, ends included.
  struct Box {
    std::int64_t left, right, top, bottom;
  };
  Box box(const Triangle& p) const noexcept {
    return {floored(std::min(std::min(p[0].x, p[1].x), p[2].x) - reach_.x),
            floored(std::max(std::max(p[0].x, p[1].x), p[2].x) + reach_.x) + 1,
            floored(std::min(std::min(p[0].y, p[1].y), p[2].y) - reach_.y),
            floored(std::max(std::max(p[0].y, p[1].y), p[2].y) + reach_.y) + 1};
  }

  /// The marks of all texels of a box, exactly.
  Marks texels(const Box& box) const noexcept { return sides_.of(box.left, box.right, box.top, box.bottom); }

  /// The marks of a closed edge with g at its ends: it is halved until a box settles the parts or they cross few lines.
  Marks edge(PlanePoint p, PlanePoint q, double at_p, double at_q) const noexcept {
    const double d = 4 * delta_;
    const Box box{floored(std::min(p.x, q.x) - d), floored(std::max(p.x, q.x) + d) + 1,
                  floored(std::min(p.y, q.y) - d), floored(std::max(p.y, q.y) + d) + 1};
    const Marks all = texels(box);
    if (all != both) return all;
    if (cells(box.left, box.right, across_) + cells(box.top, box.bottom, down_) <= 10)
      return walked(p, q, at_p, at_q);
    const PlanePoint m = middle(p, q);
    const double at_m = g(m);
    const Marks first = edge(p, m, at_p, at_m);
    if ((first & both) == both) return both;
    const Marks all_of_it = static_cast<Marks>(first | edge(m, q, at_m, at_q));
    return (all_of_it & both) == both ? both : all_of_it;
  }

  /// The marks of the centres within, or 0 if they add nothing to `seen`; `box` is the triangle's.
  Marks centres(const Triangle& p, const Box& box, Marks seen) const noexcept {
    // The outer texels of the cells are not within.
    if (box.left + 1 >= box.right || box.top + 1 >= box.bottom) return 0;
    const Marks about = texels({box.left + 1, box.right - 1, box.top + 1, box.bottom - 1});
    if ((seen | about) == seen || is_line(p)) return 0;
    Marks marks = 0;
    // Beyond its ends an axis has no centre whose mark no edge bears (impl/bake/exact/seen.hpp).
    const std::int64_t top = std::max(box.top + 1, down_.first),
                       bottom = std::min(box.bottom - 1, down_.last),
                       period = bottom - top < down_.period ? 0 : down_.period;
    const auto take = [&](const Columns& at, std::int64_t j) {
      if (!at.empty()) marks = static_cast<Marks>(marks | sides_.of(at.first, at.last, j, j));
      return marks != both;
    };
    each_row(
        top, bottom, period, period == 0 ? std::array<Bend, 6>{} : bends(p, dilation_.y),
        [&](std::int64_t j) { return within(p, j); }, take);
    return marks;
  }
  /// The marks whose texels are all clear of their limits.
  Marks clear() const noexcept { return clear_; }

 private:
  /// The marks of an edge, cell by cell.  On a column or row of centres, g is a mean of two texels; in a cell, a share
  /// s of the way from v to w,
  ///   g = v + (w - v) s - K s (1 - s),   K = d dx dy of the piece,
  /// which stands still at s = (1 - (w - v) / K) / 2 if |w - v| < |K|.
  /// Beyond an axis's ends all cells are one, and there g does not depend on it.
  /// dx is 0 or well above 2^-100, since coordinates are products of 39 bits less 1/2 and halved 12 times: so 1/dx is
  /// finite, and 1/dy likewise.
  Marks walked(PlanePoint p, PlanePoint q, double at_p, double at_q) const noexcept {
    const double dx = q.x - p.x, dy = q.y - p.y;
    std::int64_t i = std::clamp(floored(p.x), across_.first - 1, across_.last),
                 j = std::clamp(floored(p.y), down_.first - 1, down_.last);
    const std::int64_t step_x = dx < 0 ? -1 : 1, step_y = dy < 0 ? -1 : 1;
    const double per_x = dx == 0 ? 4 : 1 / std::fabs(dx), per_y = dy == 0 ? 4 : 1 / std::fabs(dy);
    double next_x = dx == 0 ? 4 : std::fabs(static_cast<double>(dx < 0 ? i : i + 1) - p.x) * per_x,
           next_y = dy == 0 ? 4 : std::fabs(static_cast<double>(dy < 0 ? j : j + 1) - p.y) * per_y;
    const auto leaves = [](std::int64_t k, std::int64_t step, const Extent& e) {
      return step < 0 ? k < e.first : k >= e.last;
    };
    if (leaves(i, step_x, across_)) next_x = 4;
    if (leaves(j, step_y, down_)) next_y = 4;
    double least = std::min(at_p, at_q), greatest = std::max(at_p, at_q), t = 0, v = at_p;
    while (true) {
      const auto f = sides_.four(i, j);
      const double d = is_beyond(i, across_) || is_beyond(j, down_) ? 0 : f.a - f.right - f.below + f.across,
                   from = t;
      double w = at_q;
      const std::int64_t i_here = i, j_here = j;
      if (next_x >= 1 && next_y >= 1) {
        t = 1;
      } else if (next_x <= next_y) {
        t = next_x;
        const double low = dx < 0 ? f.a : f.right, high = dx < 0 ? f.below : f.across;
        w = low + (p.y + t * dy - static_cast<double>(j_here)) * (high - low) - sides_.threshold;
        i += step_x;
        next_x = leaves(i, step_x, across_) ? 4 : next_x + per_x;
      } else {
        t = next_y;
        const double low = dy < 0 ? f.a : f.below, high = dy < 0 ? f.right : f.across;
        w = low + (p.x + t * dx - static_cast<double>(i_here)) * (high - low) - sides_.threshold;
        j += step_y;
        next_y = leaves(j, step_y, down_) ? 4 : next_y + per_y;
      }
      least = std::min(least, w);
      greatest = std::max(greatest, w);
      const double K = d * (dx * (t - from)) * (dy * (t - from)), rise = w - v;
      if (std::fabs(rise) < std::fabs(K)) {
        const double s = 0.5 - rise / (2 * K), still = v + rise * s - K * s * (1 - s);
        least = std::min(least, still);
        greatest = std::max(greatest, still);
      }
      if (range(least, greatest) == both) return both;
      if (t == 1) break;
      v = w;
    }
    return range_or_uncertain(least, greatest);
  }

  /// Whether the edges of a long triangle bear the marks of all its centres: it is within 5 delta of its longest edge.
  bool is_line(const Triangle& p) const noexcept {
    constexpr double long_one = 1024;  // texels; rows of shorter ones take less time
    const double ax = p[1].x - p[0].x, ay = p[1].y - p[0].y, bx = p[2].x - p[0].x, by = p[2].y - p[0].y,
                 length = std::max({std::fabs(ax), std::fabs(ay), std::fabs(bx), std::fabs(by)});
    return dilation_.none() && length > long_one && std::fabs(ax * by - ay * bx) <= 2 * delta_ * length;
  }

  /// The columns of the centres on row j.
  Columns within(const Triangle& p, std::int64_t j) const noexcept {
    const auto level = static_cast<double>(j);
    // Points within the dilation of the level along y reach the dilation beyond them along x.
    const Reach reach =
        dilation_.y == 0 ? at_level(p, level) : between(p, level - dilation_.y, level + dilation_.y);
    const double from = reach.from - dilation_.x, to = reach.to + dilation_.x;
    if (from > to) return {};
    return sides_.columns(-floored(-from), floored(to));
  }

  /// Whether cell k lies beyond the ends of an axis.
  static bool is_beyond(std::int64_t k, const Extent& e) noexcept { return k < e.first || k >= e.last; }
  /// The number of cell borders, or about as many, between two texels where alpha depends on this axis.
  static std::int64_t cells(std::int64_t from, std::int64_t to, const Extent& e) noexcept {
    return std::clamp(to, e.first - 1, e.last + 1) - std::clamp(from, e.first - 1, e.last + 1);
  }

  const TexturePropertiesOf<Texel>& sides_;
  double delta_;
  Dilation dilation_, reach_;
  double bound_, transparent_;
  Extent across_, down_;
  bool usable_;
  Marks clear_;
};

}  // namespace mmverify::impl::bake::detail
