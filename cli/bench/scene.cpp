#include "cli/bench/scene.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/scene/bake.hpp"
#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/read/bad_scene.hpp"

namespace mmverify::cli {
namespace {

constexpr std::size_t rounds = 5;

bench::SceneBakeFigures figures_of(const std::string& file, const proofs::Levels& levels, bool quiet) {
  const auto stop = [] {
    if (proofs::interrupted()) throw proofs::Interrupted();
  };
  const auto progress = [quiet](const std::string& what) {
    if (!quiet) fmt::print(stderr, "bench scene: {}\n", what);
  };
  try {
    bench::SceneBakeOptions options{file, levels.first, levels.last};
    options.rounds = rounds;
    options.progress = progress;
    options.stop = stop;
    return bench::scene_bake_figures(options);
  } catch (const mmverify::scene::BadScene& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace

std::string bench_scene(const std::string& file, const proofs::Levels& levels, bool quiet, std::FILE* out) {
  const bench::SceneBakeFigures figures = figures_of(file, levels, quiet);
  if (figures.triangles == 0) throw UsageError(file + ": nothing to bake");
  fmt::print(out,
             "{}: {} distinct triangles, one thread; textures made ready in {:.2f} ms\n"
             "millions/s and ns: of the fastest round; others on a machine only slow one down\n\n"
             "{:>5}{:>18}{:>8}{:>10}{:>12}{:>16}{:>26}\n",
             figures.file, grouped(figures.triangles), figures.ready_ms, "level", "micro-triangles", "rounds",
             "ns each", "millions/s", "of the median", "a centre sample, x ours");
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const bench::SceneBakeLevel& level : figures.levels) {
    const double ratio = level.ns_of_centres / level.fastest_ns;
    fmt::print(out, "{:>5}{:>18}{:>8}{:>10.2f}{:>12.1f}{:>16.1f}{:>26.2f}\n", level.level,
               grouped(level.micro_triangles), level.rounds, level.fastest_ns, 1e3 / level.fastest_ns,
               1e3 / level.ns, ratio);
    rows.push_back({{"level", level.level},
                    {"micro_triangles", level.micro_triangles},
                    {"rounds", level.rounds},
                    {"ns", level.ns},
                    {"fastest_ns", level.fastest_ns},
                    {"centre_ns", level.ns_of_centres},
                    {"ratio_centre_to_ours", ratio}});
  }
  const Json j{{"schema", "mmverify.bench/1"},
               {"topic", "scene"},
               {"tool", tool({{"rounds", rounds}})},
               {"file", figures.file},
               {"triangles", figures.triangles},
               {"ready_ms", figures.ready_ms},
               {"rows", rows}};
  return j.dump(1) + "\n";
}

}  // namespace mmverify::cli
