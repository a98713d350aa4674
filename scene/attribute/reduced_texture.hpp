// A texture at a lower resolution, as a sampler shows it.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/attribute/code_meaning.hpp"

namespace mmverify::scene {

/// An image as rows of RGB.
struct RgbTexels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Paints a texel of rows of RGB in the given channels: bit 0 red, 1 green, 2 blue.
inline void paint(std::vector<std::uint8_t>& rgb, std::size_t texel, const MapValue& value,
                  std::uint8_t channels) {
  for (std::size_t c = 0; c < 3; ++c)
    if ((channels >> c & 1) != 0) rgb[3 * texel + c] = value[c];
}

/// The image at 1 / factor of its resolution.  Each texel is the mean of factor x factor texels, fewer at the
/// right and lower border, averaged by their meaning.  Channels that are not in use are 0.
/// Domain: factor > 0, rgb.size() = 3 width height > 0.
RgbTexels reduced(const RgbTexels& texels, std::uint32_t factor, const CodeMeaning& meaning);

/// The reduced texels, sampled bilinearly with clamping at the centres of the original's texels:
///   x of the reduced one = (x + 1/2) / factor - 1/2, and y alike
/// Domain: as above; reduced.width = ceil(width / factor), and heights alike.
std::vector<std::uint8_t> enlarged(const RgbTexels& reduced, std::uint32_t factor, std::uint32_t width,
                                   std::uint32_t height, const CodeMeaning& meaning);

}  // namespace mmverify::scene
