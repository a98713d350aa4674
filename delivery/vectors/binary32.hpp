// Binary32 numbers by their bits; exact numbers rounded to nearest or down.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "spec/bake/texture.hpp"
#include "spec/rational.hpp"

namespace mmverify::vectors {

using spec::Integer;
using spec::Rational;

inline std::uint32_t bits_of(float x) { return std::bit_cast<std::uint32_t>(x); }

/// The value of a binary32 number. Domain: finite.
inline Rational exactly(std::uint32_t bits) {
  return spec::bake::number<Rational>(spec::bake::Binary32{bits});
}

/// The greatest binary32 number that is q or less.  Domain: 0 <= q < 2^127.
inline std::uint32_t rounded_down(const Rational& q) {
  if (q == 0) return 0;
  const auto floor = [](const Rational& r) { return Integer(r.numerator() / r.denominator()); };
  int e = static_cast<int>(msb(q.numerator())) - static_cast<int>(msb(q.denominator()));
  if (q < spec::scaled(1, e)) --e;
  if (e < -126) return static_cast<std::uint32_t>(floor(q * spec::scaled(1, 149)));
  const auto digits = static_cast<std::uint32_t>(floor(q * spec::scaled(1, 23 - e)));
  return (static_cast<std::uint32_t>(e + 127) << 23) + (digits - 0x800000u);
}

/// The nearest binary32 number; a tie goes to the even one. Domain: 0 <= q < 2^127.
inline std::uint32_t nearest(const Rational& q) {
  const std::uint32_t low = rounded_down(q);
  const Rational down = q - exactly(low), up = exactly(low + 1) - q;
  return down < up || (down == up && low % 2 == 0) ? low : low + 1;
}

/// k / 2^bits.  Domain: exact in binary32.
inline std::uint32_t dyadic(std::uint32_t k, unsigned bits) {
  return bits_of(std::ldexp(static_cast<float>(k), -static_cast<int>(bits)));
}

/// The binary32 number `steps` steps above `bits`, which is not negative; every step below 0 gives -0.
inline std::uint32_t stepped(std::uint32_t bits, int steps) {
  const std::int64_t to = std::int64_t{bits} + steps;
  return to < 0 ? 0x80000000u : static_cast<std::uint32_t>(to);
}

/// Reproducible pseudo-random numbers: a linear congruential generator modulo 2^32.
/// Source: Numerical Recipes, 7.1 (a = 1664525, c = 1013904223); the high bits alone are used.
class Mixed {
 public:
  explicit Mixed(std::uint32_t seed) : state_(seed) {}
  /// A number below 2^bits. Domain: bits in 1..24.
  std::uint32_t bits(unsigned bits) {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> (32 - bits);
  }

 private:
  std::uint32_t state_;
};

}  // namespace mmverify::vectors
