#include "bench/dag/tables.hpp"

#include <string>

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
      {{"form", "form"}, [](const DagFormOf& f) { return to_string(f.form); }},
      {{"bytes", "all maps", "bytes"}, [](const DagFormOf& f) { return f.figures.bytes; }},
      {{"ns_per_lookup", "a lookup", "ns", {.digits = 1}}, [](const DagFormOf& f) { return f.figures.ns; }},
  };
}

}  // namespace

Result dag_tables(const std::vector<DagFigures>& figures, const DagBenchOptions& options) {
  const std::string arrays = "arrays of the graph", ratios = "ratios";
  const Print times{.digits = 1};
  const Fields<F> fields{
      {{.key = "states", .heading = "states", .leads = true},
       [](const F& f) { return f.bits == 1 ? 2u : 4u; }},
      {{.key = "level", .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{"maps", "maps"}, [](const F& f) { return std::uint64_t{f.maps}; }},
      within<F, DagFormOf>({.key = "forms", .heading = "forms", .within = Within::beside}, fields_of_form(),
                           forms_of_dag),
      {{"tile_bytes", "tiles", "bytes", {}, arrays}, [](const F& f) { return f.tiles; }},
      {{"node_bytes", "nodes", "bytes", {}, arrays}, [](const F& f) { return f.nodes; }},
      {{"flat_bytes", "flat", "bytes", {}, arrays}, [](const F& f) { return f.flat; }},
      {{"memory_once_to_dag", "once / dag, memory", "", times, ratios},
       [](const F& f) { return f.once_over_dag; }},
      {{"ratio_dag_to_flat", "dag / flat, time", "", times, ratios},
       [](const F& f) { return f.dag_over_flat; }},
      {{"build_rate", "added", "M micro-triangles/s", {.digits = 0}, "building"},
       [](const F& f) { return f.build_rate; }},
  };
  return {.topic = "dag",
          .settings = {{"seed", options.seed}, {"samples", options.lookups}},
          .about =
              "Generated leaves, a fifth of the maps there twice; random lookups over all maps, one thread. "
              "flat: the array.\nonce: maps that are the same once. paper: the two bit sequences. ranked: "
              "impl/tree. dag: impl/dag.\nAll with 8 bytes a map for where it is; a time of 0: not measured",
          .tables = {table_of<F>({.key = "rows"}, fields, figures)},
          .drawn = dag_picture(figures)};
}

}  // namespace mmverify::bench
