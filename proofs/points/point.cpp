#include "proofs/points/point.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "proofs/engine/kinds.hpp"
#include "proofs/engine/law.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::points {
namespace {

using spec::Integer, spec::scaled;

/// The exact value of any finite binary floating-point number.
template <class F>
Rational exact(F x) {
  int e = 0;
  constexpr int digits = std::numeric_limits<F>::digits;
  const F m = std::frexp(x, &e);
  return scaled(Integer(static_cast<std::int64_t>(std::ldexp(m, digits))), e - digits);
}

std::string fraction_text(const Rational& q) {
  if (q.denominator() == 1) return q.numerator().str();
  return q.numerator().str() + "/" + q.denominator().str();
}

bool is_whole(const Rational& q) { return q.denominator() == 1; }

/// Decimal digits as a number; Integer itself would take a leading 0 for octal.
Integer parse_digits(std::string digits) {
  const bool negative = digits.starts_with('-');
  digits.erase(0, negative ? 1 : 0);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Integer size(digits);
  return negative ? Integer(-size) : size;
}

/// "-0x1.8p-2": sign, whole part, fraction part, exponent. Exact, whatever its length.
Rational parse_hex(const std::vector<std::string>& m) {
  const std::string digits = m[2] + m[4];
  const Integer significand("0x" + digits);
  const int exponent = std::stoi(m[5]) - 4 * static_cast<int>(m[4].size());
  return scaled(!m[1].empty() ? Integer(-significand) : significand, exponent);
}

Rational parse_coordinate(const std::string& text) {
  if (const Groups m = groups_of(text, R"((-?[0-9]{1,400})/([0-9]{1,400}))")) {
    const Integer denominator = parse_digits((*m)[2]);
    if (denominator == 0) throw BadCase(fmt::format("'{}' divides by zero", text));
    return Rational(parse_digits((*m)[1]), denominator);
  }
  if (const Groups m = groups_of(text, R"((-?)([0-9]{1,400})(\.([0-9]{1,400}))?)")) {
    Rational q{parse_digits((*m)[2] + (*m)[4])};
    for (std::size_t d = 0; d < (*m)[4].size(); ++d) q /= Integer(10);
    return !(*m)[1].empty() ? Rational(-q) : q;
  }
  if (const Groups m =
          groups_of(text, R"((-?)0[xX]([0-9a-fA-F]{1,400})(\.([0-9a-fA-F]{0,400}))?[pP]([-+]?[0-9]{1,4}))"))
    return parse_hex(*m);
  throw BadCase(fmt::format("'{}' is not a coordinate: write 3/8, 0.375 or 0x1.8p-2", text));
}

}  // namespace

RationalPoint rational(const GridPoint& p) {
  constexpr int bits = static_cast<int>(Fixed64::fraction_bits);
  return {scaled(p.u.raw(), -bits), scaled(p.v.raw(), -bits)};
}

Rational rational(float x) { return exact(x); }
Rational rational(double x) { return exact(x); }

double nearest(const Rational& q) {
  // The quotient of the integers would overflow a double for long fractions; the leading bits are enough to
  // round.
  const bool negative = q.numerator() < 0;
  Integer n = abs(q.numerator());
  if (n == 0) return 0;
  const Integer& d = q.denominator();
  const int shift = 64 - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
  const Integer top = shift >= 0 ? Integer(n << shift) : n, bottom = shift >= 0 ? d : Integer(d << -shift);
  Integer quotient = top / bottom;
  if (quotient * bottom != top) quotient |= 1;  // sticky
  // 64 or 65 bits with the last one sticky: round to 53, or fewer for a subnormal result, by hand, half to
  // even.
  const int top_bit = static_cast<int>(msb(quotient)), exponent = top_bit - shift;
  const int precision = exponent >= -1022 ? 53 : 53 - (-1022 - exponent);
  if (precision < 0) return negative ? -0.0 : 0.0;
  const unsigned extra = static_cast<unsigned>(top_bit + 1 - precision);
  const Integer half = Integer(1) << (extra - 1), rest = quotient & ((Integer(1) << extra) - 1);
  quotient >>= extra;
  if (rest > half || (rest == half && (quotient & 1) != 0)) ++quotient;
  const double size =
      std::ldexp(static_cast<double>(static_cast<std::uint64_t>(quotient)), static_cast<int>(extra) - shift);
  return negative ? -size : size;
}

Kind kind_of(const RationalPoint& p, Level n) {
  const Integer N(side(n));
  const int lines = is_whole(p.u * N) + is_whole(p.v * N) + is_whole((p.u + p.v) * N);
  return lines == 0 ? Kind::interior : lines == 1 ? Kind::edge : Kind::vertex;
}

std::string case_text(const RationalPoint& p, Level n) {
  constexpr char letters[] = {'v', 'e', 'i'};
  return fmt::format("{}:u={},v={}", letters[static_cast<std::size_t>(kind_of(p, n))], fraction_text(p.u),
                     fraction_text(p.v));
}

std::string hex_text(const RationalPoint& p) {
  const double u = nearest(p.u), v = nearest(p.v);
  if (exact(u) != p.u || exact(v) != p.v) return {};
  return fmt::format("({:a},{:a})", u, v);
}

Simplicity simplicity(const RationalPoint& p) {
  const Integer u = p.u.denominator(), v = p.v.denominator(), common = u > v ? u : v;
  const auto order = [](const Rational& q) {
    // Within one denominator the numerators decide; as doubles they keep their order.
    return static_cast<std::uint64_t>(std::ldexp(nearest(q), 62));
  };
  return {static_cast<std::uint64_t>(msb(common)), order(p.v), order(p.u)};
}

RationalPoint parse_point(const std::string& text) {
  const Groups parts = groups_of(text, R"((?:[vei]:)?u=([^,]+),v=([^,]+))");
  if (!parts)
    throw BadCase(fmt::format(
        "'{}' is not a point: write u=3/8,v=1/4 (a kind letter v:, e: or i: may stand before)", text));
  const RationalPoint p{parse_coordinate((*parts)[1]), parse_coordinate((*parts)[2])};
  // Rounding both coordinates, to binary16 at the coarsest, carries a pair that far beyond the hypotenuse.
  const Rational zero(Integer(0)), most = Rational(Integer(1)) + scaled(1, -11);
  if (p.u < zero || p.v < zero || p.u + p.v > most)
    throw BadCase(fmt::format("'{}' lies outside the triangle: u, v >= 0 and u+v <= 1", text));
  return p;
}

}  // namespace mmverify::proofs::points
