// The mean of the texels under a triangle, in whole numbers.  Internal to impl/attribute.
//
// Coordinates are in units of 1/S texel from a texel nearby.  On an edge let D = |dx| and H = |dy| (1 in the place of
// 0).  x is kept as X = x H and y as Y = y D: crossings of rows and columns are then whole numbers.  A piece within row
// j and column i, with texel c and the sum P of the texels before it, adds to the integral of F dy
//   (2 P S H + c (X + X' - 2 i S H)) (Y' - Y) / (2 D H S^2)
// so that the mean, over an area of |A| / (2 S^2), is  sum over edges of pieces / (D H |A|).
//
// If A = 0 the triangle is a line.  Along its longer axis let l0 <= l1 <= l2 be the corners: the share of the triangle
// that maps below z is
//   (z - l0)^2 / ((l1 - l0)(l2 - l0)) up to l1,  1 - (l2 - z)^2 / ((l2 - l1)(l2 - l0)) beyond.
//
// Bits, with P for S and coordinates, T for a texel and T + 15 for sums of texels.  A piece takes 4P + T + 19, all of
// an edge 20 more; times the other edges' D H, 8P + T + 41.  On a line: squares 4P, times l 5P, times a texel 5P + T +
// 1.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "impl/attribute/bake/source.hpp"

namespace mmverify::impl::attribute::detail {

/// The greatest i in [0, limit) with i size <= at.  Domain: size > 0, 0 <= at < limit size.
template <class Int>
std::int64_t whole(const Int& at, const Int& size, std::int64_t limit) {
  std::int64_t low = 0, high = limit;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (Int(middle) * size <= at ? low : high) = middle;
  }
  return low;
}

template <class Channel, class Int>
class ExactFace {
 public:
  using Number = typename Coding<Channel>::template Number<Int>;
  using Numbers = std::array<Number, 4>;
  using Sums = std::array<Int, 4>;

  /// Corners are in units of 2^-fraction_bits from texel (column, row), none below 0 nor beyond `cells` texels.
  ExactFace(const Source<Channel>& source, std::int64_t column, std::int64_t row, std::int64_t cells,
            int fraction_bits, const std::array<Int, 3>& x, const std::array<Int, 3>& y)
      : source_(source),
        column_(column),
        row_(row),
        cells_(cells),
        unit_(Int(1) << fraction_bits),
        x_(x),
        y_(y) {}

  /// The mean is sums / count, count > 0.
  std::pair<Sums, Int> mean() {
    const Int area = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (y_[1] - y_[0]) * (x_[2] - x_[0]);
    if (area == Int(0)) return on_a_line();
    std::array<Sums, 3> edges;
    std::array<Int, 3> scale;
    for (std::size_t k = 0; k < 3; ++k) scale[k] = edge(k, (k + 1) % 3, edges[k]);
    Sums sums;
    for (std::size_t c = 0; c < 4; ++c) {
      sums[c] = edges[0][c] * (scale[1] * scale[2]) + edges[1][c] * (scale[2] * scale[0]) +
                edges[2][c] * (scale[0] * scale[1]);
      if (area < Int(0)) sums[c] = Int(0) - sums[c];
    }
    return {sums, size(area) * scale[0] * scale[1] * scale[2]};
  }

 private:
  static Int size(const Int& k) { return k < Int(0) ? Int(0) - k : k; }
  static Int or_one(const Int& k) { return k == Int(0) ? Int(1) : k; }

  /// The numbers of texel (i, j), counted from texel (column, row).
  Numbers texel(std::int64_t i, std::int64_t j) const {
    const Channel* const from = source_.texel(source_.column(column_ + i), source_.row(row_ + j));
    Numbers numbers;
    for (std::size_t c = 0; c < 4; ++c) numbers[c] = source_.coding().template number<Int>(from[c], c);
    return numbers;
  }

  /// The sums of row j's texels before each of the first `count`, and the sum of all of these.
  void sum_row(std::int64_t j, std::int64_t count) {
    before_.assign(1, {});
    for (std::int64_t i = 0; i < count; ++i) {
      Numbers sum = texel(i, j);
      for (std::size_t c = 0; c < 4; ++c) sum[c] = sum[c] + before_.back()[c];
      before_.push_back(sum);
    }
  }

  /// Adds the piece in column i from X to X', dy high.
  void piece(std::int64_t i, const Int& x, const Int& next_x, const Int& dy, const Int& column, Sums& to) {
    if (dy == Int(0)) return;
    const Int beyond = x + next_x - Int(2 * i) * column;
    const auto at = static_cast<std::size_t>(i);
    for (std::size_t c = 0; c < 4; ++c)
      to[c] = to[c] + (Int(before_[at][c] + before_[at][c]) * column +
                       Int(before_[at + 1][c] - before_[at][c]) * beyond) *
                          dy;
  }

  /// Writes the sum of an edge's pieces, times the sign of its direction, to `sums`; returns D H.
  Int edge(std::size_t from, std::size_t to, Sums& sums) {
    sums.fill(Int(0));
    bool down = y_[from] < y_[to];
    if (y_[to] < y_[from]) std::swap(from, to);
    const Int dx = x_[to] - x_[from], dy = y_[to] - y_[from], wide = or_one(size(dx)), high = or_one(dy);
    if (dy == Int(0)) return wide * high;
    const Int column = unit_ * high, line = unit_ * wide;  // a texel's side in units of X, and of Y
    const Int start_x = x_[from] * high, start_y = y_[from] * wide, end_x = x_[to] * high,
              end_y = y_[to] * wide;
    const std::int64_t last = whole(end_y, line, cells_ + 1);
    Int x = start_x, y = start_y;
    for (std::int64_t j = whole(start_y, line, cells_ + 1); j <= last; ++j) {
      // X = x0 H + dx (j S - y0): dy is above 0.
      const Int next_x = j == last ? end_x : start_x + dx * (Int(j + 1) * unit_ - y_[from]),
                next_y = j == last ? end_y : Int(j + 1) * line;
      std::int64_t i = whole(x, column, cells_ + 1);
      const std::int64_t stop = whole(next_x, column, cells_ + 1);
      sum_row(j, std::max(i, stop) + 1);
      while (i != stop) {
        const bool right = i < stop;
        const std::int64_t crossed = right ? i + 1 : i;
        // Y = y0 D + dy (crossed S - x0) sign(dx), with crossed the column's line.
        const Int way = Int(crossed) * unit_ - x_[from];
        const Int at = start_y + dy * (right ? way : Int(0) - way);
        piece(i, x, Int(crossed) * column, at - y, column, sums);
        x = Int(crossed) * column;
        y = at;
        i += right ? 1 : -1;
      }
      piece(i, x, next_x, next_y - y, column, sums);
      x = next_x;
      y = next_y;
    }
    if (!down)
      for (Int& sum : sums) sum = Int(0) - sum;
    return wide * high;
  }

  std::pair<Sums, Int> on_a_line() const {
    const auto span = [](const std::array<Int, 3>& at) {
      return std::max({at[0], at[1], at[2]}) - std::min({at[0], at[1], at[2]});
    };
    const bool across = span(y_) <= span(x_);
    const std::array<Int, 3>&along = across ? x_ : y_, &aside = across ? y_ : x_;
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
    const Int l0 = along[order[0]], l1 = along[order[1]], l2 = along[order[2]], m0 = aside[order[0]];
    const Int length = l2 - l0, slant = aside[order[2]] - m0;
    const auto numbers = [&](std::int64_t l, std::int64_t m) { return across ? texel(l, m) : texel(m, l); };
    Sums sums;
    sums.fill(Int(0));
    if (length == Int(0)) {
      const auto here = numbers(whole(l0, unit_, cells_ + 1), whole(m0, unit_, cells_ + 1));
      for (std::size_t c = 0; c < 4; ++c) sums[c] = Int(here[c]);
      return {sums, Int(1)};
    }
    // The places z = Z / D, with D the slant's size, where the line crosses columns, and rows.
    const Int d = or_one(size(slant));
    std::vector<Int> places{l0 * d, l2 * d};
    for (std::int64_t k = 1; k <= cells_; ++k) {
      const Int grid = Int(k) * unit_;
      if (l0 < grid && grid < l2) places.push_back(grid * d);
      // l = l0 + (k S - m0) length / slant
      const Int way = slant < Int(0) ? m0 - grid : grid - m0;
      if (Int(0) < way && way < size(slant)) places.push_back(l0 * d + way * length);
    }
    places.push_back(l1 * d);
    std::sort(places.begin(), places.end());
    const Int rise = or_one(l1 - l0), fall = or_one(l2 - l1), count = rise * fall * length * d * d;
    const auto below = [&](const Int& z) {  // the share below z, times count
      if (z <= l1 * d) return (z - l0 * d) * (z - l0 * d) * fall;
      return count - (l2 * d - z) * (l2 * d - z) * rise;
    };
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Int &from = places[k], &to = places[k + 1];
      if (from == to) continue;
      const Int twice = from + to;  // twice the middle, in units of 1 / D
      // m = m0 + (l - l0) slant / length, times 2 D length.
      const Int m = m0 * (Int(2) * d * length) + (twice - Int(2) * l0 * d) * slant;
      const auto here = numbers(whole(twice, Int(2) * d * unit_, cells_ + 1),
                                whole(m, Int(2) * d * length * unit_, cells_ + 1));
      const Int share = below(to) - below(from);
      for (std::size_t c = 0; c < 4; ++c) sums[c] = sums[c] + share * Int(here[c]);
    }
    return {sums, count};
  }

  const Source<Channel>& source_;
  std::int64_t column_, row_, cells_;
  Int unit_;
  std::array<Int, 3> x_, y_;
  std::vector<Numbers> before_ = {};
};

}  // namespace mmverify::impl::attribute::detail
