// Baking: the alpha of a texel, and the texel that an index means.
//
// Alpha is an exact number, however it is stored.
// Source: Vulkan, Image Operations ("Wrapping Operation"), Fixed-Point Data Conversions; glTF 2.0, samplers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "spec/rational.hpp"

namespace mmverify::spec::bake {

template <class Q>
Q fraction(std::int64_t m, std::int64_t n) {
  return Q(typename Q::int_type(m), typename Q::int_type(n));
}

// ---- Stored numbers

/// A binary32 number by its bits: sign, 8 of exponent, 23 of fraction.
struct Binary32 {
  std::uint32_t bits;
};
inline constexpr Binary32 one{0x3f800000};

/// byte / 255.  Source: Vulkan, Conversion From Normalized Fixed-Point to Floating-Point.
template <class Q>
Q number(std::uint8_t byte) {
  return fraction<Q>(byte, 255);
}

/// The number word / 65535.
template <class Q>
Q number(std::uint16_t word) {
  return fraction<Q>(word, 65535);
}

/// The number (-1)^s m 2^e, where m is the fraction, with its leading bit if it is normal.
/// Errors: std::invalid_argument for NaN and infinities.  Source: IEEE 754, 3.4.
template <class Q>
Q number(Binary32 x) {
  const std::uint32_t exponent = x.bits >> 23 & 255, fraction = x.bits & 0x7fffff;
  if (exponent == 255) throw std::invalid_argument("bake: a number that is not finite");
  using Whole = typename Q::int_type;
  const Whole m = exponent == 0 ? Whole(fraction) : Whole(fraction | 0x800000);
  const Whole s = x.bits >> 31 != 0 ? Whole(-1) : Whole(1);
  // Trailing zeros are removed, so that a number that fits a narrow type does not overflow it on the way.
  int e = static_cast<int>(exponent == 0 ? 1 : exponent) - 150;
  Whole odd = m;
  for (; odd != 0 && odd % 2 == 0; ++e) odd /= 2;
  if (odd == 0) return Q(0);
  const Whole two_e = Whole(1) << (e < 0 ? -e : e);
  return e < 0 ? Q(s * odd, two_e) : Q(s * odd * two_e);
}

// ---- Texels

/// The wrap mode.  mirror_once is Vulkan's MIRROR_CLAMP_TO_EDGE.
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border, mirror_once };

/// The filter.  nearest: texel (i, j) owns [i, i+1) x [j, j+1), before wrapping.
enum class Filter : std::uint8_t { bilinear, nearest };

/// A texture of alpha, texel (i, j) at i + width j, rows from the top.
/// Texel: std::uint8_t, std::uint16_t or Binary32.
template <class Texel>
struct TextureOf {
  std::uint32_t width = 0, height = 0;
  std::vector<Texel> alpha = {};
  Wrap wrap_x = Wrap::clamp_to_edge, wrap_y = Wrap::clamp_to_edge;
  Texel border = {};      ///< the texel outside, with clamp_to_border
  Binary32 factor = one;  ///< sampled alpha is multiplied by it, as by baseColorFactor's
  Filter filter = Filter::bilinear;
  Binary32 vertex_factor = one;  ///< another factor: the alpha that all vertices have
};
using Texture = TextureOf<std::uint8_t>;

/// The texel of a row (or column) of `size` texels that an index means; none means the border.
///   repeat i mod size; mirrored size-1 - mirror(i mod 2 size - size); mirror once: clamp(mirror(i)),
///   mirror(n) = n or, below 0, -(1+n)
/// Domain: size in 1..2^31.
inline std::optional<std::uint32_t> wrapped(Wrap wrap, std::int64_t i, std::uint32_t size) {
  const auto n = static_cast<std::int64_t>(size);
  const auto mod = [](std::int64_t k, std::int64_t m) { return (k % m + m) % m; };
  const auto mirror = [](std::int64_t k) { return k >= 0 ? k : -(1 + k); };
  switch (wrap) {
    case Wrap::repeat: i = mod(i, n); break;
    case Wrap::mirrored_repeat: i = n - 1 - mirror(mod(i, 2 * n) - n); break;
    case Wrap::clamp_to_edge: i = std::clamp<std::int64_t>(i, 0, n - 1); break;
    case Wrap::mirror_once: i = std::clamp<std::int64_t>(mirror(i), 0, n - 1); break;
    case Wrap::clamp_to_border:
      if (i < 0 || i >= n) return std::nullopt;
      break;
  }
  return static_cast<std::uint32_t>(i);
}

/// Alpha of texel (i, j), wrapped, times the factors.
template <class Q, class Texel>
Q texel(const TextureOf<Texel>& t, std::int64_t i, std::int64_t j) {
  const auto x = wrapped(t.wrap_x, i, t.width), y = wrapped(t.wrap_y, j, t.height);
  const Texel stored =
      x && y ? t.alpha.at(static_cast<std::size_t>(*x) + static_cast<std::size_t>(*y) * t.width) : t.border;
  Q alpha = number<Q>(stored);
  for (const Binary32 factor : {t.factor, t.vertex_factor})
    if (factor.bits != one.bits) alpha *= number<Q>(factor);
  return alpha;
}

}  // namespace mmverify::spec::bake
