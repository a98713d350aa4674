#include "cli/bench/baker.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/scene/loaded.hpp"
#include "proofs/scene/subject_maps.hpp"
#include "scene/pipeline.hpp"
#include "subjects/dock/worker.hpp"

namespace mmverify::cli {
namespace {

using mmverify::scene::Scene;

bench::BakerLevel figures_at(const Scene& loaded, const proofs::bake::BakeSubjectPtr& baker, unsigned level) {
  mmverify::scene::PipelineOptions pipeline;
  pipeline.levels.level = level;
  pipeline.bake.done = [](std::uint64_t) { stop_if_asked(); };
  const auto made = mmverify::scene::make_micromaps(loaded, pipeline);
  const proofs::scene::Data data{loaded, made.plan, made.baked, made.arrays, made.pairs, made.squares};
  const proofs::scene::SubjectMaps maps(data, baker);
  for (std::size_t t = 0; t < made.plan.triangles.size(); ++t) {
    stop_if_asked();
    if (maps.asks(t)) maps.wrong(t);
  }
  const proofs::scene::SubjectTotals sum = maps.totals();
  return {.level = level,
          .triangles = sum.triangles,
          .outside = sum.outside,
          .declined = sum.declined,
          .micro_triangles = sum.micro_triangles,
          .wrong = sum.wrong_known,
          .needless = sum.needless_unknown,
          .ns = sum.ns,
          .our_ns = sum.our_ns};
}

}  // namespace

bench::BakerFigures baker_figures(const BenchOptions& options, const proofs::Levels& levels) {
  const auto progress = progress_of("baker", options);
  const auto baker = parse_baker(options.subject, mmverify::dock::Options().timeout_seconds);
  const Scene loaded = loaded_scene(options.scene.empty() ? options.textures : options.scene);
  bench::BakerFigures figures{baker->name(), loaded.file, {}};
  for (unsigned level = levels.first; level <= levels.last; ++level) {
    progress(fmt::format("level {}", level));
    try {
      figures.levels.push_back(figures_at(loaded, baker, level));
    } catch (const std::invalid_argument& error) {
      throw EnvironmentError(fmt::format("{}: {}", loaded.file, error.what()));
    } catch (const proofs::SubjectBroken& broken) {
      throw EnvironmentError(fmt::format("{}: {}", options.subject, broken.what()));
    }
    if (figures.levels.back().triangles == 0) throw UsageError(loaded.file + ": nothing to bake");
  }
  return figures;
}

}  // namespace mmverify::cli
