#include "scene/plan/texel_triangle.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace mmverify::scene {
namespace {

using Integer = boost::multiprecision::cpp_int;

// All numbers here are floats, or floats times whole numbers: multiples of the least float.
constexpr int least_exponent = 149;

/// 2^n.  Not a shift: for a constant shift of one, g++ 12 warns in Boost's own loop.
Integer power_of_two(int n) { return boost::multiprecision::pow(Integer(2), static_cast<unsigned>(n)); }

/// x 2^149.
Integer fixed(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  // 53 bits make the mantissa whole; the division drops only zeros.
  const Integer whole(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
  const int shift = exponent - 53 + least_exponent;
  return shift >= 0 ? Integer(whole * power_of_two(shift)) : Integer(whole / power_of_two(-shift));
}

// The relative error of a product of two differences, doubled: three roundings are less than 8 units of 2^-53.
constexpr double slack = 0x1p-49;

}  // namespace

TexelTriangle in_texels(const UvTriangle& uvs, std::uint32_t width, std::uint32_t height) {
  TexelTriangle corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {double{uvs[k][0]} * width, double{uvs[k][1]} * height};
  return corners;
}

UvShape uv_shape(const UvTriangle& uvs) {
  const auto& [a, b, c] = uvs;
  if (a == b && b == c) return UvShape::point;
  const auto difference = [](const Uv& to, const Uv& from, std::size_t k) {
    return double{to[k]} - double{from[k]};
  };
  const double left = difference(b, a, 0) * difference(c, a, 1);
  const double right = difference(c, a, 0) * difference(b, a, 1);
  if (std::abs(left - right) > slack * (std::abs(left) + std::abs(right))) return UvShape::area;
  const auto exact = [](const Uv& to, const Uv& from, std::size_t k) {
    return Integer(fixed(to[k]) - fixed(from[k]));
  };
  return exact(b, a, 0) * exact(c, a, 1) == exact(c, a, 0) * exact(b, a, 1) ? UvShape::line : UvShape::area;
}

}  // namespace mmverify::scene
