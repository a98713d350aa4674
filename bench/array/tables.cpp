#include "bench/array/tables.hpp"

namespace mmverify::bench {

Result array_tables(const std::vector<ArrayFigures>& figures, const ArrayBenchOptions& options) {
  using F = ArrayFigures;
  const std::string records = "records", times = "time a triangle";
  const Print ns{.digits = 0};
  const Fields<F> fields{
      {{.key = level(8), .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{positive("triangles", same), "triangles"}, [](const F& f) { return f.triangles; }},
      {{count("records.all", same, "without sharing"), "not shared", "", plain, records},
       [](const F& f) { return f.records_all; }},
      {{count("records.shared", same, "equal maps share one"), "shared", "", plain, records},
       [](const F& f) { return f.records_shared; }},
      {{count("records.merged", same, "with a bound of 4 micro-triangles a triangle"), "merged", "", plain,
        records},
       [](const F& f) { return f.records_merged; }},
      {{share("unknown_added", same, "share of all micro-triangles that merging made unknown"),
        "made unknown", "", percents(3)},
       [](const F& f) { return f.unknown_added; }},
      {{time("build_ns.shared", "ns a triangle"), "shared", "ns", ns, times},
       [](const F& f) { return f.shared_ns; }},
      {{time("build_ns.obvious", "ns a triangle"), "obvious", "ns", ns, times},
       [](const F& f) { return f.obvious_ns; }},
      {{time("build_ns.merged", "ns a triangle"), "merged", "ns", ns, times},
       [](const F& f) { return f.merged_ns; }},
      {{ratio("ratio_obvious_to_shared", speed_more, "of build_ns: the median of the rounds' ratios"),
        "obvious / shared", "", digits(2)},
       [](const F& f) { return f.obvious_over_shared; }},
  };
  return {.topic = "array",
          .description = "mmverify bench array: what sharing and merging of arrays save and cost",
          .settings = {{count("seed", setting, "of the maps that are generated"), options.seed}},
          .about =
              "Arrays of generated 4-state maps, a third of them equal to others, a third all but for three "
              "states; one thread. shared: equal\nmaps share a record; merged: with a bound of 4 "
              "micro-triangles a triangle, which may become unknown; obvious: shared by std::map",
          .tables = {table_of<F>({.key = "rows", .row = "one level, 4-state"}, fields, figures)}};
}

}  // namespace mmverify::bench
