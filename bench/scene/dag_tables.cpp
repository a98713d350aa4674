#include "bench/scene/dag_tables.hpp"

#include <string>

#include "bench/dag/csm_tables.hpp"

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
      {{one_of(
            "form", key, {"flat", "once", "paper", "ranked", "dag", "lz4", "zstd"},
            "flat: a map for each triangle of a mesh; once: maps that are the same once, and so the others; "
            "paper: two bit sequences a map; ranked: impl/tree; dag: impl/dag; lz4, zstd: all maps as one"),
        "form"},
       [](const FormOf& f) { return to_string(f.form); }},
      {{count("bytes", about_less,
              "bytes of all maps, 8 a map for where it is included, but for lz4 and zstd"),
        "all maps", "bytes"},
       [](const FormOf& f) { return f.figures.bytes; }},
      {{time("ns_per_lookup", "ns a lookup, where the form has one; independent random ones over all maps")
            .if_any(),
        "a lookup", "ns", digits(1)},
       [](const FormOf& f) { return if_any(f.figures.ns); }},
      {{ratio("ratio_to_once", speed_less, "of ns a lookup: the median of the rounds' ratios").if_any(),
        "x once, time", "", digits(1)},
       [](const FormOf& f) { return if_any(f.figures.ns_to_once); }},
      {{number("build_rate", left_out,
               "M/s: millions of micro-triangles a second, from flat maps, one thread")
            .if_any(),
        "built", "M/s", digits(0)},
       [](const FormOf& f) { return if_any(f.figures.build_rate); }},
  };
}

Table rows_table(const SceneDagScene& figures) {
  const std::string entropies = "entropy", ratios = "memory";
  const Print whole{.digits = 0}, times{.digits = 1};
  const Fields<F> fields{
      {{.key = one_of("states", key, {2, 4}), .heading = "states", .leads = true},
       [](const F& f) { return states_of(f.bits); }},
      {{.key = level(12), .heading = "level", .leads = true}, [](const F& f) { return f.level; }},
      {{positive("all", same,
                 "maps of the scene: distinct triangles, each in each order of its vertices that is in use"),
        "of"},
       [](const F& f) { return f.all; }},
      {{positive("taken", same,
                 "of these, those that the row is about: all, or as many as fit tool.memory, evenly by their "
                 "number"),
        "taken"},
       [](const F& f) { return f.taken; }},
      {{count("uniform", same, "of those taken, of one state: in no form"), "uniform"},
       [](const F& f) { return f.uniform; }},
      {{positive("maps", same, "the others"), "maps"}, [](const F& f) { return f.maps; }},
      {{positive("distinct", same, "of these, by their bytes"), "distinct"},
       [](const F& f) { return f.distinct; }},
      within<F, FormOf>({.key = list("forms", "", {7, 7}), .heading = "forms", .within = RowLayout::beside},
                        form_fields(), forms_of),
      {{number("entropy_order_0_bytes", about,
               "bytes: the entropy of the distinct maps' states, each by its frequency"),
        "order 0", "bytes", whole, entropies},
       [](const F& f) { return f.order_0_bytes; }},
      {{number("entropy_after_16_bits_bytes", about,
               "bytes: the same, by the frequency after the 16 bits before it in its map; not there for "
               "fewer than 2^20 states")
            .if_any(),
        "after 16 bits", "bytes", whole, entropies},
       [](const F& f) { return if_any(f.context_bytes); }},
      {{number("memory_flat_to_dag", about_more, "bytes of flat / bytes of the graph"), "flat / dag", "",
        times, ratios},
       [](const F& f) { return to_bytes(f, SceneForm::flat, SceneForm::dag); }},
      {{number("memory_once_to_dag", about_more, "bytes of once / bytes of the graph"), "once / dag", "",
        times, ratios},
       [](const F& f) { return to_bytes(f, SceneForm::once, SceneForm::dag); }},
      {{number("memory_once_to_zstd", about, "bytes of once / bytes of zstd"), "once / zstd", "", times,
        ratios},
       [](const F& f) { return to_bytes(f, SceneForm::once, SceneForm::zstd); }},
      {{"", "once / after 16 bits", "", times, ratios},
       [](const F& f) -> Value {
         if (!f.context_bytes) return {};
         return static_cast<double>(f.form(SceneForm::once).bytes) / *f.context_bytes;
       }},
  };
  return table_of<F>({.key = "rows", .row = "one level and format"}, fields, figures.rows);
}

Table squares_table(const SceneDagScene& figures) {
  using S = SquareFigures;
  const Fields<S> fields{
      {{.key = one_of("form", key, {"vq2", "vq4"}), .heading = "form", .leads = true},
       [](const S& s) { return s.form; }},
      {{one_of("level", same, {4, 5}), "level"}, [](const S& s) { return s.level; }},
      {{positive("pairs", same, "distinct pairs of triangles"), "pairs"}, [](const S& s) { return s.maps; }},
      {{count("uniform", same, "of these, those whose square has one state, and no block"), "uniform"},
       [](const S& s) { return s.uniform; }},
      {{count("bytes", about_less, "bytes of the others' blocks, 8 a block for where it is included"),
        "blocks", "bytes"},
       [](const S& s) { return s.bytes; }},
      {{count("flat_bytes", same,
              "bytes of the same pairs' 4-state maps, two a pair, 8 a map for where it is included"),
        "flat, 4 states", "bytes"},
       [](const S& s) { return s.flat_bytes; }},
      {{count("regions", same, "of the squares that have a block"), "regions"},
       [](const S& s) { return s.regions; }},
      {{count("substitutions", less, "of these, O or T that became unknown"), "lost"},
       [](const S& s) { return s.substitutions; }},
      {{time("ns_per_lookup", "ns a lookup; independent random ones over all blocks"), "a lookup", "ns",
        digits(1)},
       [](const S& s) { return s.ns; }},
      {{number("build_rate", left_out, "M regions/s: millions of regions a second, one thread"), "built",
        "M regions/s", digits(1)},
       [](const S& s) { return s.build_rate; }},
  };
  return table_of<S>(
      {.key = list("squares", "", {}),
       .caption =
           figures.squares.empty()
               ? "VQ: no pair of triangles with a square of two states, or levels 4 and 5 not asked for"
               : "VQ of the pairs of triangles, which loses states; beside it both triangles' maps"},
      fields, figures.squares);
}

Table growth_table(const SceneDagScene& figures) {
  using G = SceneGrowth;
  const Fields<G> fields{
      {{.key = one_of("states", key, {2, 4}), .heading = "states", .leads = true},
       [](const G& g) { return states_of(g.bits); }},
      {{.key = one_of("form", key, {"flat", "once", "paper", "ranked", "dag", "lz4", "zstd"}),
        .heading = "form",
        .leads = true},
       [](const G& g) { return to_string(g.form); }},
      {{count("levels", same, "how many the line was drawn through, the last five at most"), "levels"},
       [](const G& g) { return std::uint64_t{g.growth.levels}; }},
      {{whole("last", same, {0, 12}, "the finest of them"), "up to"},
       [](const G& g) { return g.growth.last; }},
      {{real("log2_a_level", about, {},
             "slope of log2 of the bytes a map against the level: 2 of what grows with the area, 1 of what "
             "grows with the outline"),
        "log2 a level"},
       [](const G& g) { return g.growth.exponential.slope; }},
      {{text("law", left_out, "the same in words"), "bytes a map grow as"},
       [](const G& g) { return area_or_outline(g.growth); }},
  };
  return table_of<G>({.key = "growth", .caption = "Growth over the last five levels"}, fields,
                     figures.growth);
}

}  // namespace

Result scene_dag_tables(const SceneDagScene& figures, const SceneDagOptions& options) {
  using S = SceneDagScene;
  const Fields<S> scene{
      {{text("file", left_out)}, [](const S& s) { return s.file; }},
      {{positive("triangles", same, "of meshes, with a map"), "triangles of meshes"},
       [](const S& s) { return s.triangles; }},
      {{positive("distinct_triangles", same, "by their texture coordinates"),
        "distinct by texture coordinates"},
       [](const S& s) { return s.distinct; }},
      {{positive("maps", same, "distinct triangles, each in each order of its vertices that is in use"),
        "maps, by order of vertices"},
       [](const S& s) { return s.maps; }},
  };
  std::vector<CsmFigures> csm;
  for (const F& f : figures.rows) csm.push_back(f.csm);
  return {
      .topic = "scene_dag",
      .description =
          "mmverify bench dag --scene FILE: what the maps of a scene take in each form, and a lookup in them",
      .settings = {{count("seed", setting, "of the lookups"), options.seed},
                   {positive("samples", setting, "lookups a level and format"), options.lookups},
                   {positive("memory", setting,
                             "bytes of a level's 4-state maps, beyond which some maps are taken"),
                    options.memory}},
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
      .tables = {table_of<S>({.form = Form::members}, scene, {figures}), rows_table(figures), csm_table(csm),
                 merged_levels_table(csm, figures.merged), squares_table(figures), growth_table(figures)},
      .drawn = scene_dag_picture(figures)};
}

}  // namespace mmverify::bench
