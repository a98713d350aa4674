// A rectangle within a triangle: most mixed triangles bear both marks there.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "impl/bake/plane/points.hpp"
#include "impl/bake/texture/properties.hpp"

namespace mmverify::impl::bake::detail {

/// A rectangle, relative to the triangle's centroid.  Empty: left > right.
struct InnerBox {
  double left = 1, right = -1, top = 1, bottom = -1;
};

/// The largest of some rectangles within p, between rows at multiples of 1/12 of the height.
inline InnerBox inner_box(const Triangle& p) noexcept {
  const PlanePoint c{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
  const double low = std::min({p[0].y, p[1].y, p[2].y}), high = std::max({p[0].y, p[1].y, p[2].y});
  constexpr int rows = 12;
  std::array<double, rows + 1> from, to, at;
  for (std::size_t r = 0; r <= rows; ++r) {
    at[r] = low + (high - low) * static_cast<double>(r) / rows;
    from[r] = 1e300;
    to[r] = -1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint a = p[k], b = p[(k + 1) % 3];
      if ((a.y <= at[r]) == (b.y <= at[r])) continue;
      const double x = std::clamp(a.x + (at[r] - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(a.x, b.x),
                                  std::max(a.x, b.x));
      from[r] = std::min(from[r], x);
      to[r] = std::max(to[r], x);
    }
  }
  InnerBox best;
  double area = 0;
  for (std::size_t r = 0; r <= rows; ++r)
    for (std::size_t s = r + 1; s <= rows; ++s) {
      const double left = std::max(from[r], from[s]), right = std::min(to[r], to[s]);
      if (left >= right || (right - left) * (at[s] - at[r]) <= area) continue;
      area = (right - left) * (at[s] - at[r]);
      best = {left - c.x, right - c.x, at[r] - c.y, at[s] - c.y};
    }
  return best;
}

/// The inner box of micro-triangles, which are one triangle moved or turned by half a circle, and its texels' marks.
class InnerMarks {
 public:
  /// `inner` is that of a micro-triangle that is not turned; it is shrunk by 4 delta, so that it is within the true
  /// triangle, whose centroid may be 2 delta off, and grown by the dilation, as the triangle is.
  InnerMarks(const TextureProperties& sides, const InnerBox& inner, const Dilation& dilation,
             double delta) noexcept
      : sides_(sides) {
    const InnerBox box = inner.left > inner.right ? InnerBox{0, 0, 0, 0} : inner;
    const double x = 4 * delta - dilation.x, y = 4 * delta - dilation.y;
    boxes_[0] = {box.left + x, box.right - x, box.top + y, box.bottom - y};
    boxes_[1] = {-box.right + x, -box.left - x, -box.bottom + y, -box.top - y};
    worth_it_ = (box.right - box.left + 2 * dilation.x) * (box.bottom - box.top + 2 * dilation.y) >= 16;
  }

  /// The marks of texels whose centres are in the box, centres at whole numbers; 0 if the box is too small for several.
  Marks centres(PlanePoint centroid, bool turned) const noexcept {
    if (!worth_it_) return 0;
    const InnerBox& b = boxes_[turned];
    return of(-floored(-(centroid.x + b.left)), floored(centroid.x + b.right),
              -floored(-(centroid.y + b.top)), floored(centroid.y + b.bottom));
  }
  /// The marks of the texels that the box meets, texels beginning at whole numbers.
  Marks texels(PlanePoint centroid, bool turned) const noexcept {
    const InnerBox& b = boxes_[turned];
    if (b.left > b.right || b.top > b.bottom) return 0;
    return of(floored(centroid.x + b.left), floored(centroid.x + b.right), floored(centroid.y + b.top),
              floored(centroid.y + b.bottom));
  }

 private:
  Marks of(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    return left <= right && top <= bottom ? sides_.of(left, right, top, bottom) : Marks{0};
  }

  const TextureProperties& sides_;
  std::array<InnerBox, 2> boxes_;  ///< not turned; turned
  bool worth_it_;
};

/// The inner marks of a base triangle's micro-triangles, made when first asked for: most triangles ask for none.
class InnerLater {
 public:
  /// The arguments outlive this.  One thread uses it.
  InnerLater(const TextureProperties& sides, const Triangle& base, std::uint32_t level,
             const Dilation& dilation, double delta) noexcept
      : sides_(sides), base_(base), level_(level), dilation_(dilation), delta_(delta) {}

  const InnerMarks& marks() const noexcept {
    if (!made_) {
      InnerBox box = inner_box(base_);
      const double part = 1.0 / static_cast<double>(std::uint32_t{1} << level_);
      for (double* const side : {&box.left, &box.right, &box.top, &box.bottom}) *side *= part;
      made_.emplace(sides_, box, dilation_, delta_);
    }
    return *made_;
  }

 private:
  const TextureProperties& sides_;
  const Triangle& base_;
  std::uint32_t level_;
  const Dilation& dilation_;
  double delta_;
  mutable std::optional<InnerMarks> made_;
};

}  // namespace mmverify::impl::bake::detail
