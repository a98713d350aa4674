// Block-compressed textures as an engine holds them, BC1 to BC4 and BC7, and their alpha.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "impl/bake/bake.hpp"

namespace mmverify::impl::bake {

/// Formats of 4 x 4 blocks, by what holds their alpha.  sRGB formats have the same alpha as the others.
enum class BlockFormat : std::uint8_t {
  bc1,  ///< 8 bytes a block; VK_FORMAT_BC1_RGBA: code 3 of a block with colour 0 <= colour 1 has alpha 0
  bc2,  ///< 16 bytes; 4 bits a texel
  bc3,  ///< 16 bytes; two ends and 3 bits a texel
  bc4,  ///< 8 bytes; the one channel of a mask, UNORM: a BC3 block's alpha without its colours
  bc7,  ///< 16 bytes; modes 0 to 3 have no alpha and are opaque, the reserved mode is transparent
};

/// Blocks, not owned: row by row, the block of texels [4 i, 4 i + 4) x [4 j, 4 j + 4) at bytes + pitch j + size i, for
/// blocks of `size` bytes.  Sides that are no multiples of four round up.
/// Domain: width and height in 1..16384; pitch, in bytes, at least a row of blocks.
struct BlockView {
  BlockFormat format;
  const std::uint8_t* bytes;
  std::uint32_t width, height;
  std::size_t pitch;
};

/// The bytes of a block: 8 or 16.
/// Test: impl_blocks_test
constexpr std::size_t block_bytes(BlockFormat format) {
  return format == BlockFormat::bc1 || format == BlockFormat::bc4 ? 8 : 16;
}

/// The alpha of each texel, of 65535: texel (x, y) at x + width y.  BC1, BC2 and BC7 have multiples of 1/255, so
/// they are exact; sevenths and fifths of BC3 and BC4 are rounded to nearest.
/// Errors: std::invalid_argument outside the view's domain.
/// Source: Khronos Data Format Specification 1.3, 20 to 22.
/// Test: impl_blocks_test
std::vector<std::uint16_t> alpha_of(const BlockView& view);

}  // namespace mmverify::impl::bake
