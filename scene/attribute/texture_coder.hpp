// Textures compressed in blocks, to compare with maps.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "impl/attribute/bake.hpp"

namespace mmverify::scene {

/// The texels of a block, as the GPU reads it.
struct BlockSize {
  std::uint32_t width = 0, height = 0;
  bool operator==(const BlockSize&) const = default;
  std::string name() const { return std::to_string(width) + "x" + std::to_string(height); }

  /// The number of blocks of an image; those at its right and lower border may reach beyond it.
  std::uint64_t blocks_of(std::uint32_t image_width, std::uint32_t image_height) const {
    const auto along = [](std::uint32_t side, std::uint32_t block) {
      return (std::uint64_t{side} + block - 1) / block;
    };
    return along(image_width, width) * along(image_height, height);
  }
};

/// An image as rows of RGB.  Channels that no attribute reads are 0.
struct TexturePixels {
  std::uint32_t width = 0, height = 0;
  std::span<const std::uint8_t> rgb;
  impl::attribute::Meaning meaning = impl::attribute::Meaning::linear;  ///< normal: each texel one unit long
};

struct DecodedTexture {
  BlockSize block;
  std::uint64_t bytes = 0;        ///< of its blocks, without a file's header
  std::vector<std::uint8_t> rgb;  ///< the decoded texels, as many as were encoded
};

struct TextureCoder {
  std::string name = {};               ///< with its version and settings
  std::vector<BlockSize> blocks = {};  ///< from the smallest on
  std::vector<BlockSize> reduced_blocks =
      {};  ///< for textures at lower resolutions; none: full resolution only
  /// Compresses a texture at each of these block sizes, in this order, and calls made() with each result.
  std::function<void(const TexturePixels&, std::span<const BlockSize>,
                     const std::function<void(const DecodedTexture&)>& made)>
      compress = {};
  std::string key = "astc", format = "ASTC";  ///< the name of its figures, and of its format
};

}  // namespace mmverify::scene
