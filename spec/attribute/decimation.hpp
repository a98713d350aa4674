// Edge decimation: a micro-vertex map of level n beside a neighbour of level n-1.
//
//   snapped          the vertex that a value is read from: odd vertices of a flagged edge move to an even neighbour
//   averaged         the other rule: nothing moves, an odd vertex's value is the mean of two even neighbours'
//   decimated_place  the micro-triangle that contains a point once vertices have moved, and the point's weights on it
#pragma once

#include <array>
#include <cstdint>

#include "spec/attribute/lookup.hpp"

namespace mmverify::spec::attribute {

// ---- Edges of the base triangle

/// Flags of a map, a bit for each edge whose neighbour has level n-1: bit 0 edge w-u (v = 0), bit 1 edge u-v (w = 0),
/// bit 2 edge v-w (u = 0).  Source: NV_attribute_micromap's primitiveFlags, BaryFile.
using EdgeFlags = std::uint32_t;
inline constexpr EdgeFlags edge_flag_sets = 8;

/// The vertex `at` steps from the first end of an edge: edge 0 runs from w to u, 1 from u to v, 2 from v to w.
/// Domain: edge in 0..2, at in [0, N].
constexpr Vertex on_edge(std::uint32_t edge, std::uint32_t at, Level n) {
  const std::uint32_t N = side(n), left = N - at;
  return edge == 0 ? Vertex{at, 0} : edge == 1 ? Vertex{left, at} : Vertex{0, left};
}

/// A vertex by its place on a base edge.
struct EdgePlace {
  bool decimated = false;  ///< the vertex is an odd one of a flagged edge; only then the members below count
  std::uint32_t edge = 0, at = 0;
};

/// The flagged edge that has the vertex at an odd place.  No edge of level 0 has one; a corner has none at other
/// levels.
/// Domain: i+j <= N.
constexpr EdgePlace decimated_at(Vertex x, Level n, EdgeFlags flags) {
  const std::uint32_t N = side(n);
  if (n == 0) return {};
  for (std::uint32_t edge = 0; edge < 3; ++edge) {
    const std::uint32_t at = edge == 0 ? x.i : edge == 1 ? x.j : N - x.j;
    if ((flags >> edge & 1) != 0 && at % 2 == 1 && on_edge(edge, at, n) == x) return {true, edge, at};
  }
  return {};
}

// ---- The two rules

/// The vertex that the value of x is read from: an odd vertex of a flagged edge goes to its even neighbour away from
/// the edge's middle; the middle of level 1 to the edge's first end.
///   at -> at - 1 if at <= N/2, else at + 1
/// Domain: i+j <= N, n in 0..16, flags below 8.
/// Source: BaryFile, whose rule it is; Color and Attribute Micromaps, 3.2 and figure 3, which has pictures only.
constexpr Vertex snapped(Vertex x, Level n, EdgeFlags flags) {
  const EdgePlace place = decimated_at(x, n, flags);
  if (!place.decimated) return x;
  return on_edge(place.edge, place.at <= side(n) / 2 ? place.at - 1 : place.at + 1, n);
}

/// The two vertices whose mean is the value of x: for an odd vertex of a flagged edge its even neighbours on it, else x
/// and x.  Domain: as snapped.
constexpr std::array<Vertex, 2> averaged(Vertex x, Level n, EdgeFlags flags) {
  const EdgePlace place = decimated_at(x, n, flags);
  if (!place.decimated) return {x, x};
  return {on_edge(place.edge, place.at - 1, n), on_edge(place.edge, place.at + 1, n)};
}

// ---- Micro-triangles once vertices have moved

/// The corners of a micro-triangle, each moved.
constexpr Corners snapped(const MicroTriangle& t, Level n, EdgeFlags flags) {
  Corners c = corners_of(t);
  for (Vertex& x : c) x = snapped(x, n, flags);
  return c;
}

/// Twice the area, in units of the grid's squares: 1 for an unmoved micro-triangle, 0 for a degenerate one, below 0 for
/// one that was turned over.
constexpr std::int64_t doubled_area(const Corners& c) {
  const auto along = [](std::uint32_t to, std::uint32_t from) {
    return std::int64_t{to} - std::int64_t{from};
  };
  return along(c[1].i, c[0].i) * along(c[2].j, c[0].j) - along(c[2].i, c[0].i) * along(c[1].j, c[0].j);
}

/// Calls f(MicroTriangle) for the micro-triangles that have the vertex for a corner, up to six.
template <class F>
constexpr void around(Vertex x, Level n, F f) {
  for (const bool upper : {false, true})
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const Vertex from = corners_of({0, 0, upper})[corner];
      if (x.i < from.i || x.j < from.j) continue;
      const MicroTriangle t{x.i - from.i, x.j - from.j, upper};
      if (t.iu + t.iv + (upper ? 1 : 0) < side(n)) f(t);
    }
}

/// A point on a triangle of micro-vertices: its weights are shares[c] / area.
template <Coordinate Q>
struct WeighedPoint {
  Corners corners;
  std::array<Q, 3> shares;
  std::int64_t area;  ///< doubled_area(corners)

  constexpr bool holds() const {
    const Q zero(0);
    return area > 0 && !(shares[0] < zero) && !(shares[1] < zero) && !(shares[2] < zero);
  }
};

namespace detail {
/// The product (to - from) q.
template <Coordinate Q>
constexpr Q times_step(std::uint32_t to, std::uint32_t from, const Q& q) {
  return to < from ? Q(0) - times(from - to, q) : times(to - from, q);
}
}  // namespace detail

/// The point on a triangle: shares[c] is twice the area of the triangle that the point makes with the two corners after
/// c.  Domain: corners of level n.
template <Coordinate Q>
constexpr WeighedPoint<Q> place_on(const Corners& c, const Point<Q>& p, Level n) {
  const Q x = times(side(n), p.u), y = times(side(n), p.v);
  const auto share = [&](Vertex a, Vertex b) {
    return detail::times_step(b.i, a.i, y - Q(a.j)) - detail::times_step(b.j, a.j, x - Q(a.i));
  };
  return {c, {share(c[1], c[2]), share(c[2], c[0]), share(c[0], c[1])}, doubled_area(c)};
}

/// The point on the micro-triangle that contains it once the flagged edges' vertices have moved.  The micro-triangle
/// that contained it before may be degenerate now, or have moved away: then one of those at a moved corner of it does.
/// Domain: u, v >= 0, u+v <= 1; n in 0..16, flags below 8.  The result holds the point.
/// Source: ours; Color and Attribute Micromaps, 3.2, adjusts the mapping and leaves the lookup of 4.1 as it is, see
/// docs/ERRATA.md.  Law: attribute.decimation_lookup.
template <Number Q>
constexpr WeighedPoint<Q> decimated_place(const Point<Q>& p, Level n, EdgeFlags flags) {
  const MicroTriangle before = vulkan_triangle(p, n);
  WeighedPoint<Q> found = place_on(snapped(before, n, flags), p, n);
  for (const Vertex& corner : corners_of(before)) {
    if (found.holds() || snapped(corner, n, flags) == corner) continue;
    around(corner, n, [&](const MicroTriangle& t) {
      if (found.holds()) return;
      if (const WeighedPoint<Q> other = place_on(snapped(t, n, flags), p, n); other.holds()) found = other;
    });
  }
  return found;
}

}  // namespace mmverify::spec::attribute
