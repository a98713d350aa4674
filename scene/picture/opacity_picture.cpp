#include "scene/picture/opacity_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "impl/bake/texture/wrap.hpp"
#include "impl/index/index.hpp"
#include "scene/bake/wrap.hpp"
#include "scene/picture/alpha_code.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::State;
using Colour = std::array<std::uint8_t, 3>;
using Point = std::array<double, 2>;

/// Okabe and Ito's colours, which readers with any colour vision tell apart.
constexpr Colour transparent{0, 114, 178}, opaque{0, 158, 115}, unknown{230, 159, 0}, wrong{213, 0, 0};
constexpr double tint = 0.55;                      ///< the share of the state's colour in a pixel
constexpr double least_with_borders = 6;           ///< pixels along a micro-triangle's side
constexpr double most_repeats = 2, border = 0.02;  ///< of the texture; share of the box

Colour colour_of(State state) {
  switch (state) {
    case State::T: return transparent;
    case State::O: return opaque;
    case State::UT:
    case State::UO: break;
  }
  return unknown;
}

/// A box in UV.
struct Window {
  Point least, size;
};

/// The triangle moved by whole repeats, so that its centroid lies in the texture; even ones keep a mirrored texture.
std::array<Point, 3> moved(const UvTriangle& uvs, const Sampler& sampler) {
  std::array<Point, 3> all;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Wrap wrap = axis == 0 ? sampler.wrap_u : sampler.wrap_v;
    const double middle = (double{uvs[0][axis]} + uvs[1][axis] + uvs[2][axis]) / 3;
    const double by = wrap == Wrap::repeat            ? std::floor(middle)
                      : wrap == Wrap::mirrored_repeat ? 2 * std::floor(middle / 2)
                                                      : 0;
    for (std::size_t k = 0; k < 3; ++k) all[k][axis] = uvs[k][axis] - by;
  }
  return all;
}

Window window_of(const std::vector<std::array<Point, 3>>& triangles) {
  Window window{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const auto& triangle : triangles)
      for (const Point& p : triangle) {
        least = std::min(least, p[axis]);
        greatest = std::max(greatest, p[axis]);
      }
    const double size = std::clamp((greatest - least) * (1 + 2 * border), 1e-6, most_repeats);
    window.size[axis] = size;
    window.least[axis] = (least + greatest - size) / 2;
  }
  return window;
}

class Canvas {
 public:
  Canvas(const Image& image, const Sampler& sampler, const Window& window, std::uint32_t longest)
      : image_(image), sampler_(sampler), window_(window) {
    // Texels are square, so that the picture has the texture's proportions.
    const double across = window.size[0] * image.width, down = window.size[1] * image.height;
    const double scale = longest / std::max(across, down);
    picture_.width = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(across * scale)));
    picture_.height = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(down * scale)));
    picture_.rgb.resize(std::size_t{3} * picture_.width * picture_.height);
    cell_.assign(std::size_t{picture_.width} * picture_.height, none);
    bordered_.resize(cell_.size());
    for (std::uint32_t y = 0; y < picture_.height; ++y)
      for (std::uint32_t x = 0; x < picture_.width; ++x) {
        const std::uint8_t grey = alpha_at(uv_of(x, y));
        for (std::size_t c = 0; c < 3; ++c) picture_.rgb[3 * pixel(x, y) + c] = grey;
      }
  }

  /// Tints the pixels of a triangle where none was drawn before.
  void draw(const std::array<Point, 3>& corners, const BakedTriangle& map,
            std::optional<std::uint32_t> marked) {
    const auto states = states_of(map);
    const double along = 1.0 / static_cast<double>(std::uint32_t{1} << map.level);
    const bool borders = side_in_pixels(corners) * along >= least_with_borders;
    const double area = cross(corners[0], corners[1], corners[2]);
    if (area == 0) return;
    for_pixels(corners, [&](std::uint32_t x, std::uint32_t y, const Point& uv) {
      const double u = cross(corners[0], uv, corners[2]) / area, v = cross(corners[0], corners[1], uv) / area;
      if (u < 0 || v < 0 || u + v > 1 || cell_[pixel(x, y)] != none) return;
      const std::uint32_t index =
          impl::index::from_barycentrics(static_cast<float>(u), static_cast<float>(v), map.level);
      cell_[pixel(x, y)] = first_ + index;
      bordered_[pixel(x, y)] = borders;
      blend(pixel(x, y), marked == index ? wrong : colour_of(states[index]), tint);
    });
    first_ += states.size();
  }

  RgbPicture finished() {
    for (std::size_t at = 0; at < bordered_.size(); ++at) {
      if (!bordered_[at]) continue;
      const std::size_t x = at % picture_.width, y = at / picture_.width;
      const bool right = x + 1 < picture_.width && cell_[at + 1] != cell_[at];
      const bool below = y + 1 < picture_.height && cell_[at + picture_.width] != cell_[at];
      if (right || below) blend(at, {0, 0, 0}, 0.6);
    }
    return std::move(picture_);
  }

 private:
  static constexpr std::uint64_t none = ~std::uint64_t{0};

  static double cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  static std::vector<State> states_of(const BakedTriangle& map) {
    std::vector<State> states(micromap::micro_triangles(map.level));
    if (map.uniform)
      states.assign(states.size(), *map.uniform);
    else
      micromap::unpack(map.map, map.format, states);
    return states;
  }

  std::size_t pixel(std::uint32_t x, std::uint32_t y) const { return x + std::size_t{picture_.width} * y; }
  Point uv_of(std::uint32_t x, std::uint32_t y) const {
    return {window_.least[0] + window_.size[0] * (x + 0.5) / picture_.width,
            window_.least[1] + window_.size[1] * (y + 0.5) / picture_.height};
  }
  /// The longest side of a triangle.
  double side_in_pixels(const std::array<Point, 3>& corners) const {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = corners[k], &b = corners[(k + 1) % 3];
      longest = std::max(longest, std::hypot((a[0] - b[0]) / window_.size[0] * picture_.width,
                                             (a[1] - b[1]) / window_.size[1] * picture_.height));
    }
    return longest;
  }
  /// The alpha of the texel at a UV, from 0 to 255.
  std::uint8_t alpha_at(const Point& uv) const {
    const auto along = [](double x, std::uint32_t size, Wrap wrap) {
      const auto texel = static_cast<std::int64_t>(std::floor(std::clamp(x, -1e6, 1e6) * size));
      return static_cast<std::size_t>(impl::bake::wrapped(wrap_of(wrap), texel, size));
    };
    const std::size_t at = along(uv[0], image_.width, sampler_.wrap_u) +
                           std::size_t{image_.width} * along(uv[1], image_.height, sampler_.wrap_v);
    return alpha_code(image_, at);
  }
  void blend(std::size_t at, const Colour& colour, double share) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& here = picture_.rgb[3 * at + c];
      here = static_cast<std::uint8_t>(std::lround((1 - share) * here + share * colour[c]));
    }
  }
  /// Calls what(x, y, uv) for each pixel of the box around a triangle.
  template <class What>
  void for_pixels(const std::array<Point, 3>& corners, What what) const {
    const auto range = [&](std::size_t axis, std::uint32_t size) {
      const auto [least, greatest] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      const auto at = [&](double uv) {
        const double x = (uv - window_.least[axis]) / window_.size[axis] * size;
        return static_cast<std::uint32_t>(std::clamp(std::floor(x), 0.0, static_cast<double>(size)));
      };
      return std::pair(at(least), std::min(size, at(greatest) + 1));
    };
    const auto [left, right] = range(0, picture_.width);
    const auto [top, bottom] = range(1, picture_.height);
    for (std::uint32_t y = top; y < bottom; ++y)
      for (std::uint32_t x = left; x < right; ++x) what(x, y, uv_of(x, y));
  }

  const Image& image_;
  const Sampler& sampler_;
  const Window window_;
  RgbPicture picture_;
  std::vector<std::uint64_t> cell_;  ///< by pixel, the number of its micro-triangle among all that are drawn
  std::vector<bool> bordered_;       ///< by pixel
  std::uint64_t first_ = 0;
};

}  // namespace

RgbPicture opacity_picture(const Image& image, const Surface& surface, const std::vector<DrawnMap>& maps,
                           std::uint32_t longest, std::optional<std::uint32_t> marked) {
  std::vector<std::array<Point, 3>> triangles;
  for (const DrawnMap& one : maps) triangles.push_back(moved(one.uvs, surface.sampler));
  Canvas canvas(image, surface.sampler, window_of(triangles), longest);
  for (std::size_t k = 0; k < maps.size(); ++k)
    canvas.draw(triangles[k], maps[k].map, k == 0 ? marked : std::nullopt);
  return canvas.finished();
}

std::optional<RgbPicture> material_picture(const Scene& scene, const Plan& plan, const Baked& baked,
                                           std::size_t material, std::uint32_t longest) {
  std::vector<DrawnMap> maps;
  std::set<std::size_t> met;
  std::optional<std::uint32_t> surface;
  for (const PlannedPrimitive& planned : plan.primitives) {
    if (scene.primitives[planned.primitive].material != material) continue;
    for (const TriangleUse& use : planned.triangles)
      if (met.insert(use.triangle).second)
        maps.push_back({plan.triangles[use.triangle].uvs, baked.triangles[use.triangle]});
    surface = planned.surface;
  }
  if (maps.empty()) return {};
  const Surface& of = plan.surfaces[*surface];
  return opacity_picture(scene.images[of.image], of, maps, longest);
}

}  // namespace mmverify::scene
