// The integral of F dy along a micro-edge, F(x, y) the sum of its row's texels up to x.
//
// A row is [j, j + 1), a column [i, i + 1).  In one row and column F is linear in x, so that a piece of the edge adds
//   (P(i) + (x - i) c(i)) (its dy),   x the middle of it, P(i) the sum of the texels before i.
// docs/ATTRIBUTE_BOUNDS.md, "An edge", bounds the error by m u E (18 + K) h, for K pieces.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "impl/attribute/bake/frame.hpp"
#include "impl/attribute/bake/quad-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_ATTRIBUTE_BAKE_EDGE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_ATTRIBUTE_BAKE_EDGE_INL_HPP_
#undef MMVERIFY_IMPL_ATTRIBUTE_BAKE_EDGE_INL_HPP_
#else
#define MMVERIFY_IMPL_ATTRIBUTE_BAKE_EDGE_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute::detail {
namespace HWY_NAMESPACE {

/// Adds the piece of a row that runs in column i from x0 to x1.
template <class Sum>
HWY_INLINE Quad with_piece(const Quad& integral, const Sum* row, std::int32_t i, double x0, double x1,
                           double dy) {
  const Sum* const p = row + 4 * static_cast<std::size_t>(i);
  const Quad before = Quad::of(p);
  return integral.plus(dy, before.plus(0.5 * (x0 + x1) - i, Quad::of(p + 4) - before));
}

/// The integral along the edge from p to q.  Domain: coordinates in [0, width or height of the sums).
template <class Sum>
HWY_INLINE Quad edge_integral(const RowSums<Sum>& sums, Point p, Point q) {
  Quad integral = Quad::zero();
  if (p.y == q.y) return integral;
  const bool up = q.y < p.y;
  if (up) std::swap(p, q);
  const double dx = q.x - p.x, dy = q.y - p.y, across = dx / dy, down = dy / dx, least = std::min(p.x, q.x),
               greatest = std::max(p.x, q.x);
  const auto last = static_cast<std::int32_t>(q.y);
  double x = p.x, y = p.y;
  for (auto j = static_cast<std::int32_t>(p.y); j <= last; ++j) {
    const bool ends = j == last;
    const double next_y = ends ? q.y : j + 1.0,
                 next_x = ends ? q.x : std::clamp(p.x + (next_y - p.y) * across, least, greatest);
    const Sum* const row = sums.first + 4 * sums.pitch * static_cast<std::size_t>(j);
    auto i = static_cast<std::int32_t>(x);
    const auto to = static_cast<std::int32_t>(next_x);
    while (i != to) {
      const double crossed = i < to ? i + 1.0 : i;
      const double at = std::clamp(p.y + (crossed - p.x) * down, y, next_y);
      integral = with_piece(integral, row, i, x, crossed, at - y);
      x = crossed;
      y = at;
      i += i < to ? 1 : -1;
    }
    integral = with_piece(integral, row, i, x, next_x, next_y - y);
    x = next_x;
    y = next_y;
  }
  return up ? Quad::zero() - integral : integral;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute::detail
HWY_AFTER_NAMESPACE();

#endif
