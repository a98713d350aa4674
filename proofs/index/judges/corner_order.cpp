#include "proofs/index/judges/corner_order.hpp"

#include <algorithm>

namespace mmverify::proofs::index {
Corners corners_in(CornerOrder order, std::uint32_t index, Level n) {
  const Corners c = spec::index::corners(index, n);
  if (order != CornerOrder::base_u_v) return c;
  // The base is the corner that shares j with one other corner and i with the other.
  const auto base = std::find_if(c.begin(), c.end(), [&](const auto& p) {
    return std::count_if(c.begin(), c.end(), [&](const auto& q) { return p.i == q.i || p.j == q.j; }) == 3;
  });
  Corners ordered{*base, *base, *base};
  for (const auto& q : c) {
    if (q.j == base->j && q.i != base->i) ordered[1] = q;
    if (q.i == base->i && q.j != base->j) ordered[2] = q;
  }
  return ordered;
}

Corners sorted(Corners c) {
  std::sort(c.begin(), c.end(),
            [](const auto& a, const auto& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
  return c;
}

std::optional<MicroTriangle> triangle_of(const Corners& c, Level n) {
  std::uint32_t i = c[0].i, j = c[0].j, far_i = i, far_j = j;
  std::uint64_t sum = 0;
  for (const auto& vertex : c) {
    i = std::min(i, vertex.i), j = std::min(j, vertex.j);
    far_i = std::max(far_i, vertex.i), far_j = std::max(far_j, vertex.j);
  }
  if (far_i != i + 1 || far_j != j + 1 || c[0] == c[1] || c[0] == c[2] || c[1] == c[2]) return std::nullopt;
  // Three of the square's four corners must be there: (1,1) is missing for an upright one, (0,0) for an inverted one.
  for (const auto& vertex : c) sum += (vertex.i - i) + (vertex.j - j);
  const bool upside_down = sum == 4;
  if (sum != 2 && !upside_down) return std::nullopt;
  for (const auto& vertex : c)
    if ((vertex.i - i) + (vertex.j - j) == (upside_down ? 0u : 2u)) return std::nullopt;
  if (std::uint64_t{i} + j + (upside_down ? 2 : 1) > side(n)) return std::nullopt;
  return MicroTriangle{i, j, upside_down};
}

}  // namespace mmverify::proofs::index
