// Orders of micro-triangles that implementations have by mistake, or of other formats.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "proofs/points/cells.hpp"

namespace mmverify::proofs::index {

using points::GridPoint;

/// Child k of a triangle is numbered permutation[k].
using Permutation = std::array<std::uint32_t, 4>;
inline constexpr Permutation identity{0, 1, 2, 3};
/// A permutation as text, such as "children 0 and 2 change places".
std::string text_of_children(const Permutation& p);

/// The point with its barycentrics (w, u, v) permuted, and the permutation as text, "(u, w, v)".
GridPoint rearranged(const GridPoint& p, const std::array<int, 3>& order);
std::string letters_of(const std::array<int, 3>& order);

/// U-major order as BaryFile numbers faces: 2 N iu - iu^2 + 2 iv, and 1 more in the upper half of the square.  The
/// rows run along v, the longest, at u = 0, first.
std::uint32_t in_u_major(const GridPoint& p, Level n);

/// Algorithm 4 without its flips or without the turn of its middle triangle: a common mistake of implementations.
std::uint32_t simplified(GridPoint p, Level n, bool flips, bool turns);

/// An order, with its index of a point inside a micro-triangle.
struct KnownOrder {
  std::string name;
  std::function<std::uint32_t(const GridPoint&, Level)> index;
};

/// Row orders in each turn of the barycentrics; the curve without its flips or turns; the curve with its children
/// permuted in every digit.
const std::vector<KnownOrder>& known_orders();

}  // namespace mmverify::proofs::index
