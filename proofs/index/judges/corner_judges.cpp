// The judges of corners: from each of the 4^n indices to its micro-triangle.
#include <charconv>

#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/picture.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint64_t indices_in_a_chunk = 1 << 16;
constexpr std::uint64_t indices_per_batch = 1024;

Counterexample at_index_case(std::uint32_t index, Level n, std::string expected, std::string got) {
  return {{index, 0, 0}, n, case_of(index), {}, std::move(expected), std::move(got)};
}

using CornersFrom = std::function<void(std::span<const std::uint32_t>, std::span<Corners>)>;

/// Calls judge(index, corners) for every index, corners taken from `ask` in batches.
Tally on_each_index(
    Level n, const Run& run, const CornersFrom& ask,
    const std::function<void(std::span<const std::uint32_t>, std::span<const Corners>, Tally&)>& judge) {
  return sweep(
      run, triangle_count(n), indices_in_a_chunk,
      [&](Chunk chunk, Tally& tally) {
        std::array<std::uint32_t, indices_per_batch> indices;
        std::array<Corners, indices_per_batch> corners;
        for (std::uint64_t from = chunk.begin; from < chunk.end; from += indices_per_batch) {
          const std::uint64_t count = std::min(indices_per_batch, chunk.end - from);
          for (std::uint64_t t = 0; t < count; ++t) indices[t] = static_cast<std::uint32_t>(from + t);
          ask({indices.data(), count}, {corners.data(), count});
          tally.count(Kind::interior, count);
          judge({indices.data(), count}, {corners.data(), count}, tally);
        }
      },
      as_one_case(Kind::interior));
}

/// A number that all six coordinates enter.
std::uint64_t fold(const Corners& c) {
  std::uint64_t sum = 0;
  for (const auto& vertex : c) sum = (sum * 0x100000001B3u + vertex.i) * 0x100000001B3u + vertex.j;
  return sum;
}

Tally compare_corners(Level n, const Run& run, const CornersFrom& ask,
                      const std::function<Corners(std::uint32_t)>& right, bool as_sets = false) {
  return on_each_index(n, run, ask, [&](auto indices, auto corners, Tally& tally) {
    for (std::size_t t = 0; t < indices.size(); ++t) {
      const Corners want = right(indices[t]);
      tally.digest(indices[t], fold(corners[t]));
      if (want != corners[t] && !(as_sets && sorted(want) == sorted(corners[t])))
        tally.mismatch(Kind::interior, {indices[t], 0, 0},
                       [&] { return at_index_case(indices[t], n, text(want), text(corners[t])); });
    }
  });
}

/// spec::index::w_minor_corners for indices that mostly follow one another: the last row is right for most.
Corners row_corners_of_next(std::uint32_t index) {
  thread_local std::uint64_t row = 0;
  if (index < row * row || index >= (row + 1) * (row + 1)) row = spec::index::w_minor_row(index);
  return spec::index::w_minor_corners_in(static_cast<std::uint32_t>(row), index);
}

RationalPoint middle_of(const Corners& c, Level n) {
  const auto third = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
    return Rational(spec::Integer(std::uint64_t{a} + b + d), spec::Integer(3 * std::uint64_t{side(n)}));
  };
  return {third(c[0].i, c[1].i, c[2].i), third(c[0].j, c[1].j, c[2].j)};
}

std::string carried_back(const std::optional<MicroTriangle>& m, std::uint32_t index, const Corners& c) {
  return m ? fmt::format("{} at its corners {}", index, text(c))
           : text(c) + ", which are not a micro-triangle";
}

Corners corners_at(const IndexSubject& s, Level n, std::uint32_t index) {
  Corners c;
  s.functions.corners(n, {&index, 1}, {&c, 1});
  return c;
}

Corners row_corners_at(const IndexSubject& s, Level n, std::uint32_t index) {
  Corners c;
  s.functions.row_corners(n, {&index, 1}, {&c, 1});
  return c;
}

}  // namespace

std::string text(const Corners& c) {
  return fmt::format("({},{}) ({},{}) ({},{})", c[0].i, c[0].j, c[1].i, c[1].j, c[2].i, c[2].j);
}

std::string case_of(std::uint32_t index) { return fmt::format("k={}", index); }

std::uint32_t parse_index(const std::string& at, Level n) {
  std::uint32_t index = 0;
  const char *begin = at.data() + 2, *end = at.data() + at.size();
  if (at.size() > 2 && at.compare(0, 2, "k=") == 0) {
    const auto [stop, error] = std::from_chars(begin, end, index);
    if (error == std::errc() && stop == end && index < triangle_count(n)) return index;
  }
  throw BadCase(
      fmt::format("'{}' is not an index of level {}: write k=0 to k={}", at, n, triangle_count(n) - 1));
}

Tally inverse(const IndexSubject& s, Level n, const Run& run) {
  const CornersFrom ask = [&](auto indices, auto corners) { s.functions.corners(n, indices, corners); };
  return on_each_index(n, run, ask, [&](auto indices, auto corners, Tally& tally) {
    std::array<GridPoint, indices_per_batch> points;
    std::array<std::optional<MicroTriangle>, indices_per_batch> triangles;
    std::array<std::uint32_t, indices_per_batch> back;
    for (std::size_t t = 0; t < indices.size(); ++t) {
      triangles[t] = triangle_of(corners[t], n);
      points[t] = representative(triangles[t].value_or(MicroTriangle{0, 0, false}), n);
    }
    s.functions.receive(std::span<GridPoint>(points.data(), indices.size()));
    s.functions.index(n, {{points.data(), indices.size()}, false}, {back.data(), indices.size()});
    for (std::size_t t = 0; t < indices.size(); ++t) {
      tally.digest(indices[t], back[t]);
      if (!triangles[t] || back[t] != indices[t])
        tally.mismatch(Kind::interior, {indices[t], 0, 0}, [&] {
          return at_index_case(indices[t], n, fmt::format("{}", indices[t]),
                               carried_back(triangles[t], back[t], corners[t]));
        });
    }
  });
}

Replayed replay_inverse(const IndexSubject& s, Level n, const std::string& at) {
  const std::uint32_t index = parse_index(at, n);
  const Corners c = corners_at(s, n, index);
  const auto m = triangle_of(c, n);
  const RationalPoint p = rational(representative(m.value_or(MicroTriangle{0, 0, false}), n));
  const std::uint32_t back = s.functions.index_at(n, s.functions.receive_at(p));
  return {m && back == index, fmt::format("{}", index), carried_back(m, back, c),
          picture(n, p, index, back, Order::curve)};
}

Tally corners_as_sets(const IndexSubject& s, Level n, const Run& run) {
  return compare_corners(
      n, run, [&](auto indices, auto corners) { s.functions.corners(n, indices, corners); },
      [n](std::uint32_t index) { return spec::index::corners(index, n); }, true);
}

Replayed replay_corners_as_sets(const IndexSubject& s, Level n, const std::string& at) {
  const std::uint32_t index = parse_index(at, n);
  const Corners want = spec::index::corners(index, n), got = corners_at(s, n, index);
  return {sorted(want) == sorted(got), text(want), text(got),
          picture(n, middle_of(want, n), index, index, Order::curve)};
}

Tally corners_in_order(const IndexSubject& s, Level n, const Run& run) {
  return compare_corners(
      n, run, [&](auto indices, auto corners) { s.functions.corners(n, indices, corners); },
      [n, order = s.functions.corner_order](std::uint32_t index) { return corners_in(order, index, n); });
}

Replayed replay_corners_in_order(const IndexSubject& s, Level n, const std::string& at) {
  const std::uint32_t index = parse_index(at, n);
  const Corners want = corners_in(s.functions.corner_order, index, n), got = corners_at(s, n, index);
  return {want == got, text(want), text(got), picture(n, middle_of(want, n), index, index, Order::curve)};
}

Tally row_corners(const IndexSubject& s, Level n, const Run& run) {
  return compare_corners(
      n, run, [&](auto indices, auto corners) { s.functions.row_corners(n, indices, corners); },
      row_corners_of_next, true);
}

Replayed replay_row_corners(const IndexSubject& s, Level n, const std::string& at) {
  const std::uint32_t index = parse_index(at, n);
  const Corners want = spec::index::w_minor_corners(index), got = row_corners_at(s, n, index);
  return {sorted(want) == sorted(got), text(want), text(got),
          picture(n, middle_of(want, n), index, index, Order::rows)};
}

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
