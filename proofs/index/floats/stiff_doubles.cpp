#include "proofs/index/floats/stiff_doubles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "proofs/engine/random.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr Level finest = 16;
constexpr double ulp = std::numeric_limits<double>::epsilon();

/// A few ulp away, in either direction, from 0 a few 2^-96; stays at or above -0.
double nudged(double x, Random& random, std::int64_t most = 3) {
  const std::int64_t ulps = random.between(-most, most);
  // The ulp of 0 is one of the numbers that only rationals hold; `special` has those.
  if (x == 0) return ulps > 0 ? std::ldexp(static_cast<double>(ulps), -96) : x;
  for (std::int64_t k = 0; k < ulps; ++k) x = std::nextafter(x, 2.0);
  for (std::int64_t k = 0; k > ulps && x > 0; --k) x = std::nextafter(x, 0.0);
  return x;
}

/// Uniform in [0, 1), all of a double's bits.
double fraction(Random& random) { return std::ldexp(static_cast<double>(random.next() >> 11), -53); }

/// k / 2^m with 0 <= k/2^m <= limit; m is the level, half of the time, or any other.  Half of the time k is below a
/// random power of two: near the w-corner numbers have their last bits farthest below the grid.
double line(Level n, double limit, Random& random) {
  const Level m = random.below(2) == 0 ? n : static_cast<Level>(random.below(finest + 1));
  const double N = std::ldexp(1.0, static_cast<int>(m));
  std::uint64_t count = static_cast<std::uint64_t>(std::max(limit, 0.0) * N) + 1;
  if (random.below(2) == 0) count = std::min(count, (std::uint64_t{1} << random.below(m + 1)) + 1);
  return static_cast<double>(random.below(count)) / N;
}

DoublePair near_lines(Level n, Random& random) {
  const double u = line(n, 1, random);
  return {nudged(u, random), nudged(line(n, 1 - u, random), random)};
}

DoublePair near_diagonal(Level n, Random& random) {
  const double sum = line(n, 1, random);
  const double u = random.below(2) == 0 ? sum * fraction(random) : nudged(line(n, sum, random), random);
  return {u, nudged(sum - u, random)};
}

/// uf a few ulp below 1 and vf about as small as what is missing, or the other way round.
DoublePair straddling(Level n, Random& random) {
  const double N = std::ldexp(1.0, static_cast<int>(n));
  const double next = (static_cast<double>(random.below(static_cast<std::uint64_t>(N))) + 1) / N;
  double u = next;
  for (std::int64_t ulps = random.between(1, 4); ulps > 0; --ulps) u = std::nextafter(u, 0.0);
  const double j = random.below(2) == 0 ? 0 : line(n, 1 - next, random);
  const double tiny = (next - u) * std::ldexp(1.0, static_cast<int>(random.between(-4, 1)));
  const double v = nudged(j + tiny, random, 1);
  return random.below(2) == 0 ? DoublePair{u, v} : DoublePair{v, u};
}

DoublePair near_hypotenuse(Random& random) {
  const double u = fraction(random);
  return {u, nudged(1 - u, random, 1)};
}

double special(Random& random) {
  constexpr double least = std::numeric_limits<double>::denorm_min(),
                   normal = std::numeric_limits<double>::min();
  constexpr std::array values{0.0,        -0.0,    0x1p-149,      0x1p-60,
                              ulp / 4,    ulp / 2, ulp,           0.5 - ulp / 4,
                              0.5,        1.0,     0.5 + ulp / 2, 1 - 0x1p-24 - ulp / 2,
                              1 - ulp / 2};
  // Seldom: no word of fixed point holds these, and rationals take their time.
  constexpr std::array tiny{least, normal - least, normal};
  return random.below(16) == 0 ? tiny[random.below(tiny.size())] : values[random.below(values.size())];
}

DoublePair uniform(Random& random) {
  const double u = fraction(random), v = fraction(random);
  return u + v <= 1 ? DoublePair{u, v} : DoublePair{1 - u, 1 - v};
}

DoublePair candidate(Level n, Random& random, std::uint64_t kind) {
  switch (kind) {
    case 0: return near_lines(n, random);
    case 1: return near_diagonal(n, random);
    case 2: return straddling(n, random);
    case 3: return near_hypotenuse(random);
    case 4:
      return random.below(2) == 0 ? DoublePair{special(random), special(random)}
                                  : DoublePair{special(random), nudged(line(n, 1, random), random)};
    default: return uniform(random);
  }
}

/// u+v <= 1 + ulp, which the rounded sum does not decide: where it is 1 + ulp, what it left out does.
bool acceptable(const DoublePair& p) {
  if (!(p.u >= 0 && p.v >= 0 && p.u <= 1 && p.v <= 1)) return false;
  const double sum = p.u + p.v, larger = std::max(p.u, p.v), smaller = std::min(p.u, p.v);
  return sum < 1 + ulp || (sum == 1 + ulp && smaller - (sum - larger) <= 0);
}

}  // namespace

DoublePair stiff_doubles(Level n, std::uint64_t seed, std::uint64_t sample) {
  Random random(seed ^ 0x646f75626c65, n, sample);
  for (int tries = 0; tries < 8; ++tries)
    if (const DoublePair p = candidate(n, random, sample % 6); acceptable(p)) return p;
  return uniform(random);
}

}  // namespace mmverify::proofs::index
