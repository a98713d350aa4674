// The exact sides of the cutoff that a closed triangle is on, in whole numbers.  Internal to impl/bake*.
//
// Coordinates are those of cells (spec/bake.hpp): the centre of texel (i, j) is at (i, j), in units of 2^-F:
// S = 2^F to a texel.  With integer texels G = unit byte - limit, opaque where G >= 0, the extremes of
// bilinear alpha over the triangle are among
//   its corners; the points where its edges cross rows and columns of centres; the centres within;
//   and, on each edge in each cell, the point where alpha stands still.
// Every one is a quotient over a positive number, and only its numerator's sign is asked.  Centres on the
// border are crossings, unless they are corners.  A triangle of no area has no inside: its edges say it all.
//
// Bits.  With P bits for S and for coordinates from a cell near by, and g bits for G and its sums,
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
#include <cstdint>
#include <utility>

#include "impl/bake_sides.hpp"
#include "impl/bake_wide.hpp"

namespace mmverify::impl::bake::detail {

/// Domain: Int has the bits above.
template <class Int>
class Exact {
 public:
  /// Corners in units of 2^-fraction_bits from the centre of the texel (column, row), none below 0 nor beyond
  /// `cells` texels.
  Exact(const Sides& sides, std::int64_t column, std::int64_t row, std::int64_t cells, int fraction_bits,
        const std::array<Int, 3>& x, const std::array<Int, 3>& y)
      : sides_(sides),
        column_(column),
        row_(row),
        cells_(cells),
        unit_(Int(1) << fraction_bits),
        x_(x),
        y_(y) {}

  Marks marks() {
    marks_ = 0;
    for (std::size_t k = 0; k < 3 && marks_ != both; ++k) take(sign_at(x_[k], y_[k], unit_));
    for (std::size_t k = 0; k < 3 && marks_ != both; ++k) edge(k, (k + 1) % 3);
    if (marks_ != both) centres();
    return marks_;
  }

  /// Of the centroid.
  Marks at_centroid() const {
    return sign_at(x_[0] + x_[1] + x_[2], y_[0] + y_[1] + y_[2], unit_ + unit_ + unit_);
  }

 private:
  void take(Marks m) { marks_ = static_cast<Marks>(marks_ | m); }

  std::int64_t texel(std::int64_t i, std::int64_t j) const {
    return sides_.unit * sides_.byte(column_ + i, row_ + j) - sides_.limit;
  }
  static Marks sign(const Int& value) { return value < Int(0) ? below : opaque; }

  /// The greatest i with i size <= position.  Domain: size > 0, 0 <= position <= cells size.
  std::int64_t whole(const Int& position, const Int& size) const {
    std::int64_t low = 0, high = cells_ + 1;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (Int(middle) * size <= position ? low : high) = middle;
    }
    return low;
  }

  /// At a point in units of 1/unit texel.
  Marks sign_at(const Int& x, const Int& y, const Int& unit) const {
    const std::int64_t i = whole(x, unit), j = whole(y, unit);
    const Int f = x - Int(i) * unit, h = y - Int(j) * unit;
    const auto along = [&](std::int64_t r) {
      return Int(texel(i, r)) * (unit - f) + Int(texel(i + 1, r)) * f;
    };
    return sign(along(j) * (unit - h) + along(j + 1) * h);
  }

  /// Where the line from (a, b), b <= level, to (a + da, b + db), db > 0, is at b = level: over db.
  static Int crossing(const Int& a, const Int& b, const Int& da, const Int& db, const Int& level) {
    return a * db + da * (level - b);
  }

  /// What an edge crosses where one coordinate, b, is a whole number of texels; `transposed`: b is x.
  void crossings(const std::array<Int, 3>& a, const std::array<Int, 3>& b, std::size_t from, std::size_t to,
                 bool transposed) {
    if (b[to] < b[from]) std::swap(from, to);
    const Int da = a[to] - a[from], db = b[to] - b[from], size = unit_ * db;
    if (db == Int(0)) return;
    for (std::int64_t j = whole(b[from], unit_) + 1; Int(j) * unit_ < b[to] && marks_ != both; ++j) {
      const Int at = crossing(a[from], b[from], da, db, Int(j) * unit_);
      const std::int64_t i = whole(at, size);
      const Int f = at - Int(i) * size;
      const std::int64_t g = transposed ? texel(j, i) : texel(i, j),
                         next = transposed ? texel(j, i + 1) : texel(i + 1, j);
      take(sign(Int(g) * (size - f) + Int(next) * f));
    }
  }

  void edge(std::size_t from, std::size_t to) {
    crossings(x_, y_, from, to, false);
    if (marks_ != both) crossings(y_, x_, from, to, true);
    if (marks_ == both || x_[from] == x_[to] || y_[from] == y_[to]) return;
    // The cells that it visits, row by row.
    if (y_[to] < y_[from]) std::swap(from, to);
    const Int dx = x_[to] - x_[from], dy = y_[to] - y_[from], size = unit_ * dy;
    const std::int64_t last = whole(y_[to], unit_);
    for (std::int64_t j = whole(y_[from], unit_); j <= last; ++j) {
      const Int top = std::max(y_[from], Int(j) * unit_), bottom = std::min(y_[to], Int(j + 1) * unit_);
      std::int64_t i = whole(crossing(x_[from], y_[from], dx, dy, top), size),
                   end = whole(crossing(x_[from], y_[from], dx, dy, bottom), size);
      if (end < i) std::swap(i, end);
      for (; i <= end; ++i) {
        standstill(x_[from] - Int(i) * unit_, y_[from] - Int(j) * unit_, dx, dy, i, j);
        if (marks_ == both) return;
      }
    }
  }

  /// On the edge (x, y) + t (dx, dy), from the corner of cell (i, j):
  ///   S^2 alpha = m + l t + k t^2 with the value m - l^2/4k at t = -l/2k.
  void standstill(const Int& x, const Int& y, const Int& dx, const Int& dy, std::int64_t i, std::int64_t j) {
    const std::int64_t a = texel(i, j), right = texel(i + 1, j), under = texel(i, j + 1),
                       across = texel(i + 1, j + 1);
    // A mean of four on one side is on that side, and the corners have said so.
    if ((a >= 0) == (right >= 0) && (a >= 0) == (under >= 0) && (a >= 0) == (across >= 0)) return;
    const Int b(right - a), c(under - a), d(a - right - under + across);
    Int k = d * dx * dy;
    if (k == Int(0)) return;
    Int l = unit_ * (b * dx + c * dy) + d * (x * dy + y * dx),
        m = unit_ * (Int(a) * unit_ + b * x + c * y) + d * x * y;
    const bool least = Int(0) < k;
    if (!least) k = -k, l = -l, m = -m;
    const Int two_k = k + k;
    if (!(l < Int(0)) || two_k < -l) return;  // t not in (0, 1]
    const Int at_x = two_k * x - l * dx, at_y = two_k * y - l * dy, side = two_k * unit_;
    if (at_x < Int(0) || side < at_x || at_y < Int(0) || side < at_y) return;
    const Int value = (two_k + two_k) * m - l * l;
    take(sign(least ? value : -value));
  }

  /// Those strictly within.
  void centres() {
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    for (std::int64_t j = whole(*low, unit_) + 1; Int(j) * unit_ < *high && marks_ != both; ++j) {
      const Int level = Int(j) * unit_;
      std::int64_t first = cells_ + 2, end = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        std::size_t from = k, to = (k + 1) % 3;
        if (y_[to] < y_[from]) std::swap(from, to);
        if (y_[from] == y_[to] || level < y_[from] || y_[to] < level) continue;
        const Int dy = y_[to] - y_[from], size = unit_ * dy;
        const Int at = crossing(x_[from], y_[from], x_[to] - x_[from], dy, level);
        const std::int64_t i = whole(at, size);
        first = std::min(first, i + 1);
        end = std::max(end, at == Int(i) * size ? i : i + 1);
      }
      if (first < end) take(sides_.of(column_ + first, column_ + end - 1, row_ + j, row_ + j));
    }
  }

  const Sides& sides_;
  std::int64_t column_, row_, cells_;
  Int unit_;
  std::array<Int, 3> x_, y_;
  Marks marks_ = 0;
};

}  // namespace mmverify::impl::bake::detail
