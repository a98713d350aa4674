// From binary32 and binary64 to the exact number types of the specification.
#pragma once

#include <bit>
#include <type_traits>

#include "proofs/points/point.hpp"
#include "spec/fixed.hpp"

namespace mmverify::proofs::points {

/// A finite number as significand 2^exponent, the significand odd or zero; zero has exponent 0.
struct Dyadic {
  std::uint64_t significand;
  int exponent;
  bool negative;
};

/// Domain: finite x, float or double.
template <class F>
constexpr Dyadic dyadic(F x) {
  using Bits = std::conditional_t<sizeof(F) == 4, std::uint32_t, std::uint64_t>;
  constexpr int digits = sizeof(F) == 4 ? 23 : 52, bias = sizeof(F) == 4 ? 127 : 1023;
  constexpr Bits leading = Bits{1} << digits;
  const Bits bits = std::bit_cast<Bits>(x), magnitude = bits & (~Bits{0} >> 1);
  if (magnitude == 0) return {0, 0, bits != 0};
  const int field = static_cast<int>(magnitude >> digits);
  // A subnormal number has exponent field 0, no leading 1, and the scale of field 1.
  const Bits significand = (magnitude & (leading - 1)) | (field == 0 ? 0 : leading);
  const int zeros = std::countr_zero(significand);
  return {significand >> zeros, (field == 0 ? 1 : field) - bias - digits + zeros, bits != magnitude};
}

/// Whether Fixed holds the number: its last bit is a fraction bit of Fixed or more, and it is 2 or less in
/// size.
template <class Fixed>
constexpr bool fits(const Dyadic& x) {
  const int size = x.exponent + static_cast<int>(std::bit_width(x.significand));
  return x.exponent >= -static_cast<int>(Fixed::fraction_bits) &&
         (size <= 1 || (size == 2 && x.significand == 1));
}

/// Domain: fits<Fixed>(x).
template <class Fixed>
constexpr Fixed exactly(const Dyadic& x) {
  using Word = typename Fixed::word_type;
  const Word raw = static_cast<Word>(x.significand) << (static_cast<int>(Fixed::fraction_bits) + x.exponent);
  return Fixed::from_raw(x.negative ? Word(-raw) : raw);
}

/// Holds binary32 and binary64 numbers whose last bit is 2^-43 or more; see docs/SOUNDNESS.md, "No sum
/// overflows", for levels up to 16.
using Fixed64ForFloats = spec::Fixed<std::int64_t, 43>;

/// Calls algorithm(point) with the two numbers exact: in the first of these types that holds both, else as
/// rationals.
template <class... Types, class F, class Algorithm>
auto on_exact_in(F u, F v, Algorithm algorithm) {
  const Dyadic du = dyadic(u), dv = dyadic(v);
  std::common_type_t<decltype(algorithm(RationalPoint{}))> answer{};
  const auto in = [&]<class Fixed>(std::type_identity<Fixed>) {
    if (!fits<Fixed>(du) || !fits<Fixed>(dv)) return false;
    answer = algorithm(spec::Point<Fixed>{exactly<Fixed>(du), exactly<Fixed>(dv)});
    return true;
  };
  if (!(in(std::type_identity<Types>{}) || ...)) answer = algorithm(RationalPoint{rational(u), rational(v)});
  return answer;
}

/// Levels up to 16, 64-bit words first.  Domain: finite.
template <class F, class Algorithm>
auto on_exact(F u, F v, Algorithm algorithm) {
  return on_exact_in<Fixed64ForFloats, spec::Fixed128, spec::Fixed256>(u, v, algorithm);
}

/// Levels up to 24, 128-bit words first.  Domain: finite.
template <class F, class Algorithm>
auto on_exact_wide(F u, F v, Algorithm algorithm) {
  return on_exact_in<spec::Fixed128, spec::Fixed256>(u, v, algorithm);
}

}  // namespace mmverify::proofs::points
