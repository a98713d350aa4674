// LINEAR in binary64.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/foreign/bake/sampled.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

/// Limits t to where low <= at + t by <= high.
void clip(double at, double by, bool has_low, double low, bool has_high, double high, double& t0,
          double& t1) {
  if (by == 0) {
    if ((has_low && at < low) || (has_high && at > high)) t1 = -1;
    return;
  }
  if (by > 0 ? has_low : has_high) t0 = std::max(t0, ((by > 0 ? low : high) - at) / by);
  if (by > 0 ? has_high : has_low) t1 = std::min(t1, ((by > 0 ? high : low) - at) / by);
}

/// The span of the line at height y inside the polygon; right < left if the line misses it.
std::pair<double, double> span_at(const std::vector<Point<double>>& p, double y) {
  double left = 1e300, right = -1e300;
  for (std::size_t e = 0; e < p.size(); ++e) {
    const Point<double>&a = p[e], &b = p[(e + 1) % p.size()];
    if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    left = std::min(left, x);
    right = std::max(right, x);
  }
  return {left, right};
}

}  // namespace

template <class T>
unsigned Sampled<T>::rough_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                                 bool& unsure, const Node& node) const {
  std::vector<Point<double>> p;
  double extent = 1;
  for (const auto& q : polygon) {
    p.push_back({real(q.x) / unit_real_, real(q.y) / unit_real_});
    extent = std::max({extent, std::abs(p.back().x), std::abs(p.back().y)});
  }
  const double near = has(double_decides) ? 0 : extent * 0x1p-40;
  unsigned seen = 0;
  const auto meet = [&](double value) {
    if (value > near)
      seen |= positive;
    else if (value < -near)
      seen |= negative;
    else if (has(double_decides))
      seen |= zero;
    else
      unsure = true;
  };
  const Box box = cells_of(polygon);
  spend(box.bottom - box.top);
  Index last = box.bottom;
  if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
  for (std::size_t e = 0; e < p.size(); ++e) {
    const Point<double>&a = p[e], &b = p[(e + 1) % p.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    for (Index j = box.top; j <= last; ++j) {
      double t0 = 0, t1 = 1;
      clip(a.y, dy, j > rows_.low, static_cast<double>(j), j < rows_.high, static_cast<double>(j + 1), t0,
           t1);
      if (t0 > t1) continue;
      const double xa = a.x + t0 * dx, xb = a.x + t1 * dx;
      const auto cell = [&](double x) {
        return std::clamp(static_cast<Index>(std::floor(x)), columns_.low, columns_.high);
      };
      const Index from = cell(std::min(xa, xb)), until = cell(std::max(xa, xb));
      spend(until - from);
      for (Index i = from; i <= until; ++i) {
        double s0 = t0, s1 = t1;
        clip(a.x, dx, i > columns_.low, static_cast<double>(i), i < columns_.high, static_cast<double>(i + 1),
             s0, s1);
        if (s0 > s1) continue;
        rough_segment(
            f, i, j, {a.x + s0 * dx - static_cast<double>(i), a.y + s0 * dy - static_cast<double>(j)},
            {a.x + s1 * dx - static_cast<double>(i), a.y + s1 * dy - static_cast<double>(j)}, e, meet, node);
        if (settled(seen, aim)) return seen;
      }
    }
  }
  if (has(saddle)) saddles(box, f, meet);
  if (inside && p.size() >= 3)
    rough_interior(p, box.top, last, [&](Index i, Index j) {
      meet(f.approximate[texel(i, j)]);
      return !settled(seen, aim);
    });
  return seen;
}

template <class T>
template <class Visit>
void Sampled<T>::rough_interior(const std::vector<Point<double>>& p, Index first, Index last,
                                const Visit& visit) const {
  for (Index j = std::max(first, rows_.low + 1); j <= last && j <= rows_.high; ++j) {
    const auto [left, right] = span_at(p, static_cast<double>(j));
    if (left > right) continue;
    Index from = std::clamp(index_of(static_cast<Wide>(std::ceil(left))),
                            std::max(columns_.low + 1, -endless), columns_.high);
    Index until = std::clamp(index_of(static_cast<Wide>(std::floor(right))), std::max(columns_.low, -endless),
                             columns_.high);
    if (along_all_ != endless) until = std::min(until, from + along_all_ - 1);
    spend(until - from);
    for (Index i = from; i <= until; ++i)
      if (!visit(i, j)) return;
  }
}

template <class T>
template <class Meet>
void Sampled<T>::saddles(const Box& box, const Field& f, const Meet& meet) const {
  if (box.right - box.left > 8 || box.bottom - box.top > 8) return;
  for (Index j = box.top; j <= box.bottom; ++j)
    for (Index i = box.left; i <= box.right; ++i) {
      const double a = f.approximate[texel(i, j)], b = f.approximate[texel(i + 1, j)] - a,
                   c = f.approximate[texel(i, j + 1)] - a;
      const double d = f.approximate[texel(i + 1, j + 1)] - a - b - c;
      if (d == 0) continue;
      const double x = -c / d, y = -b / d;
      if (x > 0 && x < 1 && y > 0 && y < 1) meet(a + b * x + c * y + d * x * y);
    }
}

template <class T>
template <class Meet>
void Sampled<T>::rough_segment(const Field& f, Index i, Index j, Point<double> p, Point<double> q,
                               std::size_t edge, const Meet& meet, const Node&) const {
  const auto& g = f.approximate;
  const double a = g[texel(i, j)], b = g[texel(i + 1, j)] - a, c = g[texel(i, j + 1)] - a,
               d = g[texel(i + 1, j + 1)] - a - b - c;
  const auto at = [&](double x, double y) { return a + b * x + c * y + d * x * y; };
  const double dx = q.x - p.x, dy = q.y - p.y;
  const bool crossing = p.y == 0 || q.y == 1;
  if (!(has(no_cell_crossings) && crossing)) {
    meet(at(p.x, p.y));
    meet(at(q.x, q.y));
  }
  const double square = d * dx * dy, slope = b * dx + c * dy + d * (p.x * dy + p.y * dx);
  if (square == 0 || !stands_still_counts(edge, square > 0)) return;
  const double t = -slope / (2 * square);
  if (t > 0 && t < 1) meet(at(p.x, p.y) + t * (slope + t * square));
}

template unsigned Sampled<Wide>::rough_signs(const std::vector<Point<Wide>>&, const Field&, Aim, bool, bool&,
                                             const Node&) const;
template unsigned Sampled<Big>::rough_signs(const std::vector<Point<Big>>&, const Field&, Aim, bool, bool&,
                                            const Node&) const;

}  // namespace mmverify::tests::foreign::bake
