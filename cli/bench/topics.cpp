#include "cli/bench/topics.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/array/tables.hpp"
#include "bench/attribute/tables.hpp"
#include "bench/bake/tables.hpp"
#include "bench/dag/tables.hpp"
#include "bench/index/tables.hpp"
#include "bench/index/times.hpp"
#include "bench/stiff/tables.hpp"
#include "bench/subdivision/tables.hpp"
#include "bench/tree/tables.hpp"
#include "bench/vq/tables.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/progress.hpp"

namespace mmverify::cli {
namespace {

using bench::Result;

Result of_index(const BenchOptions& given, const proofs::Levels& levels) {
  bench::IndexBenchOptions options = given.index;
  options.first = levels.first;
  options.last = levels.last;
  std::vector<bench::IndexFigures> figures;
  {
    proofs::Progress progress(index_points(options), !given.quiet);
    progress.now("bench index");
    options.progress = [&progress](std::uint64_t points) {
      stop_if_asked();
      progress.add(points);
    };
    figures = index_errors(options);
  }
  // Times are measured here, while no other work runs.
  add_index_times(options, figures);
  return index_tables(figures, options);
}

Result of_tree(const BenchOptions& given, const proofs::Levels& levels) {
  const bench::TreeBenchOptions options{.first = levels.first,
                                        .last = levels.last,
                                        .seed = given.index.seed,
                                        .lookups = given.index.samples,
                                        .textures = given.textures,
                                        .progress = progress_of("tree", given)};
  return tree_tables(tree_figures(options), options);
}

Result of_dag(const BenchOptions& given, const proofs::Levels& levels) {
  const bench::DagBenchOptions options{.first = levels.first,
                                       .last = levels.last,
                                       .seed = given.index.seed,
                                       .lookups = given.index.samples,
                                       .progress = progress_of("dag", given)};
  return dag_tables(dag_figures(options), options);
}

Result of_vq(const BenchOptions& given, const proofs::Levels&) {
  const bench::VqBenchOptions options{.seed = given.index.seed,
                                      .maps = given.maps == 0 ? bench::VqBenchOptions{}.maps : given.maps,
                                      .textures = given.textures,
                                      .progress = progress_of("vq", given)};
  return vq_tables(vq_figures(options), options);
}

Result of_bake(const BenchOptions& given, const proofs::Levels& levels) {
  const bench::BakeBenchOptions options{.first = levels.first,
                                        .last = levels.last,
                                        .seed = given.index.seed,
                                        .maps = given.maps == 0 ? bench::BakeBenchOptions{}.maps : given.maps,
                                        .textures = given.textures,
                                        .progress = progress_of("bake", given)};
  return bake_tables(bake_figures(options), options);
}

Result of_attribute(const BenchOptions& given, const proofs::Levels& levels) {
  bench::AttributeBenchOptions options{.first = levels.first,
                                       .last = levels.last,
                                       .samples = given.index.samples,
                                       .seed = given.index.seed,
                                       .progress = progress_of("attribute", given)};
  return attribute_tables(attribute_figures(options), options);
}

Result of_array(const BenchOptions& given, const proofs::Levels& levels) {
  const bench::ArrayBenchOptions options{.first = levels.first,
                                         .last = levels.last,
                                         .seed = given.index.seed,
                                         .progress = progress_of("array", given)};
  return array_tables(array_figures(options), options);
}

Result of_subdivision(const BenchOptions& given, const proofs::Levels& levels) {
  const bench::SubdivisionBenchOptions options{.first = levels.first,
                                               .last = levels.last,
                                               .seed = given.index.seed,
                                               .progress = progress_of("subdivision", given)};
  return subdivision_tables(subdivision_times(options), displacement_sizes(options), options);
}

Result of_stiff(const BenchOptions& given, const proofs::Levels&) {
  const bench::StiffBenchOptions options{
      .samples = given.index.samples, .seed = given.index.seed, .progress = progress_of("stiff", given)};
  return stiff_tables(stiff_figures(options), options);
}

/// The default levels of a bench.
template <class Options>
proofs::Levels levels_of() {
  const Options options;
  return {options.first, options.last};
}

}  // namespace

void stop_if_asked() {
  if (proofs::interrupted()) throw proofs::Interrupted();
}

std::function<void(const std::string&)> progress_of(const char* bench, const BenchOptions& options) {
  return [bench, quiet = options.quiet](const std::string& what) {
    stop_if_asked();
    if (!quiet) say(stderr, "bench {}: {}\n", bench, what);
  };
}

std::span<const BenchTopic> bench_topics() {
  static const std::vector<BenchTopic> table{
      {.name = "index",
       .levels = levels_of<bench::IndexBenchOptions>(),
       .highest = 16,
       .seconds = 50,
       .measure = of_index},
      {.name = "tree",
       .levels = levels_of<bench::TreeBenchOptions>(),
       .highest = bench::TreeBenchOptions{}.last,
       .seconds = 190,
       .reads_textures = true,
       .most_samples = most_lookups,
       .measure = of_tree},
      {.name = "dag",
       .levels = levels_of<bench::DagBenchOptions>(),
       .highest = 12,
       .seconds = 35,
       .most_samples = most_lookups,
       .measure = of_dag},
      {.name = "vq", .seconds = 85, .reads_textures = true, .makes_maps = true, .measure = of_vq},
      {.name = "bake",
       .levels = levels_of<bench::BakeBenchOptions>(),
       .highest = 12,
       .seconds = 4,
       .reads_textures = true,
       .makes_maps = true,
       .measure = of_bake},
      {.name = "attribute",
       .levels = levels_of<bench::AttributeBenchOptions>(),
       .highest = 16,
       .seconds = 9,
       .most_samples = most_lookups,
       .measure = of_attribute},
      {.name = "array",
       .levels = levels_of<bench::ArrayBenchOptions>(),
       .highest = 8,
       .seconds = 5,
       .draws = false,
       .measure = of_array},
      {.name = "subdivision",
       .levels = levels_of<bench::SubdivisionBenchOptions>(),
       .highest = bench::SubdivisionBenchOptions{}.last,
       .seconds = 1,
       .draws = false,
       .measure = of_subdivision},
      {.name = "stiff", .seconds = 105, .most_samples = most_stiff_points, .measure = of_stiff},
  };
  return table;
}

Result measured(const BenchTopic& topic, const BenchOptions& options, const proofs::Levels& levels) {
  try {
    Result result = topic.measure(options, levels);
    stop_if_asked();
    return result;
  } catch (const UsageError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace mmverify::cli
