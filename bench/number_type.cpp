#include "bench/number_type.hpp"

#include <algorithm>
#include <cmath>

namespace mmverify::bench {

double NumberType::ulp(double x) const {
  const int exponent = x == 0 ? least_exponent : std::max(std::ilogb(x), least_exponent);
  return std::ldexp(1.0, exponent - (precision - 1));
}

double NumberType::rounded(double x) const {
  const double spacing = ulp(x);
  return std::nearbyint(x / spacing) * spacing;
}

double NumberType::neighbour(double x, int steps) const {
  for (; steps > 0; --steps) x += ulp(x);
  // The double just below x knows whether x begins a binade, below which the spacing halves.
  for (; steps < 0 && x > 0; ++steps) x -= ulp(std::nextafter(x, 0.0));
  return x;
}

}  // namespace mmverify::bench
