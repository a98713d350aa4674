#include <string>

#include "bench/scene/dag_tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

constexpr std::pair<SceneForm, std::pair<const char*, Shape>> looks[] = {
    {SceneForm::once, {grey, Shape::disc}},      {SceneForm::paper, {vermilion, Shape::triangle}},
    {SceneForm::ranked, {blue, Shape::diamond}}, {SceneForm::dag, {green, Shape::square}},
    {SceneForm::lz4, {purple, Shape::circle}},   {SceneForm::zstd, {orange, Shape::triangle_down}}};

const char* name_of(SceneForm form) {
  switch (form) {
    case SceneForm::once: return "flat, each map once";
    case SceneForm::paper: return "trees, two sequences";
    case SceneForm::ranked: return "trees, ranked";
    case SceneForm::dag: return "one graph";
    default: return to_string(form);
  }
}

double bytes_a_map(const SceneDagFigures& row, SceneForm form) {
  return static_cast<double>(row.form(form).bytes) / static_cast<double>(row.maps);
}

std::string title(std::uint32_t bits, const char* what) {
  return std::to_string(1u << bits) + " states: " + what;
}

Panel size_against_time(const SceneDagScene& figures, std::uint32_t bits) {
  Panel panel{.title = title(bits, "size against time, a mark a level"),
              .x = {.title = "ns a lookup, one thread", .logarithmic = true},
              .y = {.title = "bytes a map", .logarithmic = true}};
  for (const auto& [form, look] : looks) {
    Series series{.colour = look.first, .shape = look.second};
    for (const SceneDagFigures& row : figures.rows)
      if (row.bits == bits && row.form(form).ns)
        series.points.push_back({*row.form(form).ns, bytes_a_map(row, form), std::to_string(row.level)});
    if (!series.points.empty()) panel.series.push_back(series);
  }
  return panel;
}

Panel size_by_level(const SceneDagScene& figures, std::uint32_t bits) {
  Panel panel{.title = title(bits, "size by level"),
              .x = {.title = "level", .whole = true},
              .y = {.title = "bytes a map", .logarithmic = true},
              .key = Key::below_all};
  for (const auto& [form, look] : looks) {
    Series series{.name = name_of(form), .colour = look.first, .shape = look.second};
    for (const SceneDagFigures& row : figures.rows)
      if (row.bits == bits) series.points.push_back({static_cast<double>(row.level), bytes_a_map(row, form)});
    panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

Picture scene_dag_picture(const SceneDagScene& figures) {
  Picture drawn{.width = 1300, .height = 1000};
  drawn.rows.resize(2);
  bool keyed = false;
  for (const std::uint32_t bits : {1u, 2u}) {
    Panel times = size_against_time(figures, bits), levels = size_by_level(figures, bits);
    if (times.series.empty()) continue;
    // Both panels share one key.
    if (keyed) levels.key = Key::none;
    keyed = true;
    drawn.rows[0].push_back(times);
    drawn.rows[1].push_back(levels);
  }
  return drawn;
}

}  // namespace mmverify::bench
