#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace bench::picture;
using mmverify::scene::Footprint;

/// A curve of bytes by level.
struct Curve {
  const char* name;
  const char* colour;
  Shape shape;
  double (*bytes)(const Footprint&);
};

constexpr Curve curves[] = {
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

Axis levels() { return {.title = "level of every triangle", .whole = true}; }

Panel memory(const SceneFigures& figures) {
  Panel panel{.title = "Memory by level",
              .x = levels(),
              .y = {.title = "bytes", .logarithmic = true},
              .key = Key::outside};
  for (const Curve& curve : curves) {
    Series series{.name = curve.name, .colour = curve.colour, .shape = curve.shape};
    for (const auto& at : figures.at_levels)
      if (const double y = curve.bytes(at.sizes.footprint); y > 0)
        series.points.push_back({static_cast<double>(at.level), y});
    if (!series.points.empty()) panel.series.push_back(series);
  }
  return panel;
}

Panel savings(const SceneFigures& figures) {
  Panel panel{.title = "How often smaller the tree is",
              .x = levels(),
              .y = {.title = "micromaps / tree", .least = 0},
              .key = Key::outside};
  for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
    Series series{.name = mode == 0 ? "2 states" : "4 states",
                  .colour = vermilion,
                  .shape = mode == 0 ? Shape::open_square : Shape::square};
    for (const auto& at : figures.at_levels)
      if (const auto& m = at.sizes.footprint.mode[mode]; m.tree != 0)
        series.points.push_back(
            {static_cast<double>(at.level), static_cast<double>(m.data) / static_cast<double>(m.tree)});
    if (!series.points.empty()) panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

Picture sizes_picture(const SceneFigures& figures) {
  return {.width = 1000, .height = 900, .rows = {{memory(figures)}, {savings(figures)}}};
}

}  // namespace mmverify::cli
