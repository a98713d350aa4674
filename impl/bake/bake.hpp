// The input of every baker: stored alpha, a cutoff, a rectangle of texels.
//
// Axes are the texture's: x along a row, y down from the first row; texel (x, y) covers [x, x+1) x [y, y+1),
// its centre is at +1/2.  Sampling is bilinear with clamp to edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mmverify::impl::bake {

/// A texture's alpha, not owned: texel (x, y) is texels[x + pitch y].
/// Texel: std::uint8_t, alpha = byte / 255; std::uint16_t, alpha = word / 65535; float, alpha itself.
/// Domain of every bake: width and height in 1..16384; floats are finite.
template <class Texel>
struct TexelView {
  const Texel* texels;
  std::uint32_t width, height;
  std::size_t pitch;
};
using AlphaView = TexelView<std::uint8_t>;

/// Interleaved pixels of 8 bits a channel, not owned: alpha of texel (x, y) is bytes[pitch y + channels x + channel].
/// Domain: 1..16 channels, channel < channels, pitch >= channels width.  RGBA8 has alpha in channel 3, which is linear in
/// sRGB formats, too: their bytes are passed as they are.  Blocks (BC1 to BC7): BlockView, impl/bake/blocks/blocks.hpp.
struct PixelView {
  const std::uint8_t* bytes;
  std::uint32_t width, height;
  std::size_t pitch;  ///< in bytes
  std::uint32_t channels = 4, channel = 3;
};

/// A cutoff: alpha >= numerator / denominator is opaque.  Domain: denominator > 0.  If numerator > denominator, nothing
/// is opaque.
struct Cutoff {
  std::uint32_t numerator = 1, denominator = 2;
};

/// Texels [x, x + width) x [y, y + height); the box's edges are the outer edges of its texels.
struct Box {
  std::uint32_t x, y, width, height;
  constexpr bool operator==(const Box&) const = default;
};

/// The smallest box that contains every texel with alpha >= cutoff; none if there is no such texel.
/// Test: impl_bake_test
std::optional<Box> opaque_box(const AlphaView& texture, Cutoff cutoff);

/// The box cut out, as a texture of its own: beyond its edge its edge texels are sampled, not the texels around it.
/// Domain: the box lies in the texture and is not empty.
/// Test: impl_bake_test
constexpr AlphaView cropped(const AlphaView& texture, const Box& box) {
  return {texture.texels + box.x + box.y * texture.pitch, box.width, box.height, texture.pitch};
}

/// The box of all texels.
constexpr Box whole(const AlphaView& texture) { return {0, 0, texture.width, texture.height}; }

}  // namespace mmverify::impl::bake
