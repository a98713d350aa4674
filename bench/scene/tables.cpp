#include "bench/scene/tables.hpp"

namespace mmverify::bench {

Result scene_bake_tables(const SceneBakeFigures& figures, const SceneBakeOptions& options) {
  using F = SceneBakeFigures;
  using L = SceneBakeLevel;
  const Fields<F> scene{
      {{text("file", left_out)}, [](const F& f) { return f.file; }},
      {{positive("triangles", same, "distinct by their texture coordinates"), "distinct triangles"},
       [](const F& f) { return f.triangles; }},
      {{time("ready_ms", "ms to make all textures ready, the median of the least rounds"),
        "textures made ready in", "ms"},
       [](const F& f) { return f.ready_ms; }},
  };
  const std::string times = "a micro-triangle", rates = "millions a second";
  const Fields<L> levels{
      {{.key = level(12), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{positive("micro_triangles", same, "of all triangles"), "micro-triangles"},
       [](const L& l) { return l.micro_triangles; }},
      {{positive("rounds", left_out, "of the timing"), "rounds"},
       [](const L& l) { return std::uint64_t{l.rounds}; }},
      {{time("ns", "ns a micro-triangle, ours, one thread, the median round"), "median", "ns", plain, times},
       [](const L& l) { return l.ns; }},
      {{time("fastest_ns", "the fastest round"), "fastest", "ns", plain, times},
       [](const L& l) { return l.fastest_ns; }},
      {{time("centre_ns",
             "ns a micro-triangle, one sample at its centre, the fastest round; 0 where no texture has 8 "
             "bits a texel"),
        "centre sample", "ns", plain, times},
       [](const L& l) { return l.ns_of_centres; }},
      {{"", "fastest", "", digits(1), rates}, [](const L& l) { return 1e3 / l.fastest_ns; }},
      {{"", "median", "", digits(1), rates}, [](const L& l) { return 1e3 / l.ns; }},
      {{ratio("ratio_centre_to_ours", speed_more, "centre_ns / fastest_ns"), "a centre sample, x ours"},
       [](const L& l) { return l.ns_of_centres / l.fastest_ns; }},
  };
  return {.topic = "scene",
          .description = "mmverify bench bake --scene FILE: how fast a scene's own triangles are baked",
          .settings = {{positive("rounds", setting, "of the timing, at least, a level"),
                        std::uint64_t{options.rounds}}},
          .about = figures.file +
                   ", one thread. fastest, centre sample: of the fastest round; others on a machine only "
                   "slow one down",
          .tables = {table_of<F>({.form = Form::members}, scene, {figures}),
                     table_of<L>({.key = "rows"}, levels, figures.levels)}};
}

}  // namespace mmverify::bench
