// Deliberately wrong subjects that several laws must catch.
#pragma once

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

using Change = std::function<void(Functions&)>;
/// A built-in subject with one deliberate error.
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// (level, point, true answer) -> answer.
using PointChange = std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)>;

/// Changes index and row order on points of a grid.  on_rationals: also on rationals; false for laws that take
/// rationals as their oracle.
Change on_points(PointChange change, bool on_rationals = true);
/// Changes one function on rationals, index or row order, at points that lie on a grid.
Change on_rationals(std::function<std::uint32_t(Level, const RationalPoint&)> Functions::*which,
                    PointChange change);
/// Changes index and row order like on_points, but only in batches that are rows, and on rationals.
Change in_rows(PointChange change);
/// Changes index and row order on pairs of binary32 numbers, and on those as rationals.
Change on_floats(std::function<std::uint32_t(Level, float u, float v, std::uint32_t)> change);
/// Changes the index on pairs of binary64 numbers, and on those as rationals.
Change on_doubles(std::function<std::uint32_t(Level, double u, double v, std::uint32_t)> change);
/// Changes corners of micro-triangles in either order: (level, index, true corners) -> corners.
Change on_indices(std::function<Corners(Level, std::uint32_t, Corners)> change);

/// A change of one point of one level: the answer becomes answer XOR flip.
PointChange only_at_point(Level level, std::int64_t ku, std::int64_t kv, Level grid, std::uint32_t flip);

/// A mutant with one wrong answer at one level, at the point (ku/4N, kv/4N): the smallest possible mistake.
Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip = 1);

/// A mutant that swaps two corners of one index of one level.
Mutant swapped_corners(const char* name, const char* base, Level level, std::uint32_t index);

/// Whether the point is on a line u = i/N of the level.
bool on_u_line(const GridPoint& p, Level n);

/// A corner of the triangle in units of 1/4N.
constexpr std::int64_t corner(Level n) { return std::int64_t{4} << n; }

}  // namespace mmverify::proofs::index
