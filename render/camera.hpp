// Where rays come from.
#pragma once

#include <cstdint>

#include "render/world.hpp"

namespace mmverify::render {

/// A pinhole.  `right` and `up` span the picture at distance 1: from (-1, 1) at its upper left to (1, -1).
struct Camera {
  Point from{}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
};

struct Ray {
  Point from, direction;
};

/// Through the middle of a pixel, x from the left, y from the top.
Ray ray_of(const Camera& camera, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height);

/// At `from`, looking to `at`, y up; half the vertical angle has the tangent `half`.
Camera looking(const Point& from, const Point& at, float half, float aspect);

/// All of a box in the picture, from ahead, right and above.  Domain: a box that is not empty.
Camera overview(const Box& box, float aspect);

/// Number `number` of a random path: somewhere in the box, enlarged by a half, looking at a point in it.
Camera on_path(const Box& box, std::uint64_t seed, std::uint64_t number, float aspect);

/// A well mixed number of 64 bits.  Source: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators.
constexpr std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// A line through a ball, evenly over directions and over the disc that the ball shows to each.
Ray line_through_ball(const Point& middle, float radius, std::uint64_t seed);

}  // namespace mmverify::render
