// The children of each scheme, as the state machines read them.
#pragma once

#include <cstdint>

#include "impl/subdivision/subdivision.hpp"

namespace mmverify::impl::subdivision::detail {

inline constexpr unsigned children[] = {4, 9, 4, 4, 8, 2}, parts[] = {2, 3, 2, 2, 2, 2};
inline constexpr unsigned corner_count[] = {3, 3, 4, 4, 4, 3};

/// A child's corners, each the mean of the parent's corners that its digits name.
inline constexpr const char* of_triangle_4[] = {"00 01 02", "02 12 01", "01 11 12", "12 02 22"};
inline constexpr const char* of_triangle_9[] = {"000 002 001", "001 012 002", "002 022 012",
                                                "012 001 011", "011 111 112", "112 011 012",
                                                "012 112 122", "122 012 022", "022 122 222"};
inline constexpr const char* of_hilbert[] = {"00 03 02 01", "01 11 12 02", "02 12 22 23", "23 02 03 33"};
inline constexpr const char* of_morton[] = {"00 01 02 03", "03 02 23 33", "01 11 12 02", "02 12 22 23"};
inline constexpr const char* of_bisection[] = {"00 02 11", "11 02 22"};
/// Bey's, in his order; a path gives them theirs.
inline constexpr const char* of_tetrahedron[] = {"00 01 02 03", "01 11 12 13", "02 12 22 23", "03 13 23 33",
                                                 "01 02 03 13", "01 02 12 13", "02 03 13 23", "02 12 13 23"};

/// A path through a tetrahedron's children: for each digit the child, the corner that it is entered at, and the one that
/// it is left at, as three decimal digits.  Paths go from corner 0 to 1, 0 to 2, 0 to 3, 1 to 2, 1 to 3, and 2 to 3.
inline constexpr std::uint16_t paths[6][8] = {
    {1, 401, 601, 302, 230, 701, 520, 101},  {1, 401, 510, 103, 310, 610, 701, 212},
    {1, 401, 510, 102, 210, 702, 621, 303},  {110, 501, 410, 13, 301, 620, 701, 212},
    {110, 501, 410, 12, 201, 710, 601, 303}, {220, 701, 523, 130, 12, 412, 612, 313}};

/// A state 4 i + j of a tetrahedron: entered at corner i, left at corner j.
inline constexpr unsigned first_path = 3, path_states = 16;

struct Step {
  std::uint8_t child, state;
};

/// The step of a digit, in a state with i != j.  A path from j to i, i < j, is the one from i to j backwards.
constexpr Step path_step(unsigned state, unsigned digit) {
  constexpr unsigned row[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
  const unsigned i = state / 4, j = state % 4;
  const unsigned code = paths[row[i][j]][i < j ? digit : 7 - digit], entry = code / 10 % 10, exit = code % 10;
  return {static_cast<std::uint8_t>(code / 100),
          static_cast<std::uint8_t>(i < j ? 4 * entry + exit : 4 * exit + entry)};
}

/// The child of a digit, and the state that it is in.
struct Listed {
  const char* corners;
  unsigned state;
};
constexpr Listed listed(Scheme scheme, unsigned state, unsigned digit) {
  switch (scheme) {
    case Scheme::triangle_4: return {of_triangle_4[digit], 0};
    case Scheme::triangle_9: return {of_triangle_9[digit], 0};
    case Scheme::hilbert: return {of_hilbert[digit], 0};
    case Scheme::morton: return {of_morton[digit], 0};
    case Scheme::bisection: return {of_bisection[digit], 0};
    default: const Step step = path_step(state, digit); return {of_tetrahedron[step.child], step.state};
  }
}

}  // namespace mmverify::impl::subdivision::detail
