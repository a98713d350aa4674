#include "display/render/scene/colours_of.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

#include "scene/attribute/atlas.hpp"
#include "scene/attribute/set_triangles.hpp"

namespace mmverify::render {
namespace {

/// The use of the texture of base colours; null if there is none.
const scene::AttributeUse* base_colour_of(const scene::AttributeScene& attributes,
                                          const scene::AttributePrimitive& primitive) {
  for (const scene::AttributeUse& use : primitive.uses)
    if (scene::has(attributes.textures[use.texture].set, scene::Attribute::base_color)) return &use;
  return nullptr;
}

std::vector<scene::MapOfTriangle> triangles_of(const scene::AttributePrimitive& primitive,
                                               const scene::AttributeUse& use) {
  std::vector<scene::MapOfTriangle> all;
  for (const scene::Triangle& t : primitive.triangles)
    all.push_back({use.texture, {use.uvs[t[0]], use.uvs[t[1]], use.uvs[t[2]]}});
  return all;
}

std::uint32_t word_of(const scene::MapValue& value) {
  return value[0] | std::uint32_t{value[1]} << 8 | std::uint32_t{value[2]} << 16 | 0xff000000u;
}

}  // namespace

ColourMaps colours_of(const scene::Scene& scene, const SceneWorld& world,
                      const scene::AttributeScene& attributes, ColoursOf of, unsigned level, unsigned threads,
                      const std::function<void(std::uint64_t)>& done) {
  const auto kind = of == ColoursOf::faces ? scene::MapKind::faces : scene::MapKind::vertices;
  ColourMaps made(of, level, world.world.geometries.size());
  const auto values = static_cast<std::size_t>(scene::values_of_map(kind, level));
  oneapi::tbb::task_arena arena(threads == 0 ? oneapi::tbb::task_arena::automatic
                                             : static_cast<int>(threads));
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const std::uint32_t geometry = world.geometry_of[k];
    if (geometry == SceneWorld::none) continue;
    const auto its =
        std::find_if(attributes.primitives.begin(), attributes.primitives.end(), [&](const auto& p) {
          return p.mesh == scene.primitives[k].mesh && p.number == scene.primitives[k].number;
        });
    if (its == attributes.primitives.end() || its->triangles.size() != scene.primitives[k].triangles.size())
      continue;
    const scene::AttributeUse* const use = base_colour_of(attributes, *its);
    if (use == nullptr) continue;
    const scene::AttributeTexture& texture = attributes.textures[use->texture];
    const scene::ColourImage& image = attributes.images[texture.image];
    const std::vector<scene::MapOfTriangle> triangles = triangles_of(*its, *use);
    if (!std::all_of(triangles.begin(), triangles.end(),
                     [&](const auto& t) { return scene::within_reach(t.uvs, image); }))
      continue;
    // Equal triangles are baked once.
    const std::vector<std::size_t> same = scene::first_of_same_uvs(triangles);
    std::vector<std::size_t> first;
    for (std::size_t t = 0; t < same.size(); ++t)
      if (same[t] == t) first.push_back(t);
    const scene::MapBaker baker(image, texture, scene::Averaging::meaning);
    std::vector<std::vector<std::uint32_t>> maps(first.size());
    arena.execute([&] {
      oneapi::tbb::parallel_for(std::size_t{0}, first.size(), [&](std::size_t m) {
        std::vector<scene::MapValue> map(values);
        baker.bake(triangles[first[m]].uvs, kind, level, map);
        for (const scene::MapValue& value : map) maps[m].push_back(word_of(value));
        if (done) done(1);
      });
    });
    std::vector<std::uint32_t> given(triangles.size());
    for (std::size_t m = 0; m < first.size(); ++m) given[first[m]] = made.add(maps[m]);
    for (std::size_t t = 0; t < same.size(); ++t) given[t] = given[same[t]];
    made.give(geometry, std::move(given));
  }
  return made;
}

}  // namespace mmverify::render
