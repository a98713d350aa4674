// Triangles of one base triangle, judged by the cells that they meet (impl/bake/judge/cells.hpp).  Internal to
// impl/bake.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "impl/bake/judge/cells.hpp"
#include "impl/bake/plane/lines.hpp"
#include "impl/bake/plane/spot.hpp"
#include "impl/bake/texture/sides.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class CellJudge {
 public:
  /// Of the base triangle, its corners within delta of the true ones; bound: of g (bake_filter.hpp).
  CellJudge(const SidesOf<Texel>& sides, const Triangle& base, double delta, double bound,
            bool usable) noexcept
      : sides_(sides), lines_(usable ? Lines(base, delta) : Lines()), delta_(delta), bound_(bound) {}

  /// Whether cells say anything about any triangle.
  bool usable() const noexcept { return lines_.usable; }

  const Lines& lines() const noexcept { return lines_; }

  /// The marks borne, or uncertain; `by_texels`: no mixed cell is met.
  Marks judged(const Triangle& p, bool turned, bool& by_texels) const noexcept {
    by_texels = false;
    const auto about = window(p, turned);
    if (!about) return uncertain;
    CellTriangle<Texel> t;
    const auto left = static_cast<double>(about->left), top = static_cast<double>(about->top);
    // Exact: what is left of a coordinate has no more digits than it.
    for (std::size_t k = 0; k < 3; ++k) t.p[k] = {p[k].x - left, p[k].y - top};
    t.top = -HUGE_VAL;
    t.bottom = HUGE_VAL;
    if (lines_.has_flat) {
      const double low = std::min({t.p[0].y, t.p[1].y, t.p[2].y}),
                   high = std::max({t.p[0].y, t.p[1].y, t.p[2].y}),
                   middle = t.p[0].y + t.p[1].y + t.p[2].y - low - high;
      (middle - low < high - middle ? t.top : t.bottom) = middle;
      t.top += 2 * lines_.margin;
      t.bottom -= 2 * lines_.margin;
    }
    t.texels = about->texels;
    t.pitch = sides_.pitch();
    t.threshold = sides_.threshold;
    t.gap = sides_.gap;
    t.bound = bound_;
    t.delta = delta_;
    t.margin = lines_.margin;
    return detail::judged<Texel>(about->cells, t, by_texels);
  }

 private:
  struct About {
    CellWindow cells;
    std::int64_t left, top;
    const Texel* texels;
  };
  /// None where it is too large or not in one picture.
  std::optional<About> window(const Triangle& p, bool turned) const noexcept {
    if (!lines_.usable) return std::nullopt;
    const double m = lines_.margin;
    const std::int64_t left = floored(std::min(std::min(p[0].x, p[1].x), p[2].x) - m),
                       right = floored(std::max(std::max(p[0].x, p[1].x), p[2].x) + m),
                       top = floored(std::min(std::min(p[0].y, p[1].y), p[2].y) - m),
                       bottom = floored(std::max(std::max(p[0].y, p[1].y), p[2].y) + m);
    if (right - left >= CellWindow::most || bottom - top >= CellWindow::most) return std::nullopt;
    const auto picture = sides_.in_one_picture(left, right + 1, top, bottom + 1);
    if (!picture) return std::nullopt;
    About about;
    about.left = left;
    about.top = top;
    about.texels = picture->first;
    CellWindow& w = about.cells;
    const Plane &are_opaque = sides_.opaque_plane(), &visible = sides_.visible_plane();
    const std::size_t word = are_opaque.strip() * static_cast<std::size_t>(picture->left / 32) +
                             static_cast<std::size_t>(picture->top);
    w.opaque = are_opaque.strips() + word;
    w.visible = visible.strips() + word;
    w.strip = are_opaque.strip();
    w.bit = static_cast<std::uint32_t>(picture->left % 32);
    w.columns = static_cast<std::int32_t>(right - left + 1);
    w.rows = static_cast<std::int32_t>(bottom - top + 1);
    w.ab_left = lines_.ab_left != turned;
    const auto x = static_cast<double>(left), y = static_cast<double>(top);
    for (std::size_t l = 0; l < 3; ++l) {
      const double s = lines_.slope[l];
      const auto at = [&](std::size_t k) { return p[k].x - x + (y - p[k].y) * s; };
      const bool is_left = w.ab_left == (l != 2);
      w.at[l] = static_cast<float>(is_left ? std::min(std::min(at(0), at(1)), at(2))
                                           : std::max(std::max(at(0), at(1)), at(2)));
      w.slope[l] = static_cast<float>(s);
      w.margin[l] = static_cast<float>(m * (1 + std::fabs(s)));
    }
    return about;
  }

  const SidesOf<Texel>& sides_;
  Lines lines_;
  double delta_, bound_;
};

}  // namespace mmverify::impl::bake::detail
