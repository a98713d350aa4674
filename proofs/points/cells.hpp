// The cells of a level's grid, one dyadic representative each: vertex, middle of an edge, a point inside.
#pragma once

#include <algorithm>

#include "proofs/engine/kinds.hpp"
#include "spec/fixed.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::points {

using spec::Fixed64;
using spec::side;
using spec::times;  // found beside the friends of Fixed, whatever the number
using spec::whole;
using GridPoint = spec::Point<Fixed64>;

/// 3N^2 + 3N + 1 cells: (N+1)(N+2)/2 vertices, 3N(N+1)/2 open edges, N^2 open micro-triangles.  Domain: n in
/// 0..17.
constexpr std::uint64_t cell_count(Level n) {
  const std::uint64_t N = side(n);
  return 3 * N * N + 3 * N + 1;
}

/// 4^n.
constexpr std::uint64_t triangle_count(Level n) { return std::uint64_t{1} << (2 * n); }

/// Consecutive cells on a line of constant v: cell `first + t` has its representative at
/// ((ku + t stride) / 4N, kv / 4N) and is of kind `even` or `odd` with t.
struct Row {
  std::uint64_t first;
  std::int64_t ku, kv, stride;
  std::uint64_t count;
  Kind even, odd;

  Kind kind(std::uint64_t t) const { return t % 2 == 0 ? even : odd; }
  std::uint64_t count_of(Kind k) const {
    return (k == even ? (count + 1) / 2 : 0) + (k == odd ? count / 2 : 0);
  }
};

/// The cells of level n, numbered strip by strip from v = 0 up. Strip j, with M = N-j, is four rows, at
///   v = j/N (vertices and edges), (j+1/4)/N (upright micro-triangles), (j+1/2)/N (edges) and
///   (j+3/4)/N (inverted ones),
/// of 2M+1, M, 2M and M-1 cells; strip N is the v-corner alone.
class Cells {
 public:
  explicit Cells(Level n) : n_(n), N_(side(n)) {}
  std::uint64_t size() const { return cell_count(n_); }

  /// Calls visit(Row) for the rows, cut to [begin, end), in order.  Domain: begin <= end <= size().
  template <class Visit>
  void rows(std::uint64_t begin, std::uint64_t end, Visit visit) const {
    for (std::uint64_t j = strip_of(begin); begin < end; ++j) {
      const std::int64_t v = static_cast<std::int64_t>(4 * j);
      const std::uint64_t M = N_ - j;
      std::uint64_t first = strip_start(j);
      const Row strip[] = {
          {first, 0, v, 2, 2 * M + 1, Kind::vertex, Kind::edge},
          {first + 2 * M + 1, 1, v + 1, 4, M, Kind::interior, Kind::interior},
          {first + 3 * M + 1, 0, v + 2, 2, 2 * M, Kind::edge, Kind::edge},
          {first + 5 * M + 1, 3, v + 3, 4, M == 0 ? 0 : M - 1, Kind::interior, Kind::interior}};
      for (const Row& whole_row : strip) {
        const std::uint64_t from = std::max(begin, whole_row.first);
        const std::uint64_t to = std::min(end, whole_row.first + whole_row.count);
        if (from >= to) continue;
        visit(cut(whole_row, from - whole_row.first, to - from));
        begin = to;
      }
    }
  }

  /// `count` cells of a row from its cell `from` on.
  static Row cut(const Row& row, std::uint64_t from, std::uint64_t count) {
    Row part = row;
    part.first += from;
    part.ku += static_cast<std::int64_t>(from) * row.stride;
    part.count = count;
    if (from % 2 != 0) std::swap(part.even, part.odd);
    return part;
  }

 private:
  std::uint64_t strip_start(std::uint64_t j) const { return 6 * j * N_ - 3 * j * (j - (j != 0 ? 1 : 0)); }

  std::uint64_t strip_of(std::uint64_t cell) const {
    std::uint64_t low = 0, high = N_ + 1;
    while (high - low > 1) {
      const std::uint64_t middle = (low + high) / 2;
      (strip_start(middle) <= cell ? low : high) = middle;
    }
    return low;
  }

  Level n_;
  std::uint64_t N_;
};

/// k / (4 2^n) as a grid coordinate.
constexpr Fixed64 coordinate(std::int64_t k, Level n) { return Fixed64::dyadic(k, n + 2); }

/// Representative `t` of a row.
constexpr GridPoint representative(const Row& row, std::uint64_t t, Level n) {
  return {coordinate(row.ku + static_cast<std::int64_t>(t) * row.stride, n), coordinate(row.kv, n)};
}

/// A micro-triangle by its grid square; `inverted` is the upper half of the square.
struct MicroTriangle {
  std::uint32_t i, j;
  bool inverted;
  friend bool operator==(const MicroTriangle&, const MicroTriangle&) = default;
};

/// The representative of an open micro-triangle: (i+1/4, j+1/4)/N or, inverted, (i+3/4, j+3/4)/N.
constexpr GridPoint representative(const MicroTriangle& m, Level n) {
  const std::int64_t inside = m.inverted ? 3 : 1;
  return {coordinate(4 * std::int64_t{m.i} + inside, n), coordinate(4 * std::int64_t{m.j} + inside, n)};
}

}  // namespace mmverify::proofs::points
