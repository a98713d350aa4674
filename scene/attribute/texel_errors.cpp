#include "scene/attribute/texel_errors.hpp"

#include <bit>
#include <cmath>

#include "scene/attribute/reduced_texture.hpp"
#include "scene/flip/flip.hpp"

namespace mmverify::scene {

std::vector<std::uint8_t> compared_texels(const ColourImage& image, AttributeSet set, Averaging averaging) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    rgb.insert(rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(k),
               image.rgba.begin() + static_cast<std::ptrdiff_t>(k + 3));
  make_unit(rgb, set, averaging);
  return rgb;
}

void make_unit(std::vector<std::uint8_t>& rgb, AttributeSet set, Averaging averaging) {
  if (!has(set, Attribute::normal)) return;
  const CodeMeaning meaning(set, averaging);
  for (std::size_t texel = 0; texel < rgb.size() / 3; ++texel)
    paint(rgb, texel,
          meaning.code_of(meaning.mean_of({rgb[3 * texel], rgb[3 * texel + 1], rgb[3 * texel + 2], 0})),
          channels_of(set));
}

std::vector<float> add_errors(ErrorSums& sums, const ColourImage& image, AttributeSet set,
                              const std::vector<std::uint8_t>& original, const std::vector<std::uint8_t>& rgb,
                              std::span<const std::uint8_t> shown, unsigned threads) {
  for (std::size_t texel = 0; texel < shown.size(); ++texel)
    for (std::size_t c = 3 * texel; shown[texel] != 0 && c < 3 * texel + 3; ++c) {
      const double difference = rgb[c] - original[c];
      sums.squares += difference * difference;
    }
  if (!is_srgb(set)) return {};
  std::vector<float> errors = flip::error_map({image.width, image.height, original},
                                              {image.width, image.height, rgb}, {.threads = threads});
  for (std::size_t texel = 0; texel < shown.size(); ++texel)
    if (shown[texel] != 0) sums.flip += errors[texel];
  return errors;
}

MapError error_of(const ErrorSums& sums, AttributeSet set, std::uint64_t shown) {
  if (shown == 0) return {};
  const auto texels = static_cast<double>(shown);
  MapError error{std::sqrt(sums.squares / (texels * std::popcount(channels_of(set)))), {}};
  if (is_srgb(set)) error.flip = sums.flip / texels;
  return error;
}

}  // namespace mmverify::scene
