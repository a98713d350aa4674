// Cameras and the rays that leave them.
#pragma once

#include <cstdint>

#include "display/render/world.hpp"

namespace mmverify::render {

/// A pinhole camera.  `right` and `up` span the picture at distance 1: from (-1, 1) at its upper left to (1,
/// -1).
struct Camera {
  Point from{}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
};

struct Ray {
  Point from, direction;
};

/// The ray through the middle of pixel (x, y); x counts from the left, y from the top.
Ray ray_of(const Camera& camera, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height);

/// A camera at `from` that looks at `at`, y up.  The tangent of half the vertical angle is `half`.
Camera looking(const Point& from, const Point& at, float half, float aspect);

/// A camera ahead, right and above that has all of the box in its picture.  Domain: a box that is not empty.
Camera overview(const Box& box, float aspect);

/// Camera `number` of a random path: it stands in the box enlarged by a half, and looks at a point of the
/// box.
Camera on_path(const Box& box, std::uint64_t seed, std::uint64_t number, float aspect);

/// A well mixed number of 64 bits.  Source: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators.
constexpr std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// A random direction on the side of a normal, its density in proportion to the cosine between both: the share of such
/// rays that meet nothing estimates ambient occlusion without weights.
/// Domain: a normal of length 1.  Source: Malley's method: a point even on the disc, lifted to the sphere.
Point about_normal(const Point& normal, std::uint64_t seed);

/// A random line through a ball, even over directions and over the disc that the ball shows to each
/// direction.
Ray line_through_ball(const Point& middle, float radius, std::uint64_t seed);

}  // namespace mmverify::render
