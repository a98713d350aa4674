#include "display/render/picture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>

namespace mmverify::render {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Picture blank(std::uint32_t width, std::uint32_t height, std::uint8_t grey) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, grey)};
}

void put(Picture& picture, std::uint32_t x, std::uint32_t y, const Rgb& colour) {
  if (x >= picture.width || y >= picture.height) return;
  std::copy(colour.begin(), colour.end(),
            picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (std::size_t{y} * picture.width + x)));
}

/// A muted colour of a number.  Steps of the golden section around the circle of hues keep near numbers
/// apart.
std::array<float, 3> colour_of(std::uint32_t number) {
  const float hue = 0.28f + 0.61803399f * static_cast<float>(number % 1024);
  std::array<float, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] = 0.62f + 0.28f * std::cos(6.2831853f * (hue + static_cast<float>(k) / 3));
  return rgb;
}

/// The dots of a letter, five rows of three bits from the top; blank if the letter has no dots.
std::array<std::uint8_t, 5> dots_of(char letter) {
  constexpr std::string_view letters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-.,:/%";
  constexpr std::array<std::array<std::uint8_t, 5>, letters.size()> dots{{
      {7, 5, 5, 5, 7}, {2, 6, 2, 2, 7}, {7, 1, 7, 4, 7}, {7, 1, 3, 1, 7}, {5, 5, 7, 1, 1}, {7, 4, 7, 1, 7},
      {7, 4, 7, 5, 7}, {7, 1, 1, 2, 2}, {7, 5, 7, 5, 7}, {7, 5, 7, 1, 7}, {2, 5, 7, 5, 5}, {6, 5, 6, 5, 6},
      {3, 4, 4, 4, 3}, {6, 5, 5, 5, 6}, {7, 4, 6, 4, 7}, {7, 4, 6, 4, 4}, {3, 4, 5, 5, 3}, {5, 5, 7, 5, 5},
      {7, 2, 2, 2, 7}, {1, 1, 1, 5, 2}, {5, 5, 6, 5, 5}, {4, 4, 4, 4, 7}, {5, 7, 7, 5, 5}, {6, 5, 5, 5, 5},
      {2, 5, 5, 5, 2}, {6, 5, 6, 4, 4}, {2, 5, 5, 6, 3}, {6, 5, 6, 5, 5}, {3, 4, 2, 1, 6}, {7, 2, 2, 2, 2},
      {5, 5, 5, 5, 7}, {5, 5, 5, 5, 2}, {5, 5, 7, 7, 5}, {5, 5, 2, 5, 5}, {5, 5, 2, 2, 2}, {7, 1, 2, 4, 7},
      {0, 0, 7, 0, 0}, {0, 0, 0, 0, 2}, {0, 0, 0, 2, 4}, {0, 2, 0, 2, 0}, {1, 1, 2, 4, 4}, {5, 1, 2, 4, 5},
  }};
  if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  const std::size_t at = letters.find(letter);
  return at == std::string_view::npos ? std::array<std::uint8_t, 5>{} : dots[at];
}

constexpr std::uint32_t dot_side = 2, letter_width = 4 * dot_side, text_height = 5 * dot_side, gap = 8,
                        most_columns = 4;

void write(Picture& picture, std::uint32_t x, std::uint32_t y, const std::string& text) {
  for (const char letter : text) {
    const auto rows = dots_of(letter);
    for (std::uint32_t row = 0; row < 5 * dot_side; ++row)
      for (std::uint32_t column = 0; column < 3 * dot_side; ++column)
        if ((rows[row / dot_side] >> (2 - column / dot_side) & 1) != 0)
          put(picture, x + column, y + row, {32, 32, 32});
    x += letter_width;
  }
}

std::uint32_t text_width(const std::string& text) {
  return static_cast<std::uint32_t>(text.size()) * letter_width;
}

}  // namespace

namespace {

/// The colour of the hit at which a ray ended, from dark (light 0) to full (light 1).
std::array<float, 3> shaded(const World& world, const ColourMaps* colours, const Met& met,
                            const Barycentrics& at, float light) {
  std::array<float, 3> rgb = colour_of(world.geometries[met.geometry].colour);
  if (colours != nullptr && colours->has(met.geometry)) {
    const std::uint32_t word = colours->at(met.geometry, met.triangle, at);
    for (unsigned c = 0; c < 3; ++c) rgb[c] = static_cast<float>(word >> 8 * c & 255) / 255;
  }
  for (float& c : rgb) c *= 0.35f + 0.65f * std::max(0.0f, light);
  return rgb;
}

Rgb bytes_of(const std::array<float, 3>& rgb) {
  Rgb bytes{};
  for (std::size_t k = 0; k < 3; ++k)
    bytes[k] = static_cast<std::uint8_t>(255 * std::clamp(rgb[k], 0.0f, 1.0f));
  return bytes;
}

}  // namespace

Picture seen(const World& world, const Frame& frame, const ColourMaps* colours) {
  Picture picture = blank(frame.width, frame.height, 0);
  for (std::uint32_t y = 0; y < frame.height; ++y)
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const Pixel& pixel = frame.pixels[std::size_t{y} * frame.width + x];
      const float height = 1 - static_cast<float>(y) / static_cast<float>(frame.height);
      std::array<float, 3> rgb{0.92f - 0.22f * height, 0.94f - 0.12f * height, 0.97f};
      if (pixel.primary.hit()) {
        rgb = shaded(world, colours, pixel.primary, pixel.at, pixel.lit ? pixel.shade : 0);
        if (frame.ambient != 0)
          for (float& c : rgb)
            c *= static_cast<float>(std::popcount(pixel.open)) / static_cast<float>(frame.ambient);
      }
      put(picture, x, y, bytes_of(rgb));
    }
  return picture;
}

Picture blended(const World& world, const BlendFrame& frame, const Blending& blending) {
  Picture picture = blank(frame.width, frame.height, 0);
  for (std::uint32_t y = 0; y < frame.height; ++y)
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const BlendPixel& pixel = frame.pixels[std::size_t{y} * frame.width + x];
      Rgb rgb = pixel.accepted.hit()
                    ? bytes_of(shaded(world, blending.colours, pixel.accepted, pixel.at, pixel.shade))
                    : Rgb{0, 0, 0};
      for (unsigned c = 0; c < 3; ++c)
        rgb[c] = static_cast<std::uint8_t>(impl::traverse::blend(
            blending.operation, rgb[c], pixel.payload >> 8 * c & 255, pixel.payload >> 24));
      put(picture, x, y, rgb);
    }
  return picture;
}

Rgb heat_colour(std::uint32_t calls, std::uint32_t most) {
  constexpr std::array<std::array<float, 3>, 5> stops{
      {{24, 24, 72}, {24, 112, 160}, {64, 168, 80}, {240, 208, 48}, {208, 32, 32}}};
  const float at = 4 * static_cast<float>(std::min(calls, most)) / static_cast<float>(std::max(most, 1u));
  const auto k = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  const float f = at - static_cast<float>(k);
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<std::uint8_t>(std::lround(stops[k][c] + f * (stops[k + 1][c] - stops[k][c])));
  return rgb;
}

Picture heat(const Frame& frame, std::uint32_t most) {
  Picture picture = blank(frame.width, frame.height, 0);
  for (std::uint32_t y = 0; y < frame.height; ++y)
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const Pixel& pixel = frame.pixels[std::size_t{y} * frame.width + x];
      put(picture, x, y, heat_colour(pixel.calls(), most));
    }
  return picture;
}

std::uint32_t scale_of(const Frame& frame) {
  std::vector<std::uint32_t> calls;
  for (const Pixel& pixel : frame.pixels) calls.push_back(pixel.calls());
  if (calls.empty()) return 1;
  const auto at = calls.begin() + static_cast<std::ptrdiff_t>(calls.size() - 1 - calls.size() / 1000);
  std::nth_element(calls.begin(), at, calls.end());
  return std::max(1u, *at);
}

Picture side_by_side(const std::vector<Picture>& pictures, const std::vector<std::string>& titles,
                     std::uint32_t most, const std::string& unit) {
  std::uint32_t cell_width = 0, cell_height = 0;
  for (const Picture& p : pictures) {
    cell_width = std::max(cell_width, p.width + gap);
    cell_height = std::max(cell_height, p.height + text_height + 2 * gap);
  }
  for (const std::string& title : titles) cell_width = std::max(cell_width, text_width(title) + gap);
  const auto count = static_cast<std::uint32_t>(pictures.size());
  const std::uint32_t columns = std::clamp(count, 1u, most_columns), rows = (count + columns - 1) / columns;
  const std::uint32_t below = rows * cell_height + gap;
  const std::string left = "0", right = std::to_string(most) + " " + unit;
  constexpr std::uint32_t bar = 160;
  const std::uint32_t from = gap + text_width(left),
                      legend_width = most == 0 ? 0 : from + bar + gap + text_width(right) + gap;
  Picture all = blank(std::max(gap + columns * cell_width, legend_width),
                      most == 0 ? below : below + text_height + 3 * gap, 255);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Picture& p = pictures[k];
    const std::uint32_t x = gap + k % columns * cell_width, y = k / columns * cell_height;
    if (k < titles.size()) write(all, x, y + gap, titles[k]);
    for (std::uint32_t row = 0; row < p.height; ++row)
      std::copy_n(p.rgb.begin() + static_cast<std::ptrdiff_t>(std::size_t{3} * row * p.width), 3 * p.width,
                  all.rgb.begin() + static_cast<std::ptrdiff_t>(
                                        3 * (std::size_t{y + 2 * gap + text_height + row} * all.width + x)));
  }
  if (most == 0) return all;
  write(all, gap, below + gap / 2, left);
  for (std::uint32_t k = 0; k < bar; ++k)
    for (std::uint32_t row = 0; row < text_height + gap; ++row)
      put(all, from + k, below + row, heat_colour(k * most * 16 / std::max(1u, bar - 1), most * 16));
  write(all, from + bar + gap, below + gap / 2, right);
  return all;
}

}  // namespace mmverify::render
