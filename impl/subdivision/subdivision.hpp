// Shapes cut again and again into children of one size: the cell of a point and the corners of a cell, in the order of a
// curve, by small state machines on integers.
//
//   triangle_4    a triangle in 2 x 2, on the curve of opacity micromaps    16 levels
//   triangle_9    a triangle in 3 x 3                                       10 levels
//   hilbert       a quad in 2 x 2, on Hilbert's curve                       16 levels
//   morton        a quad in 2 x 2, in Morton's order                        16 levels
//   tetrahedron   a tetrahedron in 8, by Bey's red refinement               10 levels
//   bisection     a triangle in 2 by its newest vertex                      31 levels
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::impl::subdivision {

using Level = std::uint32_t;

enum class Scheme : std::uint32_t { triangle_4, triangle_9, hilbert, morton, tetrahedron, bisection };

/// The last level of a scheme: b^n cells still have indices of 32 bits.
/// Law: subdivision.corners_are_specified
constexpr Level highest_level(Scheme scheme) noexcept {
  constexpr Level levels[] = {16, 10, 16, 16, 10, 31};
  return levels[static_cast<std::size_t>(scheme)];
}

/// A point of the unit shape, as fractions of one denominator: barycentrics of the second corner and the later ones of
/// a triangle with corners w, u, v, or of a tetrahedron; x and y of a quad.
struct Point {
  std::array<std::uint32_t, 3> numerators;
  std::uint32_t denominator;
};

/// The index of the cell that the point belongs to; on edges and corners by the tie rule of docs/SUBDIVISION.md.
/// Domain: points of the closed unit shape; a denominator in 1..2^31; level up to highest_level(), and that for a higher
/// one.  Result below b^level.
/// Source: spec/subdivision/subdivision.hpp, index.
/// Law: subdivision.index_is_specified
std::uint32_t index(Scheme scheme, Level level, const Point& point) noexcept;

/// A grid point of a level, in units of 1 / side(level).
using Vertex = std::array<std::uint32_t, 3>;
/// A cell's corners, in the order of its children; a triangle has three, and then zeros.
using Corners = std::array<Vertex, 4>;

/// The side of the grid that has the corners of a level's cells: 2^n, 3^n, or 2^ceil(n/2) of the bisection.
/// Law: subdivision.corners_are_specified
std::uint32_t side(Scheme scheme, Level level) noexcept;

/// The corners of the cell with an index.
/// Domain: index below b^level; level up to highest_level(), and that for a higher one.
/// Source: spec/subdivision/subdivision.hpp, cell.
/// Law: subdivision.corners_are_specified
Corners corners(Scheme scheme, Level level, std::uint32_t index) noexcept;

namespace detail {

using Offset = std::array<std::int32_t, 3>;

/// An orientation of a cell.  The cell's corners lie around its first one; a child's first corner lies at the cell's,
/// times `scale`, and a shift.
struct Orientation {
  std::array<Offset, 4> corners;
  std::uint32_t scale;
  std::array<Offset, 9> shift;
  std::array<std::uint8_t, 9> next;
};

/// The orientations that a scheme's cells have at any level; the first one is the unit shape's.
/// Law: subdivision.all_levels
const std::vector<Orientation>& orientations(Scheme scheme);

}  // namespace detail

}  // namespace mmverify::impl::subdivision
