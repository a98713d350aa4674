#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "bench/scene/size_panels.hpp"
#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace bench::picture;
using mmverify::scene::MaterialFigures;

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
  std::vector<bench::SizesOfLevel> sizes;
  for (const SceneFigures::AtLevel& at : figures.at_levels) sizes.push_back({at.level, at.sizes.footprint});
  for (Panel& panel : bench::size_panels(sizes))
    picture.rows.insert(picture.rows.end() - 1, std::vector<Panel>{std::move(panel)});
  return picture;
}

}  // namespace mmverify::cli
