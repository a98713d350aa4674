// Baking: the state of a micro-triangle in whole numbers, of a few fixed widths.
//
// state.hpp of spec/bake is the definition, in rationals; this is the same state in less time.  Bilinear alpha over a
// polygon has its extremes at centres of texels within it, and on its edges: within a cell they lie on the outline of
// the polygon's part, and on the cell's sides alpha is affine, so that a piece of a side has them at its ends.  So the
// marks of a polygon (some place is not opaque; some is not transparent) are those of the centres and those of the
// edges.  Rows whose texels have no mark that is still missing are passed over.
#pragma once

#include <optional>
#include <vector>

#include "spec/bake/whole/polygon.hpp"

namespace mmverify::spec::bake::whole {

/// Squares under a polygon's rows and columns beyond which no state is found: that takes the rationals' boxes.
inline constexpr std::int64_t most_squares = std::int64_t{1} << 17;

/// A quotient p / q.  Domain: q > 0.
template <class N>
struct Quotient {
  N p, q;
  bool operator<(const Quotient& other) const { return p * other.q < other.p * q; }
};

/// The state of one micro-triangle over the texels of a texture, in integers of one width.
template <class Numbers>
class Judge {
  using N = typename Numbers::N;
  using W = typename Numbers::W;

 public:
  Judge(const WholeTexture& t, const WholePolygon<N>& polygon)
      : t_(t), p_(polygon), unit_(N(1) << polygon.d) {
    for (std::size_t k = 0; k < 3; ++k) sides_[k] = {N(t.side(k).a), N(t.side(k).b), t.side(k).is_closed};
  }

  /// The marks of the polygon; none where it lies over more than most_squares.
  std::optional<Marks> marks() {
    N right = 0, bottom = 0;
    for (const auto& q : p_.corners) right = std::max(right, N(q.x)), bottom = std::max(bottom, N(q.y));
    const std::int64_t next = t_.filter() == Filter::bilinear ? 1 : 0;
    const N columns = floor_shift(right, p_.d) + next, rows = floor_shift(bottom, p_.d) + next;
    if (columns + rows > most_squares) return std::nullopt;
    columns_ = {p_.column, p_.column + static_cast<std::int64_t>(columns)};
    rows_ = static_cast<std::int64_t>(rows) + 1;
    const Marks all = mark_rows();
    if (all != both) return all;
    if (t_.filter() == Filter::nearest) {
      for (std::int64_t j = 0; j < rows_ && seen_ != both; ++j)
        if (adds(of_row_[static_cast<std::size_t>(j)])) take_squares(j);
      return seen_;
    }
    for (std::int64_t j = 0; j < rows_ && seen_ != both; ++j)
      if (adds(of_row_[static_cast<std::size_t>(j)])) take_centres(j);
    for (std::size_t k = 0; k < p_.corners.size() && seen_ != both; ++k)
      take_edge(p_.corners[k], p_.corners[(k + 1) % p_.corners.size()]);
    return seen_;
  }

  /// Whether alpha at the centroid is rather opaque.
  bool leans() const {
    // Three times as many units, so that the centroid is the sum.
    const N unit = 3 * unit_;
    const N column = floor_div(p_.sum.x, unit), row = floor_div(p_.sum.y, unit);
    const std::int64_t i = p_.column + static_cast<std::int64_t>(column),
                       j = p_.row + static_cast<std::int64_t>(row);
    if (t_.filter() == Filter::nearest) return holds(2, height(2, t_.stored_at(i, j)));
    return holds(2, bilinear(heights(2, stored_of(i, j)), N(p_.sum.x - column * unit),
                             N(p_.sum.y - row * unit), unit));
  }

 private:
  using Point = TexturePoint<N>;
  /// The side's heights of a cell's texels, in the order of stored_of().
  using Heights = std::array<N, 4>;
  struct Side {
    N a, b;
    bool is_closed;
  };

  bool adds(Marks marks) const { return (marks & ~seen_) != 0; }
  template <class Height>
  bool holds(std::size_t side, const Height& height) const {
    return height > 0 || (sides_[side].is_closed && height == 0);
  }
  N height(std::size_t side, std::int64_t stored) const {
    return sides_[side].a * N(stored) - sides_[side].b;
  }
  /// The stored numbers of a cell's texels: (i, j), (i+1, j), (i, j+1), (i+1, j+1).
  std::array<std::int64_t, 4> stored_of(std::int64_t i, std::int64_t j) const {
    return {t_.stored_at(i, j), t_.stored_at(i + 1, j), t_.stored_at(i, j + 1), t_.stored_at(i + 1, j + 1)};
  }
  Heights heights(std::size_t side, const std::array<std::int64_t, 4>& stored) const {
    return {height(side, stored[0]), height(side, stored[1]), height(side, stored[2]),
            height(side, stored[3])};
  }
  /// The height at (x, y) of a cell with sides of `unit`, times unit^2.
  static N bilinear(const Heights& h, const N& x, const N& y, const N& unit) {
    return (h[0] * (unit - x) + h[1] * x) * (unit - y) + (h[2] * (unit - x) + h[3] * x) * y;
  }

  /// Marks each row by the texels between the polygon's ends; returns the marks of all.
  Marks mark_rows() {
    Marks all = 0;
    of_row_.resize(static_cast<std::size_t>(rows_));
    for (std::int64_t j = 0; j < rows_; ++j)
      all |= of_row_[static_cast<std::size_t>(j)] = t_.marks_in_row(p_.row + j, columns_);
    return all;
  }

  /// floor(x) in squares of the place where the edge from a to b crosses the line y.  Domain: a.y < b.y.
  std::int64_t floor_at(const Point& a, const Point& b, const N& y) const {
    return static_cast<std::int64_t>(floor_shift(floor_div(crossing(a, b, y), N(b.y - a.y)), p_.d));
  }
  std::int64_t ceiling_at(const Point& a, const Point& b, const N& y) const {
    return -static_cast<std::int64_t>(floor_shift(floor_div(N(-crossing(a, b, y)), N(b.y - a.y)), p_.d));
  }
  static N crossing(const Point& a, const Point& b, const N& y) {
    return a.x * (b.y - a.y) + (y - a.y) * (b.x - a.x);
  }
  std::int64_t floored(const N& x) const { return static_cast<std::int64_t>(floor_shift(x, p_.d)); }
  std::int64_t ceiled(const N& x) const { return -static_cast<std::int64_t>(floor_shift(N(-x), p_.d)); }

  /// Calls visit(low, high) for each edge, the lower end first.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    for (std::size_t k = 0; k < p_.corners.size(); ++k) {
      const Point &a = p_.corners[k], &b = p_.corners[(k + 1) % p_.corners.size()];
      if (a.y <= b.y)
        visit(a, b);
      else
        visit(b, a);
    }
  }

  void take_row(std::int64_t j, std::int64_t first, std::int64_t last) {
    if (first <= last) seen_ |= t_.marks_in_row(p_.row + j, {p_.column + first, p_.column + last});
  }

  /// Takes the texels whose centres on row j's line are in the polygon.
  void take_centres(std::int64_t j) {
    const N y = N(j) * unit_;
    std::int64_t first = std::numeric_limits<std::int64_t>::max(),
                 last = std::numeric_limits<std::int64_t>::min();
    const auto take = [&](std::int64_t low, std::int64_t high) {
      first = std::min(first, low);
      last = std::max(last, high);
    };
    for_each_edge([&](const Point& a, const Point& b) {
      if (y < a.y || y > b.y) return;
      if (a.y != b.y) return take(ceiling_at(a, b, y), floor_at(a, b, y));
      take(ceiled(a.x), floored(a.x));
      take(ceiled(b.x), floored(b.x));
    });
    take_row(j, first, last);
  }

  /// Takes the texels of row j whose half-open squares the polygon meets.  The row lacks its high side: a place there
  /// only ends the interval of x, and its own column is met if the interval goes beyond it.
  void take_squares(std::int64_t j) {
    const N low = N(j) * unit_, high = low + unit_;
    std::int64_t first = std::numeric_limits<std::int64_t>::max(),
                 last = std::numeric_limits<std::int64_t>::min();
    const auto take = [&](std::int64_t floor, std::int64_t at_most) {
      first = std::min(first, floor);
      last = std::max(last, at_most);
    };
    for_each_edge([&](const Point& a, const Point& b) {
      for (const Point& p : {a, b})
        if (low <= p.y && p.y < high) take(floored(p.x), floored(p.x));
      if (a.y < low && low <= b.y) take(floor_at(a, b, low), floor_at(a, b, low));
      if (a.y < high && high <= b.y) take(floor_at(a, b, high), ceiling_at(a, b, high) - 1);
    });
    take_row(j, first, last);
  }

  void take_edge(const Point& from, const Point& to) {
    const Point &a = from.y <= to.y ? from : to, &b = from.y <= to.y ? to : from;
    const std::int64_t top = floored(a.y), bottom = floored(b.y);
    for (std::int64_t j = top; j <= bottom && seen_ != both; ++j) {
      if (!adds(of_row_[static_cast<std::size_t>(j)] | of_row_[static_cast<std::size_t>(j + 1)])) continue;
      const std::int64_t begin = j == top ? floored(a.x) : floor_at(a, b, N(N(j) * unit_)),
                         end = j == bottom ? floored(b.x) : floor_at(a, b, N(N(j + 1) * unit_));
      const Interval cells{std::min(begin, end), std::max(begin, end)},
          texels{p_.column + cells.first, p_.column + cells.last + 1};
      if (!adds(t_.marks_in_row(p_.row + j, texels) | t_.marks_in_row(p_.row + j + 1, texels))) continue;
      for (std::int64_t i = cells.first; i <= cells.last && seen_ != both; ++i) take_cell(a, b, i, j);
    }
  }

  /// Takes the part of an edge in the closed cell (i, j).  Domain: the edge meets the cell.
  void take_cell(const Point& a, const Point& b, std::int64_t i, std::int64_t j) {
    const std::int64_t x = p_.column + i, y = p_.row + j;
    const Marks m[4] = {t_.marks_at(x, y), t_.marks_at(x + 1, y), t_.marks_at(x, y + 1),
                        t_.marks_at(x + 1, y + 1)};
    seen_ |= m[0] & m[1] & m[2] & m[3];  // a mean of numbers on one side is on it
    const Marks open = (m[0] | m[1] | m[2] | m[3]) & ~seen_;
    if (open == 0) return;
    const Point local{N(a.x - N(i) * unit_), N(a.y - N(j) * unit_)}, along{N(b.x - a.x), N(b.y - a.y)};
    Quotient<N> from{0, 1}, to{1, 1};
    clip(local.x, along.x, from, to);
    clip(local.y, along.y, from, to);
    if (to < from) return;
    const auto stored = stored_of(x, y);
    for (std::size_t side = 0; side < 2; ++side) {
      if ((open & 1u << side) == 0) continue;
      const Heights h = heights(side, stored);
      if (holds(side, at(h, local, along, from)) || holds(side, at(h, local, along, to)) ||
          turns_over(side, h, local, along, from, to))
        seen_ |= 1u << side;
    }
  }

  /// Cuts from..to down to the t with 0 <= x + t dx <= unit.
  void clip(const N& x, const N& dx, Quotient<N>& from, Quotient<N>& to) const {
    if (dx == 0) return;
    const Quotient<N> low = dx > 0 ? Quotient<N>{N(-x), dx} : Quotient<N>{N(x - unit_), N(-dx)},
                      high = dx > 0 ? Quotient<N>{N(unit_ - x), dx} : Quotient<N>{x, N(-dx)};
    if (from < low) from = low;
    if (high < to) to = high;
  }

  /// The height at the end p + t d of a part, times a positive number.  Domain: t is 0 or 1, or the place is on a
  /// side of the cell, where the height is affine.
  N at(const Heights& h, const Point& p, const Point& d, const Quotient<N>& t) const {
    const N x = p.x * t.q + t.p * d.x, y = p.y * t.q + t.p * d.y, end = unit_ * t.q;
    if (x == 0) return h[0] * (end - y) + h[2] * y;
    if (x == end) return h[1] * (end - y) + h[3] * y;
    if (y == 0) return h[0] * (end - x) + h[1] * x;
    if (y == end) return h[2] * (end - x) + h[3] * x;
    return bilinear(h, x, y, end);
  }

  /// Whether the height m + l t + k t^2 along an edge, times unit^2, has a greatest value on the side between the ends:
  /// at t = -l / 2k with k < 0 it is m - l^2 / 4k.
  bool turns_over(std::size_t side, const Heights& h, const Point& p, const Point& d, const Quotient<N>& from,
                  const Quotient<N>& to) const {
    const N bend = h[0] - h[1] - h[2] + h[3];
    if (bend == 0 || d.x == 0 || d.y == 0 || ((bend > 0) == ((d.x > 0) == (d.y > 0)))) return false;
    const W unit(unit_), e(bend), b = W(h[1] - h[0]) * unit, c = W(h[2] - h[0]) * unit, x(p.x), y(p.y),
                                  dx(d.x), dy(d.y);
    const W k = e * dx * dy, l = b * dx + c * dy + e * (x * dy + y * dx),
            m = W(h[0]) * unit * unit + b * x + c * y + e * x * y;
    const W twice = -2 * k;
    if (l * W(from.q) <= twice * W(from.p) || l * W(to.q) >= twice * W(to.p)) return false;
    const W over = l * l - 4 * k * m;
    return holds(side, over);
  }

  const WholeTexture& t_;
  const WholePolygon<N>& p_;
  const N unit_;
  std::array<Side, 3> sides_;
  Interval columns_{0, 0};
  std::int64_t rows_ = 0;
  std::vector<Marks> of_row_;
  Marks seen_ = 0;
};

/// Calls ask(judge) in numbers of a width; none where they are too narrow.
template <class Numbers, class Ask>
auto in_width(const WholeTexture& t, const Place& place, Ask ask)
    -> decltype(ask(std::declval<Judge<Numbers>&>())) {
  const auto polygon = polygon_of<typename Numbers::N, Numbers::bits>(t, place);
  // A height times two coordinates, each of three times as many units for the centroid, in sums of four.
  if (!polygon || t.height_bits() + 2 * (polygon->bits + 2) + 2 > Numbers::bits) return std::nullopt;
  Judge<Numbers> judge(t, *polygon);
  return ask(judge);
}

/// Calls ask(judge) in the narrowest numbers that hold all on the way; none where none do, or the texture has no whole
/// numbers.
template <class Ask>
auto in_narrowest(const WholeTexture& t, const Place& place, Ask ask)
    -> decltype(in_width<Width128>(t, place, ask)) {
  if (!t.is_supported()) return std::nullopt;
  if (auto found = in_width<Width128>(t, place, ask)) return found;
  if (auto found = in_width<Width256>(t, place, ask)) return found;
  return in_width<Width512>(t, place, ask);
}

/// The state of a closed micro-triangle, or of one that is dilated; none where whole numbers do not find it.
/// Domain: place.level in 0..16, index below 4^level.
/// Errors: those of polygon_of.
/// Test: bake_whole_test
inline std::optional<State> state(const WholeTexture& t, const Place& place) {
  const auto marks = in_narrowest(t, place, [](auto& judge) { return judge.marks(); });
  if (!marks) return std::nullopt;
  return *marks == both ? State::C : *marks == not_opaque ? State::T : State::O;
}

/// Whether alpha at the centroid of a micro-triangle is rather opaque; none where whole numbers do not find it.
/// Domain, errors: those of state.
/// Test: bake_whole_test
inline std::optional<bool> leans(const WholeTexture& t, const Place& place) {
  return in_narrowest(t, place, [](auto& judge) { return std::optional<bool>(judge.leans()); });
}

}  // namespace mmverify::spec::bake::whole
