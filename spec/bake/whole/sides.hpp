// The sides of a threshold that a texel's alpha may lie on, in whole numbers.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "spec/bake/boxes.hpp"
#include "spec/bake/state.hpp"
#include "spec/bake/whole/numbers.hpp"

namespace mmverify::spec::bake::whole {

/// A set of statements on places, bit by bit: some place is not opaque; some place is not transparent.
using Marks = unsigned;
inline constexpr Marks not_opaque = 1, not_transparent = 2, both = 3;

/// One side of a threshold: alpha above it, or below it; or equal to it, where the side is closed.
struct AlphaSide {
  Rational threshold;
  bool is_above, is_closed;
};

/// The sides of alpha that is not opaque, not transparent, and rather opaque.
using AlphaSides = std::array<AlphaSide, 3>;
inline AlphaSides sides(const Mask<Rational>& mode) {
  return {{{mode.cutoff, false, false}, {mode.cutoff, true, true}, {mode.cutoff, true, true}}};
}
inline AlphaSides sides(const MaskAbove<Rational>& mode) {
  return {{{mode.cutoff, false, true}, {mode.cutoff, true, false}, {mode.cutoff, true, false}}};
}
inline AlphaSides sides(const Blend<Rational>&) {
  return {{{1, false, false}, {0, true, false}, {Rational(1, 2), true, true}}};
}

/// A side for stored numbers v: a v - b > 0, or = 0 where it is closed.  The least such a and b.
struct StoredSide {
  Integer a, b;
  bool is_closed;

  /// Alpha is v times `unit`.
  StoredSide(const AlphaSide& side, const Rational& unit) : is_closed(side.is_closed) {
    a = unit.numerator() * side.threshold.denominator();
    b = side.threshold.numerator() * unit.denominator();
    const Integer divisor = gcd(a, b);
    if (divisor > 1) a /= divisor, b /= divisor;
    if (!side.is_above) a = -a, b = -b;
  }
  Integer height(std::int64_t v) const { return a * v - b; }

  /// The stored numbers on this side.
  Interval numbers() const {
    const std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                       greatest = std::numeric_limits<std::int64_t>::max();
    const auto bounded = [&](const Integer& x) {
      return x < least ? least : x > greatest ? greatest : static_cast<std::int64_t>(x);
    };
    if (a == 0) return b < 0 || (b == 0 && is_closed) ? Interval{least, greatest} : Interval{greatest, least};
    // v > b / a where a > 0, and v < b / a where a < 0.
    const Integer size = a > 0 ? a : Integer(-a), at = a > 0 ? b : Integer(-b);
    const Integer down = floor_div(at, size), up = down * size == at ? down : Integer(down + 1);
    if (a > 0) return {bounded(is_closed ? up : Integer(down + 1)), greatest};
    return {least, bounded(is_closed ? down : Integer(up - 1))};
  }
};

}  // namespace mmverify::spec::bake::whole
