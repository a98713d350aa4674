// The benches of topics: one table.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/index/bench.hpp"
#include "bench/result.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// What is asked for on the command line.
struct BenchOptions {
  std::vector<std::string> topics;
  std::string json, plot, levels, subject, scene, textures;
  bench::IndexBenchOptions index;
  std::size_t maps = 0;      ///< 0: the topic's own number
  std::uint64_t memory = 0;  ///< of bench dag --scene; 0: its own
  bool quiet = false, sweep = false;
  unsigned threads = 0;
  std::uint32_t device = 0;  ///< of bench shaders
};

inline constexpr std::uint64_t most_lookups = std::uint64_t{1} << 26;  ///< 8 bytes each

struct BenchTopic {
  const char* name;                           ///< as proofs::Topic::bench has it
  std::optional<proofs::Levels> levels = {};  ///< where none are asked for; none: it has no levels
  proofs::Level highest = 0;
  bool reads_textures = false;
  bool makes_maps = false;  ///< as many as --maps says
  std::uint64_t most_samples = ~std::uint64_t{0};
  /// std::runtime_error is of the environment.
  bench::Result (*measure)(const BenchOptions& options, const proofs::Levels& levels) = nullptr;
};

/// In the order in which they run.
std::span<const BenchTopic> bench_topics();

/// Throws proofs::Interrupted, EnvironmentError.
bench::Result measured(const BenchTopic& topic, const BenchOptions& options, const proofs::Levels& levels);

/// Half a bench is none: throws proofs::Interrupted.
void stop_if_asked();

/// Told what begins: says so on stderr, unless quiet, and stops where that is asked for.
std::function<void(const std::string&)> progress_of(const char* bench, const BenchOptions& options);

}  // namespace mmverify::cli
