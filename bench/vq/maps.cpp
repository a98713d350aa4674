#include "bench/vq/maps.hpp"

#include <algorithm>

#include "bench/textures/leaf_texture.hpp"
#include "impl/bake/square/map.hpp"

namespace mmverify::bench {
namespace {

using impl::bake::AlphaView;
using impl::vq::State;

constexpr impl::bake::Cutoff map_cutoff{1, 2};

OpacityMaps maps_of(const AlphaView& part, const std::string& name) {
  OpacityMaps maps;
  maps.of = name;
  const impl::bake::Box box = impl::bake::whole(part);
  impl::bake::square_map(part, box, map_cutoff, 8, maps.regions_8);
  impl::bake::square_map(part, box, map_cutoff, 16, maps.regions_16);
  impl::bake::square_map(part, box, map_cutoff, 32, maps.regions_32);
  impl::bake::triangle_map(part, box, map_cutoff, 8, maps.sub_triangles_64x2);
  return maps;
}

}  // namespace

std::optional<AlphaView> opaque_part(const AlphaTexture& texture) {
  const AlphaView all{texture.alpha.data(), static_cast<std::uint32_t>(texture.width),
                      static_cast<std::uint32_t>(texture.height), static_cast<std::size_t>(texture.width)};
  const auto box = impl::bake::opaque_box(all, map_cutoff);
  if (!box) return std::nullopt;
  return impl::bake::cropped(all, *box);
}

std::vector<OpacityMaps> opacity_maps(const std::vector<AlphaTexture>& textures) {
  std::vector<OpacityMaps> maps;
  for (const AlphaTexture& texture : textures)
    if (const auto part = opaque_part(texture)) maps.push_back(maps_of(*part, texture.file));
  return maps;
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
