#include "bench/dag/tables.hpp"

#include <string>

#include "bench/dag/csm_tables.hpp"

namespace mmverify::bench {
namespace {

using F = DagFigures;

struct DagFormOf {
  DagForm form;
  DagFormFigures figures;
};

std::vector<DagFormOf> forms_of_dag(const F& f) {
  std::vector<DagFormOf> all;
  for (std::size_t k = 0; k < dag_forms; ++k) all.push_back({static_cast<DagForm>(k), f.forms[k]});
  return all;
}

Fields<DagFormOf> fields_of_form() {
  return {
      {{one_of("form", key, {"flat", "once", "paper", "ranked", "dag"}), "form"},
       [](const DagFormOf& f) { return to_string(f.form); }},
      {{count("bytes", about_less, "bytes of all maps, 8 a map for where it is included"), "all maps",
        "bytes"},
       [](const DagFormOf& f) { return f.figures.bytes; }},
      {{number("ns_per_lookup", left_out,
               "ns a lookup; independent random ones over all maps; 0: not measured"),
        "a lookup", "ns", digits(1)},
       [](const DagFormOf& f) { return f.figures.ns; }},
      {{time("least_ns_per_lookup", "ns a lookup of the fastest round; 0: not measured").if_any()},
       [](const DagFormOf& f) { return f.figures.least_ns; }},
      {{time("most_ns_per_lookup", "ns a lookup of the slowest round; 0: not measured").if_any()},
       [](const DagFormOf& f) { return f.figures.most_ns; }},
  };
}

}  // namespace

Result dag_tables(const std::vector<DagFigures>& figures, const DagBenchOptions& options) {
  const std::string arrays = "arrays of the graph", ratios = "ratios";
  const Print times{.digits = 1};
  const Fields<F> fields{
      {{.key = one_of("states", key, {2, 4}), .heading = "states", .leads = true},
       [](const F& f) { return f.bits == 1 ? 2u : 4u; }},
      {{.key = level(12), .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{positive("maps", same), "maps"}, [](const F& f) { return std::uint64_t{f.maps}; }},
      within<F, DagFormOf>(
          {.key = list("forms", "", {5, 5}), .heading = "forms", .within = RowLayout::beside},
          fields_of_form(), forms_of_dag),
      {{count("tile_bytes", about_less, "bytes of the graph's tiles"), "tiles", "bytes", {}, arrays},
       [](const F& f) { return f.tiles; }},
      {{count("node_bytes", about_less, "bytes of its nodes"), "nodes", "bytes", {}, arrays},
       [](const F& f) { return f.nodes; }},
      {{count("flat_bytes", about_less, "bytes of the maps that it lays flat"), "flat", "bytes", {}, arrays},
       [](const F& f) { return f.flat; }},
      {{number("memory_once_to_dag", about_more, "bytes of maps that are the same once / bytes of the graph"),
        "once / dag, memory", "", times, ratios},
       [](const F& f) { return f.once_over_dag; }},
      {{ratio("ratio_dag_to_flat", speed_less, "of ns a lookup: the median of the rounds' ratios"),
        "dag / flat, time", "", times, ratios},
       [](const F& f) { return f.dag_over_flat; }},
      {{number("build_rate", left_out, "M micro-triangles/s: millions of them a second, all maps added"),
        "added", "M micro-triangles/s", digits(0), "building"},
       [](const F& f) { return f.build_rate; }},
  };
  std::vector<CsmFigures> csm;
  for (const F& f : figures) csm.push_back(f.csm);
  return {.topic = "dag",
          .description = "mmverify bench dag: what the maps of a scene take, and a lookup in them",
          .settings = {{seed_of_all(), options.seed},
                       {positive("samples", setting, "lookups a level and format"), options.lookups}},
          .about =
              "Generated leaves, a fifth of the maps there twice; random lookups over all maps, one thread. "
              "flat: the array.\nonce: maps that are the same once. paper: the two bit sequences. ranked: "
              "impl/tree. dag: impl/dag.\nAll with 8 bytes a map for where it is; a time of 0: not measured",
          .tables = {table_of<F>({.key = "rows", .row = "one level and format"}, fields, figures),
                     csm_table(csm)},
          .drawn = dag_picture(figures)};
}

}  // namespace mmverify::bench
