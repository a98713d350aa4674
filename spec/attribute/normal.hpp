// Attribute micromaps of normals: the mean direction and the mean's length, rounded exactly.
//
// A texel's normal is taken as a sampler gives it, not made one unit long first.  The mean m of texels is divided by
// its length, which is irrational; but whether a / |m| is a threshold t or more is a comparison of squares,
//   a >= t |m|   if   a, t >= 0 and a^2 >= t^2 |m|^2, or t <= 0 <= a, or a, t < 0 and a^2 <= t^2 |m|^2.
// Source: glTF 2.0, normalTexture (2 code / 255 - 1, then normalised); the length as a measure of how the normals
// spread: Toksvig, Mipmapping Normal Maps.
#pragma once

#include <array>
#include <cstdint>

#include "spec/attribute/colour.hpp"

namespace mmverify::spec::attribute {

template <class Q>
using Vector3 = std::array<Q, 3>;

template <class Q>
Q squared_length(const Vector3<Q>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// Whether a >= t sqrt(square), exactly.  Domain: square >= 0.
template <class Q>
bool reaches(const Q& a, const Q& t, const Q& square) {
  if (a >= 0) return t <= 0 || a * a >= t * t * square;
  return t < 0 && a * a <= t * t * square;
}

/// The codes of m / |m|, half up:  floor(full (m_i / |m| + 1) / 2 + 1/2), full = 255 or 65535.
/// The mean of no direction, m = 0, is the surface's own normal (0, 0, 1): (128, 128, 255), or (32768, 32768, 65535).
template <class Code = std::uint8_t, class Q>
std::array<Normal<Code>, 3> direction(const Vector3<Q>& m) {
  constexpr std::int64_t full = full_code<Code>;
  const Q square = squared_length(m);
  if (square == 0) {
    constexpr auto middle = static_cast<Code>((full + 1) / 2);
    return {Normal<Code>{middle}, Normal<Code>{middle}, Normal<Code>{full_code<Code>}};
  }
  std::array<Normal<Code>, 3> codes;
  // Code c begins at full (x + 1) / 2 = c - 1/2, that is x = (2 c - 1 - full) / full.
  for (std::size_t k = 0; k < 3; ++k)
    codes[k] = {last_code<Code>(
        [&](int c) { return reaches(m[k], fraction<Q>(2 * std::int64_t{c} - 1 - full, full), square); })};
  return codes;
}

/// The code of |m|, half up, at most full:  floor(full |m| + 1/2).  full less the code measures the normals' spread.
template <class Code = std::uint8_t, class Q>
Code length_code(const Vector3<Q>& m) {
  const Q square = squared_length(m);
  return last_code<Code>([&](int c) {
    const Q begins = fraction<Q>(2 * std::int64_t{c} - 1, 2 * full_code<Code>);
    return square >= begins * begins;
  });
}

}  // namespace mmverify::spec::attribute
