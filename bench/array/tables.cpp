#include "bench/array/tables.hpp"

namespace mmverify::bench {

Result array_tables(const std::vector<ArrayFigures>& figures, const ArrayBenchOptions& options) {
  using F = ArrayFigures;
  const std::string records = "records", times = "time a triangle";
  const Print ns{.digits = 0};
  const Fields<F> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{"triangles", "triangles"}, [](const F& f) { return f.triangles; }},
      {{"records.all", "not shared", "", {}, records}, [](const F& f) { return f.records_all; }},
      {{"records.shared", "shared", "", {}, records}, [](const F& f) { return f.records_shared; }},
      {{"records.merged", "merged", "", {}, records}, [](const F& f) { return f.records_merged; }},
      {{"unknown_added", "made unknown", "", {.digits = 3, .factor = per_cent, .unit = "%"}},
       [](const F& f) { return f.unknown_added; }},
      {{"build_ns.shared", "shared", "ns", ns, times}, [](const F& f) { return f.shared_ns; }},
      {{"build_ns.obvious", "obvious", "ns", ns, times}, [](const F& f) { return f.obvious_ns; }},
      {{"build_ns.merged", "merged", "ns", ns, times}, [](const F& f) { return f.merged_ns; }},
      {{"ratio_obvious_to_shared", "obvious / shared", "", {.digits = 2}},
       [](const F& f) { return f.obvious_over_shared; }},
  };
  return {.topic = "array",
          .settings = {{"seed", options.seed}},
          .about =
              "Arrays of generated 4-state maps, a third of them equal to others, a third all but for three "
              "states; one thread. shared: equal\nmaps share a record; merged: with a bound of 4 "
              "micro-triangles a triangle, which may become unknown; obvious: shared by std::map",
          .tables = {table_of<F>({.key = "rows"}, fields, figures)}};
}

}  // namespace mmverify::bench
