#include "bench/bake/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

struct Look {
  Baker baker;
  const char* colour;
};
constexpr Look looks[] = {
    {Baker::centre, grey},     {Baker::corners, orange}, {Baker::sixteen_samples, vermilion},
    {Baker::rasterised, blue}, {Baker::ours, green},     {Baker::rational, purple}};

Panel error_against_time(const BakeLevel& level) {
  Panel panel{
      .title = "Wrong and needless states, against the time of one, level " + std::to_string(level.level),
      .x = {.title = "ns a micro-triangle, one thread", .logarithmic = true},
      .y = {.title = "a million", .logarithmic = true, .least = 1, .most = 2e6}};
  for (const Look& look : looks) {
    const BakeFigure& f = level.of(look.baker);
    panel.series.push_back({.name = "",
                            .colour = look.colour,
                            .joined = false,
                            .points = {{f.ns, f.wrong_per_million() + f.needless_per_million(),
                                        to_string(look.baker), Range{f.least_ns, f.most_ns}}}});
  }
  return panel;
}

Panel time_against_level(const BakeFigures& figures) {
  Panel panel{.title = "Time, by level",
              .x = {.title = "level", .whole = true},
              .y = {.title = "ns a micro-triangle", .logarithmic = true},
              .key = Key::top_right};
  for (const Look& look : looks) {
    Series series{.name = to_string(look.baker), .colour = look.colour};
    for (const BakeLevel& level : figures.levels)
      series.points.push_back({static_cast<double>(level.level), level.of(look.baker).ns});
    panel.series.push_back(series);
  }
  return panel;
}

Panel time_against_size(const BakeFigures& figures) {
  Series ours{.name = to_string(Baker::ours), .colour = green},
      binary64{.name = to_string(Baker::rasterised), .colour = blue};
  for (const BakeSize& s : figures.sizes) {
    ours.points.push_back({static_cast<double>(s.size), s.ns});
    binary64.points.push_back({static_cast<double>(s.size), s.ns_rasterised});
  }
  return {.title = "Time, by texture size, level 6",
          .x = {.title = "texels along a side", .logarithmic = true},
          .y = {.title = "ns a micro-triangle", .logarithmic = true},
          .series = {ours, binary64},
          .key = Key::top_right};
}

Panel unknown_against_margin(const BakeFigures& figures) {
  Series series{.name = "", .colour = green};
  for (const BakeMargin& m : figures.margins) series.points.push_back({m.texels, per_cent * m.unknown});
  return {.title = "Unknown states, by margin, level 6",
          .x = {.title = "texels"},
          .y = {.title = "%", .least = 0},
          .series = {series}};
}

}  // namespace

Picture bake_picture(const BakeFigures& figures) {
  Picture drawn{.width = 1200, .height = 960};
  if (!figures.levels.empty())
    drawn.rows.push_back(
        {error_against_time(figures.levels[figures.levels.size() / 2]), time_against_level(figures)});
  drawn.rows.push_back({time_against_size(figures), unknown_against_margin(figures)});
  return drawn;
}

}  // namespace mmverify::bench
