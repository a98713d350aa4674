#include "bench/vq/maps.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "bench/textures/leaf_texture.hpp"
#include "impl/bake/square/map.hpp"

namespace mmverify::bench {
namespace {

using impl::bake::AlphaView;
using impl::vq::State;

constexpr impl::bake::Cutoff map_cutoff{1, 2};

/// Whether alpha is at least the cutoff, in binary64: beside the cutoff it may round to either side.
bool opaque_at(const AlphaView& part, double u, double v) {
  const auto texel = [&](double x, double y) {
    const auto within = [](double k, std::uint32_t size) {
      return static_cast<std::size_t>(std::clamp(k, 0.0, size - 1.0));
    };
    return static_cast<double>(part.texels[within(x, part.width) + part.pitch * within(y, part.height)]);
  };
  const double x = u * part.width - 0.5, y = (1 - v) * part.height - 0.5, x0 = std::floor(x),
               y0 = std::floor(y);
  const double lower = std::lerp(texel(x0, y0), texel(x0 + 1, y0), x - x0),
               upper = std::lerp(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), x - x0);
  return 2 * std::lerp(lower, upper, y - y0) >= 255;
}

std::vector<SampledHit> hits_of(const AlphaView& part) {
  constexpr std::size_t count = 4096;
  std::mt19937 random(1);
  // The coordinates are below 1, and exact: 24 bits.
  const auto coordinate = [&] { return static_cast<float>(random() >> 8) / 16777216; };
  std::vector<SampledHit> hits(count);
  for (SampledHit& hit : hits) {
    hit.u = coordinate();
    hit.v = coordinate();
    hit.opaque = opaque_at(part, double{hit.u}, double{hit.v});
  }
  return hits;
}

OpacityMaps maps_of(const AlphaView& part, const std::string& name) {
  OpacityMaps maps;
  maps.of = name;
  const impl::bake::Box box = impl::bake::whole(part);
  impl::bake::square_map(part, box, map_cutoff, 8, maps.regions_8);
  impl::bake::square_map(part, box, map_cutoff, 16, maps.regions_16);
  impl::bake::square_map(part, box, map_cutoff, 32, maps.regions_32);
  impl::bake::triangle_map(part, box, map_cutoff, 8, maps.sub_triangles_64x2);
  maps.hits = hits_of(part);
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
