// Subjects that are broken on purpose, in the ways that several laws must catch.
#pragma once

#include "proofs/index/altered.hpp"

namespace mmverify::proofs::index {

/// The built-in subject of this name.
SubjectOfIndex built_in(const char* name);

/// One answer of one level, at the point (ku/4N, kv/4N), a bit off: as small as a mistake gets.
Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip = 1);

/// (level, point, true answer) -> answer.
Mutant on_points(const char* name, const char* base, Levels levels,
                 std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)> change,
                 bool on_rationals = true);

/// (level, index, true corners) -> corners.
Mutant on_indices(const char* name, const char* base, Levels levels,
                  std::function<Corners(Level, std::uint32_t, Corners)> change);

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
