#include "bench/papers/drawings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "bench/vq/maps.hpp"
#include "impl/index/index.hpp"
#include "scene/picture/alpha_code.hpp"

namespace mmverify::bench::papers {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
using impl::vq::State;
using render::Picture;

/// Okabe and Ito's colours, as in scene/picture/.
constexpr Rgb transparent{0, 114, 178}, opaque{0, 158, 115}, unknown{230, 159, 0}, lost{213, 0, 0},
    white{255, 255, 255};

/// A triangle in texels of its texture, its centroid in the first repeat.
using TexelPoints = std::array<std::array<double, 2>, 3>;
TexelPoints in_texels(const scene::UvTriangle& uvs, const scene::Image& image) {
  TexelPoints points{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double middle = (double{uvs[0][axis]} + uvs[1][axis] + uvs[2][axis]) / 3;
    for (std::size_t k = 0; k < 3; ++k)
      points[k][axis] = (uvs[k][axis] - std::floor(middle)) * (axis == 0 ? image.width : image.height);
  }
  return points;
}

double cross(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Calls what(x, y, u, v) for each texel whose centre lies in the triangle.
void for_texels(const TexelPoints& t,
                const std::function<void(std::int64_t, std::int64_t, double, double)>& what) {
  const double area = cross(t[0], t[1], t[2]);
  if (area == 0) return;
  const auto [left, right] = std::minmax({t[0][0], t[1][0], t[2][0]});
  const auto [top, bottom] = std::minmax({t[0][1], t[1][1], t[2][1]});
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  for (std::int64_t y = whole(top); y <= whole(bottom); ++y)
    for (std::int64_t x = whole(left); x <= whole(right); ++x) {
      const std::array<double, 2> at{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
      const double u = cross(t[0], at, t[2]) / area, v = cross(t[0], t[1], at) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) what(x, y, u, v);
    }
}

const scene::Image& image_of(const PlannedScene& of, std::uint32_t surface) {
  return of.scene.images[of.plan.surfaces[surface].image];
}

PixelNumbers numbers_of(const scene::Image& image) {
  return {image.width, image.height, std::vector<std::uint32_t>(std::size_t{image.width} * image.height, 0)};
}

Picture blank(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, 255)};
}

void put(Picture& picture, std::size_t pixel, const Rgb& colour) {
  std::copy(colour.begin(), colour.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

bool uniform(std::span<const State> map, std::uint32_t side, std::size_t x, std::size_t y) {
  const std::size_t at = (x & ~std::size_t{1}) + side * (y & ~std::size_t{1});
  return map[at] == map[at + 1] && map[at] == map[at + side] && map[at] == map[at + side + 1];
}

}  // namespace

std::uint32_t PixelNumbers::most() const {
  std::vector<std::uint32_t> all;
  std::copy_if(of.begin(), of.end(), std::back_inserter(all), [](std::uint32_t n) { return n != 0; });
  if (all.empty()) return 1;
  const auto at = all.end() - 1 - static_cast<std::ptrdiff_t>(all.size() / 1000);
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

double PixelNumbers::mean() const {
  const auto count = of.size() - static_cast<std::size_t>(std::count(of.begin(), of.end(), 0u));
  return count == 0 ? 0 : std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(count);
}

std::vector<std::uint32_t> bits_read_by_index(unsigned level, const impl::tree::Stream& tree) {
  std::vector<std::uint32_t> bits;
  bits.reserve(impl::micromap::micro_triangles(level));
  std::uint32_t at = 0;
  const auto subtree = [&](const auto& self, unsigned height) -> void {
    const bool internal = (tree.tree[at / 8] >> at % 8 & 1) != 0;
    ++at;
    if (!internal) {
      bits.insert(bits.end(), impl::micromap::micro_triangles(height), at);
      return;
    }
    for (int child = 0; child < 4; ++child) self(self, height - 1);
  };
  subtree(subtree, level);
  return bits;
}

PixelNumbers bits_read(Measured& measured, const PlannedScene& of, std::uint32_t surface, unsigned level) {
  std::vector<unsigned> levels(of.plan.triangles.size(), 0);
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (of.plan.triangles[k].surface == surface) levels[k] = level;
  scene::BakeOptions options = measured.options();
  options.two_state = true;
  const scene::Baked baked = scene::bake(of.scene, of.plan, levels, options);
  const scene::Image& image = image_of(of, surface);
  PixelNumbers numbers = numbers_of(image);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (of.plan.triangles[k].surface != surface) continue;
    measured.stop();
    const scene::BakedTriangle& one = baked.triangles[k];
    std::vector<std::uint32_t> bits;  // empty: a special index, no tree
    if (!one.uniform)
      bits = bits_read_by_index(
          level, impl::tree::encode_stream(level, one.format,
                                           impl::micromap::Bytes(one.map.begin(), one.map.end())));
    for_texels(
        in_texels(of.plan.triangles[k].uvs, image), [&](std::int64_t x, std::int64_t y, double u, double v) {
          if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
          const std::uint32_t index =
              impl::index::from_barycentrics(static_cast<float>(u), static_cast<float>(v), level);
          numbers.of[static_cast<std::size_t>(x) + std::size_t{image.width} * static_cast<std::size_t>(y)] =
              bits.empty() ? 1 : bits[index];
        });
  }
  return numbers;
}

PixelNumbers triangles_over(const PlannedScene& of, std::uint32_t surface) {
  const scene::Image& image = image_of(of, surface);
  PixelNumbers numbers = numbers_of(image);
  const auto wrapped = [](std::int64_t x, std::int64_t size) {
    return static_cast<std::size_t>(((x % size) + size) % size);
  };
  for (const scene::PlannedTriangle& triangle : of.plan.triangles)
    if (triangle.surface == surface)
      for_texels(in_texels(triangle.uvs, image), [&](std::int64_t x, std::int64_t y, double, double) {
        ++numbers.of[wrapped(x, image.width) + std::size_t{image.width} * wrapped(y, image.height)];
      });
  return numbers;
}

Picture coloured(const PixelNumbers& numbers, std::uint32_t most) {
  Picture picture = blank(numbers.width, numbers.height);
  for (std::size_t at = 0; at < numbers.of.size(); ++at)
    if (numbers.of[at] != 0) put(picture, at, render::heat_colour(numbers.of[at], most));
  return picture;
}

Picture edges_on_texture(const PlannedScene& of, std::uint32_t surface, std::uint32_t times) {
  const scene::Image& image = image_of(of, surface);
  Picture small = blank(image.width, image.height);
  for (std::size_t at = 0; at < std::size_t{image.width} * image.height; ++at) {
    const std::uint8_t grey = scene::alpha_code(image, at);
    put(small, at, {grey, grey, grey});
  }
  Picture picture = enlarged(small, times);
  for (const scene::PlannedTriangle& triangle : of.plan.triangles) {
    if (triangle.surface != surface) continue;
    const TexelPoints t = in_texels(triangle.uvs, image);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = t[k], &b = t[(k + 1) % 3];
      const auto steps =
          static_cast<std::uint32_t>(std::min(1e6, 2 * times * std::hypot(a[0] - b[0], a[1] - b[1]))) + 1;
      for (std::uint32_t step = 0; step <= steps; ++step) {
        const double x = std::lerp(a[0], b[0], static_cast<double>(step) / steps) * times,
                     y = std::lerp(a[1], b[1], static_cast<double>(step) / steps) * times;
        // The far edges of the texture are its last pixels.
        if (x < 0 || y < 0 || x > picture.width || y > picture.height) continue;
        put(picture,
            std::min<std::size_t>(picture.width - 1, static_cast<std::size_t>(x)) +
                std::size_t{picture.width} *
                    std::min<std::size_t>(picture.height - 1, static_cast<std::size_t>(y)),
            lost);
      }
    }
  }
  return picture;
}

Picture enlarged(const Picture& picture, std::uint32_t times) {
  Picture large = blank(picture.width * times, picture.height * times);
  for (std::size_t y = 0; y < large.height; ++y)
    for (std::size_t x = 0; x < large.width; ++x) {
      const std::size_t from = 3 * (x / times + picture.width * (y / times));
      put(large, x + large.width * y, {picture.rgb[from], picture.rgb[from + 1], picture.rgb[from + 2]});
    }
  return large;
}

Picture alpha_picture(const AlphaTexture& texture, std::uint32_t side) {
  const auto part = opaque_part(texture);
  Picture picture = blank(side, side);
  for (std::size_t y = 0; part && y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const std::uint8_t grey =
          part->texels[x * part->width / side + part->pitch * (y * part->height / side)];
      put(picture, x + std::size_t{side} * y, {grey, grey, grey});
    }
  return picture;
}

Picture square_picture(std::span<const State> map, std::span<const State> decoded, std::uint32_t side,
                       std::uint32_t cell, bool vectors_alone) {
  constexpr std::array<Rgb, 3> colours{transparent, unknown, opaque};
  Picture small = blank(side, side);
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const std::size_t at = x + side * y;
      const Rgb colour = vectors_alone && uniform(map, side, x, y) ? white
                         : decoded[at] != map[at]                  ? lost
                                                  : colours[static_cast<std::size_t>(map[at])];
      put(small, x + side * (side - 1 - y), colour);
    }
  return enlarged(small, cell);
}

}  // namespace mmverify::bench::papers
