// The exact number of every specification.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/rational.hpp>
#include <cstdint>

namespace mmverify::spec {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::rational<Integer>;

/// A rational within 127 bits, some forty times as fast: beyond them it throws std::overflow_error and never rounds.
using Rational128 = boost::rational<boost::multiprecision::checked_int128_t>;

/// The number m 2^e, which every finite binary floating-point number is.
inline Rational scaled(const Integer& m, int e) {
  return e >= 0 ? Rational(Integer(m << e)) : Rational(m, Integer(1) << -e);
}

/// floor(q) for 0 <= q < 2^32.  Boost keeps the denominator positive, so the quotient truncates downwards.
inline std::uint32_t whole(const Rational& q) {
  return static_cast<std::uint32_t>(Integer(q.numerator() / q.denominator()));
}

}  // namespace mmverify::spec
