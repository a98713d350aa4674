#include "display/render/camera.hpp"

#include <algorithm>
#include <cmath>

#include "display/render/vectors.hpp"

namespace mmverify::render {
namespace {

/// The length of a box's longest side.
float size_of(const Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

constexpr float full_turn = 6.2831853f;
constexpr float half_angle = 0.35f;  // some 39 degrees from bottom to top

/// The next pseudo-random number in [0,1).
float share(std::uint64_t& state) {
  state = mixed(state);
  return static_cast<float>(state >> 40) * 0x1p-24f;
}

}  // namespace

Ray ray_of(const Camera& camera, std::uint32_t x, std::uint32_t y, std::uint32_t width,
           std::uint32_t height) {
  const float s = (2 * static_cast<float>(x) + 1) / static_cast<float>(width) - 1,
              t = 1 - (2 * static_cast<float>(y) + 1) / static_cast<float>(height);
  Point d = camera.forward;
  for (std::size_t k = 0; k < 3; ++k) d[k] += s * camera.right[k] + t * camera.up[k];
  return {camera.from, unit(d)};
}

Camera looking(const Point& from, const Point& at, float half, float aspect) {
  Camera camera;
  camera.from = from;
  camera.forward = unit(minus(at, from));
  const Point sky = std::fabs(camera.forward[1]) > 0.999f ? Point{0, 0, 1} : Point{0, 1, 0};
  const Point right = unit(cross(camera.forward, sky));
  camera.up = times(cross(right, camera.forward), half);
  camera.right = times(right, half * aspect);
  return camera;
}

Camera overview(const Box& box, float aspect) {
  const Point middle{(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2,
                     (box.low[2] + box.high[2]) / 2};
  const Point towards = unit({0.45f, 0.35f, 1});
  // Far from the origin, a step of length 1 would be rounded to another direction.
  const float most = std::max({std::fabs(middle[0]), std::fabs(middle[1]), std::fabs(middle[2])});
  Camera camera =
      looking(plus(middle, times(towards, most > 0x1p14f ? most : 1.0f)), middle, half_angle, aspect);
  const Point right = unit(camera.right), up = unit(camera.up);
  // The least distance at which the picture has all corners.
  float distance = 1e-3f * size_of(box);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Point p =
        minus({(corner & 1) != 0 ? box.high[0] : box.low[0], (corner & 2) != 0 ? box.high[1] : box.low[1],
               (corner & 4) != 0 ? box.high[2] : box.low[2]},
              middle);
    const float near = dot(p, towards);
    distance = std::max({distance, near + std::fabs(dot(p, right)) / (half_angle * aspect),
                         near + std::fabs(dot(p, up)) / half_angle});
  }
  for (std::size_t k = 0; k < 3; ++k) camera.from[k] = middle[k] + 1.02f * distance * towards[k];
  return camera;
}

Camera on_path(const Box& box, std::uint64_t seed, std::uint64_t number, float aspect) {
  std::uint64_t state = mixed(seed) ^ number * 0x9E3779B97F4A7C15u;
  Point from{}, at{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float size = box.high[k] - box.low[k];
    // A camera views a flat scene from outside its plane: rays within the plane do not meet it.
    const bool flat = size < 1e-3f * size_of(box);
    const float beside = flat ? size_of(box) : size;
    from[k] = box.low[k] - (flat ? beside / 2 : 0) + beside * (1.5f * share(state) - 0.25f);
    at[k] = box.low[k] + size * share(state);
  }
  return looking(from, at, half_angle + 0.4f * share(state), aspect);
}

Point about_normal(const Point& normal, std::uint64_t seed) {
  std::uint64_t state = seed;
  const float squared = share(state), angle = full_turn * share(state), r = std::sqrt(squared);
  const Point across = unit(cross(normal, std::fabs(normal[2]) < 0.7f ? Point{0, 0, 1} : Point{1, 0, 0})),
              other = cross(normal, across);
  return unit(plus(times(normal, std::sqrt(1 - squared)),
                   plus(times(across, r * std::cos(angle)), times(other, r * std::sin(angle)))));
}

Ray line_through_ball(const Point& middle, float radius, std::uint64_t seed) {
  std::uint64_t state = seed;
  // If z is even on the axis, the direction is even on the sphere (Archimedes).
  const float z = 2 * share(state) - 1, around = full_turn * share(state),
              r = std::sqrt(std::max(0.0f, 1 - z * z));
  const Point direction{r * std::cos(around), r * std::sin(around), z};
  const Point across = unit(cross(direction, std::fabs(z) < 0.7f ? Point{0, 0, 1} : Point{1, 0, 0})),
              other = cross(direction, across);
  const float from_middle = radius * std::sqrt(share(state)), at = full_turn * share(state);
  const Point beside =
      plus(times(across, from_middle * std::cos(at)), times(other, from_middle * std::sin(at)));
  return {minus(plus(middle, beside), times(direction, 1.01f * radius)), direction};
}

}  // namespace mmverify::render
