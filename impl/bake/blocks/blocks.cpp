#include "impl/bake/blocks/blocks.hpp"

#include <stdexcept>
#include <string>

#include "impl/bake/blocks/bc.hpp"
#include "impl/bake/blocks/bc7.hpp"

namespace mmverify::impl::bake {
namespace {

constexpr std::uint32_t most_texels = 16384;

void require(const BlockView& view) {
  if (view.format > BlockFormat::bc7)
    throw std::invalid_argument("blocks are of the formats BC1, BC2, BC3, BC4 or BC7");
  if (view.width < 1 || view.width > most_texels || view.height < 1 || view.height > most_texels)
    throw std::invalid_argument("a texture of blocks has 1 to 16384 texels along each side");
  if (view.bytes == nullptr) throw std::invalid_argument("a texture of blocks has no bytes");
  const std::size_t row = (std::size_t{view.width} + 3) / 4 * block_bytes(view.format);
  if (view.pitch < row)
    throw std::invalid_argument("a row of blocks has " + std::to_string(row) + " bytes, and the pitch is " +
                                std::to_string(view.pitch));
}

/// `scale` times what of_block gives for each texel.
template <class OfBlock>
std::vector<std::uint16_t> alpha_by(const BlockView& view, OfBlock of_block, unsigned scale) {
  std::vector<std::uint16_t> alpha(std::size_t{view.width} * view.height);
  const std::size_t size = block_bytes(view.format), across = (std::size_t{view.width} + 3) / 4;
  blocks::each_texel_of_blocks(
      view.width, view.height,
      [&](std::size_t k) {
        return of_block(std::span(view.bytes + view.pitch * (k / across) + size * (k % across), size));
      },
      [&](std::size_t at, unsigned value) { alpha[at] = static_cast<std::uint16_t>(scale * value); });
  return alpha;
}

}  // namespace

std::vector<std::uint16_t> alpha_of(const BlockView& view) {
  constexpr unsigned of_255 = 257;  // 65535 = 257 * 255
  require(view);
  switch (view.format) {
    case BlockFormat::bc1: return alpha_by(view, blocks::alpha_of_bc1, of_255);
    case BlockFormat::bc2: return alpha_by(view, blocks::alpha_of_bc2, of_255);
    case BlockFormat::bc7: return alpha_by(view, blocks::alpha_of_bc7, of_255);
    default: return alpha_by(view, blocks::alpha_of_bc3, 1);
  }
}

}  // namespace mmverify::impl::bake
