// The number types in which index functions receive their points, by their rounding.
#pragma once

#include <string_view>

namespace mmverify::bench {

/// Binary numbers of `precision` significant bits, fewer below 2^least_exponent: there, and so in fixed point
/// everywhere below 2, the spacing stays the same. Every number below 2 of these types is a double.
struct NumberType {
  std::string_view name;
  int precision;
  int least_exponent;

  /// Distance to the next number away from zero.  Domain: representable x in [0, 2).
  double ulp(double x) const;

  /// x to the nearest number, ties to even.  Domain: x in [0, 2).
  double rounded(double x) const;

  /// The number `steps` numbers above x, or below it if negative; zero if that would be negative.
  /// Domain: representable x in [0, 1], |steps| small.
  double neighbour(double x, int steps) const;
};

inline constexpr NumberType binary16{"binary16", 11, -14};
inline constexpr NumberType binary32{"binary32", 24, -126};
inline constexpr NumberType binary64{"binary64", 53, -1022};
/// Whole multiples of 2^-30: spec's Fixed64.
inline constexpr NumberType fixed64{"fixed point", 31, 0};

}  // namespace mmverify::bench
