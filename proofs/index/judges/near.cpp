#include "proofs/index/judges/near.hpp"

#include <algorithm>
#include <cmath>

#include "proofs/index/judges/corner_order.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index {
namespace {

/// The unit in the last place of the arithmetic's numbers at x.
Rational ulp(const Rational& x, Arithmetic arithmetic) {
  struct Format {
    int bits, least_exponent;
  };
  Format format{};
  switch (arithmetic) {
    case Arithmetic::exact:
      return Rational(spec::Integer(0));
    case Arithmetic::binary16:
      format = {11, -24};
      break;
    case Arithmetic::binary32:
      format = {24, -149};
      break;
    case Arithmetic::binary64:
      format = {53, -1074};
      break;
  }
  int exponent = format.least_exponent;
  if (const double value = nearest(x); value != 0) std::frexp(value, &exponent);
  return rational(std::ldexp(1.0, std::max(exponent - format.bits, format.least_exponent)));
}

}  // namespace

bool reaches(const RationalPoint& p, Level n, std::uint32_t index, Arithmetic arithmetic,
             std::uint32_t ulps) {
  if (index >= triangle_count(n)) return false;
  const auto number = [](std::uint64_t x) { return Rational(spec::Integer(x)); };
  const Rational N = number(side(n)), reach = number(ulps);
  const Rational du = reach * ulp(p.u, arithmetic) * N, dv = reach * ulp(p.v, arithmetic) * N, u = p.u * N,
                 v = p.v * N;
  const MicroTriangle m = triangle_of(spec::index::corners(index, n), n).value();
  const Rational left = number(m.i), right = number(std::uint64_t{m.i} + 1), low = number(m.j),
                 high = number(std::uint64_t{m.j} + 1), diagonal = number(std::uint64_t{m.i} + m.j + 1);
  // The box of all points in reach against the unit square, and its corner next to the diagonal against that.
  if (u + du < left || u - du > right || v + dv < low || v - dv > high) return false;
  return m.inverted ? std::min(right, u + du) + std::min(high, v + dv) >= diagonal
                    : std::max(left, u - du) + std::max(low, v - dv) <= diagonal;
}

}  // namespace mmverify::proofs::index
