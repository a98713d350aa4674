#include <fmt/format.h>

#include <algorithm>

#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace bench::picture;
using mmverify::scene::Footprint;
using mmverify::scene::MaterialFigures;

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

/// The share of the area that calls shaders against the bytes of the maps, level by level.
Series asks(std::string name, const char* colour, Shape shape, const MaterialFigures& of, bool labels) {
  Series series{.name = std::move(name), .colour = colour, .shape = shape};
  for (std::size_t n = 0; n < of.levels.size(); ++n)
    if (of.levels[n].bytes != 0)
      series.points.push_back({static_cast<double>(of.levels[n].bytes), 100 * of.levels[n].unknown,
                               labels ? std::to_string(n) : std::string()});
  return series;
}

/// The scene, and the materials with the largest areas; the numbers beside the scene's marks are levels.
Panel shares(const SceneFigures& figures) {
  constexpr std::pair<const char*, Shape> looks[] = {{blue, Shape::circle},
                                                     {vermilion, Shape::square},
                                                     {green, Shape::triangle},
                                                     {orange, Shape::diamond},
                                                     {purple, Shape::triangle_down}};
  Panel panel{.title = "Area that calls the any-hit shader, by bytes of maps and level",
              .x = {.title = "bytes", .logarithmic = true},
              .y = {.title = "% of the area", .least = 0},
              .key = Key::outside};
  panel.series.push_back(asks("the scene", grey, Shape::disc, total(figures.materials), true));
  std::vector<MaterialFigures> all = figures.materials;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
  for (std::size_t k = 0; k < std::min(all.size(), std::size(looks)); ++k) {
    const std::string& name = figures.scene.materials[all[k].material].name;
    panel.series.push_back(asks(fmt::format("{} {:.24}", all[k].material, name), looks[k].first,
                                looks[k].second, all[k], false));
  }
  return panel;
}

}  // namespace

Picture sizes_picture(const SceneFigures& figures) {
  Picture picture{.width = 1000, .height = 450, .rows = {{shares(figures)}}};
  if (figures.at_levels.empty()) return picture;
  picture.height = 1350;
  picture.rows.insert(picture.rows.begin(), {{memory(figures)}, {savings(figures)}});
  return picture;
}

}  // namespace mmverify::cli
