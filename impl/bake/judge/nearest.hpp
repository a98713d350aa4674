// The judge of micro-triangles sampled nearest: by the texels that they meet.  Internal to impl/bake.
//
// T is the true triangle, T' the computed one, each within `delta` of the other; P and P' are T and T' dilated by the
// margin m.  In the row of texels with j <= y < j + 1, P meets
//   at most  the texels that P' + [-delta, delta]^2 meets.  Its points there come from points of T' with
//            j - m - delta <= y <= j + 1 + m + delta, moved by at most m + delta along x.
//   at least the texels that P' meets by delta: a point (x, y) of P' with i + 2 delta <= x <= i + 1 - 2 delta and
//            j + 2 delta <= y <= j + 1 - 2 delta has a point of P within the texel (i, j).
// A computed crossing lies within delta of its edge, at a y within delta of the level: hence 2 delta where the above
// has delta, and 4 where it has 2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "impl/bake/exact/later.hpp"
#include "impl/bake/judge/bends.hpp"
#include "impl/bake/judge/codes.hpp"
#include "impl/bake/judge/inner_box.hpp"
#include "impl/bake/plane/points.hpp"
#include "impl/bake/sixteen/sixteen.hpp"
#include "impl/bake/texture/properties.hpp"
#include "impl/bake/texture/rows.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class Nearest {
 public:
  static constexpr double offset = 0;

  Nearest(const TexturePropertiesOf<Texel>& sides, const ExactLater& exact, const Triangle& base,
          index::Level level, double delta, const Dilation& dilation) noexcept
      : sides_(sides),
        exact_(exact),
        inner_(sides, base, level, dilation, delta),
        delta_(delta),
        dilation_(dilation),
        usable_(delta < 0x1p-10) {}

  Marks texels(const Triangle& p) const noexcept { return texels(box(p)); }
  SixteenNodes sixteen_nodes(const Triangle&, bool, std::uint32_t, std::uint32_t) const noexcept {
    return {};
  }
  bool sixty_four(const Triangle&, bool, std::uint32_t, std::uint32_t, BakeCounts&,
                  std::array<std::uint32_t, 4>&) const noexcept {
    return false;
  }

  unsigned single(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    const Box around = box(p);
    const Marks all = texels(around);
    if (all != both) return known_code(all);
    ++counts.leaves;
    const PlanePoint centroid{(p[0].x + p[1].x + p[2].x) * (1.0 / 3), (p[0].y + p[1].y + p[2].y) * (1.0 / 3)};
    const Marks marks =
        usable_ ? judged(p, around, centroid, turned) : inner_.marks().texels(centroid, turned);
    if (usable_ && (marks == below || marks == opaque)) return known_code(marks);
    if (marks == both) {
      const std::int64_t i = floored(centroid.x - 2 * delta_), j = floored(centroid.y - 2 * delta_);
      if (i == floored(centroid.x + 2 * delta_) && j == floored(centroid.y + 2 * delta_)) {
        if (!sides_.limits.blend) return sides_.of(i, i, j, j) == opaque ? unknown | 1 : unknown;
        const double at = static_cast<double>(sides_.texel(i, j)) - 0.5 * sides_.gap;
        if (std::fabs(at) > 0x1p-40 * sides_.scale) return at > 0 ? unknown | 1 : unknown;
      }
    }
    ++counts.exact;
    return code_of((*exact_)(index, marks));
  }

  unsigned four(const Triangle& p, PlanePoint p01, PlanePoint p02, PlanePoint p12, bool turned,
                std::uint32_t index, BakeCounts& counts) const {
    return single({p[0], p01, p02}, turned, index, counts) |
           single({p02, p12, p01}, !turned, index + 1, counts) << 2 |
           single({p01, p[1], p12}, turned, index + 2, counts) << 4 |
           single({p12, p02, p[2]}, turned, index + 3, counts) << 6;
  }

  std::uint32_t sixteen(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    const PlanePoint p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    const auto child = [&](const Triangle& q, bool is_turned, std::uint32_t first) {
      return four(q, middle(q[0], q[1]), middle(q[0], q[2]), middle(q[1], q[2]), is_turned, first, counts);
    };
    return child({p[0], p01, p02}, turned, index) | child({p02, p12, p01}, !turned, index + 4) << 8 |
           child({p01, p[1], p12}, turned, index + 8) << 16 |
           child({p12, p02, p[2]}, turned, index + 12) << 24;
  }

 private:
  struct Box {
    std::int64_t left, right, top, bottom;
  };
  Box box(const Triangle& p) const noexcept {
    const double x = delta_ + dilation_.x, y = delta_ + dilation_.y;
    return {floored(std::min({p[0].x, p[1].x, p[2].x}) - x), floored(std::max({p[0].x, p[1].x, p[2].x}) + x),
            floored(std::min({p[0].y, p[1].y, p[2].y}) - y), floored(std::max({p[0].y, p[1].y, p[2].y}) + y)};
  }
  Marks texels(const Box& b) const noexcept { return sides_.of(b.left, b.right, b.top, b.bottom); }

  /// The marks of a triangle whose texels bear both marks.
  Marks judged(const Triangle& p, const Box& around, PlanePoint centroid, bool turned) const noexcept {
    Marks seen = inner_.marks().texels(centroid, turned);
    if (seen == both) return both;
    Marks most = 0;
    const double near = dilation_.y + 2 * delta_, far = dilation_.y - 2 * delta_,
                 reach_x = dilation_.x + 2 * delta_;
    // Beyond its ends an axis has one row: the first or last row takes everything beyond.
    const Extent down = sides_.down();
    const std::int64_t top = std::clamp(around.top, down.first, down.last),
                       bottom = std::clamp(around.bottom, down.first, down.last);
    const auto reach = [&](std::int64_t j, double grown) {
      return between(p, static_cast<double>(j == top ? around.top : j) - grown,
                     static_cast<double>(j == bottom ? around.bottom : j) + 1 + grown);
    };
    const auto columns = [&](std::int64_t j) {
      const Reach outer = reach(j, near);
      if (outer.from > outer.to) return Columns{};
      return sides_.columns(floored(outer.from - reach_x), floored(outer.to + reach_x));
    };
    const auto take = [&](const Columns& at, std::int64_t j) {
      if (at.empty()) return true;
      const Marks row = sides_.of(at.first, at.last, j, j);
      most = static_cast<Marks>(most | row);
      if ((seen | row) == seen) return true;
      const Reach inner = reach(j, far);
      const double from = inner.from - dilation_.x + 4 * delta_, to = inner.to + dilation_.x - 4 * delta_;
      if (!(from <= to)) return true;
      const Columns sure = sides_.columns(floored(from), floored(to));
      seen = static_cast<Marks>(seen | sides_.of(sure.first, sure.last, j, j));
      return seen != both;
    };
    const std::int64_t period = bottom - top < down.period ? 0 : down.period;
    each_row(top, bottom, period, period == 0 ? std::array<Bend, 6>{} : bends(p, near), columns, take);
    if (seen == both) return both;
    return most == both ? uncertain : most;
  }

  const TexturePropertiesOf<Texel>& sides_;
  const ExactLater& exact_;
  InnerLater inner_;
  double delta_;
  Dilation dilation_;
  bool usable_;
};

}  // namespace mmverify::impl::bake::detail
