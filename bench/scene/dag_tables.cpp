#include "bench/scene/dag_tables.hpp"

#include <string>

namespace mmverify::bench {
namespace {

using F = SceneDagFigures;

std::uint64_t states_of(std::uint32_t bits) { return std::uint64_t{1} << bits; }

Value if_any(const std::optional<double>& value) { return value ? Value(*value) : Value(); }

double to_bytes(const F& f, SceneForm a, SceneForm b) {
  return static_cast<double>(f.form(a).bytes) / static_cast<double>(f.form(b).bytes);
}

struct FormOf {
  SceneForm form;
  SceneFormFigures figures;
};

std::vector<FormOf> forms_of(const F& f) {
  std::vector<FormOf> all;
  for (std::size_t k = 0; k < scene_forms; ++k) all.push_back({static_cast<SceneForm>(k), f.forms[k]});
  return all;
}

Fields<FormOf> form_fields() {
  return {
      {{"form", "form"}, [](const FormOf& f) { return to_string(f.form); }},
      {{"bytes", "all maps", "bytes"}, [](const FormOf& f) { return f.figures.bytes; }},
      {{"ns_per_lookup", "a lookup", "ns", {.digits = 1}},
       [](const FormOf& f) { return if_any(f.figures.ns); }},
      {{"ratio_to_once", "x once, time", "", {.digits = 1}},
       [](const FormOf& f) { return if_any(f.figures.ns_to_once); }},
      {{"build_rate", "built", "M/s", {.digits = 0}},
       [](const FormOf& f) { return if_any(f.figures.build_rate); }},
  };
}

Table rows_table(const SceneDagScene& figures) {
  const std::string entropies = "entropy", ratios = "memory";
  const Print whole{.digits = 0}, times{.digits = 1};
  const Fields<F> fields{
      {{.key = "states", .heading = "states", .leads = true}, [](const F& f) { return states_of(f.bits); }},
      {{.key = "level", .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{"all", "of"}, [](const F& f) { return f.all; }},
      {{"taken", "taken"}, [](const F& f) { return f.taken; }},
      {{"uniform", "uniform"}, [](const F& f) { return f.uniform; }},
      {{"maps", "maps"}, [](const F& f) { return f.maps; }},
      {{"distinct", "distinct"}, [](const F& f) { return f.distinct; }},
      within<F, FormOf>({.key = "forms", .heading = "forms", .within = Within::beside}, form_fields(),
                        forms_of),
      {{"entropy_order_0_bytes", "order 0", "bytes", whole, entropies},
       [](const F& f) { return f.order_0_bytes; }},
      {{"entropy_after_16_bits_bytes", "after 16 bits", "bytes", whole, entropies},
       [](const F& f) { return if_any(f.context_bytes); }},
      {{"memory_flat_to_dag", "flat / dag", "", times, ratios},
       [](const F& f) { return to_bytes(f, SceneForm::flat, SceneForm::dag); }},
      {{"memory_once_to_dag", "once / dag", "", times, ratios},
       [](const F& f) { return to_bytes(f, SceneForm::once, SceneForm::dag); }},
      {{"memory_once_to_zstd", "once / zstd", "", times, ratios},
       [](const F& f) { return to_bytes(f, SceneForm::once, SceneForm::zstd); }},
      {{"", "once / after 16 bits", "", times, ratios},
       [](const F& f) -> Value {
         if (!f.context_bytes) return {};
         return static_cast<double>(f.form(SceneForm::once).bytes) / *f.context_bytes;
       }},
  };
  return table_of<F>({.key = "rows"}, fields, figures.rows);
}

Table squares_table(const SceneDagScene& figures) {
  using S = SquareFigures;
  const Fields<S> fields{
      {{.key = "form", .heading = "form", .leads = true}, [](const S& s) { return s.form; }},
      {{"level", "level"}, [](const S& s) { return s.level; }},
      {{"pairs", "pairs"}, [](const S& s) { return s.maps; }},
      {{"uniform", "uniform"}, [](const S& s) { return s.uniform; }},
      {{"bytes", "blocks", "bytes"}, [](const S& s) { return s.bytes; }},
      {{"flat_bytes", "flat, 4 states", "bytes"}, [](const S& s) { return s.flat_bytes; }},
      {{"regions", "regions"}, [](const S& s) { return s.regions; }},
      {{"substitutions", "lost"}, [](const S& s) { return s.substitutions; }},
      {{"ns_per_lookup", "a lookup", "ns", {.digits = 1}}, [](const S& s) { return s.ns; }},
      {{"build_rate", "built", "M regions/s", {.digits = 1}}, [](const S& s) { return s.build_rate; }},
  };
  return table_of<S>(
      {.key = "squares",
       .caption =
           figures.squares.empty()
               ? "VQ: no pair of triangles with a square of two states, or levels 4 and 5 not asked for"
               : "VQ of the pairs of triangles, which loses states; beside it both triangles' maps"},
      fields, figures.squares);
}

Table growth_table(const SceneDagScene& figures) {
  using G = SceneGrowth;
  const Fields<G> fields{
      {{.key = "states", .heading = "states", .leads = true}, [](const G& g) { return states_of(g.bits); }},
      {{.key = "form", .heading = "form", .leads = true}, [](const G& g) { return to_string(g.form); }},
      {{"levels", "levels"}, [](const G& g) { return std::uint64_t{g.growth.levels}; }},
      {{"last", "up to"}, [](const G& g) { return g.growth.last; }},
      {{"log2_a_level", "log2 a level"}, [](const G& g) { return g.growth.exponential.slope; }},
      {{"law", "bytes a map grow as"}, [](const G& g) { return area_or_outline(g.growth); }},
  };
  return table_of<G>({.key = "growth", .caption = "Growth over the last five levels"}, fields,
                     figures.growth);
}

}  // namespace

Result scene_dag_tables(const SceneDagScene& figures, const SceneDagOptions& options) {
  using S = SceneDagScene;
  const Fields<S> scene{
      {{"file"}, [](const S& s) { return s.file; }},
      {{"triangles", "triangles of meshes"}, [](const S& s) { return s.triangles; }},
      {{"distinct_triangles", "distinct by texture coordinates"}, [](const S& s) { return s.distinct; }},
      {{"maps", "maps, by order of vertices"}, [](const S& s) { return s.maps; }},
  };
  return {
      .topic = "scene_dag",
      .settings = {{"seed", options.seed}, {"samples", options.lookups}, {"memory", options.memory}},
      .about =
          figures.file +
          ", one thread. of: maps of the scene; taken: all, or, where 4-state maps would take more than " +
          std::to_string(options.memory) +
          " bytes,\nas many as fit, evenly by their number: a sample. uniform: of one state, so in no form. "
          "flat: a map for each triangle of a mesh.\nonce: maps that are the same once, as is all that "
          "follows. paper: two bit sequences a map. ranked: impl/tree. dag: impl/dag. These with\n8 bytes a "
          "map for where it is; lz4, zstd: all maps as one, no lookups. Entropy of the states of the "
          "distinct maps: order 0: each by\nits frequency; after 16 bits: by that after the 16 bits before "
          "it along the curve, no figure for fewer than 2^20 states",
      .tables = {table_of<S>({.form = Form::members}, scene, {figures}), rows_table(figures),
                 squares_table(figures), growth_table(figures)},
      .drawn = scene_dag_picture(figures)};
}

}  // namespace mmverify::bench
