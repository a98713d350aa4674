#include "bench/vq_maps.hpp"

#include <algorithm>
#include <cmath>

#include "bench/leaves.hpp"
#include "impl/bake_map.hpp"

namespace mmverify::bench {
namespace {

using impl::bake::AlphaView;
using impl::vq::State;

constexpr impl::bake::Cutoff cutoff{1, 2};

OpacityMaps maps_of(const AlphaView& part, const std::string& name) {
  OpacityMaps maps;
  maps.of = name;
  const impl::bake::Box box = impl::bake::whole(part);
  impl::bake::square_map(part, box, cutoff, 8, maps.regions_8);
  impl::bake::square_map(part, box, cutoff, 16, maps.regions_16);
  impl::bake::square_map(part, box, cutoff, 32, maps.regions_32);
  impl::bake::triangle_map(part, box, cutoff, 8, maps.sub_triangles_64x2);
  return maps;
}

}  // namespace

std::optional<AlphaView> opaque_part(const AlphaTexture& texture) {
  const AlphaView all{texture.alpha.data(), static_cast<std::uint32_t>(texture.width),
                      static_cast<std::uint32_t>(texture.height), static_cast<std::size_t>(texture.width)};
  const auto box = impl::bake::opaque_box(all, cutoff);
  if (!box) return std::nullopt;
  return impl::bake::cropped(all, *box);
}

std::vector<OpacityMaps> opacity_maps(const std::vector<AlphaTexture>& textures) {
  std::vector<OpacityMaps> maps;
  for (const AlphaTexture& texture : textures)
    if (const auto part = opaque_part(texture)) maps.push_back(maps_of(*part, texture.file));
  return maps;
}

AlphaTexture leaf_texture(std::uint64_t seed, int size) {
  const Leaves leaves(seed, 4, 99);
  // A part of the foliage, its leaves a little larger: so that vectors of 2x2 regions all O, all T or all C
  // are each about as frequent as the paper found them (4: 11 to 29 %).
  const double texel = 0.6 / size, fade = texel * static_cast<double>(1 + seed % 4),
               swell = 0.03 / 7 * static_cast<double>(seed / 4 % 8);
  AlphaTexture texture{"leaves " + std::to_string(seed), size, size, {}};
  texture.alpha.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  // Tile by tile: only a few leaves are near one, and most are all leaf or all none.
  constexpr int tile = 16;
  const double radius = tile * 0.7072 * texel;
  const auto byte = [&](const Leaves::Near& near, const Place& p) {
    const double inside = (swell - leaves(near, p)) / fade + 0.5;
    return static_cast<std::uint8_t>(255 * std::clamp(inside, 0.0, 1.0) + 0.5);
  };
  for (int top = 0; top < size; top += tile)
    for (int left = 0; left < size; left += tile) {
      const Place centre{(left + tile * 0.5) * texel, (top + tile * 0.5) * texel};
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

std::vector<OpacityMaps> leaf_opacity_maps(std::size_t count, std::uint64_t seed) {
  std::vector<OpacityMaps> maps;
  for (std::size_t k = 0; k < count; ++k)
    if (const AlphaTexture texture = leaf_texture(seed + k); const auto part = opaque_part(texture))
      maps.push_back(maps_of(*part, texture.file));
  return maps;
}

double savings(std::span<const State> states) {
  const auto checked = std::count(states.begin(), states.end(), State::C);
  return 1 - static_cast<double>(checked) / static_cast<double>(states.size());
}

}  // namespace mmverify::bench
