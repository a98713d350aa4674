// What a closed triangle, or one dilated by a square, sees of a texture, in whole numbers.  Internal to
// impl/bake.
//
// Of heights (impl/bake/texture/limits.hpp): whether some are negative, and whether some are not.  Coordinates are those
// of cells (spec/bake/bake.hpp), the centre of texel (i, j) at (i, j), or with nearest filtering those of texels,
// its low corner at (i, j); in units of 2^-F, S = 2^F to a texel.
//
// Segments.  The dilated triangle P is its sum with [-m, m]^2.  Its edges are among the triangle's, each
// moved by (+-m, +-m), and the sides of the squares about the triangle's corners; all of these lie in P.  So
// what is greatest and least on P's edges is so on them, and a row's part of P is between the least and the
// greatest of what they have in the row.  With m = 0 they are the three edges.
//
// Bilinear: the extremes over P are among
//   the segments' ends; the points where they cross rows and columns of centres; the centres within;
//   and, on each segment in each cell, the point where alpha stands still.
// Every one is a quotient over a positive number, and only its numerator's sign is asked.  Centres on the
// border are crossings, unless they are corners.  A triangle of no area has no inside: its edges say it all.
//
// Nearest: row j of texels is met where P comes below j + 1 and not only above it; of P's part with j <= y <
// j + 1, the texels from floor(inf x) to floor(sup x), less the last where sup x is whole and not attained.
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
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "impl/bake/texture/limits.hpp"
#include "impl/bake/texture/properties.hpp"

namespace mmverify::impl::bake::detail {

/// Points, and the segments between them.
template <class Int>
struct Outline {
  std::vector<Int> x, y;
  std::vector<std::pair<std::size_t, std::size_t>> segments;

  Outline(const std::array<Int, 3>& at_x, const std::array<Int, 3>& at_y, const Int& margin) {
    if (margin == Int(0)) {
      x.assign(at_x.begin(), at_x.end());
      y.assign(at_y.begin(), at_y.end());
      segments = {{0, 1}, {1, 2}, {2, 0}};
      return;
    }
    // Around each corner (-, -), (-, +), (+, +), (+, -).
    constexpr std::size_t around = 4;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t s = 0; s < around; ++s) {
        x.push_back(s < 2 ? at_x[k] - margin : at_x[k] + margin);
        y.push_back(s == 0 || s == 3 ? at_y[k] - margin : at_y[k] + margin);
        segments.push_back({around * k + s, around * k + (s + 1) % around});
        segments.push_back({around * k + s, around * ((k + 1) % 3) + s});
      }
  }
};

/// Which heights are asked, what they mean and when enough is known: with BLEND only negative ones tell.
template <class Int>
struct Question {
  Height<Int> height;
  Marks enough = both;
  /// Of `below`, that some texel of a rectangle is negative, and of `opaque`, that some is not, from the
  /// marks of all.
  Marks (*of_texels)(Marks) = [](Marks m) { return m; };
};

/// Domain: Int has the bits above.
template <class Int>
class Exact {
 public:
  /// Points in units of 2^-fraction_bits from the origin of texel (column, row), none below 0 nor beyond
  /// `cells` texels.
  Exact(const TextureProperties& sides, const Question<Int>& question, std::int64_t column, std::int64_t row,
        std::int64_t cells, int fraction_bits, const Outline<Int>& outline)
      : sides_(sides),
        question_(question),
        column_(column),
        row_(row),
        cells_(cells),
        unit_(Int(1) << fraction_bits),
        outline_(outline),
        x_(outline.x),
        y_(outline.y) {}

  Marks bilinear() {
    for (std::size_t k = 0; k < x_.size() && !done(); ++k) take(sign_at(x_[k], y_[k], unit_));
    for (const auto& [from, to] : outline_.segments)
      if (!done()) edge(from, to);
    if (!done()) centres();
    return marks_;
  }

  Marks nearest() {
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    const std::int64_t last = whole(*high, unit_);
    for (std::int64_t j = whole(*low, unit_); j <= last && !done(); ++j) texels(j);
    return marks_;
  }

  /// Of a point in units of 1/unit texel.
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
  void take(Marks m) { marks_ = static_cast<Marks>(marks_ | m); }
  bool done() const { return (marks_ & question_.enough) == question_.enough; }

  Int texel(std::int64_t i, std::int64_t j) const {
    return question_.height(sides_.stored(column_ + i, row_ + j));
  }
  static Marks sign(const Int& value) { return value < Int(0) ? below : opaque; }
  void take_row(std::int64_t first, std::int64_t last, std::int64_t j) {
    if (first <= last)
      take(question_.of_texels(sides_.of(column_ + first, column_ + last, row_ + j, row_ + j)));
  }

  /// The greatest i with i size <= position.  Domain: size > 0, 0 <= position <= cells size.
  std::int64_t whole(const Int& position, const Int& size) const {
    std::int64_t low = 0, high = cells_ + 1;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (Int(middle) * size <= position ? low : high) = middle;
    }
    return low;
  }

  /// Where the line from (a, b), b <= level, to (a + da, b + db), db > 0, is at b = level: over db.
  static Int crossing(const Int& a, const Int& b, const Int& da, const Int& db, const Int& level) {
    return a * db + da * (level - b);
  }

  /// What an edge crosses where one coordinate, b, is a whole number of texels; `transposed`: b is x.
  void crossings(const std::vector<Int>& a, const std::vector<Int>& b, std::size_t from, std::size_t to,
                 bool transposed) {
    if (b[to] < b[from]) std::swap(from, to);
    const Int da = a[to] - a[from], db = b[to] - b[from], size = unit_ * db;
    if (db == Int(0)) return;
    for (std::int64_t j = whole(b[from], unit_) + 1; Int(j) * unit_ < b[to] && !done(); ++j) {
      const Int at = crossing(a[from], b[from], da, db, Int(j) * unit_);
      const std::int64_t i = whole(at, size);
      const Int f = at - Int(i) * size;
      const Int g = transposed ? texel(j, i) : texel(i, j),
                next = transposed ? texel(j, i + 1) : texel(i + 1, j);
      take(sign(g * (size - f) + next * f));
    }
  }

  void edge(std::size_t from, std::size_t to) {
    crossings(x_, y_, from, to, false);
    if (!done()) crossings(y_, x_, from, to, true);
    if (done() || x_[from] == x_[to] || y_[from] == y_[to]) return;
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
        if (done()) return;
      }
    }
  }

  /// On the edge (x, y) + t (dx, dy), from the corner of cell (i, j):
  ///   S^2 alpha = m + l t + k t^2 with the value m - l^2/4k at t = -l/2k.
  void standstill(const Int& x, const Int& y, const Int& dx, const Int& dy, std::int64_t i, std::int64_t j) {
    const Int a = texel(i, j), right = texel(i + 1, j), under = texel(i, j + 1), across = texel(i + 1, j + 1);
    // A mean of four on one side is on that side, and the corners have said so.
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

  /// Those strictly within.
  void centres() {
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    for (std::int64_t j = whole(*low, unit_) + 1; Int(j) * unit_ < *high && !done(); ++j) {
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
      take_row(first, end - 1, j);
    }
  }

  /// Those of row j that are met.
  void texels(std::int64_t j) {
    const Int level = Int(j) * unit_, next = level + unit_;
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
    take_row(first, last, j);
  }

  const TextureProperties& sides_;
  const Question<Int>& question_;
  std::int64_t column_, row_, cells_;
  Int unit_;
  const Outline<Int>& outline_;
  const std::vector<Int>&x_, &y_;
  Marks marks_ = 0;
};

}  // namespace mmverify::impl::bake::detail
