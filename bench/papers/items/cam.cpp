// The items of Color and Attribute Micromaps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/papers/item.hpp"
#include "scene/attribute/footprint.hpp"

namespace mmverify::bench::papers {
namespace {

using scene::Attribute;
using scene::AttributeFigures;
using scene::MapKind;
using Ours = std::function<std::vector<double>(Measured&)>;

constexpr std::uint64_t texels_of_2048 = std::uint64_t{2048} * 2048;

/// Table 2's vertex maps at a level over the scene's textures, in %.
double vertex_share(std::uint64_t maps, unsigned level, std::uint64_t textures) {
  return 100 * static_cast<double>(scene::bytes_of_maps(maps, MapKind::vertices, level)) /
         static_cast<double>(textures * texels_of_2048 * scene::bytes_of_value);
}
/// The greatest counts of vertices' maps of table 2, of the Shoe and of the Flight helmet.
constexpr std::uint64_t of_shoe = 14'669 + 21'647 + 22'310, of_helmet = 86'844 + 88'886 + 91'090;
constexpr std::uint64_t shoe_textures = 3, helmet_textures = 18;

Ours constant(double value) {
  return [value](Measured&) { return std::vector<double>{value}; };
}

/// figure(scene's number) for each scene, masked or not.
std::vector<double> by_asset(Measured& m, const std::function<double(std::size_t)>& figure) {
  std::vector<double> all;
  for (std::size_t k = 0; k < m.scenes().size(); ++k) all.push_back(figure(k));
  return all;
}

/// The least and the greatest count of distinct maps of an attribute, over the levels and scenes; empty without one.
Ours counts(Attribute attribute, MapKind kind) {
  return [=](Measured& m) {
    std::vector<double> all;
    for (std::size_t k = 0; k < m.scenes().size(); ++k)
      for (const scene::AttributeSetFigures& set : m.attributes(k).sets)
        for (const scene::MapsAtLevel& at : set.levels)
          if (has(set.set, attribute) && at.kind == kind) all.push_back(static_cast<double>(at.distinct));
    if (all.empty()) return all;
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return std::vector<double>{*least, *most};
  };
}

Ours each_asset(double (*figure)(Measured&, std::size_t)) {
  return [=](Measured& m) { return by_asset(m, [&](std::size_t k) { return figure(m, k); }); };
}
double triangles_of(Measured& m, std::size_t at) { return static_cast<double>(m.attributes(at).triangles); }
double textures_of(Measured& m, std::size_t at) { return static_cast<double>(m.attributes(at).images); }
double uses_of(Measured& m, std::size_t at) { return static_cast<double>(m.scenes()[at].uses.size()); }

double meshes_of(Measured& m, std::size_t at) {
  return static_cast<double>(m.scenes()[at].scene.meshes.size());
}

/// A count of opacity micromaps at level 5.
Ours opacity(std::uint64_t scene::Footprint::*count) {
  return [=](Measured& m) {
    return by_scene(m, [&](std::size_t k) {
      const auto& sizes = m.sizes(k, 5);
      return sizes ? static_cast<double>(sizes->footprint.*count) : std::nan("");
    });
  };
}

/// Table 2: the counts of distinct maps of each scene's attributes, from the least to the greatest of the levels.
Grid counts_by_scene(Measured& m) {
  Grid grid{{"scene", "attributes", "levels, as far as they take seconds", "triangles", "faces", "vertices"},
            {}};
  for (std::size_t k = 0; k < m.scenes().size(); ++k)
    for (const scene::AttributeSetFigures& set : m.attributes(k).sets) {
      const auto range = [&set](MapKind kind) {
        std::uint64_t least = ~std::uint64_t{0}, most = 0;
        for (const scene::MapsAtLevel& at : set.levels)
          if (at.kind == kind) {
            least = std::min(least, at.distinct);
            most = std::max(most, at.distinct);
          }
        return fmt::format("{} to {}", least, most);
      };
      grid.rows.push_back({m.scenes()[k].name, scene::name(set.set),
                           fmt::format("0 to {}", set.levels.back().level), std::to_string(set.triangles),
                           range(MapKind::faces), range(MapKind::vertices)});
    }
  return grid;
}

/// All maps of a kind over the textures, in %.
Ours memory(MapKind kind, unsigned level) {
  return [=](Measured& m) {
    return by_asset(m, [&](std::size_t k) {
      const AttributeFigures& f = m.attributes(k);
      if (f.texture_bytes == 0 || f.sets.front().levels.back().level < level) return std::nan("");
      return 100 * static_cast<double>(f.bytes(level, kind)) / static_cast<double>(f.texture_bytes);
    });
  };
}

/// Mean FLIP of base colours in texture space.
Ours flip(MapKind kind, unsigned level) {
  return [=](Measured& m) {
    return by_asset(m, [&](std::size_t k) {
      double sum = 0, sets = 0;
      for (const scene::AttributeSetFigures& set : m.attributes(k).sets)
        for (const scene::MapsAtLevel& at : set.levels)
          if (has(set.set, Attribute::base_color) && at.kind == kind && at.level == level) {
            sum += at.error.flip.value_or(0);
            ++sets;
          }
      return sets > 0 ? sum / sets : std::nan("");
    });
  };
}

/// The number of levels from 0 to 5 at which faces have the lower FLIP.
std::vector<double> levels_where_faces_win(Measured& m) {
  std::vector<double> levels(m.scenes().size(), 0);
  for (unsigned level = 0; level <= 5; ++level) {
    const std::vector<double> faces = flip(MapKind::faces, level)(m),
                              vertices = flip(MapKind::vertices, level)(m);
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k] += faces[k] < vertices[k] ? 1 : 0;
  }
  return levels;
}

/// The lower levels of a map of faces over the map, in %.
double lower_levels(MapKind kind, unsigned level) {
  double lower = 0;
  for (unsigned k = 0; k < level; ++k) lower += static_cast<double>(scene::values_of_map(kind, k));
  return 100 * lower / static_cast<double>(scene::values_of_map(kind, level));
}

/// Figures 9 and 11 in texture space: each level of each scene.
Grid by_level(Measured& m) {
  Grid grid{{"scene", "level", "faces, % of the textures", "vertices, %", "FLIP, faces", "FLIP, vertices"},
            {}};
  for (std::size_t k = 0; k < m.scenes().size(); ++k)
    for (unsigned level = 0; level <= 5; ++level) {
      const auto at = [&](const Ours& ours, const char* how) {
        const double value = ours(m)[k];
        return std::isnan(value) ? "-" : fmt::format(fmt::runtime(how), value);
      };
      grid.rows.push_back(
          {m.scenes()[k].name, std::to_string(level), at(memory(MapKind::faces, level), "{:.2f}"),
           at(memory(MapKind::vertices, level), "{:.2f}"), at(flip(MapKind::faces, level), "{:.3f}"),
           at(flip(MapKind::vertices, level), "{:.3f}")});
    }
  return grid;
}

constexpr char other_assets[] =
    "three of the six scenes are free: ATTRIBUTE_SCENES.md, Counts, has them; here our own";

std::vector<Item> introduction_of_attributes() {
  return {
      {"figure 1",
       "the Shoe by vertices' maps, in a share of its textures",
       Status::ok,
       "views SHOE --level 4 --pictures FOLDER",
       "58,626 maps of vertices, table 2's greatest, at level 4 over three textures of 2048^2",
       {{"memory", {71}, "%", constant(vertex_share(of_shoe, 4, shoe_textures))}}},
      {"2",
       "the ratios of Compressed and of Succinct Opacity Micromaps, 50 to 25 %, 45 to 15 %, below 1 %; no "
       "real-time use "
       "of trees beyond 3 or 4 levels",
       Status::differs, "paper com --item 7; paper som --item 6.2; paper som --item \"6.1 f\"",
       "50 to 25 % holds, 45 to 15 % contradicts their table 2 (ERRATA.md), below 1 % holds on a twig at "
       "level 12; lookups "
       "by rank are as quick as flat ones (TREE.md)"},
      {"table 1", "states", Status::ok, "prove micromap", "MICROMAP.md"},
      {"figure 2", "three orders", Status::ok, "prove attribute.order_is_walk",
       "ATTRIBUTE.md, Orders, draws them"},
      {"3.2", "neighbours differ by one level at most", Status::ok, "attributes FILE --level 0..6 --plan 4",
       "plans keep it for vertices (ATTRIBUTE_SCENES.md)"},
      {"figure 3", "edge decimation of the first two levels", Status::differs,
       "prove attribute.decimation_watertight",
       "ATTRIBUTE.md, Decimation, draws it; vertices \"merely adjusted\" need another lookup than 4.1's "
       "(ERRATA.md)"},
  };
}

std::vector<Item> lookups_and_mips() {
  return {
      {"4.1 a", "barycentrics remapped by a 3x3 system", Status::differs, "prove paper.cramer_in_binary32",
       "exact in rationals; in binary32 two bits lost a level (ERRATA.md)"},
      {"4.1 b", "the closest triplet", Status::differs, "prove paper.triplet_is_not_closest",
       "it is the triplet of the face that holds the point (ERRATA.md)"},
      {"figure 4", "lookup in W-minor order", Status::differs,
       "prove paper.w_minor_holds_point paper.figure_4_triplets; bench attribute",
       "32 bits and the root's rounding have limits (ERRATA.md)"},
      {"figure 5", "a GLSL API of attributes", Status::differs, "",
       "subjects/shaders/attribute_api.glsl, by functions; the print leaves a read's meaning open "
       "(ERRATA.md, SHADERS.md)"},
      {"figure 6", "transparency by component-wise max", Status::ok,
       "render FILE --blend max --level 5 --method flat -o OUT.png; prove traverse.blend_order_free",
       "RENDER.md, Hits that blend; one case depends on the order (ERRATA.md)"},
      {"figure 7", "mips of faces, of the image, and FLIP of both", Status::ok,
       "attributes FILE --level 0..6 --mips --pictures FOLDER", "ATTRIBUTE_SCENES.md, Mips and bleeding"},
      {"4.4",
       "memory of mips over the map",
       Status::differs,
       "prove paper.mip_third_is_faces_only",
       "true of faces; of vertices more, unless in Bird order (ERRATA.md)",
       {{"faces, level 8", {33}, "%", constant(lower_levels(MapKind::faces, 8))},
        {"vertices, level by level, level 8", {33}, "%", constant(lower_levels(MapKind::vertices, 8))}}},
      {"4.4.1", "vertices' mips: the lower level", Status::ok, "prove attribute.vertex_mip_is_prefix",
       "samples, not means (ERRATA.md)"},
      {"figure 8", "level of detail by ray cones", Status::differs,
       "views FILE --level 6 --cones; prove attribute.lod_level attribute.lod_blend",
       "ATTRIBUTE_SCENES.md, Levels of detail; words, formula and the third step have three levels, and "
       "values jump at "
       "edges (ERRATA.md)"},
  };
}

std::vector<Item> counts_of_maps() {
  return {
      {"table 2",
       "counts of distinct maps: Quad, Avocado, Shoe, Flight helmet, Sponza, Sun Temple",
       Status::differs,
       "attributes FILE --level 0..5 --codes",
       other_assets,
       {{"triangles", {2, 1115, 23'133, 95'155, 262'267, 606'376}, "", each_asset(triangles_of)},
        {"textures", {2, 3, 3, 18, 73, 148}, "", each_asset(textures_of)},
        {"instances", {1, 2, 2, 7, 1, 517}, "", each_asset(uses_of)},
        {"meshes", {1, 2, 2, 7, 1, 517}, "", each_asset(meshes_of)},
        {"opacity micromaps",
         {0, 3801},
         "",
         opacity(&scene::Footprint::records),
         "0 to 2; 0; 0; 0; 0 to 3801; 0 to 569"},
        {"special indices",
         {0, 338'783},
         "",
         opacity(&scene::Footprint::special),
         "0 to 2; 0; 0; 0; 19 to 3820; 334,038 to 338,783"},
        {"faces, colours",
         {2, 85'570},
         "",
         counts(Attribute::base_color, MapKind::faces),
         "2; 587 to 682; 2103 to 14,555; 8426 to 85,570; 26,321 to 73,542; 11,691 to 43,778"},
        {"faces, normals",
         {1, 88'897},
         "",
         counts(Attribute::normal, MapKind::faces),
         "1 to 2; 372 to 682; 8438 to 21,323; 20,260 to 88,897; 11,905 to 45,470; 23,196 to 45,263"},
        {"faces, metal and roughness",
         {0, 91'074},
         "",
         counts(Attribute::metallic_roughness, MapKind::faces),
         "0; 5 to 682; 12,163 to 22,272; 31,760 to 91,074; 4725 to 40,539; 0"},
        {"vertices, colours",
         {1, 86'844},
         "",
         counts(Attribute::base_color, MapKind::vertices),
         "1 to 2; 682; 11,879 to 14,669; 69,561 to 86,844; 72,682 to 73,539; 41,967 to 44,010"},
        {"vertices, normals",
         {1, 88'886},
         "",
         counts(Attribute::normal, MapKind::vertices),
         "1 to 2; 682; 19,513 to 21,647; 86,232 to 88,886; 44,287 to 45,027; 43,602 to 45,298"},
        {"vertices, metal and roughness",
         {0, 91'090},
         "",
         counts(Attribute::metallic_roughness, MapKind::vertices),
         "0; 22 to 382; 21,144 to 22,310; 90,174 to 91,090; 34,443 to 40,179; 0"}},
       counts_by_scene},
  };
}

std::vector<Item> measured_attributes() {
  return {
      {"table 2, 433",
       "triangles beyond the assets' 682, 22,700 and 94,722",
       Status::differs,
       "attributes FILE --codes",
       "the same surplus in all three: a mesh of 433 triangles without maps (ERRATA.md)",
       {{"Avocado, Shoe, Flight helmet",
         {1115 - 682},
         "",
         [](Measured&) {
           return std::vector<double>{1115 - 682, 23'133 - 22'700, 95'155 - 94'722};
         }}}},
      {"5.1", "faces by averaged pixels, vertices by bilinear samples", Status::differs,
       "attributes FILE --level 0..5 --codes",
       "its words leave the codes open in six questions (ERRATA.md); ours by area, in light"},
      {"figure 9",
       "memory by level",
       Status::differs,
       "attributes FILE --level 0..6 --plot FILE.png",
       "a picture without numbers; ATTRIBUTE_SCENES.md, Memory, has the free assets",
       {{"faces of level 4 over the textures", {}, "%", memory(MapKind::faces, 4)},
        {"vertices of level 4", {}, "%", memory(MapKind::vertices, 4)}},
       by_level},
      {"figure 10", "frame times, RTX 3060", Status::not_here, "attributes FILE --time",
       "a graphics card's frame time; of lookups instead (ATTRIBUTE_SCENES.md, Time)"},
      {"table 3", "renders at 1920 x 1080 and FLIP's maps, levels 0 to 8", Status::differs,
       "views FILE --level 0..8 --size 1920x1080 --pictures FOLDER",
       "the free assets' in ATTRIBUTE_SCENES.md, Rendered views; its lights and cameras are not described"},
      {"figure 11",
       "mean FLIP by level",
       Status::differs,
       "views FILE --level 0..8 --size 1920x1080; attributes FILE --level 0..6",
       "a picture without numbers; here in texture space, rendered in ATTRIBUTE_SCENES.md",
       {{"faces of level 4", {}, "FLIP", flip(MapKind::faces, 4)},
        {"vertices of level 4", {}, "FLIP", flip(MapKind::vertices, 4)}}},
      {"5.2", "unlit renders, world-space normals", Status::ok,
       "views FILE --shading unlit; views FILE --shading normals", "ATTRIBUTE_SCENES.md, Rendered views"},
      {"6.3 c", "faces look worse, by their tessellation", Status::not_here,
       "views FILE --level 4 --pictures FOLDER",
       "a judgement of the eye; FLIP's maps are beside the pictures"},
  };
}

std::vector<Item> claims_of_attributes() {
  return {
      {"6.1 a",
       "footprints consistently low for levels 0 to 5",
       Status::differs,
       "attributes FILE --level 0..5",
       "false by its own table 2 (ERRATA.md): vertices at level 5 over the textures",
       {{"Shoe, Flight helmet",
         {},
         "%",
         [](Measured&) {
           return std::vector<double>{vertex_share(of_shoe, 5, shoe_textures),
                                      vertex_share(of_helmet, 5, helmet_textures)};
         }}}},
      {"6.1 b",
       "the Quad goes beyond level 8 before parity",
       Status::ok,
       "attributes FILE --level 0..8",
       "4 maps of vertices reach two textures of 1024^2 at this level",
       {{"level",
         {8},
         "",
         constant(scene::level_beyond(4, MapKind::vertices, std::uint64_t{2} * 1024 * 1024 * 4))}}},
      {"6.2", "lookups in line with textures", Status::differs, "attributes FILE --time; bench attribute",
       "on a processor without texture units (ATTRIBUTE_SCENES.md, Time)"},
      {"6.3 a",
       "faces frequently have the lower mean FLIP at a level",
       Status::ok,
       "attributes FILE --level 0..6",
       "ATTRIBUTE_SCENES.md, Quality; at equal bytes vertices often win",
       {{"levels 0 to 5 where they have", {}, "", levels_where_faces_win}}},
      {"6.3 b",
       "Shoe and Flight helmet, levels 2 to 4, over the textures",
       Status::differs,
       "attributes FILE --level 2..4",
       "by table 2 the Flight helmet's are less (ERRATA.md)",
       {{"Shoe",
         {7, 71},
         "%",
         [](Measured&) {
           return std::vector<double>{vertex_share(of_shoe, 2, shoe_textures),
                                      vertex_share(of_shoe, 4, shoe_textures)};
         }},
        {"Flight helmet",
         {7, 71},
         "%",
         [](Measured&) {
           return std::vector<double>{vertex_share(of_helmet, 2, helmet_textures),
                                      vertex_share(of_helmet, 4, helmet_textures)};
         }}}},
      {"7 a", "authoring, animation, micro-edges", Status::not_here, "",
       "maps are baked from textures; no third kind of map"},
      {"7 b", "compression of attributes", Status::ok, "prove attribute.packed_canonical",
       "ATTRIBUTE_COMPRESSION.md"},
      {"7 c", "special indices, a palette", Status::ok, "attributes FILE --level 0..6 --plan 4",
       "a value of a palette for a triangle of one value (ATTRIBUTE_SCENES.md, A level for each triangle)"},
      {"7 d", "Surface-Stable Fractal Dithering on micromaps", Status::not_here, "",
       "another rendering algorithm"},
  };
}

}  // namespace

std::vector<Item> attribute_micromaps() {
  return joined({introduction_of_attributes(), lookups_and_mips(), counts_of_maps(), measured_attributes(),
                 claims_of_attributes()});
}

}  // namespace mmverify::bench::papers
