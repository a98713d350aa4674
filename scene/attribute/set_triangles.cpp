#include "scene/attribute/set_triangles.hpp"

#include <array>
#include <bit>
#include <set>
#include <utility>

#include "scene/attribute/atlas.hpp"

namespace mmverify::scene {

std::vector<std::size_t> first_of_same_uvs(std::span<const MapOfTriangle> triangles) {
  std::map<std::pair<std::size_t, std::array<std::uint32_t, 6>>, std::size_t> known;
  std::vector<std::size_t> first;
  first.reserve(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    std::array<std::uint32_t, 6> bits;
    for (std::size_t c = 0; c < 6; ++c)
      bits[c] = std::bit_cast<std::uint32_t>(triangles[k].uvs[c / 2][c % 2]);
    first.push_back(known.try_emplace({triangles[k].texture, bits}, k).first->second);
  }
  return first;
}

SetTriangles::SetTriangles(const AttributeScene& scene, AttributeSet set, Averaging averaging,
                           std::function<void()> stop)
    : scene_(scene),
      set_(set),
      channels_(channels_of(set)),
      meaning_(set, averaging),
      stop_(std::move(stop)) {
  for (std::size_t k = 0; k < scene.textures.size(); ++k)
    if (scene.textures[k].set == set)
      bakers_.emplace(k, MapBaker(scene.images[scene.textures[k].image], scene.textures[k], averaging));
  for (const AttributePrimitive& primitive : scene.primitives)
    for (const AttributeUse& use : primitive.uses) {
      if (!bakers_.contains(use.texture)) continue;
      const ColourImage& image = scene.images[scene.textures[use.texture].image];
      primitives_.emplace_back();
      for (const Triangle& t : primitive.triangles) {
        const MapOfTriangle map{use.texture, {use.uvs[t[0]], use.uvs[t[1]], use.uvs[t[2]]}};
        if (!within_reach(map.uvs, image)) {
          ++left_out_;
          continue;
        }
        all_.push_back(map);
        primitives_.back().push_back(t);
      }
    }
  same_ = first_of_same_uvs(all_);
}

std::vector<std::size_t> SetTriangles::images() const {
  std::set<std::size_t> images;
  for (const auto& [number, baker] : bakers_) images.insert(scene_.textures[number].image);
  return {images.begin(), images.end()};
}

void SetTriangles::bake(std::size_t triangle, MapKind kind, unsigned level,
                        std::vector<MapValue>& map) const {
  if (stop_) stop_();
  map.resize(static_cast<std::size_t>(values_of_map(kind, level)));
  bakers_.at(all_[triangle].texture).bake(all_[triangle].uvs, kind, level, map);
}

}  // namespace mmverify::scene
