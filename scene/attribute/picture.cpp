#include "scene/attribute/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/attribute/charts.hpp"

namespace mmverify::scene {
namespace {

/// A picture's pixel: the mean over a square block, of the channel.
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

/// Three columns of two tiles, each an image made smaller.
class Tiles {
 public:
  Tiles(std::uint32_t width, std::uint32_t height, std::uint32_t longest)
      : width_(width),
        height_(height),
        block_((std::max(width, height) + longest - 1) / longest),
        across_((width + block_ - 1) / block_),
        down_((height + block_ - 1) / block_),
        all_{3 * across_ + 2 * gap, 2 * down_ + gap, {}} {
    all_.rgb.assign(std::size_t{3} * all_.width * all_.height, 255);
  }

  /// Fills the tile in this column and row with channel(c, texel).
  template <class Channel>
  void fill(std::uint32_t column, std::uint32_t row, Channel channel) {
    for (std::uint32_t y = 0; y < down_; ++y)
      for (std::uint32_t x = 0; x < across_; ++x) {
        const std::size_t at =
            3 * (column * (across_ + gap) + x + std::size_t{all_.width} * (row * (down_ + gap) + y));
        for (std::size_t c = 0; c < 3; ++c)
          all_.rgb[at + c] = mean_of_block(width_, height_, x, y, block_,
                                           [&](std::size_t texel) -> double { return channel(c, texel); });
      }
  }

  RgbPicture picture() { return std::move(all_); }

 private:
  static constexpr std::uint32_t gap = 4;
  std::uint32_t width_, height_, block_, across_, down_;
  RgbPicture all_;
};

auto codes(const std::vector<std::uint8_t>& rgb) {
  return [&rgb](std::size_t c, std::size_t texel) { return rgb[3 * texel + c]; };
}

auto errors(const std::vector<float>& of) {
  return [&of](std::size_t c, std::size_t texel) { return colour_of_error(of[texel])[c]; };
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
  Tiles tiles(width, height, longest);
  tiles.fill(0, 0, codes(picture.original));
  tiles.fill(1, 0, codes(picture.faces));
  tiles.fill(2, 0, codes(picture.vertices));
  tiles.fill(0, 1, [&](std::size_t c, std::size_t texel) -> std::uint8_t {
    // A strip of an eighth of the tile, at its top.
    if (texel / width >= height / 8) return 255;
    return colour_of_error(static_cast<float>(texel % width) / static_cast<float>(width))[c];
  });
  tiles.fill(1, 1, errors(picture.face_errors));
  tiles.fill(2, 1, errors(picture.vertex_errors));
  return tiles.picture();
}

RgbPicture side_by_side(const MipPicture& picture, std::uint32_t longest) {
  constexpr std::uint8_t grey = 96;
  Tiles tiles(picture.image.width, picture.image.height, longest);
  std::uint32_t column = 0;
  for (const ShownMip* shown : {&picture.texture, &picture.faces, &picture.vertices}) {
    tiles.fill(column, 0, codes(shown->rgb));
    tiles.fill(column++, 1, [&](std::size_t c, std::size_t texel) {
      return picture.bands[texel] == no_band ? grey : colour_of_error(shown->errors[texel])[c];
    });
  }
  return tiles.picture();
}

}  // namespace mmverify::scene
