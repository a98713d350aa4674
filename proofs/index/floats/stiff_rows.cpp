#include <cmath>

#include "proofs/engine/random.hpp"
#include "proofs/index/floats/stiff_doubles.hpp"

namespace mmverify::proofs::index {
namespace {

/// k / N with k in 1..N, as often of one size as of another: k below a random power of two.
double line(Level n, Random& random) {
  const std::uint64_t below = std::uint64_t{1} << random.below(n + 1);
  return std::ldexp(static_cast<double>(1 + random.below(below)), -static_cast<int>(n));
}

/// A few ulp away, in either direction; stays at or above 0.
float nudged(double at, Random& random) {
  auto x = static_cast<float>(at);
  const std::int64_t ulps = random.between(-2, 2);
  for (std::int64_t k = 0; k < ulps; ++k) x = std::nextafter(x, 2.0f);
  for (std::int64_t k = 0; k > ulps && x > 0; --k) x = std::nextafter(x, 0.0f);
  return x;
}

/// Uniform in (0, 1), to 32 bits.
double fraction(Random& random) {
  return std::ldexp(static_cast<double>(random.below(1ull << 32)) + 0.5, -32);
}

FloatPair either_way(float u, float v, Random& random) {
  return random.below(2) == 0 ? FloatPair{u, v} : FloatPair{v, u};
}

FloatPair near_row(Level n, Random& random) {
  const double sum = line(n, random);
  // The smaller part has up to 48 bits fewer than the sum.
  const double part = sum * fraction(random) * std::ldexp(1.0, -static_cast<int>(random.below(49)));
  const auto small = static_cast<float>(part);
  if (random.below(2) == 0)
    return either_way(small, nudged(sum - static_cast<double>(small), random), random);
  // The larger part first: a few ulp below the line; the smaller one about fills the gap.
  auto large = static_cast<float>(sum);
  for (std::int64_t ulps = random.between(1, 3); ulps > 0; --ulps) large = std::nextafter(large, 0.0f);
  return either_way(large, nudged(sum - static_cast<double>(large), random), random);
}

FloatPair near_column(Level n, Random& random) {
  const double u = line(n, random);
  const double v = random.below(2) == 0 ? line(n, random) : (1 - u) * fraction(random);
  return {nudged(u, random), nudged(v, random)};
}

FloatPair beside_nothing(Level n, Random& random) {
  const double v = line(n, random);
  const int power = -static_cast<int>(23 + random.below(127));
  const auto u = static_cast<float>(std::ldexp(1 + fraction(random), power));
  return {u, nudged(v, random)};
}

FloatPair at_corner(Level n, Random& random) {
  const double sum = line(n, random), v = sum * fraction(random), N = std::ldexp(1.0, static_cast<int>(n));
  const float on_line = nudged(std::floor(v * N) / N, random);
  return {nudged(sum - static_cast<double>(on_line), random), on_line};
}

FloatPair candidate(Level n, Random& random, std::uint64_t kind) {
  switch (kind) {
    case 0: return near_row(n, random);
    case 1: return near_column(n, random);
    case 2: return beside_nothing(n, random);
    default: return at_corner(n, random);
  }
}

bool acceptable(const FloatPair& p) {
  return p.u >= 0 && p.v >= 0 && p.u <= 1 && p.v <= 1 &&
         static_cast<double>(p.u) + static_cast<double>(p.v) <= 1 + 0x1p-23;
}

}  // namespace

FloatPair stiff_rows(Level n, std::uint64_t seed, std::uint64_t sample) {
  if (sample % 2 == 0) return stiff_floats(n, seed, sample / 2);
  Random random(seed ^ 0x726f7773, n, sample);
  for (int tries = 0; tries < 8; ++tries)
    if (const FloatPair p = candidate(n, random, sample / 2 % 4); acceptable(p)) return p;
  return stiff_floats(n, seed, sample);
}

}  // namespace mmverify::proofs::index
