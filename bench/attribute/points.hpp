// Random points of the triangle for the benches of attributes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace mmverify::bench {

constexpr std::uint32_t highest_map = 12;  ///< above, no map is made
/// The number of points of a pass: too many for a processor to memorise the branches, few enough for its
/// second-level cache.
constexpr std::size_t points_timed = std::size_t{1} << 14;

struct FloatPoints {
  std::vector<float> u, v;
};

/// Evenly spread points, multiples of 2^-24, so that u + v is exact.
inline FloatPoints uniform_points(std::size_t count, std::mt19937_64& random) {
  constexpr std::uint32_t one = 1u << 24;
  const auto number = [](std::uint32_t x) { return static_cast<float>(x) / static_cast<float>(one); };
  FloatPoints points;
  for (std::size_t k = 0; k < count; ++k) {
    auto a = static_cast<std::uint32_t>(random() % one), b = static_cast<std::uint32_t>(random() % one);
    if (a + b > one) {
      a = one - a;
      b = one - b;
    }
    points.u.push_back(number(a));
    points.v.push_back(number(b));
  }
  return points;
}

}  // namespace mmverify::bench
