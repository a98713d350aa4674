#include "bench/papers/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/papers/drawings.hpp"
#include "bench/papers/rays.hpp"
#include "bench/papers/square_pictures.hpp"
#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/size_panels.hpp"
#include "display/render/tracer.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/attribute/picture.hpp"
#include "scene/picture/opacity_picture.hpp"

namespace mmverify::bench::papers {
namespace {

using Pictures = std::vector<Drawn>;

constexpr std::uint32_t longest = 300;  ///< pixels of a tile

render::Picture plain(scene::RgbPicture picture) {
  return {picture.width, picture.height, std::move(picture.rgb)};
}

/// The maps of the first material with any, at the levels, one beside the other.
render::Picture maps_by_level(Measured& m, std::size_t at, const std::vector<unsigned>& levels,
                              bool two_state) {
  const PlannedScene& of = m.scenes()[at];
  const scene::PlannedPrimitive& first = of.plan.primitives.front();
  const std::size_t material = of.scene.primitives[first.primitive].material.value();
  std::vector<render::Picture> maps;
  std::vector<std::string> titles;
  for (const unsigned level : levels) {
    std::vector<unsigned> of_triangles(of.plan.triangles.size(), 0);
    for (std::size_t k = 0; k < of_triangles.size(); ++k)
      if (of.plan.triangles[k].surface == first.surface) of_triangles[k] = level;
    scene::BakeOptions options = m.options();
    options.two_state = two_state;
    const scene::Baked baked = scene::bake(of.scene, of.plan, of_triangles, options);
    maps.push_back(plain(scene::material_picture(of.scene, of.plan, baked, material, longest).value()));
    titles.push_back(fmt::format("level {}", level));
  }
  return render::side_by_side(maps, titles, 0);
}

/// Figure 9: heat maps of the bits that are read, at two levels with a scale each.
render::Picture bits_by_level(Measured& m, std::size_t at, unsigned level) {
  const PlannedScene& of = m.scenes()[at];
  const PixelNumbers bits = bits_read(m, of, of.plan.primitives.front().surface, level);
  const std::uint32_t times = std::max(1u, 512 / std::max(bits.width, bits.height));
  return render::side_by_side({enlarged(coloured(bits, bits.most()), times)},
                              {fmt::format("level {}: {:.0f} bits in the mean", level, bits.mean())},
                              bits.most(), "bits of the tree read or more");
}

Pictures atlases(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  Pictures all;
  for (std::uint32_t surface = 0; surface < of.plan.surfaces.size(); ++surface) {
    m.stop();
    const PixelNumbers over = triangles_over(of, surface);
    const std::uint32_t times = std::max(1u, 512 / std::max(over.width, over.height)),
                        most = std::max(2u, over.most());
    const std::string name = of.scene.images[of.plan.surfaces[surface].image].name;
    all.push_back(
        {"figure 11", fmt::format("atlas_{}", surface),
         fmt::format(
             "{}: all distinct triangles on it, and how many lie over a texel ({:.2f} in the mean of those "
             "that are covered)",
             name, over.mean()),
         render::side_by_side({edges_on_texture(of, surface, times), enlarged(coloured(over, most), times)},
                              {"edges", "triangles over a texel"}, most, "triangles over a texel or more")});
  }
  return all;
}

Pictures som(Measured& m, std::size_t at) {
  m.begins("pictures of maps");
  Pictures all{{"figure 1", "levels", "Our leaves in 4-state: blue transparent, green opaque, orange unknown",
                maps_by_level(m, at, {1, 2, 3, 4, 5, 6}, false)},
               {"figure 6", "two_states", "Our leaves in 2-state: each level is another picture",
                maps_by_level(m, at, {1, 3, 5, 7, 9}, true)},
               {"figure 12", "segments", "Our leaves, each on two triangles, level 4",
                maps_by_level(m, at, {4}, false)}};
  std::vector<SizesOfLevel> sizes;
  for (unsigned level = 1; level <= 9; ++level)
    if (const auto& one = m.sizes(at, level)) sizes.push_back({level, one->footprint});
  picture::Picture plot{.width = 1000, .height = 900, .rows = {}};
  for (picture::Panel& panel : size_panels(sizes)) plot.rows.push_back({std::move(panel)});
  all.push_back({"figure 5", "sizes", m.scenes()[at].name + ": memory by level", plot});
  for (const unsigned level : {4u, 9u})
    all.push_back({"figure 9", fmt::format("bits_level{}", level),
                   fmt::format("Bits of the 2-state tree that a lookup reads on our leaves, level {}", level),
                   bits_by_level(m, at, level)});
  for (Drawn& atlas : atlases(m, at)) all.push_back(std::move(atlas));
  if (!render::has_embree()) return all;
  for (Drawn& rays : bits_of_rays(m, at)) all.push_back(std::move(rays));
  all.push_back({"figure 6", "two_states_rendered",
                 m.scenes()[at].name +
                     " by 2-state maps of each level, and by a bitmask of 1 bit a texel: each is "
                     "another picture",
                 two_state_pictures(m, at)});
  return all;
}

/// Figure 7: mips of the first image whose colours are drawn.
Pictures mips(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const scene::AttributeScene read = attributes_of(of);
  Pictures all;
  const scene::ColourImage* first = nullptr;
  scene::AttributeOptions options;
  options.threads = m.sources().threads;
  options.stop = [&m] { m.stop(); };
  scene::MipErrors errors(options, [&](const scene::MipPicture& picture) {
    if (first == nullptr) first = &picture.image;
    if (first == &picture.image && picture.mip >= 1 && picture.mip <= 3)
      all.push_back(
          {"figure 7", fmt::format("mip{}", picture.mip),
           fmt::format("Mip {}: the texture's, faces', vertices'; below, FLIP of each", picture.mip),
           plain(side_by_side(picture, longest))});
  });
  options.atlas = [&errors](const scene::AttributeAtlas& atlas) { errors.take(atlas); };
  m.begins(of.name + ", mips");
  measure(read, options);
  return all;
}

Pictures cam(Measured& m, std::size_t at) {
  Pictures all{{"figure 9", "attributes", m.scenes()[at].name + ": memory and FLIP by level",
                scene_attribute_picture(m.attributes(at), "png")}};
  for (Drawn& mip : mips(m, at)) all.push_back(std::move(mip));
  if (!render::has_embree()) return all;
  all.push_back(
      {"figure 6", "max", "Hits that blend by max, colours of faces of level 3", blended_by_max(m, at)});
  for (Drawn& view : views(m, {0, 2, 4, 6})) all.push_back(std::move(view));
  return all;
}

Pictures com(Measured& m, std::size_t at) {
  Pictures all{
      {"figure 2", "mask", "Our leaves with masks of 64 sub-triangles", maps_by_level(m, at, {3}, false)}};
  for (Drawn& one : square_map_pictures(m)) all.push_back(std::move(one));
  if (render::has_embree())
    all.push_back({"figure 1", "heat",
                   m.scenes()[at].name + ": any-hit calls of a pixel's primary and shadow ray",
                   heat_maps(m, at)});
  return all;
}

Pictures khr(Measured& m, std::size_t at) {
  return {{"shape", "shape", "Our leaves at levels 4 and 5", maps_by_level(m, at, {4, 5}, false)}};
}

}  // namespace

std::vector<Drawn> pictures(const Paper& paper, Measured& measured) {
  static const std::map<std::string, Pictures (*)(Measured&, std::size_t)> drawn{
      {"som", som}, {"com", com}, {"cam", cam}, {"khr", khr}};
  const std::vector<std::size_t> scenes = masked(measured);
  const auto of = drawn.find(paper.id);
  return of == drawn.end() || scenes.empty() ? Pictures() : of->second(measured, scenes.front());
}

}  // namespace mmverify::bench::papers
