// Shapes cut again and again into children of one size, and the cells of a level in the order of a curve: the family that
// the index of opacity micromaps is one of.
//
//   triangle_4    a triangle in 2 x 2: the curve of opacity micromaps
//   triangle_9    a triangle in 3 x 3
//   hilbert       a quad in 2 x 2, on Hilbert's curve
//   morton        a quad in 2 x 2, in Morton's order
//   tetrahedron   a tetrahedron in 8: Bey's red refinement
//   bisection     a triangle in 2 by its newest vertex: Sierpinski's curve
//
// A cell is its corners in order.  A scheme lists a cell's children; the same list, on each child's own corners, gives the
// next level.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spec/number.hpp"

namespace mmverify::spec::subdivision {

enum class Scheme : std::uint32_t { triangle_4, triangle_9, hilbert, morton, tetrahedron, bisection };
inline constexpr std::array all_schemes{Scheme::triangle_4, Scheme::triangle_9,  Scheme::hilbert,
                                        Scheme::morton,     Scheme::tetrahedron, Scheme::bisection};

inline constexpr std::size_t most_corners = 4, most_children = 9;

/// Coordinates; the third one is 0 in the plane.
template <class Q>
using At = std::array<Q, 3>;
template <class Q>
using Corners = std::array<At<Q>, most_corners>;

/// The facts of a scheme.
struct Cut {
  const char* name;
  unsigned dimension, corners, children;
  unsigned parts;                               ///< a child's corner is the mean of so many of its parent's
  std::array<At<int>, most_corners> base = {};  ///< of the unit shape
  /// Directions into the unit shape, for each corner one.  None is parallel to a facet of any cell.
  std::array<At<int>, most_corners> inward = {};
  unsigned state = 0;  ///< the unit shape's
  Level highest = 0;   ///< the last level whose indices fit 32 bits
};

constexpr Cut cut(Scheme scheme) {
  constexpr std::array<At<int>, most_corners> triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      from_w_u_v{{{2, 1, 0}, {-2, 1, 0}, {1, -2, 0}}},  //
      square{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
      into_square{{{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}}};
  switch (scheme) {
    case Scheme::triangle_4: return {"triangle-4", 2, 3, 4, 2, triangle, from_w_u_v, 0, 16};
    case Scheme::triangle_9: return {"triangle-9", 2, 3, 9, 3, triangle, from_w_u_v, 0, 10};
    case Scheme::hilbert: return {"hilbert", 2, 4, 4, 2, square, into_square, 0, 16};
    case Scheme::morton: return {"morton", 2, 4, 4, 2, square, into_square, 0, 16};
    case Scheme::tetrahedron:
      return {"tetrahedron",
              3,
              4,
              8,
              2,
              {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
              {{{1, 1, 1}, {-4, 1, 1}, {1, -4, 1}, {1, 1, -4}}},
              3,
              10};
    default: return {"bisection", 2, 3, 2, 2, {{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}}, from_w_u_v, 0, 31};
  }
}

/// b^n, the cells of a level.  Domain: n up to the scheme's highest level.
constexpr std::uint64_t cells(Scheme scheme, Level n) {
  std::uint64_t all = 1;
  for (Level depth = 0; depth < n; ++depth) all *= cut(scheme).children;
  return all;
}

/// The side of the coarsest grid that has all corners of level n: k^n; 2^ceil(n/2) of the bisection, whose cells become
/// half as wide in two levels.
constexpr std::uint32_t side(Scheme scheme, Level n) {
  std::uint32_t N = 1;
  for (Level depth = 0; depth < (scheme == Scheme::bisection ? (n + 1) / 2 : n); ++depth)
    N *= cut(scheme).parts;
  return N;
}

// ---- The children

/// A child: the parent's corners whose mean each of its corners is, and its state.
struct Child {
  std::array<std::array<unsigned, 3>, most_corners> means = {};
  unsigned state = 0;
};

/// A child by its corners' digits: "00 01 02" has the parent's corner 0 and the midpoints of 0 and 1, and of 0 and 2.
constexpr Child child_of(const char* corners, unsigned parts, unsigned state = 0) {
  Child child{{}, state};
  for (std::size_t c = 0; *corners != 0; ++c, corners += *corners == ' ' ? 1 : 0)
    for (unsigned part = 0; part < parts; ++part)
      child.means[c][part] = static_cast<unsigned>(*corners++ - '0');
  return child;
}

/// A visit to a child of the tetrahedron: the curve enters it at one of its corners, and leaves at another.
struct Visit {
  unsigned child, entry, exit;
};

/// The state of a tetrahedron that the curve enters at its corner `entry` and leaves at its corner `exit`.
constexpr unsigned tetrahedron_state(unsigned entry, unsigned exit) { return 4 * entry + exit; }

/// Bey's children.  0 to 3 have a corner each; 4 to 7 share the octahedron's diagonal from 02 to 13.  Each list is in the
/// order that cuts the child's own octahedron along the diagonal that keeps the shapes to three.
/// Source: Bey, Tetrahedral Grid Refinement, Computing 55 (1995), algorithm RedRefinement3D.
inline constexpr const char* bey_children[8] = {"00 01 02 03", "01 11 12 13", "02 12 22 23", "03 13 23 33",
                                                "01 02 03 13", "01 02 12 13", "02 03 13 23", "02 12 13 23"};

/// The children in order where the curve goes from the lesser of two corners to the greater: a child is left at the point
/// where the next one is entered.  Two by two in one row they share a face, but for one step, 4 to 5, over a point alone.
inline constexpr Visit
    visits_01[] = {{0, 0, 1}, {4, 0, 1}, {6, 0, 1}, {3, 0, 2}, {2, 3, 0}, {7, 0, 1}, {5, 2, 0}, {1, 0, 1}},
    visits_02[] = {{0, 0, 1}, {4, 0, 1}, {5, 1, 0}, {1, 0, 3}, {3, 1, 0}, {6, 1, 0}, {7, 0, 1}, {2, 1, 2}},
    visits_03[] = {{0, 0, 1}, {4, 0, 1}, {5, 1, 0}, {1, 0, 2}, {2, 1, 0}, {7, 0, 2}, {6, 2, 1}, {3, 0, 3}},
    visits_12[] = {{1, 1, 0}, {5, 0, 1}, {4, 1, 0}, {0, 1, 3}, {3, 0, 1}, {6, 2, 0}, {7, 0, 1}, {2, 1, 2}},
    visits_13[] = {{1, 1, 0}, {5, 0, 1}, {4, 1, 0}, {0, 1, 2}, {2, 0, 1}, {7, 1, 0}, {6, 0, 1}, {3, 0, 3}},
    visits_23[] = {{2, 2, 0}, {7, 0, 1}, {5, 2, 3}, {1, 3, 0}, {0, 1, 2}, {4, 1, 2}, {6, 1, 2}, {3, 1, 3}};

/// The visit of a digit.  From the greater corner to the lesser one the curve is the same one backwards.
constexpr Visit visit(unsigned state, unsigned digit) {
  const unsigned entry = state / 4, exit = state % 4;
  if (entry > exit) {
    const Visit back = visit(tetrahedron_state(exit, entry), 7 - digit);
    return {back.child, back.exit, back.entry};
  }
  const Visit* const from_0[] = {nullptr, visits_01, visits_02, visits_03};
  const Visit* const from_1[] = {visits_12, visits_13};
  return (entry == 0 ? from_0[exit] : entry == 1 ? from_1[exit - 2] : visits_23)[digit];
}

/// The child with a digit of a cell in a state.
/// Source: triangle_4, as spec::index::corners_turn; triangle_9, the first of the ten orders with the fewest steps over a
/// point alone; hilbert, Hilbert 1891; bisection, Sierpinski 1912, Mitchell, ACM TOMS 15 (1989).
/// Domain: digit below the scheme's children; a state that the unit shape's leads to.
constexpr Child child(Scheme scheme, unsigned state, unsigned digit) {
  constexpr const char *in_4[] = {"00 01 02", "02 12 01", "01 11 12", "12 02 22"},
                       *in_9[] = {"000 002 001", "001 012 002", "002 022 012", "012 001 011", "011 111 112",
                                  "112 011 012", "012 112 122", "122 012 022", "022 122 222"},
                       *on_hilbert[] = {"00 03 02 01", "01 11 12 02", "02 12 22 23", "23 02 03 33"},
                       *on_morton[] = {"00 01 02 03", "03 02 23 33", "01 11 12 02", "02 12 22 23"},
                       *by_newest[] = {"00 02 11", "11 02 22"};
  switch (scheme) {
    case Scheme::triangle_4: return child_of(in_4[digit], 2);
    case Scheme::triangle_9: return child_of(in_9[digit], 3);
    case Scheme::hilbert: return child_of(on_hilbert[digit], 2);
    case Scheme::morton: return child_of(on_morton[digit], 2);
    case Scheme::tetrahedron: {
      const Visit v = visit(state, digit);
      return child_of(bey_children[v.child], 2, tetrahedron_state(v.entry, v.exit));
    }
    default: return child_of(by_newest[digit], 2);
  }
}

// ---- Cells

/// A cell, and the state in which its own children are listed.
template <class Q>
struct Cell {
  Corners<Q> corners;
  unsigned state;
};

/// The unit shape, times `unit`.
template <class Q>
constexpr Cell<Q> base(Scheme scheme, const Q& unit) {
  const Cut c = cut(scheme);
  Cell<Q> cell{{}, c.state};
  for (std::size_t k = 0; k < c.corners; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) cell.corners[k][axis] = unit * Q(c.base[k][axis]);
  return cell;
}

/// The cell's child of a digit: each corner the mean of corners of its parent.
/// Domain: a Q that divides exactly: rationals, or integers of a unit that side() of the child's level divides.
template <class Q>
constexpr Cell<Q> turn(Scheme scheme, const Cell<Q>& parent, unsigned digit) {
  const Cut c = cut(scheme);
  const Child child = subdivision::child(scheme, parent.state, digit);
  Cell<Q> cell{{}, child.state};
  for (std::size_t k = 0; k < c.corners; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Q sum(0);
      for (std::size_t part = 0; part < c.parts; ++part) sum += parent.corners[child.means[k][part]][axis];
      cell.corners[k][axis] = sum / Q(c.parts);
    }
  return cell;
}

/// The cell with an index, times `unit`: child by child, highest digit first.
/// Domain: index below cells(scheme, n); as turn().
template <class Q>
constexpr Cell<Q> cell(Scheme scheme, Level n, std::uint64_t index, const Q& unit) {
  Cell<Q> at = base(scheme, unit);
  std::uint64_t below = cells(scheme, n);
  for (Level depth = 0; depth < n; ++depth) {
    below /= cut(scheme).children;
    at = turn(scheme, at, static_cast<unsigned>(index / below));
    index %= below;
  }
  return at;
}

// ---- The cell of a point

/// The determinant of the vectors a, b, c; in the plane of a and b, where c counts for nothing.
template <class Q>
constexpr Q determinant(unsigned dimension, const At<Q>& a, const At<Q>& b, const At<Q>& c) {
  const Q plane = a[0] * b[1] - a[1] * b[0];
  if (dimension == 2) return plane;
  return plane * c[2] + (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1];
}

template <class Q>
constexpr At<Q> difference(const At<Q>& a, const At<Q>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// A facet of a cell, as corners on it, as many as the dimension, and one that is not.  Facet f of a simplex lacks corner f;
/// facet f of a quad is the edge between the two corners after corner f.
struct Facet {
  std::array<std::size_t, 3> on;
  std::size_t off;
};
constexpr Facet facet(const Cut& c, std::size_t f) {
  const std::size_t m = c.corners;
  return {{(f + 1) % m, (f + 2) % m, (f + 3) % m}, f};
}

/// A vector's part across a facet: positive towards the inside, 0 along the facet, negative outwards.
template <class Q>
constexpr Q across(const Cut& c, const Corners<Q>& corners, std::size_t f, const At<Q>& vector) {
  const Facet at = facet(c, f);
  const At<Q>& origin = corners[at.on[0]];
  const At<Q> a = difference(corners[at.on[1]], origin), b = difference(corners[at.on[2]], origin),
              inside = difference(corners[at.off], origin);
  const auto part = [&](const At<Q>& v) {
    return c.dimension == 2 ? determinant(2, a, v, v) : determinant(3, a, b, v);
  };
  return part(inside) < Q(0) ? -part(vector) : part(vector);
}

/// Whether a cell holds the points that are reached from p by small steps in a direction: at each facet p lies inside, or on
/// the facet, and then the direction leads inside.
template <class Q>
constexpr bool holds(const Cut& c, const Corners<Q>& corners, const At<Q>& p, const At<Q>& direction) {
  for (std::size_t f = 0; f < c.corners; ++f) {
    const Q place = across(c, corners, f, difference(p, corners[facet(c, f).on[0]]));
    if (place < Q(0) || (place == Q(0) && across(c, corners, f, direction) < Q(0))) return false;
  }
  return true;
}

/// The tie rule: a point that several cells share belongs to the one that the first of the scheme's directions enters, of
/// those that do not leave the unit shape from there.
template <class Q>
constexpr At<Q> direction_from(const Cut& c, const Corners<Q>& shape, const At<Q>& p) {
  At<Q> direction{};
  for (std::size_t k = c.corners; k-- > 0;) {
    const At<Q> inward{Q(c.inward[k][0]), Q(c.inward[k][1]), Q(c.inward[k][2])};
    if (holds(c, shape, p, inward)) direction = inward;
  }
  return direction;
}

/// The index of the one cell that a point, given times `unit`, belongs to: the child that holds it, level by level.
/// Domain: points of the closed unit shape; as turn().
template <class Q>
constexpr std::uint64_t index(Scheme scheme, Level n, const At<Q>& p, const Q& unit) {
  const Cut c = cut(scheme);
  Cell<Q> at = base(scheme, unit);
  const At<Q> direction = direction_from(c, at.corners, p);
  std::uint64_t index = 0;
  for (Level depth = 0; depth < n; ++depth) {
    unsigned digit = 0;
    while (digit + 1 < c.children && !holds(c, turn(scheme, at, digit).corners, p, direction)) ++digit;
    at = turn(scheme, at, digit);
    index = index * c.children + digit;
  }
  return index;
}

// ---- Neighbours

/// The corners that two cells of one level have in common; the scheme's dimension of them make a facet.
template <class Q>
constexpr unsigned shared(const Cut& c, const Corners<Q>& a, const Corners<Q>& b) {
  unsigned count = 0;
  for (std::size_t i = 0; i < c.corners; ++i)
    for (std::size_t j = 0; j < c.corners; ++j) count += a[i] == b[j] ? 1 : 0;
  return count;
}

/// Whether the step from a child to the next one is over a point alone.
constexpr bool breaks_after(Scheme scheme, unsigned digit) {
  switch (scheme) {
    case Scheme::triangle_4: return digit == 2;
    case Scheme::triangle_9: return digit == 2 || digit == 3;
    case Scheme::tetrahedron: return digit == 3;
    case Scheme::morton: return digit % 2 == 1;
    default: return false;
  }
}

/// Whether two cells that follow each other share no facet: so do the children of their lowest common parent.  Morton's
/// order leaves a cell with an odd index over less than an edge.
constexpr bool breaks_after(Scheme scheme, std::uint64_t index) {
  if (scheme == Scheme::morton) return index % 2 == 1;
  const unsigned b = cut(scheme).children;
  while (index % b == b - 1) index /= b;
  return breaks_after(scheme, static_cast<unsigned>(index % b));
}

}  // namespace mmverify::spec::subdivision
