
#include "bench/attribute/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

const char* colour_of(const std::string& order) {
  return order.starts_with("W") ? blue : order.starts_with("U") ? orange : green;
}
bool batched(const std::string& order) { return order.ends_with("batched"); }

/// Adds a series for each order, with one figure of each level.
template <class Of>
void add_orders(Panel& panel, const std::vector<AttributeLookupLevel>& levels, Of of) {
  if (levels.empty()) return;
  for (std::size_t o = 0; o < levels.front().orders.size(); ++o) {
    const std::string& name = levels.front().orders[o].order;
    Series series{
        .name = name, .colour = colour_of(name), .shape = batched(name) ? Shape::square : Shape::circle};
    for (const AttributeLookupLevel& l : levels)
      if (const std::optional<double> y = of(l.orders[o]))
        series.points.push_back({static_cast<double>(l.level), *y});
    panel.series.push_back(series);
  }
}

Panel triplets(const AttributeFigures& figures) {
  Panel panel{.title = "(u, v) to three indices",
              .x = {.title = "level", .whole = true},
              .y = {.title = "ns a point, one thread", .logarithmic = true},
              .key = Key::outside};
  Series figure_4{.name = "figure 4, binary32", .colour = vermilion, .shape = Shape::diamond};
  for (const AttributeLookupLevel& l : figures.lookups)
    figure_4.points.push_back({static_cast<double>(l.level), l.figure_4_ns});
  panel.series.push_back(figure_4);
  add_orders(panel, figures.lookups,
             [](const AttributeOrderTimes& o) { return std::optional<double>(o.triplet_ns); });
  return panel;
}

Panel values(const AttributeFigures& figures) {
  Panel panel{.title = "(u, v) to a value of RGBA8",
              .x = {.title = "level", .whole = true},
              .y = {.title = "ns a point", .logarithmic = true},
              .key = Key::outside};
  for (const bool simd : {false, true}) {
    Series series{.name = simd ? "bilinear, batched" : "bilinear",
                  .colour = vermilion,
                  .shape = simd ? Shape::square : Shape::circle};
    for (const AttributeLookupLevel& l : figures.lookups)
      if (const std::optional<double> y = simd ? l.bilinear_simd_ns : l.bilinear_ns)
        series.points.push_back({static_cast<double>(l.level), *y});
    panel.series.push_back(series);
  }
  add_orders(panel, figures.lookups, [](const AttributeOrderTimes& o) { return o.lookup_ns; });
  return panel;
}

constexpr std::pair<Remap, const char*> remap_colours[] = {
    {Remap::cramer, vermilion}, {Remap::two_equations, blue}, {Remap::pattern, orange}, {Remap::ours, green}};

Panel errors_by_level(const AttributeFigures& figures) {
  Panel panel{.title = "Worst error of a weight",
              .x = {.title = "level", .whole = true},
              .y = {.title = "heights of a micro-triangle", .logarithmic = true},
              .key = Key::outside};
  for (const auto& [remap, colour] : remap_colours) {
    Series series{.name = to_string(remap), .colour = colour};
    for (const RemapLevel& l : figures.remaps)
      if (l.of(remap).no_number == 0)
        series.points.push_back({static_cast<double>(l.level), l.of(remap).worst});
    panel.series.push_back(series);
  }
  return panel;
}

/// The panel shows the highest level up to 12: above it, Cramer's rule gives no number for some points.
Panel error_against_time(const AttributeFigures& figures) {
  Panel panel{.title = "Error against time of remaps",
              .x = {.title = "ns a point", .logarithmic = true},
              .y = {.title = "worst, heights", .logarithmic = true}};
  const RemapLevel* shown = nullptr;
  for (const RemapLevel& l : figures.remaps)
    if (shown == nullptr || l.level <= 12) shown = &l;
  if (shown == nullptr) return panel;
  panel.title += ", level " + std::to_string(shown->level);
  for (const auto& [remap, colour] : remap_colours) {
    const RemapFigure& f = shown->of(remap);
    panel.series.push_back({.colour = colour,
                            .joined = false,
                            .points = {{f.ns, f.worst, to_string(remap), Range{f.least_ns, f.most_ns}}}});
  }
  return panel;
}

}  // namespace

Picture attribute_picture(const AttributeFigures& figures) {
  return {.width = 1300,
          .height = 960,
          .rows = {{triplets(figures), values(figures)},
                   {errors_by_level(figures), error_against_time(figures)}}};
}

}  // namespace mmverify::bench
