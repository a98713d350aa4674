// Points as the laws hold and print them: exact, whatever number they came from.
#pragma once

#include "proofs/engine/result.hpp"
#include "proofs/points/cells.hpp"
#include "spec/rational.hpp"

namespace mmverify::proofs::points {

using spec::Rational;
using RationalPoint = spec::Point<Rational>;

RationalPoint rational(const GridPoint& p);

/// The exact value of a binary32 or binary64 number.  Domain: finite.
Rational rational(float x);
Rational rational(double x);

/// The nearest double; exact where the number has at most 53 significant bits.
double nearest(const Rational& q);

/// Which kind of cell of the level's grid holds the point.  Domain: inside the closed triangle.
Kind kind_of(const RationalPoint& p, Level n);

/// "v:u=3/8,v=1/4", "e:...", "i:...": the text that `replay --case` takes back.
std::string case_text(const RationalPoint& p, Level n);

/// "(0x1.8p-2,0x1p-2)", or empty where a double does not hold the point.
std::string hex_text(const RationalPoint& p);

/// log2 of the common denominator, then v, then u: a point with a small denominator is a simple one.
/// Domain: dyadic points; others come last.
Simplicity simplicity(const RationalPoint& p);

/// Reads case_text back; the kind letter may be left out, a coordinate is a fraction, a decimal or a
/// hexadecimal float. Anything else, and a point outside the triangle by more than 2^-20, throws BadCase.
RationalPoint parse_point(const std::string& text);

}  // namespace mmverify::proofs::points
