#include "cli/bench/topics.hpp"

#include "bench/bake/bench.hpp"
#include "bench/tree/bench.hpp"
#include "bench/vq/bench.hpp"
#include "cli/bench/bake.hpp"
#include "cli/bench/index.hpp"
#include "cli/bench/tree.hpp"
#include "cli/bench/vq.hpp"

namespace mmverify::cli {
namespace {

using proofs::Levels;

BenchOutput of_index(const BenchOptions& options, const Levels& levels, std::FILE* out) {
  bench::IndexBenchOptions index = options.index;
  index.first = levels.first;
  index.last = levels.last;
  return bench_index(index, options.quiet, out);
}

BenchOutput of_tree(const BenchOptions& options, const Levels& levels, std::FILE* out) {
  return bench_tree({.first = levels.first,
                     .last = levels.last,
                     .seed = options.index.seed,
                     .lookups = options.index.samples,
                     .textures = options.textures},
                    options.quiet, out);
}

BenchOutput of_vq(const BenchOptions& options, const Levels&, std::FILE* out) {
  return bench_vq({.seed = options.index.seed,
                   .maps = options.maps == 0 ? bench::VqBenchOptions{}.maps : options.maps,
                   .textures = options.textures},
                  options.quiet, out);
}

BenchOutput of_bake(const BenchOptions& options, const Levels& levels, std::FILE* out) {
  return bench_bake({.first = levels.first,
                     .last = levels.last,
                     .seed = options.index.seed,
                     .maps = options.maps == 0 ? bench::BakeBenchOptions{}.maps : options.maps,
                     .textures = options.textures},
                    options.quiet, out);
}

/// The levels that a bench has where none are asked for.
template <class Options>
Levels levels_of() {
  const Options options;
  return {options.first, options.last};
}

constexpr std::uint64_t most_lookups = std::uint64_t{1} << 26;  // 8 bytes each

}  // namespace

std::span<const BenchTopic> bench_topics() {
  static const std::vector<BenchTopic> table{
      {.name = "index", .levels = levels_of<bench::IndexBenchOptions>(), .highest = 16, .run = of_index},
      {.name = "tree",
       .levels = levels_of<bench::TreeBenchOptions>(),
       .highest = bench::TreeBenchOptions{}.last,
       .reads_textures = true,
       .most_samples = most_lookups,
       .run = of_tree},
      {.name = "vq", .reads_textures = true, .run = of_vq},
      {.name = "bake",
       .levels = levels_of<bench::BakeBenchOptions>(),
       .highest = 12,
       .reads_textures = true,
       .run = of_bake},
  };
  return table;
}

}  // namespace mmverify::cli
