#include <string>

#include "bench/tree/tables.hpp"

namespace mmverify::bench {

picture::Picture tree_picture(const std::vector<TreeFigures>& figures) {
  using namespace picture;
  const Series looks[] = {{.name = "flat", .colour = grey, .shape = Shape::disc},
                          {.name = "paper, Algorithm 3", .colour = vermilion, .shape = Shape::triangle},
                          {.name = "ours", .colour = green, .shape = Shape::square},
                          {.name = "sdsl", .colour = blue, .shape = Shape::diamond}};
  Picture drawn{.width = 1000, .height = 1000};
  for (const std::uint32_t bits : {1u, 2u}) {
    Panel panel{.title = std::to_string(2 * bits) + " states: size against time, a mark a level",
                .x = {.title = "ns a lookup, one thread", .logarithmic = true},
                .y = {.title = "bits a micro-triangle", .logarithmic = true},
                .key = Key::outside};
    for (std::size_t form = 0; form < tree_forms; ++form) {
      Series series = looks[form];
      for (const TreeFigures& f : figures)
        if (f.bits == bits)
          series.points.push_back({f.forms[form].ns, f.forms[form].bits, std::to_string(f.level),
                                   Range{f.forms[form].least_ns, f.forms[form].most_ns}});
      if (!series.points.empty()) panel.series.push_back(series);
    }
    if (!panel.series.empty()) drawn.rows.push_back({panel});
  }
  return drawn;
}

}  // namespace mmverify::bench
