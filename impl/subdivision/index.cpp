#include "impl/index/index.hpp"

#include <algorithm>

#include "impl/subdivision/rules.hpp"
#include "impl/subdivision/subdivision.hpp"

namespace mmverify::impl::subdivision {
namespace {

/// Barycentrics of a point on the current cell, times their sum.
using Weights = std::array<std::int64_t, 4>;

/// A point that lies on no facet of any cell of the level, and in the cell that the given point belongs to.
struct Nudged {
  Weights weights;
  std::int64_t sum;
};

/// The point moved a little along the first direction that does not leave the shape: no weight that is 0 falls.
template <std::size_t corners>
Nudged nudged(const Point& p, const std::int64_t (&directions)[corners][corners], std::int64_t factor) {
  Weights w{};
  w[0] = p.denominator;
  for (std::size_t k = 1; k < corners; ++k) {
    w[k] = p.numerators[k - 1];
    w[0] -= w[k];
  }
  for (const auto& direction : directions) {
    bool stays = true;
    for (std::size_t k = 0; k < corners; ++k) stays &= w[k] > 0 || direction[k] > 0;
    if (!stays) continue;
    for (std::size_t k = 0; k < corners; ++k) w[k] = w[k] * factor + direction[k];
    return {w, p.denominator * factor};
  }
  return {w, p.denominator};
}

/// The directions of the tie rule, by the corners' weights; a triangle's are w, u, v.
constexpr std::int64_t triangle_directions[3][3] = {{-3, 2, 1}, {1, -2, 1}, {1, 1, -2}};
constexpr std::int64_t tetrahedron_directions[4][4] = {
    {-3, 1, 1, 1}, {2, -4, 1, 1}, {2, 1, -4, 1}, {2, 1, 1, -4}};

/// The point's weights are multiplied by this much, and then moved by a direction, whose numbers are at most 4.  A step
/// compares a sum of the given weights with whole factors: 1 or more if it is not 0.  On a cell of level n a direction
/// changes the cell's own weights by less than 8 sides, and what a step compares by less than 64 sides.  So it decides
/// ties alone.
std::int64_t nudge_factor(std::uint32_t side) { return std::int64_t{64} * side; }

// ---- Triangles

/// A grid square's side, and how far a coordinate reaches into it.
struct Column {
  std::uint32_t whole;
  std::uint64_t part;  ///< times the denominator
};
Column column(std::uint32_t x, std::uint32_t denominator, std::uint32_t N) {
  const std::uint64_t scaled = std::uint64_t{x} * N;
  return {static_cast<std::uint32_t>(scaled / denominator), scaled % denominator};
}

/// The closed form of impl/index.
std::uint32_t in_four(const Point& p, std::uint32_t N) {
  const Column u = column(p.numerators[0], p.denominator, N), v = column(p.numerators[1], p.denominator, N);
  return index::detail::curve(index::detail::square(u.whole, v.whole, u.part + v.part >= p.denominator, N));
}

/// A child of the triangle in nine by the whole parts t of three times its weights.  They sum up to 2 in a child like its
/// parent, whose corners are t and one more of each weight, and to 1 in a turned one, whose corners are t and one more of
/// two weights.
struct Place {
  std::uint8_t digit = 0;
  bool turned = false;
  std::array<std::uint8_t, 3> order = {};  ///< the weight that each corner takes, or that it lacks
};

constexpr auto places = [] {
  std::array<Place, 27> all{};
  for (std::size_t digit = 0; digit < 9; ++digit) {
    const auto times = [&](std::size_t corner, std::size_t of) {
      unsigned n = 0;
      for (std::size_t part = 0; part < 3; ++part)
        n += detail::of_triangle_9[digit][4 * corner + part] == static_cast<char>('0' + of) ? 1 : 0;
      return n;
    };
    std::array<unsigned, 3> t{};
    for (std::size_t of = 0; of < 3; ++of) t[of] = std::min({times(0, of), times(1, of), times(2, of)});
    Place place{static_cast<std::uint8_t>(digit), t[0] + t[1] + t[2] == 1, {}};
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t of = 0; of < 3; ++of)
        if ((times(corner, of) > t[of]) != place.turned) place.order[corner] = static_cast<std::uint8_t>(of);
    all[t[0] * 9 + t[1] * 3 + t[2]] = place;
  }
  return all;
}();

std::uint32_t in_nine(Nudged at, Level level) {
  std::uint32_t index = 0;
  for (Level depth = 0; depth < level; ++depth) {
    std::size_t key = 0;
    std::array<std::int64_t, 3> rest{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t scaled = 3 * at.weights[i];
      const std::int64_t whole = (scaled >= at.sum ? 1 : 0) + (scaled >= 2 * at.sum ? 1 : 0);
      rest[i] = scaled - whole * at.sum;
      key = 3 * key + static_cast<std::size_t>(whole);
    }
    const Place& place = places[key];
    // No branch: where it goes depends on the point.
    const std::int64_t turned = place.turned ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i)
      at.weights[i] = turned * at.sum + (1 - 2 * turned) * rest[place.order[i]];
    index = 9 * index + place.digit;
  }
  return index;
}

std::uint32_t in_bisection(Nudged at, Level level) {
  auto [first, newest, last, unused] = at.weights;
  std::uint32_t index = 0;
  for (Level depth = 0; depth < level; ++depth) {
    const std::int64_t beyond = last - first;  // past the middle of the edge that is cut
    const std::int64_t middle = 2 * std::min(first, last);
    index = index * 2 + (beyond > 0 ? 1 : 0);
    if (beyond > 0) {
      first = newest;
      last = beyond;
    } else {
      first = -beyond;
      last = newest;
    }
    newest = middle;
  }
  return index;
}

// ---- Quads

/// The state is how the cell's x and y come from the square's: both from the other side, and then in turn.
std::uint32_t in_hilbert(std::uint32_t x, std::uint32_t y, Level level) {
  std::uint32_t index = 0, other_side = 0, in_turn = 0;
  for (Level depth = level; depth-- > 0;) {
    const std::uint32_t a = (x >> depth & 1) ^ other_side, b = (y >> depth & 1) ^ other_side;
    const std::uint32_t i = in_turn != 0 ? b : a, j = in_turn != 0 ? a : b;
    index = index << 2 | ((3 * i) ^ j);
    in_turn ^= 1 ^ j;
    other_side ^= i & ~j & 1;
  }
  return index;
}

std::uint32_t in_morton(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FF;
    bits = (bits | bits << 4) & 0x0F0F0F0F;
    bits = (bits | bits << 2) & 0x33333333;
    return (bits | bits << 1) & 0x55555555;
  };
  return spread(x) | spread(y) << 1;
}

// ---- Tetrahedra

/// The digit of each child in each state, and the child's state.
struct Turn {
  std::uint8_t digit = 0, state = 0;
};
constexpr auto turns = [] {
  std::array<std::array<Turn, 8>, detail::path_states> all{};
  for (unsigned state = 0; state < detail::path_states; ++state)
    for (unsigned digit = 0; digit < 8 && state / 4 != state % 4; ++digit) {
      const detail::Step step = detail::path_step(state, digit);
      all[state][step.child] = {static_cast<std::uint8_t>(digit), step.state};
    }
  return all;
}();

/// Replaces the weights by those on the child that they lie in, and returns its number.
unsigned into_child(Weights& w, std::int64_t sum) {
  for (unsigned k = 0; k < 4; ++k)
    if (2 * w[k] >= sum) {
      for (std::int64_t& weight : w) weight *= 2;
      w[k] -= sum;
      return k;
    }
  // Two planes through the diagonal from 02 to 13 cut the octahedron: one has the midpoints 01 and 23, one 03 and 12.
  const auto [a, b, c, d] = w;
  const bool near_03 = 2 * (a + d) >= sum, near_01 = 2 * (a + b) >= sum;
  if (near_03 && near_01) {  // 01 02 03 13
    const std::int64_t last = sum - 2 * a;
    w = {2 * b - last, 2 * c, 2 * d - last, last};
    return 4;
  }
  if (near_01) {  // 01 02 12 13
    const std::int64_t second = sum - 2 * b;
    w = {2 * a - second, second, 2 * c - second, 2 * d};
    return 5;
  }
  if (near_03) {  // 02 03 13 23
    const std::int64_t first = sum - 2 * d;
    w = {first, 2 * a - first, 2 * b, 2 * c - first};
    return 6;
  }
  const std::int64_t third = sum - 2 * c;  // 02 12 13 23
  w = {2 * a, 2 * b - third, third, 2 * d - third};
  return 7;
}

std::uint32_t in_tetrahedron(Nudged at, Level level) {
  std::uint32_t index = 0;
  std::size_t state = detail::first_path;
  for (Level depth = 0; depth < level; ++depth) {
    const Turn turn = turns[state][into_child(at.weights, at.sum)];
    index = index * 8 + turn.digit;
    state = turn.state;
  }
  return index;
}

}  // namespace

std::uint32_t index(Scheme scheme, Level level, const Point& point) noexcept {
  level = std::min(level, highest_level(scheme));
  const std::uint32_t N = side(scheme, level);
  const std::int64_t factor = nudge_factor(N);
  switch (scheme) {
    case Scheme::triangle_4: return in_four(point, N);
    case Scheme::triangle_9: return in_nine(nudged(point, triangle_directions, factor), level);
    case Scheme::tetrahedron: return in_tetrahedron(nudged(point, tetrahedron_directions, factor), level);
    case Scheme::bisection: {
      Nudged at = nudged(point, triangle_directions, factor);
      std::swap(at.weights[0], at.weights[1]);
      return in_bisection(at, level);
    }
    default: break;
  }
  const std::uint32_t x = std::min(column(point.numerators[0], point.denominator, N).whole, N - 1),
                      y = std::min(column(point.numerators[1], point.denominator, N).whole, N - 1);
  return scheme == Scheme::hilbert ? in_hilbert(x, y, level) : in_morton(x, y);
}

}  // namespace mmverify::impl::subdivision
