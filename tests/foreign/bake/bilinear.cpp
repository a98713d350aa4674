// LINEAR: by the texels about a polygon, then in binary64, then exactly.
#include <algorithm>
#include <cmath>

#include "tests/foreign/bake/sampled.hpp"

namespace mmverify::tests::foreign::bake {

template <class T>
unsigned Sampled<T>::bilinear_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim,
                                    const Node& node) const {
  bool inside = !has(edges_only);
  if (has(clockwise_hollow) && clockwise()) inside = false;
  if (has(edges_only_when_small)) {
    const Box b = cells_of(polygon);
    if (b.right - b.left < 2 && b.bottom - b.top < 2) inside = false;
  }
  const bool line = clockwise_sign() == 0;
  if ((has(line_is_its_corners) && line) || (has(sliver_is_its_corners) && is_sliver()) ||
      has(corners_only)) {
    unsigned seen = 0;
    for (const Point<T>& p : polygon) seen |= exact_signs({p}, f, aim, true, node);
    return seen;
  }
  if (inside) {
    const unsigned all = texel_signs(polygon, f);
    if ((all & negative) == 0 && aim != Aim::any_positive) return all;
    if (all == negative) return all;
    if ((all & positive) == 0 && aim == Aim::any_positive) return all;
  }
  bool unsure = false;
  const unsigned seen = rough_signs(polygon, f, aim, inside, unsure, node);
  if (settled(seen, aim) || !unsure) return seen;
  if (has(double_decides)) return seen;
  return exact_signs(polygon, f, aim, inside, node);
}

template <class T>
bool Sampled<T>::is_sliver() const {
  const double ux = real(along_u_[0]), uy = real(along_u_[1]), vx = real(along_v_[0]), vy = real(along_v_[1]);
  return std::abs(ux * vy - uy * vx) * 1e5 < std::max(ux * ux + uy * uy, vx * vx + vy * vy);
}

template <class T>
unsigned Sampled<T>::texel_signs(const std::vector<Point<T>>& polygon, const Field& f) const {
  const Box b = cells_of(polygon);
  const Index right = along_all_ == endless ? b.right + 1 : std::min(b.right + 1, b.left + along_all_ - 1);
  const Index bottom = down_all_ == endless ? b.bottom + 1 : std::min(b.bottom + 1, b.top + down_all_ - 1);
  unsigned seen = 0;
  for (Index j = b.top; j <= bottom; ++j)
    for (Index i = b.left; i <= right; ++i) {
      seen |= f.signs[texel(i, j)];
      if ((seen & negative) != 0 && (seen & positive) != 0) return seen;
    }
  return seen;
}

template unsigned Sampled<Wide>::bilinear_signs(const std::vector<Point<Wide>>&, const Field&, Aim,
                                                const Node&) const;
template unsigned Sampled<Big>::bilinear_signs(const std::vector<Point<Big>>&, const Field&, Aim,
                                               const Node&) const;

}  // namespace mmverify::tests::foreign::bake
