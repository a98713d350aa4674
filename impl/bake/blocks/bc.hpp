// The alpha of BC1 to BC4's blocks, and pictures of 4 x 4 blocks.  Internal to impl and scene.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::impl::bake::blocks {

/// Blocks of 4 x 4 texels that cover a picture; sides of the picture that are no multiples of four round up.
inline std::size_t count_blocks(std::uint32_t width, std::uint32_t height) {
  return (std::size_t{width} + 3) / 4 * ((std::size_t{height} + 3) / 4);
}

/// Calls put(x + width * y, texel) for each texel of a picture of 4 x 4 blocks: of_block(k) gives the 16 texels of
/// block k, row by row.  Texels outside the picture are dropped.
template <class OfBlock, class Put>
void each_texel_of_blocks(std::uint32_t width, std::uint32_t height, OfBlock of_block, Put put) {
  const std::size_t across = (std::size_t{width} + 3) / 4;
  for (std::size_t k = 0; k < count_blocks(width, height); ++k) {
    const auto texels = of_block(k);
    const std::size_t left = k % across * 4, top = k / across * 4;
    for (std::size_t y = top; y < std::min<std::size_t>(top + 4, height); ++y)
      for (std::size_t x = left; x < std::min<std::size_t>(left + 4, width); ++x)
        put(x + width * y, texels[(y - top) * 4 + x - left]);
  }
}

/// The alpha of a picture whose blocks have `size` bytes each: of_block(bytes) gives the alphas of one block.
template <class OfBlock>
auto alpha_of_blocks(std::uint32_t width, std::uint32_t height, std::span<const unsigned char> data,
                     std::size_t size, OfBlock of_block) {
  std::vector<typename decltype(of_block(data))::value_type> picture(std::size_t{width} * height);
  each_texel_of_blocks(
      width, height, [&](std::size_t k) { return of_block(data.subspan(k * size, size)); },
      [&](std::size_t at, auto alpha) { picture[at] = alpha; });
  return picture;
}

/// The 16 alphas of a BC1 block, of 255: 0 for the code 3 of a block with colour 0 <= colour 1, else 255.
/// Domain: 8 bytes.  Source: Khronos Data Format Specification 1.3, 20 (S3TC).
std::array<std::uint8_t, 16> alpha_of_bc1(std::span<const unsigned char> block);

/// The 16 alphas of a BC2 block, of 255: code / 15.  Domain: 8 bytes or more.  Source: as for BC1.
std::array<std::uint8_t, 16> alpha_of_bc2(std::span<const unsigned char> block);

/// The 16 alphas of a BC3 block, or the 16 numbers of a BC4 block, row by row, of 65535: the rational of the
/// specification, rounded to nearest.
///   a0 > a1: ((7 - i) a0 + i a1) / 7, i in 0..7; else ((5 - i) a0 + i a1) / 5, i in 0..5, then 0 and 1
/// The code k stands for i = 0, 7 (or 5), 1, 2, ...  Domain: 8 bytes.
/// Test: pictures_test compares all endpoints and codes with rationals.
std::array<std::uint16_t, 16> alpha_of_bc3(std::span<const unsigned char> block);

}  // namespace mmverify::impl::bake::blocks
