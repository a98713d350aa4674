#include "cli/render/path.hpp"

#include <fmt/format.h>

#include "bench/scene/path_tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/bench/tables.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "display/render/scene/path.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::cli {
namespace {

/// The reason why equal pictures are no evidence; empty if some ray met a triangle with micromaps.
std::string vacuous(const render::Path& path) {
  for (const render::PathRow& row : path.rows)
    if (row.counts.met != 0) return {};
  return path.rows.empty() ? "no method was compared; give more --memory or a lower --level"
                           : "no ray of any camera met a triangle with micromaps, so nothing was compared";
}

void say_what_differs(const render::Path& path, const PathRun& run) {
  for (const render::PathRow& row : path.rows)
    if (row.first)
      say(stderr, "refuted traverse.same_image {} {}{} camera {} seed {} pixel {},{}\n", run.scene.file,
          name_of(row.method), row.level ? fmt::format(" level {}", *row.level) : "", row.first->camera,
          run.seed, row.first->x, row.first->y);
}

}  // namespace

int render_path(const PathRun& run, const render::CompareOptions& options) {
  if (run.plan.triangles.empty())
    throw UsageError(
        fmt::format("{}: no triangle gets a micromap, so there is nothing to compare", run.scene.file));
  render::Path path;
  try {
    path = render::along_path(run.scene, run.plan, run.world, run.tracer, options.forms(), options.trace,
                              run.seed, run.cameras);
  } catch (const std::invalid_argument& error) {
    throw EnvironmentError(fmt::format("{}: {}", run.scene.file, error.what()));
  }
  run.ended();
  if (path.left_out.first)
    say(stderr, "render: maps of level {} would take {} bytes, more than --memory; left out from here on\n",
        *path.left_out.first, grouped(path.left_out.bytes));
  const auto tested = mmverify::scene::counts(run.plan);
  const bench::Result result = bench::path_tables({.file = run.scene.file,
                                                   .tested = tested.unique,
                                                   .tested_placed = tested.placed,
                                                   .width = options.trace.width,
                                                   .height = options.trace.height,
                                                   .seed = run.seed,
                                                   .threads = options.trace.threads,
                                                   .shadows = options.trace.shadows,
                                                   .ambient = options.trace.ambient,
                                                   .embree = render::embree_text(),
                                                   .path = &path});
  print_result(run.json.text(), result);
  run.json.write([&] { return result_json(result); });
  say_what_differs(path, run);
  for (const render::PathRow& row : path.rows)
    if (row.differing != 0) return failed;
  if (const std::string nothing = vacuous(path); !nothing.empty())
    throw UsageError(fmt::format("{}: {}", run.scene.file, nothing));
  return complete;
}

}  // namespace mmverify::cli
