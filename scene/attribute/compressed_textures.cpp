#include "scene/attribute/compressed_textures.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/attribute/reduced_texture.hpp"

namespace mmverify::scene {
namespace {

TexturePixels pixels_of(const RgbTexels& texels, AttributeSet set, Averaging averaging) {
  using impl::attribute::Meaning;
  TexturePixels pixels{texels.width, texels.height, texels.rgb, Meaning::linear};
  if (is_srgb(set)) pixels.meaning = Meaning::srgb;
  if (meaning_of(set, averaging) == Meaning::normal) pixels.meaning = Meaning::normal;
  return pixels;
}

std::uint64_t blocks_shown(const ColourImage& image, BlockSize block,
                           const std::vector<std::uint8_t>& shown) {
  const std::uint64_t across = block.blocks_of(image.width, 1);
  std::vector<bool> seen(block.blocks_of(image.width, image.height));
  for (std::size_t texel = 0; texel < shown.size(); ++texel)
    if (shown[texel] != 0)
      seen[texel % image.width / block.width + texel / image.width / block.height * across] = true;
  return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
}

}  // namespace

void TextureCompression::add(const ColourImage& image, const ComparedImage& compared) {
  const CodeMeaning meaning(set_, averaging_);
  const std::uint8_t channels = channels_of(set_);
  RgbTexels used{image.width, image.height, compared.original};
  for (std::size_t k = 0; k < used.rgb.size(); ++k)
    if ((channels >> k % 3 & 1) == 0) used.rgb[k] = 0;
  std::size_t size = 0;
  for (std::uint32_t factor = 1; factor <= most_reduced; factor *= 2) {
    const std::vector<BlockSize>& blocks = factor == 1 ? coder_.blocks : coder_.reduced_blocks;
    if (blocks.empty()) continue;
    const RgbTexels small = factor == 1 ? used : reduced(used, factor, meaning);
    std::size_t block = 0;
    coder_.compress(pixels_of(small, set_, averaging_), blocks, [&](const DecodedTexture& decoded) {
      if (stop_) stop_();
      if (block == blocks.size() || decoded.block != blocks[block] || decoded.rgb.size() != small.rgb.size())
        throw std::invalid_argument("attributes: a texture coder tells of the block sizes that it was given");
      add_decoded(image, compared, size++, decoded, factor,
                  factor == 1 ? decoded.rgb
                              : enlarged({small.width, small.height, decoded.rgb}, factor, image.width,
                                         image.height, meaning));
      ++block;
    });
    if (block != blocks.size())
      throw std::invalid_argument("attributes: a texture coder tells of all block sizes that it was given");
  }
}

/// Adds a texture at one size; `codes` are the decoded texels at full resolution.
void TextureCompression::add_decoded(const ColourImage& image, const ComparedImage& compared,
                                     std::size_t size, const DecodedTexture& decoded, std::uint32_t factor,
                                     const std::vector<std::uint8_t>& codes) {
  if (size == all_.size()) {
    all_.push_back({decoded.block, factor, 0, 0, {}});
    sums_.emplace_back();
  }
  const std::uint8_t channels = channels_of(set_);
  std::vector<std::uint8_t> rgb = compared.original;
  for (std::size_t k = 0; k < rgb.size(); ++k)
    if ((channels >> k % 3 & 1) != 0) rgb[k] = codes[k];
  make_unit(rgb, set_, averaging_);
  const std::vector<std::uint8_t>& shown = compared.triangles.shown;
  add_errors(sums_[size], image, set_, compared.original, rgb, shown, threads_);
  const BlockSize covers{factor * decoded.block.width, factor * decoded.block.height};
  CompressedTextures& all = all_[size];
  all.bytes += decoded.bytes;
  all.shown_bytes +=
      decoded.bytes / covers.blocks_of(image.width, image.height) * blocks_shown(image, covers, shown);
}

std::vector<CompressedTextures> TextureCompression::all(std::uint64_t shown) const {
  std::vector<CompressedTextures> all = all_;
  for (std::size_t k = 0; k < all.size(); ++k) all[k].error = error_of(sums_[k], set_, shown);
  return all;
}

}  // namespace mmverify::scene
