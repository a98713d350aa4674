// The textures of a set compressed in blocks, to compare with its maps.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "scene/attribute/image_triangles.hpp"
#include "scene/attribute/texel_errors.hpp"
#include "scene/attribute/texture_coder.hpp"

namespace mmverify::scene {

/// The greatest factor by which textures are reduced before they are compressed.
inline constexpr std::uint32_t most_reduced = 32;

/// All textures of a set, compressed in blocks of one size, without mips.
struct CompressedTextures {
  BlockSize block;
  std::uint32_t reduced = 1;  ///< factor by which the sides are shortened first; then sampled bilinearly
  std::uint64_t bytes = 0;
  std::uint64_t shown_bytes = 0;  ///< of the blocks with a texel that a triangle shows
  MapError error;                 ///< over the same texels as the maps' error
};

/// A set's textures, each compressed at full resolution, 1/2, 1/4 ... down to 1 / most_reduced.
class TextureCompression {
 public:
  /// The coder must outlive the object.  stop: called after each compression; may throw.
  TextureCompression(AttributeSet set, Averaging averaging, const TextureCoder& coder, unsigned threads,
                     const std::function<void()>& stop)
      : set_(set), averaging_(averaging), coder_(coder), threads_(threads), stop_(stop) {}

  /// Compresses a texture.
  /// Errors: std::invalid_argument for a coder that does not answer for the block sizes that it was given.
  void add(const ColourImage& image, const ComparedImage& compared);

  /// Results over all textures, of which the set shows so many texels.
  std::vector<CompressedTextures> all(std::uint64_t shown) const;

 private:
  void add_decoded(const ColourImage& image, const ComparedImage& compared, std::size_t size,
                   const DecodedTexture& decoded, std::uint32_t factor,
                   const std::vector<std::uint8_t>& codes);

  AttributeSet set_;
  Averaging averaging_;
  const TextureCoder& coder_;
  unsigned threads_;
  std::function<void()> stop_;
  std::vector<CompressedTextures> all_;
  std::vector<ErrorSums> sums_;  ///< of all_
};

}  // namespace mmverify::scene
