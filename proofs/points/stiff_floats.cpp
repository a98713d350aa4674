#include "proofs/points/stiff_floats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "proofs/engine/random.hpp"

namespace mmverify::proofs::points {
namespace {

constexpr Level finest = 16;

/// A few ulp away, in either direction; stays at or above -0.
float nudged(float x, Random& random, std::int64_t most = 3) {
  std::int64_t ulps = random.between(-most, most);
  for (; ulps > 0; --ulps) x = std::nextafter(x, 2.0f);
  for (; ulps < 0 && x > 0; ++ulps) x = std::nextafter(x, 0.0f);
  return x;
}

/// The level asked for, half of the time, or any other.
Level some_level(Level n, Random& random) {
  return random.below(2) == 0 ? n : static_cast<Level>(random.below(finest + 1));
}

/// k / 2^level in [0, limit]: half of the time k is below a random power of two, so that the w-corner's lines come as
/// often as others, where numbers have their last bits farthest below the grid.
double line(Level level, double limit, Random& random) {
  const double N = std::ldexp(1.0, static_cast<int>(level));
  std::uint64_t count = static_cast<std::uint64_t>(limit * N) + 1;
  if (random.below(2) == 0) count = std::min(count, (std::uint64_t{1} << random.below(level + 1)) + 1);
  return static_cast<double>(random.below(count)) / N;
}

FloatPair near_lines(Level n, Random& random) {
  const double u = line(some_level(n, random), 1, random);
  return {nudged(static_cast<float>(u), random),
          nudged(static_cast<float>(line(some_level(n, random), 1 - u, random)), random)};
}

FloatPair near_diagonal(Level n, Random& random) {
  const double sum = line(some_level(n, random), 1, random);
  const double u = sum * static_cast<double>(random.below(1u << 24)) / (1u << 24);
  const float near_u = random.below(2) == 0
                           ? static_cast<float>(u)
                           : nudged(static_cast<float>(line(some_level(n, random), sum, random)), random);
  return {near_u, nudged(static_cast<float>(sum - static_cast<double>(near_u)), random)};
}

/// uf a few ulp below 1 and vf about as small as what is missing, or the other way round.
FloatPair straddling(Level n, Random& random) {
  const double N = std::ldexp(1.0, static_cast<int>(n));
  const double i = static_cast<double>(random.below(static_cast<std::uint64_t>(N)));
  float u = static_cast<float>((i + 1) / N);
  for (std::int64_t ulps = random.between(1, 4); ulps > 0; --ulps) u = std::nextafter(u, 0.0f);
  const double missing = (i + 1) / N - static_cast<double>(u);
  const double j = random.below(2) == 0 ? 0 : line(n, 1 - (i + 1) / N, random);
  const double tiny = missing * std::ldexp(1.0, static_cast<int>(random.between(-4, 1)));
  const float v = nudged(static_cast<float>(j + tiny), random, 1);
  return random.below(2) == 0 ? FloatPair{u, v} : FloatPair{v, u};
}

FloatPair near_hypotenuse(Random& random) {
  const float u =
      static_cast<float>(static_cast<double>(random.below(std::uint64_t{1} << 32)) / 4294967296.0);
  return {u, nudged(static_cast<float>(1.0 - static_cast<double>(u)), random, 1)};
}

float special(Random& random) {
  constexpr float ulp = std::numeric_limits<float>::epsilon();
  constexpr std::array<float, 14> values{
      0.0f,
      -0.0f,
      std::numeric_limits<float>::denorm_min(),
      std::numeric_limits<float>::min() - std::numeric_limits<float>::denorm_min(),
      std::numeric_limits<float>::min(),
      0x1p-100f,
      0x1p-76f,
      0x1p-25f,
      ulp / 2,
      ulp,
      0.5f - ulp / 4,
      0.5f,
      1.0f - ulp / 2,
      1.0f};
  return values[random.below(values.size())];
}

FloatPair uniform(Random& random) {
  const double u = static_cast<double>(random.below(std::uint64_t{1} << 32)) / 4294967296.0;
  const double v = static_cast<double>(random.below(std::uint64_t{1} << 32)) / 4294967296.0;
  if (u + v <= 1) return {static_cast<float>(u), static_cast<float>(v)};
  return {static_cast<float>(1 - u), static_cast<float>(1 - v)};
}

/// A coordinate of any size down to 2^-60, and the other on a line or next to it: sums of the two and their
/// complements lose bits of the small one, in binary64, too.
FloatPair tiny_beside_a_line(Level n, Random& random) {
  const double whole = static_cast<double>(random.between(16, 31)) / 32;
  const float tiny = static_cast<float>(std::ldexp(whole, -static_cast<int>(random.below(61)))),
              on_line = nudged(static_cast<float>(line(some_level(n, random), 1, random)), random, 1);
  return random.below(2) == 0 ? FloatPair{tiny, on_line} : FloatPair{on_line, tiny};
}

FloatPair candidate(Level n, Random& random, std::uint64_t kind) {
  switch (kind) {
    case 0: return near_lines(n, random);
    case 1: return near_diagonal(n, random);
    case 2: return straddling(n, random);
    case 3: return near_hypotenuse(random);
    case 4: return {special(random), special(random)};
    case 5:
      return random.below(2) == 0
                 ? FloatPair{special(random),
                             nudged(static_cast<float>(line(some_level(n, random), 1, random)), random)}
                 : FloatPair{nudged(static_cast<float>(line(some_level(n, random), 1, random)), random),
                             special(random)};
    default: return random.below(2) == 0 ? tiny_beside_a_line(n, random) : uniform(random);
  }
}

bool acceptable(const FloatPair& p) {
  // Neither above 1, or a tiny other one could hide in the sum's rounding.
  return p.u >= 0 && p.v >= 0 && p.u <= 1 && p.v <= 1 &&
         static_cast<double>(p.u) + static_cast<double>(p.v) <= 1 + 0x1p-23;
}

}  // namespace

FloatPair stiff_floats(Level n, std::uint64_t seed, std::uint64_t sample) {
  Random random(seed, n, sample);
  const std::uint64_t kind = sample % 7;
  for (int tries = 0; tries < 8; ++tries)
    if (const FloatPair p = candidate(n, random, kind); acceptable(p)) return p;
  return uniform(random);
}

}  // namespace mmverify::proofs::points
