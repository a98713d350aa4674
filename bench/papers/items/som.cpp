// The items of Succinct Opacity Micromaps.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "bench/papers/drawings.hpp"
#include "bench/papers/item.hpp"
#include "bench/papers/pictures.hpp"
#include "bench/subdivision/bench.hpp"
#include "impl/tree/stream.hpp"

namespace mmverify::bench::papers {
namespace {

namespace micromap = impl::micromap;
using scene::Footprint;
using scene::ModeFootprint;
using Ours = std::function<std::vector<double>(Measured&)>;

constexpr double mib = 1024.0 * 1024.0;
constexpr unsigned of_table_2 = 6;  ///< its level; 5: "up to subdivision level 6"
constexpr std::size_t two = 0, four = 1;

template <class Value>
double real(Value value) {
  return static_cast<double>(value);
}

/// A figure of the footprint at a level, for each scene; NaN where its maps would not fit.
Ours at_level(unsigned level, std::function<double(const Footprint&)> figure) {
  return [level, figure = std::move(figure)](Measured& m) {
    return by_scene(m, [&](std::size_t k) {
      const auto& sizes = m.sizes(k, level);
      return sizes ? figure(sizes->footprint) : std::nan("");
    });
  };
}

/// Bytes of one mode at table 2's level, in MiB.
Ours mib_of(std::size_t mode, std::uint64_t ModeFootprint::*bytes) {
  return at_level(of_table_2, [=](const Footprint& f) { return real(f.mode[mode].*bytes) / mib; });
}
Ours mib_of(std::uint64_t Footprint::*bytes) {
  return at_level(of_table_2, [=](const Footprint& f) { return real(f.*bytes) / mib; });
}

Ours tree_share(std::size_t mode, unsigned level = of_table_2) {
  return at_level(level, [=](const Footprint& f) {
    return 100 * real(f.mode[mode].tree) / real(std::max<std::uint64_t>(1, f.mode[mode].data));
  });
}
/// The share at each of the levels 1 to 9, its greatest and its least.
std::vector<double> tree_shares(Measured& m) {
  double least = 1e9, most = 0;
  for (unsigned level = 1; level <= 9; ++level)
    for (const double share : tree_share(four, level)(m)) {
      least = std::min(least, share);
      most = std::max(most, share);
    }
  return {most, least};
}

Ours constant(double value) {
  return [value](Measured&) { return std::vector<double>{value}; };
}

/// The range of a count over the levels 1 to 6.
Ours range_of(std::uint64_t Footprint::*count) {
  return [=](Measured& m) {
    std::vector<double> all;
    for (unsigned level = 1; level <= of_table_2; ++level)
      for (const double one : at_level(level, [=](const Footprint& f) { return real(f.*count); })(m))
        all.push_back(one);
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return std::vector<double>{*least, *most};
  };
}

/// Bits of the tree that a lookup of each micro-triangle of a twig reads, in the mean.
Ours bits_read(unsigned level) {
  return [level](Measured& m) {
    return by_scene(m, [&](std::size_t k) {
      const auto map = twig_map(m, k, level);
      if (!map) return std::nan("");
      const std::vector<std::uint32_t> bits =
          bits_read_by_index(level, impl::tree::encode_stream(level, map->format, map->packed));
      return std::accumulate(bits.begin(), bits.end(), 0.0) / real(bits.size());
    });
  };
}

/// How many times smaller the tree of a twig is than its flat map.
double twig_ratio(Measured& m, std::size_t at, unsigned level) {
  const auto map = twig_map(m, at, level);
  if (!map) return std::nan("");
  const impl::tree::Stream tree = impl::tree::encode_stream(level, map->format, map->packed);
  return real(map->packed.size()) / real(tree.tree.size() + tree.data.size());
}
Ours twig_ratio(unsigned level) {
  return [=](Measured& m) { return by_scene(m, [&](std::size_t k) { return twig_ratio(m, k, level); }); };
}

/// The tree of the map of figure 10, T and O in turn: its internal nodes, and the bits that it adds to the flat map.
impl::tree::Stream alternating_tree() {
  constexpr unsigned level = 2;
  const micromap::Bytes map(
      micromap::packed_bytes(micromap::micro_triangles(level), micromap::Format::two_state), 0xaa);
  return impl::tree::encode_stream(level, micromap::Format::two_state, map);
}
std::vector<double> internal_nodes(Measured&) {
  const impl::tree::Stream tree = alternating_tree();
  return {real(tree.nodes - tree.leaves)};
}
std::vector<double> added_bits(Measured&) {
  const impl::tree::Stream tree = alternating_tree();
  return {real(tree.nodes + tree.leaves) - real(micromap::micro_triangles(2))};
}

/// log2 of the Catalan number of n over 2n.
double catalan_share(double n) {
  return (std::lgamma(2 * n + 1) - 2 * std::lgamma(n + 1) - std::log(n + 1)) / std::log(2.0) / (2 * n);
}

std::string shortest(double value) { return std::isnan(value) ? "" : fmt::format("{:.4g}", value); }

/// Figure 11: how many distinct triangles lie over the texels of each texture.
Grid overlaps(Measured& m) {
  constexpr std::uint32_t most = 5;
  Grid grid{{"scene", "texture", "triangles", "texels under none, %", "1", "2", "3", "4", "5 or more"}, {}};
  for (const std::size_t k : masked(m)) {
    const PlannedScene& of = m.scenes()[k];
    for (std::uint32_t surface = 0; surface < of.plan.surfaces.size(); ++surface) {
      m.stop();
      const PixelNumbers over = triangles_over(of, surface);
      std::array<double, most + 1> texels{};
      for (const std::uint32_t count : over.of) ++texels[std::min(count, most)];
      const auto on_it = std::count_if(of.plan.triangles.begin(), of.plan.triangles.end(),
                                       [&](const scene::PlannedTriangle& t) { return t.surface == surface; });
      std::vector<std::string> row{of.name, of.scene.images[of.plan.surfaces[surface].image].name,
                                   std::to_string(on_it)};
      for (const double count : texels)
        row.push_back(fmt::format("{:.1f}", 100 * count / real(over.of.size())));
      grid.rows.push_back(std::move(row));
    }
  }
  return grid;
}

/// Figure 5: bytes of each form by level, of each scene.
Grid sizes_by_level(Measured& m) {
  Grid grid{{"scene", "level", "2-state, kB", "tree", "tree, %", "4-state, kB", "tree", "tree, %",
             "bitmask, 4-state", "texture", "area that calls a shader, %"},
            {}};
  for (const std::size_t k : masked(m))
    for (unsigned level = 1; level <= 9; ++level) {
      const auto& sizes = m.sizes(k, level);
      if (!sizes) continue;
      const Footprint& f = sizes->footprint;
      const auto kb = [](std::uint64_t bytes) { return shortest(real(bytes) / 1000); };
      const auto share = [](const ModeFootprint& of) {
        return shortest(100 * real(of.tree) / real(of.data));
      };
      grid.rows.push_back({m.scenes()[k].name, std::to_string(level), kb(f.mode[two].data),
                           kb(f.mode[two].tree), share(f.mode[two]), kb(f.mode[four].data),
                           kb(f.mode[four].tree), share(f.mode[four]), kb(f.mode[four].bitmask),
                           kb(f.texture), shortest(100 * sizes->any_hit.unknown)});
    }
  return grid;
}

double uses(const PlannedScene& of) { return real(of.uses.size()); }
double meshes(const PlannedScene& of) { return real(of.scene.meshes.size()); }
double triangles(const PlannedScene& of) { return real(scene::count_triangles(of.scene).unique); }
double textures(const PlannedScene& of) { return real(of.scene.images.size()); }
double masks(const PlannedScene& of) {
  std::vector<std::size_t> images;
  for (const scene::Surface& surface : of.plan.surfaces) images.push_back(surface.image);
  std::sort(images.begin(), images.end());
  return real(std::unique(images.begin(), images.end()) - images.begin());
}
Ours of_scene(double (*count)(const PlannedScene&)) {
  return [=](Measured& m) { return by_scene(m, [&](std::size_t k) { return count(m.scenes()[k]); }); };
}

constexpr char their_scenes[] =
    "their scenes are not shipped; in each list they come as Sponza, Ecosys, New Sponza, San Miguel, "
    "Landscape";
constexpr char no_graphics_card[] =
    "a frame time of a graphics card; this project times a processor (RENDER.md, Frame times)";

std::vector<Item> introduction_and_micromaps() {
  return {
      {"figure 1",
       "values merged in a 4-way tree, a twig by level",
       Status::differs,
       "scene FILE --sizes 1..9; render FILE --level 1..6 --method flat -o OUT.png",
       "the paper's 75 % is of a drawn map, without level or mode; ours is the mean of a scene, here at the "
       "level "
       "where it is nearest, and 29 % at level 6",
       {{"tree over flat, ours 4-state, level 4", {75}, "%", tree_share(four, 4)}}},
      {"figure 2", "two subdivision schemes, ties at edges and corners", Status::ok,
       "prove index.rounding index.row_order", "INDEX.md; Gruen's rows are `w-minor`"},
      {"2",
       "Fenney and Ozkan's maps, as a share of the original",
       Status::ok,
       "paper com --item 7",
       "of Compressed Opacity Maps, 7",
       {{"VQ2, VQ4",
         {50, 25},
         "%",
         [](Measured&) {
           return std::vector<double>{100 * 256 / 512.0, 100 * 512 / 2048.0};
         }}}},
      {"3.1 a", "the states' numbers, 2-state and 4-state", Status::ok, "prove micromap.packing",
       "MICROMAP.md"},
      {"3.1 b", "unknowns read as two states", Status::ok, "prove micromap.force2", "MICROMAP.md"},
      {"figure 3", "from barycentrics to a state", Status::ok,
       "prove index.equals_reference tree.point_is_index", "INDEX.md"},
      {"equation 1", "the highest useful level", Status::differs, "scene FILE --level auto --details",
       "printed the wrong way round (ERRATA.md)"},
      {"3.1.1", "coordinates that are deformed, by their maximum deformation", Status::ok,
       "scene FILE --moving; prove bake.moving bake.moving_positions",
       "maps that hold wherever an animation moves the texture (SCENE.md)"},
      {"3.1.2", "four special indices", Status::ok, "prove micromap.special_indices array.special_indices",
       "ARRAYS.md"},
      {"3.2",
       "about 4^n binary trees, so 2n bits for n nodes",
       Status::ok,
       "prove tree.sizes",
       "closed form: log2 of the Catalan number of 1000 over 2000",
       {{"bits over 2n", {1}, "", constant(catalan_share(1000))}}},
  };
}

std::vector<Item> algorithms() {
  return {
      {"figure 4", "a map of level 2 as a tree", Status::ok, "prove tree.equals_spec",
       "TREE.md has another map by hand"},
      {"algorithm 1", "the perfect tree", Status::ok, "prove tree.equals_spec tree.all_levels",
       "`perfect_tree` of spec/tree/tree.hpp"},
      {"algorithm 2", "two sequences", Status::ok, "prove tree.round_trip tree.canonical",
       "`succinct`; the print leaves the order of children open (ERRATA.md)"},
      {"algorithm 3", "lookup in the tree", Status::differs,
       "prove tree.lookup_is_decode paper.restarted_step_differs",
       "`lookup`; the print forgets the step's state (ERRATA.md)"},
      {"algorithm 4", "the index by steps", Status::ok, "prove paper.step_equals_reference --levels 0..16",
       "the print is right but for `depth`, which is no parameter and never grows (ERRATA.md)"},
      {"figure 13", "Appendix A: the step derived", Status::differs, "prove paper",
       "the print needs three corrections (ERRATA.md)"},
      {"4.3 a", "equivalent to the reference up to level 15, a discrepancy at 16", Status::differs,
       "prove index.all_levels", "there is no discrepancy at 16: every level by induction"},
      {"4.3 b", "the reference interleaves 16 bits, so levels above 16 need another", Status::ok,
       "prove index.vulkan_ends_at_16", "the library has a wider index beyond (INDEX.md)"},
      {"4.3 c",
       "the bytes of a map of level 16",
       Status::differs,
       "",
       "4^16 states of 1 and 2 bits are 0.5 and 1 GiB (ERRATA.md)",
       {{"2-state, 4-state",
         {4},
         "GiB",
         [](Measured&) {
           const auto gib = [](micromap::Format f) {
             return real(micromap::packed_bytes(micromap::micro_triangles(16), f)) / mib / 1024;
           };
           return std::vector<double>{gib(micromap::Format::two_state), gib(micromap::Format::four_state)};
         }}}},
  };
}

std::vector<Item> table_1_and_2() {
  return {
      {"table 1",
       "properties of the scenes; maps and special indices over the levels",
       Status::differs,
       "scene FILE --sizes 1..6 --details",
       their_scenes,
       {{"instances", {25, 12'755, 4, 380'748, 407'691}, "", of_scene(uses)},
        {"meshes", {25, 141, 4, 808, 370}, "", of_scene(meshes)},
        {"triangles", {262'267, 1'171'562, 2'023'747, 2'503'044, 27'885'845}, "", of_scene(triangles)},
        {"textures", {4, 237}, "", of_scene(textures), "37 to 38; 8 to 9; 4 to 5; 236 to 237; 211 to 212"},
        {"alpha masks", {3, 8, 1, 236, 211}, "", of_scene(masks)},
        {"opacity micromaps, levels 1 to 6",
         {4, 52'118},
         "",
         range_of(&Footprint::records),
         "22 to 3792; 24 to 128; 4 to 40; 1409 to 52,118; 832 to 17,636"},
        {"special indices, levels 1 to 6",
         {0, 7'498'852},
         "",
         range_of(&Footprint::special),
         "218 to 28,427; 1080 to 8280; 0 to 1,219,113; 147,313 to 394,049; 287,534 to 7,498,852"}}},
      {"table 2",
       "memory of each method, level 6",
       Status::differs,
       "scene FILE --sizes 6 --details",
       their_scenes,
       {{"2-state micromap", {1.842, 0.062, 0.020, 24.091, 8.192}, "MiB", mib_of(two, &ModeFootprint::data)},
        {"2-state tree", {0.139, 0.002, 0.003, 0.960, 0.630}, "MiB", mib_of(two, &ModeFootprint::tree)},
        {"2-state Vulkan", {1.915, 0.067, 0.021, 25.103, 8.574}, "MiB", {}},
        {"2-state bitmask",
         {0.188, 0.320, 2.000, 5.428, 14.402},
         "MiB",
         mib_of(two, &ModeFootprint::bitmask)},
        {"4-state micromap",
         {3.703, 0.125, 0.039, 50.896, 17.223},
         "MiB",
         mib_of(four, &ModeFootprint::data)},
        {"4-state tree", {0.346, 0.004, 0.007, 2.279, 1.446}, "MiB", mib_of(four, &ModeFootprint::tree)},
        {"4-state Vulkan", {3.777, 0.130, 0.041, 51.962, 17.620}, "MiB", {}},
        {"4-state bitmask",
         {0.375, 0.640, 4.000, 10.852, 28.801},
         "MiB",
         mib_of(four, &ModeFootprint::bitmask)},
        {"texture", {1.500, 2.558, 16.000, 43.399, 115.195}, "MiB", mib_of(&Footprint::texture)},
        {"vertex data", {1.258, 1.315, 52.706, 51.910, 422.197}, "MiB", mib_of(&Footprint::vertex_data)},
        {"triangle index", {0.133, 0.082, 5.167, 1.923, 35.083}, "MiB", mib_of(&Footprint::index_bytes)},
        {"metadata", {0.029, 0.001, 0.000, 0.376, 0.128}, "MiB", mib_of(&Footprint::record_bytes)}}},
  };
}

std::vector<Item> table_2_divided() {
  return {
      {"table 2, units",
       "what its MB and its metadata are",
       Status::ok,
       "scene FILE --sizes 6 --details",
       "its MB are MiB: San Miguel's 52,118 4-state maps of level 6 are 50.9; its metadata are 8 bytes for "
       "each of San "
       "Miguel's 2-state maps",
       {{"52,118 maps, 4-state", {50.896}, "MiB", constant(52'118 * 1024 / mib)},
        {"metadata of 24.091 MiB of 512-byte maps", {0.376}, "MiB", constant(24.091 / 512 * 8)},
        {"San Miguel's bitmask over its texture, 2-state",
         {100 * 5.428 / 43.399},
         "%",
         at_level(of_table_2,
                  [](const Footprint& f) { return 100 * real(f.mode[two].bitmask) / real(f.texture); })}}},
      {"table 2, shares",
       "tree over micromap, by division",
       Status::differs,
       "scene FILE --sizes 6 --details",
       "our triangles show few texels each: at level 6 more micro-triangles of a map lie on an outline",
       {{"2-state",
         {100 * 0.139 / 1.842, 100 * 0.002 / 0.062, 100 * 0.003 / 0.020, 100 * 0.960 / 24.091,
          100 * 0.630 / 8.192},
         "%",
         tree_share(two)},
        {"4-state",
         {100 * 0.346 / 3.703, 100 * 0.004 / 0.125, 100 * 0.007 / 0.039, 100 * 2.279 / 50.896,
          100 * 1.446 / 17.223},
         "%",
         tree_share(four)}}},
      {"figure 5",
       "memory and compression by level, San Miguel",
       Status::differs,
       "scene FILE --sizes 1..9 --plot OUT.png",
       "a picture without numbers; SCENE.md has five free scenes at levels 1 to 9",
       {{"tree over micromap, levels 1 to 9, 4-state", {}, "%", tree_shares}},
       sizes_by_level},
  };
}

std::vector<Item> table_3() {
  return {
      {"table 3",
       "frame times of each method, level 6",
       Status::not_here,
       "render FILE --level 6 --repeat 7",
       "frame times of a graphics card, in each list Sponza, Ecosys, New Sponza, San Miguel, Landscape; this "
       "project times "
       "a processor (RENDER.md, Frame times)",
       {{"RTX 4080, 2-state, micromap", {4.6, 7.5, 2.1, 7.5, 16.1}, "ms", {}},
        {"RTX 4080, 2-state, tree", {9.8, 13.9, 33.3, 19.2, 36.5}, "ms", {}},
        {"RTX 4080, 2-state, Vulkan (FT)", {4.5, 7.3, 1.3, 7.0, 13.9}, "ms", {}},
        {"RTX 4080, 2-state, Vulkan (FB)", {4.6, 7.4, 1.4, 7.0, 14.2}, "ms", {}},
        {"RTX 4080, 2-state, bitmask", {4.6, 8.1, 3.5, 7.7, 17.8}, "ms", {}},
        {"RTX 4080, 4-state, micromap", {4.6, 7.5, 3.3, 7.9, 16.9}, "ms", {}},
        {"RTX 4080, 4-state, tree", {16.2, 15.6, 68.7, 29.8, 56.9}, "ms", {}},
        {"RTX 4080, 4-state, Vulkan (FT)", {4.6, 7.4, 2.7, 7.3, 14.5}, "ms", {}},
        {"RTX 4080, 4-state, Vulkan (FB)", {4.7, 7.5, 2.9, 7.4, 15.0}, "ms", {}},
        {"RTX 4080, 4-state, bitmask", {4.7, 8.2, 3.8, 7.9, 18.5}, "ms", {}},
        {"RTX 4080, texture", {4.6, 8.2, 3.7, 8.0, 18.5}, "ms", {}},
        {"RTX 3080, 2-state, micromap", {7.6, 13.3, 3.8, 15.0, 30.7}, "ms", {}},
        {"RTX 3080, 2-state, tree", {15.8, 23.4, 52.3, 34.0, 62.3}, "ms", {}},
        {"RTX 3080, 2-state, Vulkan (FT)", {7.6, 13.6, 3.6, 14.8, 29.9}, "ms", {}},
        {"RTX 3080, 2-state, Vulkan (FB)", {7.7, 13.9, 4.0, 15.1, 31.1}, "ms", {}},
        {"RTX 3080, 2-state, bitmask", {7.7, 14.3, 7.2, 15.5, 34.2}, "ms", {}},
        {"RTX 3080, 4-state, micromap", {7.7, 13.4, 6.6, 15.6, 32.0}, "ms", {}},
        {"RTX 3080, 4-state, tree", {25.5, 26.3, 108.6, 50.4, 94.3}, "ms", {}},
        {"RTX 3080, 4-state, Vulkan (FT)", {7.8, 13.7, 6.4, 15.4, 31.1}, "ms", {}},
        {"RTX 3080, 4-state, Vulkan (FB)", {7.8, 14.0, 6.8, 15.7, 32.5}, "ms", {}},
        {"RTX 3080, 4-state, bitmask", {7.7, 14.1, 7.0, 15.7, 34.0}, "ms", {}},
        {"RTX 3080, texture", {7.8, 14.2, 7.4, 15.8, 34.4}, "ms", {}}}},
  };
}

std::vector<Item> runtime() {
  return {
      {"5", "maps up to level 6, six methods", Status::differs, "render FILE --level 0..6",
       "micromap, tree, bitmask and texture are rendered here; Vulkan's two builds need a graphics card"},
      {"5.1", "what a footprint counts", Status::ok, "scene FILE --sizes 6 --details",
       "the same sums: maps, indices, metadata; vertex indices and coordinates beside a texture (SCENE.md)"},
      {.id = "5.2",
       .what = "ambient occlusion, stochastic transparency, means over viewpoints, 1920 x 1080, RTX 3080 and "
               "4080",
       .status = Status::ok,
       .show = "render FILE --cameras 8 --level 0..6 --ambient-occlusion 16",
       .why = "RENDER.md, Ambient occlusion; a picture is one round, with so many rays from each hit",
       .on_this_machine = viewpoint_means},
      {.id = "figure 6",
       .what = "one twig at levels 1 to 12: frame times, and 2-state pictures",
       .status = Status::differs,
       .show = "render FILE --states 2 --level 1..9 --method flat,bitmask -o OUT.png",
       .why = "no graphics card; 2-state pictures by level, and how far each is from the texture's: "
              "RENDER.md, Two states",
       .grid = two_state_figures},
      {.id = "figure 7",
       .what = "frame times by level, RTX 4080",
       .status = Status::not_here,
       .show = "render FILE --level 0..9 --repeat 7",
       .why = no_graphics_card,
       .on_this_machine = frame_times},
      {"figure 8", "frame times by level, RTX 3080", Status::not_here, "render FILE --level 0..9 --repeat 7",
       no_graphics_card},
  };
}

/// The claim, and what table 3 has.
std::vector<Number> official_changes() {
  return {{"change", {-29, 2}, "%", {}},
          {"Vulkan (FT) over texture, RTX 4080, 4-state, by division",
           {100 * 4.6 / 4.6 - 100, 100 * 7.4 / 8.2 - 100, 100 * 2.7 / 3.7 - 100, 100 * 7.3 / 8.0 - 100,
            100 * 14.5 / 18.5 - 100},
           "%",
           {}},
          {"the same, 2-state",
           {100 * 4.5 / 4.6 - 100, 100 * 7.3 / 8.2 - 100, 100 * 1.3 / 3.7 - 100, 100 * 7.0 / 8.0 - 100,
            100 * 13.9 / 18.5 - 100},
           "%",
           {}}};
}

std::vector<Item> runtime_claims() {
  return {
      {"6.1 a", "fast-trace builds a little faster than fast-build, of one size", Status::not_here, "",
       "a driver's own builds"},
      {"6.1 b",
       "frame time of software micromaps over the texture's",
       Status::differs,
       "render FILE --level 0..9 --repeat 7",
       "on six scenes and a processor -25 to +18 % (RENDER.md, Frame times); by the paper's table 3 its "
       "2-state maps take 43 % from New Sponza's on an RTX 4080, and 49 % on an RTX 3080 (ERRATA.md)",
       {{"change", {-16, 30}, "%", {}}}},
      {"6.1 c", "frame time of official micromaps over the texture's", Status::not_here, "",
       "a graphics card's; it is of 4-state maps: by table 3 those of 2 states change it by -65 % "
       "(ERRATA.md)",
       official_changes()},
      {"6.1 d",
       "figure 6: all methods within",
       Status::not_here,
       "",
       no_graphics_card,
       {{"difference", {0.15}, "ms", {}}}},
      {.id = "6.1 e",
       .what = "a bitmask hardly better than a texture",
       .status = Status::ok,
       .show = "render FILE --states 2 --method bitmask --repeat 7; render FILE --method bitmask --repeat 7; "
               "bench vq",
       .why = "RENDER.md, Bitmasks; VQ of square maps is the compression that it asks for (VQ.md)",
       .on_this_machine = bitmask_times},
      {"6.1 f", "the tree comparable at levels 3 or 4", Status::ok, "render FILE --level 0..9 --repeat 7",
       "on a processor at most 1.21 of the texture's frame there (RENDER.md, Frame times)"},
      {"6.1 g",
       "subtrees to scan roughly quadruple with each level",
       Status::ok,
       "prove paper.tree_bits_read",
       "of the largest tree, in closed form: 1 + n/2 + 2/3 (4^n - 1) bits in the mean; of a twig's tree the "
       "outline's 2^n",
       {{"factor of the largest tree, level 8 to 9",
         {4},
         "",
         constant((1 + 9 / 2.0 + 2.0 / 3 * (262'144 - 1)) / (1 + 8 / 2.0 + 2.0 / 3 * (65'536 - 1)))}}},
      {"6.1 h",
       "an index with constant-time access takes more memory",
       Status::differs,
       "bench tree",
       "`tree-ranked` leaves out the bits of the last level, which pays for its counts: 0.91 to 1.01 of the "
       "paper's bits (TREE.md)",
       {{"more",
         {26.5},
         "%",
         at_level(of_table_2,
                  [](const Footprint& f) {
                    return 100 * (real(f.mode[four].our_tree) / real(f.mode[four].tree) - 1);
                  })}}},
  };
}

std::vector<Item> compression_claims() {
  return {
      {"6.2 a",
       "trees typically over the flat map",
       Status::differs,
       "scene FILE --sizes 1..9",
       "table 2 has 3 to 18 %, eight of its ten below 15 (ERRATA.md)",
       {{"share, level 6, 4-state", {45, 15}, "%", tree_share(four)}}},
      {"6.2 b",
       "New Sponza at level 12: times smaller",
       Status::differs,
       "scene FILE --sizes 6..12",
       "one twig of ours, in 2-state; the paper names no mode. Each level doubles the factor, once "
       "micro-triangles "
       "are smaller than texels: with fewer texels a triangle it is larger",
       {{"level 12", {110}, "x", twig_ratio(12)},
        {"level 12 over level 11",
         {},
         "x",
         [](Measured& m) {
           return by_scene(m, [&](std::size_t k) { return twig_ratio(m, k, 12) / twig_ratio(m, k, 11); });
         }}}},
      {"figure 9",
       "bits of the tree that a ray reads, 2-state, levels 4 and 9",
       Status::differs,
       "prove paper.tree_bits_read; bench tree",
       "a picture without numbers; the pages draw it on our twig",
       {{"mean of a twig, level 4", {}, "bits", bits_read(4)},
        {"mean of a twig, level 9", {}, "bits", bits_read(9)}}},
      {"figure 10",
       "the worst map, level 2",
       Status::differs,
       "prove paper.tree_worst_size",
       "the leaves have a bit each as well: 21 bits more than flat (ERRATA.md)",
       {{"internal nodes", {5}, "", internal_nodes}, {"bits more than flat", {}, "", added_bits}}},
      {"6.2.1", "subtrees encoded in the place of leaves", Status::ok, "prove dag; bench dag --scene FILE",
       "the graph of a scene's maps (DAG.md)"},
  };
}

/// Bytes of both trees over flat ones, at levels 1 to 6.
std::vector<Number> displacement_trees() {
  constexpr std::uint32_t bits = 11;
  std::vector<Number> numbers;
  for (const std::string field : {"terrain", "bumps", "plain"})
    for (const auto& [name, bytes] : {std::pair{"merged", &DisplacementSizes::tree},
                                      std::pair{"narrowing", &DisplacementSizes::narrowing}})
      numbers.push_back({field + ", " + name + " tree over flat, levels 1 to 6",
                         {},
                         "%",
                         [field, bytes = bytes](Measured&) {
                           static const std::vector<DisplacementSizes> sizes = displacement_sizes({});
                           std::vector<double> shares;
                           for (const DisplacementSizes& d : sizes)
                             if (d.field == field && d.bits == bits)
                               shares.push_back(100 * real(d.*bytes) / real(d.flat));
                           return shares;
                         }});
  return numbers;
}

std::vector<Item> overlap_and_future_work() {
  return {
      {"figure 11",
       "an atlas with all triangles' UVs, and how many overlap",
       Status::differs,
       "scene FILE --details",
       "CryTek's atlas is not shipped; the pages draw each texture of ours",
       {},
       overlaps},
      {"figure 12", "leaves in segments on one texture", Status::differs, "scene FILE --picture FOLDER",
       "two textures of scenes that are not shipped; the pages draw ours with the states of their maps"},
      {"7 a", "the index in other dimensions, shapes and subdivisions", Status::ok,
       "prove subdivision; bench subdivision",
       "triangles in four and in nine, quads, tetrahedra, bisection (SUBDIVISION.md)"},
      {"7 b", "the tree in hardware", Status::not_here, "", "software and shaders alone (SHADERS.md)"},
      {"7 c", "1-bit modes with an unknown state", Status::ok, "prove micromap.modes",
       "T/C and O/C measured (MICROMAP.md, Further 1-bit modes)"},
      {"7 d", "a tree for displacement micromaps", Status::ok, "bench subdivision",
       "made height fields, the least and the greatest of a micro-triangle in 11 bits each; a tree that "
       "merges four "
       "equal siblings pays on a plain alone, one of ranges in ranges on rough terrain, too (SUBDIVISION.md)",
       displacement_trees()},
      {"7 e", "lossy trees", Status::ok, "prove lossy", "three rules of loss (MICROMAP.md)"},
      {"7 f", "construction, efficient and continuous", Status::ok,
       "prove bake; prove bake.update; bench bake",
       "an exact baker, and updates where texels changed (BAKE.md)"},
      {"8", "an increase by at most 29 % in 4-state mode", Status::differs, "paper som --item \"6.1 c\"",
       "the frame time falls, it does not increase; table 3 has 27 % (ERRATA.md)"},
  };
}

}  // namespace

std::vector<Item> succinct_micromaps() {
  return joined({introduction_and_micromaps(), algorithms(), table_1_and_2(), table_2_divided(), table_3(),
                 runtime(), runtime_claims(), compression_claims(), overlap_and_future_work()});
}

}  // namespace mmverify::bench::papers
