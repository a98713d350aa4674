// Attribute micromaps: the number of a stored code, and the code that a number is rounded to.
//
// The sRGB curve is not rational.  But the fifth power of r^(12/5) is r^12, which decides every comparison:
//   y = m / 510,   light(y) = y / 12.92 up to y = 0.04045, else r^(12/5),   r = (y + 0.055) / 1.055
//   x >= r^(12/5)  if and only if  x^5 >= r^12
// So codes are decoded by a table of integers over 2^24, each the nearest.  Numbers are encoded by a table of
// thresholds, each the nearest to the point where the curve passes the middle between two codes.
// Stated error: a decoded number is within 2^-25 of the curve, and so is a mean of such numbers, and a threshold.  A
// code is that of the curve itself unless the mean is within 2^-24 of a threshold.
// Source: IEC 61966-2-1; glTF 2.0, "baseColorTexture"; Vulkan, Conversion From Normalized Fixed-Point to Floating-Point.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "spec/bake/bake.hpp"

namespace mmverify::spec::attribute {

using bake::Binary32;
using bake::fraction;
using bake::number;

/// A code of 8 bits on the sRGB curve; the number is linear light.
struct Srgb8 {
  std::uint8_t code = 0;
};

/// A component of a normal as a code; the number is 2 code / full - 1, full the greatest code, and 0 has no code.
template <class Code>
struct Normal {
  Code code = 0;
};
using Normal8 = Normal<std::uint8_t>;
using Normal16 = Normal<std::uint16_t>;

/// The greatest code: 255 or 65535.
template <class Code>
inline constexpr std::int64_t full_code = std::numeric_limits<Code>::max();

// ---- The sRGB curve

/// The unit of light is 2^-24.
inline constexpr unsigned light_bits = 24;

/// Whether k / 2^bits >= light(m / 510), exactly.  Domain: k >= 0; m in 0..510.
inline bool reaches_light(const Integer& k, unsigned bits, std::uint32_t m) {
  namespace mp = boost::multiprecision;
  // m / 510 / 12.92 = 5 m / 32946, and m / 510 <= 0.04045 up to m = 20.
  if (m <= 20) return k * 32946 >= (Integer(5 * m) << bits);
  // r = (20 m + 561) / 10761.
  return mp::pow(k, 5) * mp::pow(Integer(10761), 12) >= (mp::pow(Integer(20 * m + 561), 12) << 5 * bits);
}

/// light(m / 510) in units of 2^-24, to nearest: the last k with k - 1/2 <= 2^24 light.
/// Domain: m in 0..510; an even m is the code m / 2, an odd one the middle between two codes.
inline std::uint32_t nearest_light(std::uint32_t m) {
  std::uint32_t low = 0, high = (1u << light_bits) + 1;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    // middle - 1/2 is never the light itself: but for 0 and 1 its denominator is no power of 2.
    (reaches_light(Integer(2 * middle - 1), light_bits + 1, m) ? high : low) = middle;
  }
  return low;
}

/// nearest_light() of every m, computed once.
inline const std::array<std::uint32_t, 511>& light_table() {
  static const std::array<std::uint32_t, 511> table = [] {
    std::array<std::uint32_t, 511> t{};
    for (std::uint32_t m = 0; m < t.size(); ++m) t[m] = nearest_light(m);
    return t;
  }();
  return table;
}

/// The light of a code, in units of 2^-24.
inline std::uint32_t light_of(std::uint8_t code) { return light_table()[2u * code]; }
/// The least light that is rounded to a code, in units of 2^-24.  Domain: code in 1..255.
inline std::uint32_t least_light(std::uint8_t code) { return light_table()[2u * code - 1]; }

template <class Q>
Q number(Srgb8 stored) {
  return fraction<Q>(light_of(stored.code), std::int64_t{1} << light_bits);
}

template <class Q, class Code>
Q number(Normal<Code> stored) {
  return fraction<Q>(2 * std::int64_t{stored.code} - full_code<Code>, full_code<Code>);
}

// ---- Rounding

/// min(full, max(0, floor(full q + 1/2))): half up.
template <class Q>
std::int64_t half_up(const Q& q, std::int64_t full) {
  const std::int64_t k = bake::floored(fraction<Q>(full, 1) * q + fraction<Q>(1, 2));
  return k < 0 ? 0 : k > full ? full : k;
}

/// The code that a number is rounded to, for each form of texels.
template <class Texel>
struct Rounded;

/// Rounds to 8 bits: 0 to 255.
template <>
struct Rounded<std::uint8_t> {
  template <class Q>
  static std::uint8_t of(const Q& q) {
    return static_cast<std::uint8_t>(half_up(q, 255));
  }
};

/// Rounds to 16 bits: 0 to 65535.
template <>
struct Rounded<std::uint16_t> {
  template <class Q>
  static std::uint16_t of(const Q& q) {
    return static_cast<std::uint16_t>(half_up(q, 65535));
  }
};

/// The last code with begun(code).  Domain: begun is true of 0 and up to some code, and false beyond.
template <class Code = std::uint8_t, class Begun>
Code last_code(Begun begun) {
  int low = 0, high = static_cast<int>(full_code<Code>) + 1;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (begun(middle) ? low : high) = middle;
  }
  return static_cast<Code>(low);
}

/// Rounds half up on the curve, to the last code whose least light is reached.
template <>
struct Rounded<Srgb8> {
  template <class Q>
  static Srgb8 of(const Q& q) {
    return {last_code([&](int c) {
      return q >= fraction<Q>(least_light(static_cast<std::uint8_t>(c)), std::int64_t{1} << light_bits);
    })};
  }
};

/// Rounds a component by itself; spec/attribute/normal.hpp rounds a direction.
template <class Code>
struct Rounded<Normal<Code>> {
  template <class Q>
  static Normal<Code> of(const Q& q) {
    return {static_cast<Code>(half_up(Q((q + fraction<Q>(1, 1)) * fraction<Q>(1, 2)), full_code<Code>))};
  }
};

/// Rounds to nearest, ties to even.  Errors: std::overflow_error beyond binary32's greatest, which no mean of it is.
/// Source: IEEE 754, 4.3.1.
template <>
struct Rounded<Binary32> {
  template <class Q>
  static Binary32 of(const Q& q) {
    const bool negative = q < 0;
    const Q size = negative ? Q(-q) : q, two(2);
    if (size == 0) return {0};
    // size = m 2^e with m in [2^23, 2^24), or e = -149.
    int e = -149;
    Q m = size;
    for (int k = 0; k < 149; ++k) m *= two;
    while (m >= fraction<Q>(1 << 24, 1)) {
      m /= two;
      ++e;
    }
    std::int64_t whole = bake::floored(m);
    const Q rest = (m - fraction<Q>(whole, 1)) * two;
    if (rest > 1 || (rest == 1 && whole % 2 != 0)) ++whole;
    // The leading bit of a normal number adds one to the exponent; a carry does so, too.
    const std::int64_t bits = (std::int64_t{e + 149} << 23) + whole;
    if (bits >= 0x7f800000) throw std::overflow_error("attribute: beyond binary32");
    return {static_cast<std::uint32_t>(bits) | (negative ? 0x80000000u : 0u)};
  }
};

}  // namespace mmverify::spec::attribute
