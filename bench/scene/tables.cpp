#include "bench/scene/tables.hpp"

namespace mmverify::bench {

Result scene_bake_tables(const SceneBakeFigures& figures, const SceneBakeOptions& options) {
  using F = SceneBakeFigures;
  using L = SceneBakeLevel;
  const Fields<F> scene{
      {{"file"}, [](const F& f) { return f.file; }},
      {{"triangles", "distinct triangles"}, [](const F& f) { return f.triangles; }},
      {{"ready_ms", "textures made ready in", "ms"}, [](const F& f) { return f.ready_ms; }},
  };
  const std::string times = "a micro-triangle", rates = "millions a second";
  const Fields<L> levels{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{"micro_triangles", "micro-triangles"}, [](const L& l) { return l.micro_triangles; }},
      {{"rounds", "rounds"}, [](const L& l) { return std::uint64_t{l.rounds}; }},
      {{"ns", "median", "ns", {}, times}, [](const L& l) { return l.ns; }},
      {{"fastest_ns", "fastest", "ns", {}, times}, [](const L& l) { return l.fastest_ns; }},
      {{"centre_ns", "centre sample", "ns", {}, times}, [](const L& l) { return l.ns_of_centres; }},
      {{"", "fastest", "", {.digits = 1}, rates}, [](const L& l) { return 1e3 / l.fastest_ns; }},
      {{"", "median", "", {.digits = 1}, rates}, [](const L& l) { return 1e3 / l.ns; }},
      {{"ratio_centre_to_ours", "a centre sample, x ours"},
       [](const L& l) { return l.ns_of_centres / l.fastest_ns; }},
  };
  return {.topic = "scene",
          .settings = {{"rounds", std::uint64_t{options.rounds}}},
          .about = figures.file +
                   ", one thread. fastest, centre sample: of the fastest round; others on a machine only "
                   "slow one down",
          .tables = {table_of<F>({.form = Form::members}, scene, {figures}),
                     table_of<L>({.key = "rows"}, levels, figures.levels)}};
}

}  // namespace mmverify::bench
