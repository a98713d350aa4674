#include "scene/attribute/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mmverify::scene {
namespace {

/// A picture's pixel as a mean over square blocks.
template <class Channel>
std::uint8_t mean_of_block(std::uint32_t width, std::uint32_t height, std::uint32_t x, std::uint32_t y,
                           std::uint32_t block, Channel channel) {
  double sum = 0, count = 0;
  for (std::uint32_t j = block * y; j < std::min(height, block * (y + 1)); ++j)
    for (std::uint32_t i = block * x; i < std::min(width, block * (x + 1)); ++i) {
      sum += channel(i + std::size_t{j} * width);
      ++count;
    }
  return static_cast<std::uint8_t>(std::floor(sum / count + 0.5));
}

}  // namespace

std::array<std::uint8_t, 3> colour_of_error(float error) {
  constexpr std::array<std::array<double, 3>, 6> steps{
      {{0, 0, 0}, {30, 40, 130}, {150, 30, 120}, {235, 105, 40}, {250, 215, 70}, {255, 255, 255}}};
  const double at = std::clamp(double{error}, 0.0, 1.0) * (steps.size() - 1);
  const auto step = std::min(static_cast<std::size_t>(at), steps.size() - 2);
  std::array<std::uint8_t, 3> colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(std::lround(
        steps[step][c] + (at - static_cast<double>(step)) * (steps[step + 1][c] - steps[step][c])));
  return colour;
}

RgbPicture made_smaller(const ColourImage& image, std::uint32_t longest) {
  const std::uint32_t block = (std::max(image.width, image.height) + longest - 1) / longest;
  RgbPicture small{(image.width + block - 1) / block, (image.height + block - 1) / block, {}};
  for (std::uint32_t y = 0; y < small.height; ++y)
    for (std::uint32_t x = 0; x < small.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        small.rgb.push_back(mean_of_block(image.width, image.height, x, y, block,
                                          [&](std::size_t texel) { return image.rgba[4 * texel + c]; }));
  return small;
}

RgbPicture side_by_side(const AttributePicture& picture, std::uint32_t longest) {
  const std::uint32_t width = picture.image.width, height = picture.image.height;
  const std::uint32_t block = (std::max(width, height) + longest - 1) / longest;
  const std::uint32_t across = (width + block - 1) / block, down = (height + block - 1) / block, gap = 4;
  RgbPicture all{3 * across + 2 * gap, 2 * down + gap, {}};
  all.rgb.assign(std::size_t{3} * all.width * all.height, 255);
  // channel(c, texel) of the tile in column k, row l.
  const auto tile = [&](std::uint32_t k, std::uint32_t l, auto channel) {
    for (std::uint32_t y = 0; y < down; ++y)
      for (std::uint32_t x = 0; x < across; ++x) {
        const std::size_t at = 3 * (k * (across + gap) + x + std::size_t{all.width} * (l * (down + gap) + y));
        for (std::size_t c = 0; c < 3; ++c)
          all.rgb[at + c] = mean_of_block(width, height, x, y, block,
                                          [&](std::size_t texel) -> double { return channel(c, texel); });
      }
  };
  const auto codes = [](const std::vector<std::uint8_t>& rgb) {
    return [&rgb](std::size_t c, std::size_t texel) { return rgb[3 * texel + c]; };
  };
  const auto errors = [](const std::vector<float>& of) {
    return [&of](std::size_t c, std::size_t texel) { return colour_of_error(of[texel])[c]; };
  };
  tile(0, 0, codes(picture.original));
  tile(1, 0, codes(picture.faces));
  tile(2, 0, codes(picture.vertices));
  tile(0, 1, [&](std::size_t c, std::size_t texel) -> std::uint8_t {
    // A strip of an eighth of the tile, at its top.
    if (texel / width >= height / 8) return 255;
    return colour_of_error(static_cast<float>(texel % width) / static_cast<float>(width))[c];
  });
  tile(1, 1, errors(picture.face_errors));
  tile(2, 1, errors(picture.vertex_errors));
  return all;
}

}  // namespace mmverify::scene
