// NEAREST: the texels whose squares a polygon meets.
#include <algorithm>

#include "tests/foreign/bake/sampled.hpp"

namespace mmverify::tests::foreign::bake {

template <class T>
unsigned Sampled<T>::nearest_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim) const {
  const Box box = cells_of(polygon);
  spend(box.bottom - box.top);
  unsigned seen = 0;
  Index last = box.bottom;
  if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
  for (Index j = box.top; j <= last; ++j) {
    // the strip j <= y < j + 1; the first and last distinct rows have no end
    const bool has_low = j > rows_.low, has_high = j < rows_.high;
    const T low = T(j) * unit_, high = T(j + 1) * unit_;
    Index first = endless, end = -endless;
    bool touched = false;
    const auto meet = [&](const T& n, const T& d, bool attained) {  // x = n/d
      touched = true;
      const T by = d * unit_;
      const T floor = floor_div(n, by);
      const Index from = index_of(floor);
      first = std::min(first, from);
      if (has(nearest_high_sides) && floor * by == n) first = std::min(first, from - 1);
      const bool on_line = floor * by == n;
      if (has(nearest_high_corner) && on_line && attained && has_low && polygon.size() > 2)
        corner_hit(n, d, low, polygon, from, first);
      end = std::max(end, attained || !on_line ? from : from - 1);
    };
    if (polygon.size() == 1) meet(polygon[0].x, T(1), true);
    for (std::size_t k = 0; k < polygon.size() && polygon.size() > 1; ++k) {
      const Point<T>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const T dx = q.x - p.x, dy = q.y - p.y;
      const bool p_in = (!has_low || p.y >= low) && (!has_high || p.y <= high);
      if (p_in) meet(p.x, T(1), !has_high || p.y < high);
      if (dy == 0) continue;
      const auto across = [&](const T& line, bool attained) {
        if ((p.y < line) == (q.y < line) && p.y != line && q.y != line) return;
        const T d = dy < 0 ? T(-dy) : dy;
        meet(p.x * d + (line - p.y) * (dy < 0 ? T(-dx) : dx), d, attained);
      };
      if (has_low) across(low, true);
      if (has_high) across(high, false);
    }
    if (!touched) continue;
    if (has(nearest_low_sides) && has_low && j == box.bottom && j > box.top && polygon.size() > 1) {
      // the row met by its low side alone
      T most = polygon[0].y;
      for (const auto& p : polygon) most = std::max(most, p.y);
      if (most == low) continue;
    }
    first = std::clamp(first, columns_.low, columns_.high);
    end = std::clamp(end, columns_.low, columns_.high);
    end = std::min(end, along_all_ == endless ? end : first + along_all_ - 1);
    spend(end - first);
    for (Index i = first; i <= end; ++i) {
      seen |= f.signs[texel(i, j)];
      if (settled(seen, aim)) return seen;
    }
  }
  return seen;
}

template <class T>
void Sampled<T>::corner_hit(const T& n, const T& d, const T& low, const std::vector<Point<T>>& polygon,
                            Index from, Index& first) const {
  if (d != 1) return;
  for (const auto& p : polygon)
    if (p.x == n && p.y == low) first = std::min(first, from - 1);
}

template unsigned Sampled<Wide>::nearest_signs(const std::vector<Point<Wide>>&, const Field&, Aim) const;
template unsigned Sampled<Big>::nearest_signs(const std::vector<Point<Big>>&, const Field&, Aim) const;

}  // namespace mmverify::tests::foreign::bake
