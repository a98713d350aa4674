#include <string>

#include "bench/dag/tables.hpp"

namespace mmverify::bench {

picture::Picture dag_picture(const std::vector<DagFigures>& figures) {
  using namespace picture;
  const std::pair<DagForm, Series> looks[] = {
      {DagForm::flat, {.name = "flat", .colour = grey, .shape = Shape::disc}},
      {DagForm::ranked, {.name = "trees, ranked", .colour = blue, .shape = Shape::diamond}},
      {DagForm::dag, {.name = "one graph", .colour = green, .shape = Shape::square}}};
  Picture drawn{.width = 1000, .height = 1000};
  for (const std::uint32_t bits : {1u, 2u}) {
    Panel panel{.title = std::to_string(2 * bits) + " states: size against time, a mark a level",
                .x = {.title = "ns a lookup, one thread", .logarithmic = true},
                .y = {.title = "bytes a map", .logarithmic = true},
                .key = Key::outside};
    for (const auto& [form, look] : looks) {
      Series series = look;
      for (const DagFigures& f : figures)
        if (f.bits == bits && f.maps > 0)
          series.points.push_back(
              {f.form(form).ns, static_cast<double>(f.form(form).bytes) / static_cast<double>(f.maps),
               std::to_string(f.level), Range{f.form(form).least_ns, f.form(form).most_ns}});
      if (!series.points.empty()) panel.series.push_back(series);
    }
    if (!panel.series.empty()) drawn.rows.push_back({panel});
  }
  return drawn;
}

}  // namespace mmverify::bench
