// LINEAR in whole numbers, as wide as it takes.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <type_traits>

#include "tests/foreign/bake/sampled.hpp"

namespace mmverify::tests::foreign::bake {

template <class T>
unsigned Sampled<T>::exact_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                                 const Node& node) const {
  if (has(tolerance_1e_6) || has(tolerance_1e_12) ||
      (has(tolerance_1e_12_blend) && case_.alpha_mode == MMVERIFY_BLEND)) {
    // near enough is good enough: only what binary64 is sure of counts
    bool unsure = false;
    const unsigned seen = tolerant_signs(polygon, f, inside, unsure, node);
    return seen != 0 ? seen : unsigned{positive};
  }
  if (std::is_same_v<T, Wide> && f.fits && 2 * f.size_bits + 4 * place_bits_ + 14 <= 126)
    return whole_signs<Wide>(polygon, f, aim, inside);
  return whole_signs<Big>(polygon, f, aim, inside);
}

template <class T>
unsigned Sampled<T>::tolerant_signs(const std::vector<Point<T>>& polygon, const Field& f, bool inside,
                                    bool& unsure, const Node& node) const {
  return rough_signs(polygon, f, Aim::both_sides, inside, unsure, node);
}

template <class T>
template <class E>
unsigned Sampled<T>::whole_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim,
                                 bool inside) const {
  std::vector<Point<E>> p;
  for (const auto& q : polygon) p.push_back({to<E>(q.x), to<E>(q.y)});
  const E unit = to<E>(unit_);
  const Box box = cells_of(polygon);
  spend(box.bottom - box.top);
  Index last = box.bottom;
  if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
  unsigned seen = 0;
  for (std::size_t e = 0; e < p.size(); ++e) {
    const Point<E>&a = p[e], &b = p[(e + 1) % p.size()];
    const E dx = b.x - a.x, dy = b.y - a.y;
    for (Index j = box.top; j <= last; ++j) {
      Fraction<E> t0{E(0), E(1)}, t1{E(1), E(1)};
      clip<E>(a.y, dy, j > rows_.low, E(j) * unit, j < rows_.high, E(j + 1) * unit, t0, t1);
      if (less(t1, t0)) continue;
      const auto cell = [&](const Fraction<E>& t) {
        return std::clamp(index_of(floor_div(E(a.x * t.d + t.n * dx), E(t.d * unit))), columns_.low,
                          columns_.high);
      };
      const Index one = cell(t0), other = cell(t1);
      spend(std::abs(one - other));
      for (Index i = std::min(one, other); i <= std::max(one, other); ++i) {
        Fraction<E> s0 = t0, s1 = t1;
        clip<E>(a.x, dx, i > columns_.low, E(i) * unit, i < columns_.high, E(i + 1) * unit, s0, s1);
        if (less(s1, s0)) continue;
        seen |= whole_segment<E>(f, i, j, {a.x - E(i) * unit, a.y - E(j) * unit}, dx, dy, s0, s1, e);
        if (settled(seen, aim)) return seen;
      }
    }
  }
  if (!inside || p.size() < 3) return seen;
  for (Index j = std::max(box.top, rows_.low + 1); j <= last && j <= rows_.high; ++j) {
    const E y = E(j) * unit;
    std::optional<E> left, right;
    for (std::size_t e = 0; e < p.size(); ++e) {
      const Point<E>&a = p[e], &b = p[(e + 1) % p.size()];
      if (a.y == b.y || std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
      const E d = b.y > a.y ? E(b.y - a.y) : E(a.y - b.y), dx = b.y > a.y ? E(b.x - a.x) : E(a.x - b.x);
      const E n = a.x * d + (y - a.y) * dx, by = d * unit;
      const E up = ceil_div(n, by), down = floor_div(n, by);
      if (!left || up < *left) left = up;
      if (!right || down > *right) right = down;
    }
    if (!left || *left > *right) continue;
    const Index from = std::max(index_of(*left), columns_.low + 1);
    Index until = std::min(index_of(*right), columns_.high);
    if (along_all_ != endless) until = std::min(until, from + along_all_ - 1);
    spend(until - from);
    for (Index i = from; i <= until; ++i) {
      seen |= f.signs[texel(i, j)];
      if (settled(seen, aim)) return seen;
    }
  }
  return seen;
}

template <class T>
template <class E>
unsigned Sampled<T>::whole_segment(const Field& f, Index i, Index j, const Point<E>& p, const E& dx,
                                   const E& dy, const Fraction<E>& t0, const Fraction<E>& t1,
                                   std::size_t edge) const {
  const E unit = to<E>(unit_);
  const E a = f.value<E>(texel(i, j)), b = f.value<E>(texel(i + 1, j)) - a,
          c = f.value<E>(texel(i, j + 1)) - a, d = f.value<E>(texel(i + 1, j + 1)) - a - b - c;
  const E square = d * dx * dy;
  const E slope = unit * (b * dx + c * dy) + d * (p.x * dy + p.y * dx);
  const E constant = unit * (a * unit + b * p.x + c * p.y) + d * p.x * p.y;
  const auto at = [&](const Fraction<E>& t) {
    return sign_bit(sign(E((square * t.n + slope * t.d) * t.n + constant * t.d * t.d)));
  };
  unsigned seen = 0;
  const bool crossing = has(no_cell_crossings) && (t0.n != 0 || t1.n != t1.d);
  if (!crossing) seen = at(t0) | at(t1);
  if (square == 0 || !stands_still_counts(edge, square > 0)) return seen;
  const bool up = square > 0;
  const Fraction<E> still{up ? E(-slope) : slope, up ? E(2 * square) : E(-2 * square)};
  if (!less(t0, still) || !less(still, t1)) return seen;
  const int above = sign(E(4 * square * constant - slope * slope));
  return seen | sign_bit(up ? above : -above);
}

template unsigned Sampled<Wide>::exact_signs(const std::vector<Point<Wide>>&, const Field&, Aim, bool,
                                             const Node&) const;
template unsigned Sampled<Big>::exact_signs(const std::vector<Point<Big>>&, const Field&, Aim, bool,
                                            const Node&) const;

}  // namespace mmverify::tests::foreign::bake
