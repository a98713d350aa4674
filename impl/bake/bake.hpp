// What every baker works on: stored alpha, a cutoff, a rectangle of texels.
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
/// Domain of all that is baked from it: width and height in 1..16384; floats are finite.
template <class Texel>
struct TexelView {
  const Texel* texels;
  std::uint32_t width, height;
  std::size_t pitch;
};
using AlphaView = TexelView<std::uint8_t>;

/// alpha >= numerator / denominator is opaque.  Domain: denominator > 0; numerator <= denominator, or nothing
/// is opaque.
struct Cutoff {
  std::uint32_t numerator = 1, denominator = 2;
};

/// Texels [x, x + width) x [y, y + height), with the outer edges of its texels for its own.
struct Box {
  std::uint32_t x, y, width, height;
  constexpr bool operator==(const Box&) const = default;
};

/// The smallest box that holds every texel with alpha >= cutoff; none where there is no such texel.
std::optional<Box> opaque_box(const AlphaView& texture, Cutoff cutoff);

/// The box cut out, as a texture of its own: what is sampled beyond its edge is its edge, not the texels
/// around. Domain: the box lies in the texture and is not empty.
constexpr AlphaView cropped(const AlphaView& texture, const Box& box) {
  return {texture.texels + box.x + box.y * texture.pitch, box.width, box.height, texture.pitch};
}

/// All of it.
constexpr Box whole(const AlphaView& texture) { return {0, 0, texture.width, texture.height}; }

}  // namespace mmverify::impl::bake
