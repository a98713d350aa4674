#include "bench/papers/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "bench/papers/drawings.hpp"
#include "bench/papers/rays.hpp"
#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/size_panels.hpp"
#include "bench/vq/tables.hpp"
#include "display/render/tracer.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/attribute/picture.hpp"
#include "scene/picture/opacity_picture.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"

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
  return all;
}

/// The texture whose 32x32 map has most nearly as many O and T as the paper's maple leaf.
std::size_t like_the_maple_leaf(Measured& m) {
  constexpr double known_of_maple = 834.0 / 1024;
  const auto distance = [](const OpacityMaps& maps) {
    return std::abs(savings(maps.regions_32) - known_of_maple);
  };
  const auto& all = m.textures();
  return static_cast<std::size_t>(
      std::min_element(all.begin(), all.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
      all.begin());
}

/// Figures 3, 5, 8 and 9: a texture, its square maps, its blocks, and the regions that they lose in red.
render::Picture blocks_of(Measured& m, std::size_t number) {
  constexpr std::uint32_t side = 256;
  const OpacityMaps& maps = m.textures()[number];
  const auto at_16 = [&](const impl::vq::Map2& decoded, bool vectors) {
    return square_picture(maps.regions_16, decoded, 16, side / 16, vectors);
  };
  const auto at_32 = [&](const impl::vq::Map4& decoded) {
    return square_picture(maps.regions_32, decoded, 32, side / 32);
  };
  const impl::vq::Encoded2 paper_2 = impl::vq::encode_paper(maps.regions_16),
                           best_2 = impl::vq::encode_optimal(maps.regions_16);
  const impl::vq::Encoded4 paper_4 = impl::vq::encode_paper(maps.regions_32),
                           ours_4 = encode(maps.regions_32);
  const auto title = [](const char* codec, std::uint32_t lost) {
    return fmt::format("{}: {} lost", codec, lost);
  };
  return render::side_by_side(
      {alpha_picture(m.alpha().at(maps.of), side), at_16(maps.regions_16, false),
       at_16(impl::vq::decode(paper_2.block), false), at_16(impl::vq::decode(best_2.block), false),
       at_16(maps.regions_16, true), at_32(maps.regions_32), at_32(impl::vq::decode(paper_4.block)),
       at_32(impl::vq::decode(ours_4.block))},
      {"alpha", "source, 16x16", title("VQ2, algorithm 1", paper_2.substitutions),
       title("VQ2, optimal", best_2.substitutions), "vectors that are not uniform", "source, 32x32",
       title("VQ4, algorithm 2", paper_4.substitutions), title("VQ4, default", ours_4.substitutions)},
      0);
}

/// Rows of bench vq with the encoders that are drawn.
std::vector<VqRow> drawn_rows(Measured& m) {
  std::vector<VqRow> rows;
  for (std::size_t k = 0; k < m.textures().size(); ++k) {
    const OpacityMaps& maps = m.textures()[k];
    VqRow& row = rows.emplace_back();
    row.savings_64x2 = savings(maps.sub_triangles_64x2);
    row.savings_8 = savings(maps.regions_8);
    row.savings_16 = savings(maps.regions_16);
    row.savings_32 = savings(maps.regions_32);
    const auto lost = [&](VqEncoder encoder) { return m.loss(encoder).lost[k]; };
    row.vq2[static_cast<std::size_t>(Vq2Encoder::paper)].substitutions = lost(VqEncoder::vq2_paper);
    row.vq2[static_cast<std::size_t>(Vq2Encoder::optimal)].substitutions = lost(VqEncoder::vq2_optimal);
    row.vq4[static_cast<std::size_t>(Vq4Encoder::paper)].substitutions = lost(VqEncoder::vq4_paper);
    row.vq4[static_cast<std::size_t>(Vq4Encoder::balanced)].substitutions = lost(VqEncoder::vq4_balanced);
  }
  return rows;
}

Pictures com(Measured& m, std::size_t at) {
  const std::vector<picture::Panel> panels = vq_savings_panels(drawn_rows(m));
  const auto plot = [&](std::size_t k) {
    return picture::Picture{.width = 700, .height = 480, .rows = {{panels[k]}}};
  };
  const std::size_t leaf = like_the_maple_leaf(m);
  Pictures all{
      {"figure 2", "mask", "Our leaves with masks of 64 sub-triangles", maps_by_level(m, at, {3}, false)},
      {"figure 6", "savings_vq2", "Savings of VQ2, texture by texture", plot(0)},
      {"figure 7", "savings_resolution", "Savings of the sources by resolution", plot(2)},
      {"figure 9", "blocks", m.textures()[leaf].of + ": T blue, C orange, O green; red: T or O that became C",
       blocks_of(m, leaf)},
      {"figure 10", "savings_vq4", "Savings of VQ4, texture by texture", plot(1)}};
  if (render::has_embree())
    all.push_back({"figure 1", "heat",
                   m.scenes()[at].name + ": any-hit calls of a pixel's primary and shadow ray",
                   heat_maps(m, at)});
  return all;
}

/// Figure 7: mips of the first image whose colours are drawn.
Pictures mips(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const scene::Bytes sample = of.file.empty() ? scene::sample_scene() : scene::Bytes();
  const scene::AttributeScene read =
      of.file.empty() ? scene::load_attributes(of.name, sample) : scene::load_attributes(of.file);
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
  for (Drawn& view : views(m, at, {0, 2, 4, 6})) all.push_back(std::move(view));
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
