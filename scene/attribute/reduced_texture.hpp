// A texture at a lower resolution, as a sampler shows it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/attribute/code_meaning.hpp"

namespace mmverify::scene {

/// Rows of RGB.
struct RgbTexels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A texel of rows of RGB, in the channels given: bit 0 red, 1 green, 2 blue.
inline void paint(std::vector<std::uint8_t>& rgb, std::size_t texel, const MapValue& value,
                  std::uint8_t channels) {
  for (std::size_t c = 0; c < 3; ++c)
    if ((channels >> c & 1) != 0) rgb[3 * texel + c] = value[c];
}

/// Each texel is the mean of factor x factor texels, of fewer at the right and lower border, as codes of that meaning are
/// averaged.  Channels that are not in use are 0.
/// Domain: factor > 0, rgb.size() = 3 width height > 0.
RgbTexels reduced(const RgbTexels& texels, std::uint32_t factor, const CodeMeaning& meaning);

/// What a bilinear sampler that clamps shows of reduced texels at the centres of the original's:
///   x of the reduced one = (x + 1/2) / factor - 1/2, the like of y
/// Domain: as above; reduced.width = ceil(width / factor), the like of heights.
std::vector<std::uint8_t> enlarged(const RgbTexels& reduced, std::uint32_t factor, std::uint32_t width,
                                   std::uint32_t height, const CodeMeaning& meaning);

}  // namespace mmverify::scene
