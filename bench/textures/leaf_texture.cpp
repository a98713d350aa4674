#include "bench/textures/leaf_texture.hpp"

#include <algorithm>
#include <cmath>

#include "bench/textures/leaves.hpp"

namespace mmverify::bench {

AlphaTexture leaf_texture(std::uint64_t seed, int size) {
  const Leaves leaves(seed, 4, 99);
  // The texture shows a part of the foliage, with its leaves a little larger, so that vectors of 2x2 regions
  // all O, all T or all C are each about as frequent as in the paper (4: 11 to 29 %).
  const double texel = 0.6 / size, fade = texel * static_cast<double>(1 + seed % 4),
               swell = 0.03 / 7 * static_cast<double>(seed / 4 % 8);
  AlphaTexture texture{"leaves " + std::to_string(seed), size, size, {}};
  texture.alpha.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  // The texture is filled tile by tile: only a few leaves are near one, and most tiles are all leaf or all
  // none.
  constexpr int tile = 16;
  const double radius = tile * 0.7072 * texel;
  const auto byte = [&](const Leaves::Near& near, const LeafPoint& p) {
    const double inside = (swell - leaves(near, p)) / fade + 0.5;
    return static_cast<std::uint8_t>(255 * std::clamp(inside, 0.0, 1.0) + 0.5);
  };
  for (int top = 0; top < size; top += tile)
    for (int left = 0; left < size; left += tile) {
      const LeafPoint centre{(left + tile * 0.5) * texel, (top + tile * 0.5) * texel};
      const Leaves::Near near = leaves.near(leaves.all(), centre, radius);
      const bool plain = std::abs(swell - leaves(near, centre)) > leaves.slope() * radius + fade;
      const std::uint8_t at_centre = byte(near, centre);
      for (int y = top; y < std::min(top + tile, size); ++y)
        for (int x = left; x < std::min(left + tile, size); ++x) {
          const auto at =
              static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * static_cast<std::size_t>(size);
          texture.alpha[at] = plain ? at_centre : byte(near, {(x + 0.5) * texel, (y + 0.5) * texel});
        }
    }
  return texture;
}

}  // namespace mmverify::bench
