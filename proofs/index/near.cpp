#include "proofs/index/near.hpp"

#include <algorithm>
#include <cmath>

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
  const Corners c = spec::index::corners(index, n);
  const std::uint32_t i = std::min({c[0].i, c[1].i, c[2].i}), j = std::min({c[0].j, c[1].j, c[2].j});
  const Rational left = number(i), right = number(std::uint64_t{i} + 1), low = number(j),
                 high = number(std::uint64_t{j} + 1), diagonal = number(std::uint64_t{i} + j + 1);
  // The box of all points in reach against the unit square, and its corner next to the diagonal against that.
  if (u + du < left || u - du > right || v + dv < low || v - dv > high) return false;
  std::uint64_t sum = 0;
  for (const auto& corner : c) sum += (corner.i - i) + (corner.j - j);
  const bool upright = sum == 2;
  return upright ? std::max(left, u - du) + std::max(low, v - dv) <= diagonal
                 : std::min(right, u + du) + std::min(high, v + dv) >= diagonal;
}

}  // namespace mmverify::proofs::index
