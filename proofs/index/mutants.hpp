// Subjects that are broken on purpose, in the ways that several laws must catch.
#pragma once

#include <functional>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// A built-in subject with one thing broken on purpose.
using Change = std::function<void(Functions&)>;
Mutant mutant(const char* name, const char* base, Levels levels, const Change& change);

/// (level, point, true answer) -> answer.
using PointChange = std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)>;

/// Index and row order on points of a grid; on rationals too, or not, where a law takes those as its oracle.
Change on_points(PointChange change, bool on_rationals = true);
/// Index or row order at the points among rationals that a grid has, by one of the functions that take rationals.
Change on_rationals(std::function<std::uint32_t(Level, const RationalPoint&)> Functions::*which,
                    PointChange change);
/// The same as on_points in batches that are rows, and on rationals.
Change in_rows(PointChange change);
/// Index and row order on pairs of binary32 numbers, and on those as rationals.
Change on_floats(std::function<std::uint32_t(Level, float u, float v, std::uint32_t)> change);
/// Index on pairs of binary64 numbers, and on those as rationals.
Change on_doubles(std::function<std::uint32_t(Level, double u, double v, std::uint32_t)> change);
/// (level, index, true corners) -> corners, of micro-triangles in either order.
Change on_indices(std::function<Corners(Level, std::uint32_t, Corners)> change);

/// At one point of one level only, the answer becomes answer XOR flip.
PointChange only_at_point(Level level, std::int64_t ku, std::int64_t kv, Level grid, std::uint32_t flip);

/// One answer of one level, at the point (ku/4N, kv/4N), a bit off: as small as a mistake gets.
Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip = 1);

/// Two corners of one index of one level change places.
Mutant swapped_corners(const char* name, const char* base, Level level, std::uint32_t index);

/// Whether the point is on a line u = i/N of the level.
bool on_u_line(const GridPoint& p, Level n);

/// A corner of the triangle in units of 1/4N.
constexpr std::int64_t corner(Level n) { return std::int64_t{4} << n; }

/// What a law that compares answers on cells must catch: one vertex, the last cell, ties, an order of
/// children.
std::vector<Mutant> wrong_on_cells(const char* base);

/// The same, but for the order of children: consistent in itself.
std::vector<Mutant> inconsistent_on_cells(const char* base);

}  // namespace mmverify::proofs::index
