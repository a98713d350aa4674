#include "display/render/scene/views.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "display/render/attribute/shading.hpp"
#include "display/render/scene/texture_looks.hpp"
#include "display/render/vectors.hpp"

namespace mmverify::render {
namespace {

Vector vector_of(const Point& p) { return {p[0], p[1], p[2]}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector plus(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// `a` at length 1, or `other` if `a` has no length.
Vector unit_or(const Vector& a, const Vector& other) { return dot(a, a) > 1e-60 ? unit(a) : other; }

/// A linear map, stored by columns, applied to a direction, and to a normal: cofactors, times the
/// determinant's sign.
Vector applied(const std::array<float, 12>& m, const Vector& a) {
  Vector b{};
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row) b[row] += double{m[3 * column + row]} * a[column];
  return b;
}
Vector normal_applied(const std::array<float, 12>& m, const Vector& a) {
  const auto column = [&m](std::size_t k) { return Vector{m[3 * k], m[3 * k + 1], m[3 * k + 2]}; };
  const Vector x = column(0), y = column(1), z = column(2);
  const double sign = dot(cross(x, y), z) < 0 ? -1 : 1;
  const std::array<Vector, 3> cofactors{cross(y, z), cross(z, x), cross(x, y)};
  Vector b{};
  for (std::size_t k = 0; k < 3; ++k) b = plus(b, sign * a[k], cofactors[k]);
  return b;
}

using Rgb = std::array<float, 3>;

}  // namespace

class Views::Shader {
 public:
  Shader(const scene::Scene& scene, const SceneWorld& world, const scene::AttributeScene& attributes,
         const std::vector<scene::PrimitiveShading>& shading, const Frame& frame, const Camera& camera,
         const ViewOptions& options)
      : world_(world.world),
        frame_(frame),
        camera_(camera),
        options_(options),
        looks_(scene, world, attributes, shading),
        box_(box_of(world_, false)) {
    const std::uint32_t k = options.rays, width = frame.width / k;
    textured_.resize(std::size_t{width} * (frame.height / k));
    for (std::uint32_t at = 0; at < frame.pixels.size(); ++at) {
      const Met& met = frame.pixels[at].primary;
      if (!met.hit()) continue;
      order_.push_back({std::uint64_t{met.geometry} << 32 | met.triangle, at});
      if (looks_.has_texture(met.geometry))
        textured_[at % frame.width / k + std::size_t{width} * (at / frame.width / k)] = 1;
    }
    std::sort(order_.begin(), order_.end());
    for (std::size_t at = 0; at < order_.size(); ++at)
      if (at == 0 || order_[at].first != order_[at - 1].first) {
        groups_.push_back(at);
        triangles_ += looks_.has_texture(static_cast<std::uint32_t>(order_[at].first >> 32));
      }
    groups_.push_back(order_.size());
  }

  Picture picture(ShownFrom from, unsigned level, Detail detail) const {
    std::vector<Rgb> light(frame_.pixels.size());
    for (std::uint32_t at = 0; at < light.size(); ++at)
      if (!frame_.pixels[at].primary.hit()) light[at] = sky(at / frame_.width);
    oneapi::tbb::task_arena arena(options_.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                        : static_cast<int>(options_.threads));
    arena.execute([&] {
      oneapi::tbb::parallel_for(std::size_t{0}, groups_.size() - 1, [&](std::size_t g) {
        if (options_.stop) options_.stop();
        shade(groups_[g], groups_[g + 1], from, level, detail, light);
      });
    });
    return encoded(light);
  }

  DetailLevel level_of(std::uint32_t at, unsigned finest) const {
    const Pixel& pixel = frame_.pixels[at];
    const Geometry& geometry = world_.geometries[pixel.primary.geometry];
    std::array<Point, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = placed(world_.instances[pixel.primary.instance],
                          geometry.positions[geometry.triangles[pixel.primary.triangle][k]]);
    const Point normal = render::unit(
        render::cross(render::minus(corners[1], corners[0]), render::minus(corners[2], corners[0])));
    const Ray ray = ray_of(camera_, at % frame_.width, at / frame_.width, frame_.width, frame_.height);
    const float half = std::sqrt(render::dot(camera_.up, camera_.up));
    const float area =
        cone_area(spread_of_pixel(half, frame_.height), pixel.primary.t, render::dot(normal, ray.direction));
    const auto corner = [&](std::size_t k) {
      return glsl::vec3(corners[k][0], corners[k][1], corners[k][2]);
    };
    return detail_level(finest, area, corner(0), corner(1), corner(2));
  }

  const std::vector<std::uint8_t>& textured() const { return textured_; }
  std::uint64_t triangles() const { return triangles_; }

 private:
  /// The sky of seen(), as linear light.
  Rgb sky(std::uint32_t row) const {
    const double height = 1 - static_cast<double>(row) / frame_.height;
    Rgb rgb{};
    const std::array<double, 3> codes{0.92 - 0.22 * height, 0.94 - 0.12 * height, 0.97};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(srgb_light(codes[c]));
    return rgb;
  }

  void shade(std::size_t first, std::size_t last, ShownFrom from, unsigned level, Detail detail,
             std::vector<Rgb>& light) const {
    const auto geometry = static_cast<std::uint32_t>(order_[first].first >> 32),
               triangle = static_cast<std::uint32_t>(order_[first].first);
    const bool by_cones = detail == Detail::cones && from != ShownFrom::textures;
    const TriangleLooks looks(looks_, geometry, triangle, from, level, by_cones);
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t at = order_[k].second;
      const Pixel& pixel = frame_.pixels[at];
      Look look = by_cones ? looks.at(pixel.at, level_of(at, level)) : looks.at(pixel.at);
      Vector shown = look.colour;
      if (options_.shading != Shading::unlit) shown = lit(pixel, at, look, looks);
      if (options_.shading == Shading::normals)
        for (std::size_t c = 0; c < 3; ++c) shown[c] = srgb_light(0.5 + 0.5 * look.normal[c]);
      const double occlusion = options_.shading == Shading::unlit ? look.occlusion : 1;
      for (std::size_t c = 0; c < 3; ++c) light[at][c] = static_cast<float>(occlusion * shown[c]);
    }
  }

  /// Turns the look's normal into world space, and returns the light that reaches the eye.
  Vector lit(const Pixel& pixel, std::uint32_t at, Look& look, const TriangleLooks& looks) const {
    const Ray ray = ray_of(camera_, at % frame_.width, at / frame_.width, frame_.width, frame_.height);
    const Vector to_eye = unit(plus({}, -1, vector_of(ray.direction)));
    const Vector place = plus(vector_of(ray.from), pixel.primary.t, vector_of(ray.direction));
    const auto& transform = world_.instances[pixel.primary.instance].transform;
    const TriangleLooks::Directions object = looks.directions(pixel.at);
    Vector flat = unit_or(normal_applied(transform, object.flat), to_eye);
    Vector normal = unit_or(normal_applied(transform, object.normal), flat);
    if (dot(flat, to_eye) < 0) {
      flat = plus({}, -1, flat);
      normal = plus({}, -1, normal);
    }
    const Vector along = applied(transform, object.along);
    const Vector tangent = plus(along, -dot(along, normal), normal);
    if (dot(tangent, tangent) > 1e-60) {
      const Vector t = unit(tangent);
      Vector b = cross(normal, t);
      if (dot(b, applied(transform, object.up)) < 0) b = plus({}, -1, b);
      Vector sum{};
      sum = plus(sum, look.normal[0], t);
      sum = plus(sum, look.normal[1], b);
      sum = plus(sum, look.normal[2], normal);
      look.normal = unit_or(sum, normal);
    } else {
      look.normal = normal;
    }
    Vector shown{};
    constexpr double sun = 3.2, lamp = 1.1, everywhere = 0.10;
    if (pixel.lit) shown = plus(shown, sun, reflected(look, to_eye, unit(vector_of(options_.sun))));
    const Vector middle{(double{box_.low[0]} + box_.high[0]) / 2, (double{box_.low[1]} + box_.high[1]) / 2,
                        (double{box_.low[2]} + box_.high[2]) / 2};
    double size = 0;
    for (std::size_t c = 0; c < 3; ++c) size = std::max(size, double{box_.high[c]} - box_.low[c]);
    for (const Vector& direction : {Vector{-0.8, 0.5, 1.2}, Vector{1.0, -0.2, 1.0}}) {
      const Vector to = minus(plus(middle, 1.5 * size, direction), place);
      const double squared = dot(to, to), unit_distance = 2.25 * size * size * dot(direction, direction);
      if (!(squared > 0)) continue;
      shown = plus(shown, lamp * unit_distance / squared, reflected(look, to_eye, unit(to)));
    }
    return plus(shown, everywhere * look.occlusion, look.colour);
  }

  Picture encoded(const std::vector<Rgb>& light) const {
    const std::uint32_t k = options_.rays;
    Picture picture{frame_.width / k, frame_.height / k, {}};
    picture.rgb.reserve(std::size_t{3} * picture.width * picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)
      for (std::uint32_t x = 0; x < picture.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          double sum = 0;
          for (std::uint32_t j = 0; j < k; ++j)
            for (std::uint32_t i = 0; i < k; ++i)
              sum += std::clamp(light[k * x + i + std::size_t{frame_.width} * (k * y + j)][c], 0.0f, 1.0f);
          picture.rgb.push_back(srgb_code(sum / (k * k)));
        }
    return picture;
  }

  const World& world_;
  const Frame& frame_;
  Camera camera_;
  ViewOptions options_;
  TextureLooks looks_;
  Box box_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order_;  ///< hits by triangle: the triangle, the pixel
  std::vector<std::size_t> groups_;  ///< the first hit of each triangle in order_, and the end
  std::vector<std::uint8_t> textured_;
  std::uint64_t triangles_ = 0;
};

Views::Views(const scene::Scene& scene, const SceneWorld& world, const scene::AttributeScene& attributes,
             const std::vector<scene::PrimitiveShading>& shading, const Frame& frame, const Camera& camera,
             const ViewOptions& options)
    : shader_(std::make_unique<Shader>(scene, world, attributes, shading, frame, camera, options)) {}
Views::~Views() = default;

Picture Views::picture(ShownFrom from, unsigned level, Detail detail) const {
  return shader_->picture(from, level, detail);
}
DetailLevel Views::detail(std::uint32_t pixel, unsigned finest) const {
  return shader_->level_of(pixel, finest);
}
const std::vector<std::uint8_t>& Views::textured() const { return shader_->textured(); }
std::uint64_t Views::triangles() const { return shader_->triangles(); }

}  // namespace mmverify::render
