#include "bench/scene/size_panels.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;
using scene::Footprint;

/// A curve of bytes by level.
struct SizeCurve {
  const char* name;
  const char* colour;
  Shape shape;
  double (*bytes)(const Footprint&);
};

constexpr SizeCurve size_curves[] = {
    {"micromaps, 4-state", blue, Shape::disc,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].data); }},
    {"micromaps, 2-state", blue, Shape::circle,
     [](const Footprint& f) { return static_cast<double>(f.mode[0].data); }},
    {"tree, 4-state", vermilion, Shape::square,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].tree); }},
    {"tree, 2-state", vermilion, Shape::open_square,
     [](const Footprint& f) { return static_cast<double>(f.mode[0].tree); }},
    {"ranked tree, 4-state", green, Shape::triangle,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].our_tree); }},
    {"bitmask, 4-state", grey, Shape::triangle_down,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].bitmask); }},
    {"texture", orange, Shape::diamond, [](const Footprint& f) { return static_cast<double>(f.texture); }},
    {"records and indices", purple, Shape::circle,
     [](const Footprint& f) { return static_cast<double>(f.record_bytes + f.index_bytes); }},
};

Axis level_axis() { return {.title = "level of every triangle", .whole = true}; }

Panel memory_panel(const std::vector<SizesOfLevel>& sizes) {
  Panel panel{.title = "Memory by level",
              .x = level_axis(),
              .y = {.title = "bytes", .logarithmic = true},
              .key = Key::outside};
  for (const SizeCurve& curve : size_curves) {
    Series series{.name = curve.name, .colour = curve.colour, .shape = curve.shape};
    for (const SizesOfLevel& at : sizes)
      if (const double y = curve.bytes(at.footprint); y > 0)
        series.points.push_back({static_cast<double>(at.level), y});
    if (!series.points.empty()) panel.series.push_back(series);
  }
  return panel;
}

Panel ratio_panel(const std::vector<SizesOfLevel>& sizes) {
  Panel panel{.title = "How often smaller the tree is",
              .x = level_axis(),
              .y = {.title = "micromaps / tree", .least = 0},
              .key = Key::outside};
  for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
    Series series{.name = mode == 0 ? "2 states" : "4 states",
                  .colour = vermilion,
                  .shape = mode == 0 ? Shape::open_square : Shape::square};
    for (const SizesOfLevel& at : sizes)
      if (const auto& m = at.footprint.mode[mode]; m.tree != 0)
        series.points.push_back(
            {static_cast<double>(at.level), static_cast<double>(m.data) / static_cast<double>(m.tree)});
    if (!series.points.empty()) panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

std::vector<Panel> size_panels(const std::vector<SizesOfLevel>& sizes) {
  return {memory_panel(sizes), ratio_panel(sizes)};
}

}  // namespace mmverify::bench
