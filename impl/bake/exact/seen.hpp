// The marks that a closed triangle, or one dilated by a rectangle, bears in a texture, in whole numbers.  Internal to
// impl/bake.
//
// The marks say whether some heights (impl/bake/texture/limits.hpp) are negative, and whether some are not.
// Coordinates are those of cells (spec/bake/bake.hpp), the centre of texel (i, j) at (i, j), or with nearest filtering
// those of texels, its low corner at (i, j).  The unit is 2^-F texel, S = 2^F.
//
// Segments.  The dilated triangle P is its sum with [-m, m] x [-n, n].  Its edges are among the triangle's edges, each
// moved by (+-m, +-n), and the sides of the rectangles about the triangle's corners.  All of these lie in P, so the extremes on P's
// edges are extremes on them, and a row's part of P reaches from their least to their greatest x in the row.  With m = n =
// 0 they are the three edges.
//
// Bilinear: the extremes over P are among
//   the segments' ends; the points where they cross rows and columns of centres; the centres within;
//   and, on each segment in each cell, the point where alpha stands still.
// Each of them is a quotient over a positive number, so the sign of its numerator decides.  Centres on the border are
// crossings, unless they are corners.  A triangle of no area has no inside: its edges decide.
//
// Nearest: row j of texels is met where P comes below j + 1 and not only above it; of P's part with j <= y <
// j + 1, the texels from floor(inf x) to floor(sup x), less the last where sup x is whole and not attained.
//
// Far away.  Beyond the end of an axis (impl/bake/texture/wrap.hpp, Extent) alpha does not depend on that axis.
// Bilinear, P bears there only marks of its edges' ends, of points where they cross that end, and of points where they
// cross lines of the other axis: only these are looked at, and of repeating lines one period.  Nearest, all rows there
// are one, and P, being convex, meets one run of it.  An edge whose texels repeat is cut off after one closing
// (Closing), and of equal rows no more are taken than a period has (each_row()).
//
// Bits.  With P bits for S and for coordinates from a cell near by, and g bits for heights and their sums,
//   a corner    (G S + G f) S           2P + g + 2
//   a crossing  S dy G + r G            2P + g + 1
//   centroid    the same in S/3         2P + g + 6
//   standstill  k = d dx dy             2P + g + 2
//               l, m                    2P + g + 4
//               4 k m - l^2             4P + 2g + 9
// so that 4P + 2g + 12 bits, sign included, are enough.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "impl/bake/exact/closing.hpp"
#include "impl/bake/texture/limits.hpp"
#include "impl/bake/texture/properties.hpp"
#include "impl/bake/texture/rows.hpp"
#include "impl/bake/texture/wrap.hpp"
#include "impl/common/wide.hpp"

namespace mmverify::impl::bake::detail {

/// The corners of a triangle, dilated or not, and the segments between them.
template <class Int>
struct Outline {
  /// Corners of a rectangle around each corner of the triangle.
  static constexpr std::size_t around = 4;
  using Along = Few<Int, 3 * around>;
  Along x, y;
  Few<std::array<std::size_t, 2>, 2 * 3 * around> segments;

  Outline(const std::array<Int, 3>& at_x, const std::array<Int, 3>& at_y, const Int& across,
          const Int& down) {
    if (across == Int(0) && down == Int(0)) {
      for (std::size_t k = 0; k < 3; ++k) {
        x.push_back(at_x[k]);
        y.push_back(at_y[k]);
        segments.push_back({k, (k + 1) % 3});
      }
      return;
    }
    // The corners of the rectangle around corner k: (-, -), (-, +), (+, +), (+, -).
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t s = 0; s < around; ++s) {
        x.push_back(s < 2 ? at_x[k] - across : at_x[k] + across);
        y.push_back(s == 0 || s == 3 ? at_y[k] - down : at_y[k] + down);
        segments.push_back({around * k + s, around * k + (s + 1) % around});
        segments.push_back({around * k + s, around * ((k + 1) % 3) + s});
      }
  }
};

/// The heights to judge, and the marks that suffice; with BLEND only negative heights tell.
template <class Int>
struct Question {
  Height<Int> height;
  Marks enough = both;
  /// Turns the marks of all texels of a rectangle into marks of heights: `below` if some texel's height is negative,
  /// `opaque` if some is not.
  Marks (*of_texels)(Marks) = [](Marks m) { return m; };
};

/// The marks of one outline, exactly.
/// Time: that of the rows of a period and of the cells along the edges, up to one closing; there are no rows or cells
/// beyond the ends of an axis.
/// Domain: Int has the bits above.
template <class Int>
class Exact {
 public:
  /// Points are in units of 2^-fraction_bits from the origin of texel (column, row), none below 0 nor beyond
  /// `cells` texels.
  Exact(const TextureProperties& sides, const Question<Int>& question, std::int64_t column, std::int64_t row,
        std::int64_t cells, int fraction_bits, const Outline<Int>& outline, const Closings& closings)
      : sides_(sides),
        question_(question),
        column_(column),
        row_(row),
        cells_(cells),
        unit_(Int(1) << fraction_bits),
        outline_(outline),
        x_(outline.x),
        y_(outline.y),
        closings_(closings),
        across_(from_here(sides.across(), column)),
        down_(from_here(sides.down(), row)) {}

  Marks bilinear() {
    for (std::size_t k = 0; k < x_.size() && !done(); ++k) take(sign_at(x_[k], y_[k], unit_));
    for (const auto& [from, to] : outline_.segments)
      if (!done()) edge(from, to);
    if (!done()) centres();
    return marks_;
  }

  Marks nearest() {
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    const std::int64_t top = whole(*low, unit_), bottom = whole(*high, unit_),
                       first = std::clamp(top, down_.first, down_.last),
                       last = std::clamp(bottom, down_.first, down_.last);
    // Beyond its ends an axis has one row: the first or last row takes everything beyond.
    rows(first, last, [&](std::int64_t j) { return met(j == first ? top : j, j == last ? bottom : j); });
    return marks_;
  }

  /// The mark at a point in units of 1/unit texel.
  Marks sign_at(const Int& x, const Int& y, const Int& unit) const {
    const std::int64_t i = whole(x, unit), j = whole(y, unit);
    const Int f = x - Int(i) * unit, h = y - Int(j) * unit;
    const auto along = [&](std::int64_t r) { return texel(i, r) * (unit - f) + texel(i + 1, r) * f; };
    return sign(along(j) * (unit - h) + along(j + 1) * h);
  }
  Marks nearest_at(const Int& x, const Int& y, const Int& unit) const {
    return sign(texel(whole(x, unit), whole(y, unit)));
  }

 private:
  /// The extent counted from texel `origin`; ends beyond all points are brought nearer, for products with sizes.
  Extent from_here(Extent e, std::int64_t origin) const {
    if (!e.ends()) return e;
    const auto near = [&](std::int64_t k) { return std::clamp<std::int64_t>(k - origin, -2, cells_ + 2); };
    return {near(e.first), near(e.last), 0};
  }
  void take(Marks m) { marks_ = static_cast<Marks>(marks_ | m); }
  bool done() const { return (marks_ & question_.enough) == question_.enough; }

  Int texel(std::int64_t i, std::int64_t j) const {
    return question_.height(sides_.stored(column_ + i, row_ + j));
  }
  static Marks sign(const Int& value) { return value < Int(0) ? below : opaque; }
  /// Takes the marks of texels row by row; columns(j) are columns of the texture, before wrapping.
  template <class Of>
  void rows(std::int64_t first, std::int64_t last, Of columns) {
    Few<Bend, 3 * Outline<Int>::around> bends;
    if (!down_.ends())
      for (const Int& y : y_) {
        const std::int64_t at = whole(y, unit_);
        bends.push_back({at - 1, at + 1});
      }
    each_row(first, last, down_.period, {bends.data(), bends.size()}, columns,
             [this](const Columns& at, std::int64_t j) {
               if (!at.empty()) take(question_.of_texels(sides_.of(at.first, at.last, row_ + j, row_ + j)));
               return !done();
             });
  }

  /// The greatest i with i size <= position.  Domain: size > 0, 0 <= position <= cells size.
  static std::int64_t whole(const Int& position, const Int& size) {
    // The quotient in binary64 is off by less than 2^-50 of itself, and is below 2^37, so i is off by one at most.
    const double ratio = static_cast<double>(leading(position)) / static_cast<double>(leading(size));
    const auto i = static_cast<std::int64_t>(std::ldexp(ratio, bit_width(position) - bit_width(size)));
    const Int rest = position - Int(i) * size;
    if (rest < Int(0)) return i - 1;
    return rest < size ? i : i + 1;
  }

  /// The place, times db, where the line from (a, b), b <= level, to (a + da, b + db), db > 0, is at b = level.
  static Int crossing(const Int& a, const Int& b, const Int& da, const Int& db, const Int& level) {
    return a * db + da * (level - b);
  }

  /// The part of [first, last] without the runs at either end that lie beside an axis on one side.  Domain: side(j) is
  /// -1, 0 or 1, and monotonic.
  template <class Side>
  static std::pair<std::int64_t, std::int64_t> between_sides(std::int64_t first, std::int64_t last,
                                                             Side side) {
    if (first > last) return {first, last};
    const auto after = [&](std::int64_t low, std::int64_t high, auto is_low) {
      while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (is_low(middle) ? low : high) = middle;
      }
      return high;
    };
    const int begins = side(first), ends = side(last);
    if (begins != 0) first = after(first, last + 1, [&](std::int64_t j) { return side(j) == begins; });
    if (ends != 0 && first <= last)
      last = after(first - 1, last, [&](std::int64_t j) { return side(j) != ends; }) - 1;
    return {first, last};
  }
  /// The side of a/size with respect to an axis: -1 or 1 beyond its ends, else 0.
  static int side_of(const Int& a, const Int& size, const Extent& e) {
    return !(Int(e.first) * size < a) ? -1 : !(a < Int(e.last) * size) ? 1 : 0;
  }

  /// Takes the marks where the edge from (a, b) to (a1, b1) crosses whole b; `transposed`: b is x.  Beyond the ends of
  /// the axis of b alpha does not depend on it.  Beyond those of a alpha depends on b alone, and one period is enough.
  void crossings(Int a, Int b, Int a1, Int b1, const Extent& of_a, const Extent& of_b, bool transposed) {
    if (b1 < b) {
      std::swap(a, a1);
      std::swap(b, b1);
    }
    const Int da = a1 - a, db = b1 - b, size = unit_ * db;
    if (db == Int(0)) return;
    const auto at = [&](std::int64_t j) { return crossing(a, b, da, db, Int(j) * unit_); };
    const auto ask = [&](std::int64_t from, std::int64_t to) {
      for (std::int64_t j = from; j <= to && !done(); ++j) {
        const Int p = at(j);
        const std::int64_t i = whole(p, size);
        const Int f = p - Int(i) * size;
        const Int g = transposed ? texel(j, i) : texel(i, j),
                  next = transposed ? texel(j, i + 1) : texel(i + 1, j);
        take(sign(g * (size - f) + next * f));
      }
    };
    const std::int64_t first = std::max(whole(b, unit_) + 1, of_b.first),
                       last = std::min(whole_below(b1), of_b.last);
    if (of_b.ends() || !of_a.ends()) return ask(first, last);
    const auto [begin, end] =
        between_sides(first, last, [&](std::int64_t j) { return side_of(at(j), size, of_a); });
    ask(first, std::min(begin, first + of_b.period) - 1);
    ask(begin, end);
    ask(std::max(end, last - of_b.period) + 1, last);
  }
  /// The greatest whole number of texels before b.
  std::int64_t whole_below(const Int& b) const {
    const std::int64_t j = whole(b, unit_);
    return Int(j) * unit_ == b ? j - 1 : j;
  }

  /// Shortens an edge that closes, to the part before alpha repeats.
  void fold(const Int& x, const Int& y, Int& x1, Int& y1) const {
    for (const auto& [columns, lines] : closings_) {
      const std::int64_t across = columns < 0 ? -columns : columns, down = lines < 0 ? -lines : lines;
      if (across > cells_ || down > cells_) continue;
      const Int dx = x1 - x, dy = y1 - y, cx = Int(columns) * unit_, cy = Int(lines) * unit_;
      if (!(dx * cy == dy * cx)) continue;
      const Int length = across != 0 ? dx : dy, step = across != 0 ? cx : cy;
      const bool same_way = (length < Int(0)) == (step < Int(0));
      const Int size = length < Int(0) ? -length : length;
      if (!((step < Int(0) ? -step : step) < size)) continue;
      x1 = same_way ? x + cx : x - cx;
      y1 = same_way ? y + cy : y - cy;
    }
  }

  void edge(std::size_t from, std::size_t to) {
    Int x0 = x_[from], y0 = y_[from], x1 = x_[to], y1 = y_[to];
    fold(x0, y0, x1, y1);
    crossings(x0, y0, x1, y1, across_, down_, false);
    if (!done()) crossings(y0, x0, y1, x1, down_, across_, true);
    if (done() || x0 == x1 || y0 == y1) return;
    // Visits the edge's cells, row by row, where alpha depends on both coordinates.
    if (y1 < y0) {
      std::swap(x0, x1);
      std::swap(y0, y1);
    }
    const Int dx = x1 - x0, dy = y1 - y0, size = unit_ * dy;
    const auto at = [&](const Int& y) { return crossing(x0, y0, dx, dy, y); };
    const auto top = [&](std::int64_t j) { return at(std::max(y0, Int(j) * unit_)); };
    const auto bottom = [&](std::int64_t j) { return at(std::min(y1, Int(j + 1) * unit_)); };
    std::int64_t begin = std::max(whole(y0, unit_), down_.first),
                 end = std::min(whole(y1, unit_), down_.last - 1);
    if (across_.ends())
      std::tie(begin, end) = between_sides(begin, end, [&](std::int64_t j) {
        const int one = side_of(top(j), size, across_);
        return one == side_of(bottom(j), size, across_) ? one : 0;
      });
    for (std::int64_t j = begin; j <= end; ++j) {
      std::int64_t i = whole(top(j), size), last = whole(bottom(j), size);
      if (last < i) std::swap(i, last);
      for (i = std::max(i, across_.first), last = std::min(last, across_.last - 1); i <= last; ++i) {
        standstill(x0 - Int(i) * unit_, y0 - Int(j) * unit_, dx, dy, i, j);
        if (done()) return;
      }
    }
  }

  /// Takes the mark where alpha stands still on the edge (x, y) + t (dx, dy), counted from the corner of cell (i, j):
  ///   S^2 alpha = m + l t + k t^2 with the value m - l^2/4k at t = -l/2k.
  void standstill(const Int& x, const Int& y, const Int& dx, const Int& dy, std::int64_t i, std::int64_t j) {
    const Int a = texel(i, j), right = texel(i + 1, j), under = texel(i, j + 1), across = texel(i + 1, j + 1);
    // The sign of a mean of four heights of one sign is that sign, which the corners have borne.
    const bool negative = a < Int(0);
    if (negative == (right < Int(0)) && negative == (under < Int(0)) && negative == (across < Int(0))) return;
    const Int b = right - a, c = under - a, d = a - right - under + across;
    Int k = d * dx * dy;
    if (k == Int(0)) return;
    Int l = unit_ * (b * dx + c * dy) + d * (x * dy + y * dx),
        m = unit_ * (a * unit_ + b * x + c * y) + d * x * y;
    const bool least = Int(0) < k;
    if (!least) k = -k, l = -l, m = -m;
    const Int two_k = k + k;
    if (!(l < Int(0)) || two_k < -l) return;  // t not in (0, 1]
    const Int at_x = two_k * x - l * dx, at_y = two_k * y - l * dy, side = two_k * unit_;
    if (at_x < Int(0) || side < at_x || at_y < Int(0) || side < at_y) return;
    const Int value = (two_k + two_k) * m - l * l;
    take(sign(least ? value : -value));
  }

  /// Takes the marks of centres strictly within.  A row beyond the ends of its axis is as the last one before: a line
  /// from one of its centres, along y, leaves the region through an edge where alpha is the same.
  void centres() {
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    rows(std::max(whole(*low, unit_) + 1, down_.first), std::min(whole_below(*high), down_.last),
         [this](std::int64_t j) { return within(j); });
  }
  Columns within(std::int64_t j) const {
    const Int level = Int(j) * unit_;
    std::int64_t first = cells_ + 2, end = 0;
    for (auto [from, to] : outline_.segments) {
      if (y_[to] < y_[from]) std::swap(from, to);
      if (y_[from] == y_[to] || level < y_[from] || y_[to] < level) continue;
      const Int dy = y_[to] - y_[from], size = unit_ * dy;
      const Int at = crossing(x_[from], y_[from], x_[to] - x_[from], dy, level);
      const std::int64_t i = whole(at, size);
      first = std::min(first, i + 1);
      end = std::max(end, at == Int(i) * size ? i : i + 1);
    }
    return sides_.columns(column_ + first, column_ + end - 1);
  }

  /// The columns that the outline meets anywhere in the rows [top, bottom].
  Columns met(std::int64_t top, std::int64_t bottom) const {
    const Int level = Int(top) * unit_, next = Int(bottom + 1) * unit_;
    std::int64_t first = cells_ + 2, last = -1;
    for (const auto& [one, other] : outline_.segments) {
      const bool down = !(y_[other] < y_[one]);
      const std::size_t from = down ? one : other, to = down ? other : one;
      if (y_[to] < level || !(y_[from] < next)) continue;
      const Int dx = x_[to] - x_[from], dy = y_[to] - y_[from];
      const auto reach = [&](const Int& at, const Int& size, bool attained) {
        const std::int64_t i = whole(at, size);
        first = std::min(first, i);
        last = std::max(last, attained || Int(i) * size < at ? i : i - 1);
      };
      if (dy == Int(0)) {
        reach(x_[from], unit_, true);
        reach(x_[to], unit_, true);
        continue;
      }
      const Int size = unit_ * dy;
      const auto at = [&](const Int& y) { return crossing(x_[from], y_[from], dx, dy, y); };
      reach(at(std::max(y_[from], level)), size, true);
      const bool leaves = !(y_[to] < next);
      reach(at(leaves ? next : y_[to]), size, !leaves);
    }
    return sides_.columns(column_ + first, column_ + last);
  }

  const TextureProperties& sides_;
  const Question<Int>& question_;
  std::int64_t column_, row_, cells_;
  Int unit_;
  const Outline<Int>& outline_;
  const typename Outline<Int>::Along &x_, &y_;
  const Closings& closings_;
  Extent across_, down_;  ///< counted from (column, row)
  Marks marks_ = 0;
};

}  // namespace mmverify::impl::bake::detail
