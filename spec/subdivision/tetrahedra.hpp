// The shapes of a tetrahedron's children, by the octahedron's diagonal that they share.
#pragma once

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "spec/subdivision/subdivision.hpp"

namespace mmverify::spec::subdivision {

/// A tetrahedron with corners at whole numbers, and the squares of its edges' lengths.
using Tetrahedron = std::array<At<std::int64_t>, 4>;
using Lengths = std::array<std::int64_t, 6>;

/// The rule that cuts the octahedron: Bey's, by the order of the corners, or by the diagonals' lengths, of equal ones the
/// first.
enum class Diagonal : std::uint32_t { bey, shortest, longest };

constexpr std::int64_t square_of_distance(const At<std::int64_t>& a, const At<std::int64_t>& b) {
  const At<std::int64_t> d = difference(a, b);
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/// The same for all tetrahedra of one shape: the squares, divided by what divides all, in the order of the corners that
/// comes first.  Mirror images are of one shape.
inline Lengths shape_of(const Tetrahedron& t) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  Lengths first{};
  do {
    Lengths lengths{};
    std::size_t edge = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) lengths[edge++] = square_of_distance(t[order[i]], t[order[j]]);
    if (first == Lengths{} || lengths < first) first = lengths;
  } while (std::next_permutation(order.begin(), order.end()));
  const std::int64_t divisor = std::accumulate(first.begin(), first.end(), std::int64_t{0},
                                               [](std::int64_t a, std::int64_t b) { return std::gcd(a, b); });
  for (std::int64_t& length : first) length /= divisor;
  return first;
}

/// The eight children, twice as large: so their corners are whole numbers, too.
inline std::vector<Tetrahedron> children(const Tetrahedron& t, Diagonal rule) {
  const auto sum = [&](std::size_t i, std::size_t j) {
    return At<std::int64_t>{t[i][0] + t[j][0], t[i][1] + t[j][1], t[i][2] + t[j][2]};
  };
  // Opposite midpoints of the octahedron: 01 and 23, 02 and 13, 03 and 12.
  using Ends = std::array<std::array<std::size_t, 2>, 2>;
  constexpr std::array<Ends, 3> diagonals{{{{{0, 1}, {2, 3}}}, {{{0, 2}, {1, 3}}}, {{{0, 3}, {1, 2}}}}};
  const auto length = [&](const Ends& d) {
    return square_of_distance(sum(d[0][0], d[0][1]), sum(d[1][0], d[1][1]));
  };
  const auto shorter = [&](const Ends& a, const Ends& b) { return length(a) < length(b); };
  std::size_t chosen = 1;
  if (rule == Diagonal::shortest)
    chosen = static_cast<std::size_t>(std::min_element(diagonals.begin(), diagonals.end(), shorter) -
                                      diagonals.begin());
  if (rule == Diagonal::longest)
    chosen = static_cast<std::size_t>(std::max_element(diagonals.begin(), diagonals.end(), shorter) -
                                      diagonals.begin());

  std::vector<Tetrahedron> all;
  if (rule == Diagonal::bey) {
    for (const char* corners : bey_children) {
      const Child child = child_of(corners, 2);
      Tetrahedron one{};
      for (std::size_t k = 0; k < 4; ++k) one[k] = sum(child.means[k][0], child.means[k][1]);
      all.push_back(one);
    }
    return all;
  }
  for (std::size_t k = 0; k < 4; ++k) all.push_back({sum(k, 0), sum(k, 1), sum(k, 2), sum(k, 3)});
  const Ends &axis = diagonals[chosen], &one = diagonals[(chosen + 1) % 3],
             &other = diagonals[(chosen + 2) % 3];
  for (const auto& a : one)
    for (const auto& b : other)
      all.push_back(
          {sum(axis[0][0], axis[0][1]), sum(axis[1][0], axis[1][1]), sum(a[0], a[1]), sum(b[0], b[1])});
  return all;
}

/// The number of shapes among all cells of levels 0 to n.  One cell of a shape stands for all, since its children have the
/// same shapes; under Bey's rule, which heeds the order of corners, for all with its edges in its order.
inline std::size_t shapes(const Tetrahedron& t, Diagonal rule, Level n) {
  using Key = std::pair<Lengths, std::array<At<std::int64_t>, 3>>;
  const auto key = [&](const Tetrahedron& one) {
    Key found{shape_of(one), {}};
    if (rule != Diagonal::bey) return found;
    for (std::size_t k = 0; k < 3; ++k) found.second[k] = difference(one[k + 1], one[k]);
    return found;
  };
  std::vector<Tetrahedron> level{t};
  std::set<Lengths> seen{shape_of(t)};
  for (Level depth = 1; depth <= n; ++depth) {
    std::set<Key> fresh;
    std::vector<Tetrahedron> next;
    for (const Tetrahedron& parent : level)
      for (const Tetrahedron& child : children(parent, rule))
        if (fresh.insert(key(child)).second) next.push_back(child);
    for (const Tetrahedron& one : next) seen.insert(shape_of(one));
    level = std::move(next);
  }
  return seen.size();
}

}  // namespace mmverify::spec::subdivision
