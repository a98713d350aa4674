// Conversions of doubles to the exact number types of the specification, and back for print.
#pragma once

#include <cmath>
#include <cstdint>

#include "spec/fixed.hpp"
#include "spec/number.hpp"
#include "spec/rational.hpp"

namespace mmverify::bench {

/// The exact value of x.  Domain: finite x.
inline spec::Rational exact_rational(double x) {
  int exponent = 0;
  const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  return spec::scaled(significand, exponent - 53);
}

/// Calls algorithm(point) with the two doubles exact: in 128-bit fixed point if its 100 fraction bits
/// represent them, else as rationals.  Domain: u and v in [0, 1].
template <class Algorithm>
auto on_exact(double u, double v, Algorithm algorithm) {
  static_assert(spec::Fixed128::fraction_bits == 100);
  const double scaled_u = u * 0x1p100, scaled_v = v * 0x1p100;
  const auto raw_u = static_cast<spec::Int128>(scaled_u), raw_v = static_cast<spec::Int128>(scaled_v);
  if (static_cast<double>(raw_u) == scaled_u && static_cast<double>(raw_v) == scaled_v)
    return algorithm(
        spec::Point<spec::Fixed128>{spec::Fixed128::from_raw(raw_u), spec::Fixed128::from_raw(raw_v)});
  return algorithm(spec::Point<spec::Rational>{exact_rational(u), exact_rational(v)});
}

/// The nearest double or one beside it: for figures, never for verdicts.
inline double to_double(const spec::Fixed128& q) {
  return std::ldexp(static_cast<double>(q.raw()), -static_cast<int>(spec::Fixed128::fraction_bits));
}
inline double to_double(const spec::Rational& q) { return boost::rational_cast<double>(q); }

}  // namespace mmverify::bench
