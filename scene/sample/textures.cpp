#include "scene/sample/textures.hpp"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace mmverify::scene {
namespace {

using Colour = std::array<double, 3>;

/// A point of a shape: whether it is inside, in [0, 1], and the colour there.
struct Dot {
  double inside;
  Colour colour;
};

double fraction(double x) { return x - std::floor(x); }

/// 1 in the middle of each of `count` teeth a unit, 0 between them.
double tooth(double x, double count) { return 1 - std::abs(2 * fraction(x * count) - 1); }

Colour mixed(const Colour& a, const Colour& b, double share) {
  Colour colour;
  for (std::size_t k = 0; k < 3; ++k) colour[k] = a[k] + (b[k] - a[k]) * share;
  return colour;
}

std::uint8_t as_byte(double x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0, 1.0) * 255 + 0.5); }

/// A picture of `shape` over the unit square, v down.
template <class Shape>
Picture drawn(const char* name, std::uint32_t width, std::uint32_t height, const Shape& shape) {
  Picture picture{name, width, height, {}};
  picture.rgba.reserve(std::size_t{4} * width * height);
  constexpr int samples = 4;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      double inside = 0;
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
          inside += shape((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height).inside;
      const Dot middle = shape((x + 0.5) / width, (y + 0.5) / height);
      for (const double c : middle.colour) picture.rgba.push_back(as_byte(c));
      picture.rgba.push_back(as_byte(inside / (samples * samples)));
    }
  return picture;
}

constexpr Colour green{0.20, 0.42, 0.12}, light_green{0.45, 0.62, 0.25}, yellow{0.93, 0.75, 0.20};

/// A toothed leaf, its tip at the top of the unit square, its stalk at the bottom.
Dot toothed_leaf(double x, double y) {
  const double across = std::abs(x - 0.5), along = (y - 0.04) / 0.80;
  bool inside = along > 0.8 && y < 0.97 && across < 0.015;  // the stalk
  if (along >= 0 && along <= 1) {
    const double outline = 1.1 * along * std::sqrt(1 - along);
    inside |= across < outline * (0.88 + 0.12 * tooth(along + across, 14));
  }
  const double vein = std::max(across < 0.012 ? 1.0 : 0.0, tooth(along - 0.7 * across, 7) > 0.88 ? 0.6 : 0.0);
  return {inside ? 1.0 : 0.0, mixed(green, light_green, vein)};
}

bool in_ellipse(double x, double y, double half_width, double half_height) {
  x /= half_width;
  y /= half_height;
  return x * x + y * y < 1;
}

/// Pairs of leaflets along a stalk, smaller towards the tip, and one leaflet at its end.
Dot compound_leaf(double x, double y) {
  const double across = std::abs(x - 0.5);
  bool inside = across < 0.012 && y > 0.1 && y < 0.97;
  inside |= in_ellipse(across, y - 0.11, 0.05, 0.08);
  for (int pair = 0; pair < 6; ++pair) {
    const double size = 0.55 + 0.07 * pair, root = 0.27 + 0.115 * pair;
    // The leaflet goes up along (4/5, -3/5).
    const double out = across - 0.19 * size, down = y - (root - 0.13 * size);
    const double along = 0.8 * out - 0.6 * down, aside = 0.6 * out + 0.8 * down;
    inside |= in_ellipse(along, aside, 0.2 * size, 0.055 * size);
  }
  return {inside ? 1.0 : 0.0, mixed(light_green, green, across)};
}

/// A square picture, alpha 255, of the colour at each texel's centre.
template <class ColourAt>
Picture painted(const char* name, const ColourAt& colour_at) {
  constexpr std::uint32_t side = 1024;
  Picture picture{name, side, side, {}};
  picture.rgba.reserve(std::size_t{4} * side * side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      for (const double c : colour_at((x + 0.5) / side, (y + 0.5) / side)) picture.rgba.push_back(as_byte(c));
      picture.rgba.push_back(255);
    }
  return picture;
}

}  // namespace

Picture rings() {
  return painted("rings", [](double x, double y) {
    const double squared = (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5);
    return mixed(mixed(green, light_green, y), yellow, tooth(squared, 60));
  });
}

Picture waves() {
  return painted("waves", [](double x, double y) {
    // Slopes of at most 1/2 along each axis leave a third component.
    const double a = tooth(x, 16) - 0.5, b = tooth(y, 16) - 0.5;
    return Colour{0.5 + 0.5 * a, 0.5 + 0.5 * b, 0.5 + 0.5 * std::sqrt(1 - a * a - b * b)};
  });
}

Picture leaves() {
  return drawn("leaves", 256, 128, [](double x, double y) {
    return x < 0.5 ? toothed_leaf(2 * x, y) : compound_leaf(2 * x - 1, y);
  });
}

Picture wire() {
  return drawn("wire", 64, 64, [](double x, double y) {
    const double falling = tooth(x - y, 1), rising = tooth(x + y, 1);
    const double nearest = std::min(falling, rising);
    return Dot{nearest < 0.16 ? 1.0 : 0.0, mixed({0.75, 0.77, 0.78}, {0.35, 0.36, 0.38}, nearest / 0.16)};
  });
}

Picture flower() {
  return drawn("flower", 96, 96, [](double x, double y) {
    // The corners of a regular pentagon.
    constexpr double corners[5][2] = {{0, -1},
                                      {0.95105651629515357, -0.30901699437494742},
                                      {0.58778525229247313, 0.80901699437494742},
                                      {-0.58778525229247313, 0.80901699437494742},
                                      {-0.95105651629515357, -0.30901699437494742}};
    const double u = 2 * x - 1, v = 2 * y - 1;
    const bool eye = in_ellipse(u, v, 0.22, 0.22);
    bool inside = eye;
    for (const auto& [a, b] : corners) {
      const double out = u * a + v * b, aside = u * b - v * a;
      inside |= in_ellipse(out - 0.52, aside, 0.42, 0.27);
    }
    const double rim = std::min(1.0, u * u + v * v);
    return Dot{inside ? 1.0 : 0.0, eye ? yellow : mixed({0.95, 0.90, 0.95}, {0.75, 0.25, 0.55}, rim)};
  });
}

Picture blades() {
  return drawn("blades", 128, 64, [](double x, double y) {
    const double height = 1 - y;
    bool inside = false;
    for (int blade = 0; blade < 9; ++blade) {
      const double side = blade % 2 == 0 ? 1 : -1, tall = 0.46 + 0.04 * ((blade * 5) % 9);
      const double up = height / tall;
      if (up > 1) continue;
      const double bend = 0.14 * side * up * up;
      const double middle = 0.09 + 0.1 * blade + bend;
      inside |= std::abs(x - middle) < 0.03 * (1 - up);
    }
    return Dot{inside ? 1.0 : 0.0, mixed(green, {0.62, 0.66, 0.28}, height)};
  });
}

Picture pond() {
  return drawn("pond", 64, 64, [](double x, double y) {
    const double u = 2 * x - 1, v = 2 * y - 1;
    const double ripple = 0.04 * tooth(u + 0.5 * v, 2);
    const double alpha = (0.92 + ripple - std::sqrt(u * u + v * v)) / 0.35;
    return Dot{std::clamp(alpha, 0.0, 1.0), {0.16, 0.33, 0.42}};
  });
}

Bytes png(const Picture& picture) {
  Bytes bytes;
  const auto append = [](void* to, void* data, int size) {
    const auto* const first = static_cast<const unsigned char*>(data);
    static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), first, first + size);
  };
  const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  if (stbi_write_png_to_func(append, &bytes, width, height, 4, picture.rgba.data(), 4 * width) == 0)
    throw std::runtime_error("png: no memory for " + picture.name);
  return bytes;
}

}  // namespace mmverify::scene
