// The table of topics that have a bench.
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

/// The options of mmverify bench.
struct BenchOptions {
  std::vector<std::string> topics;
  std::string json, csv, plot, levels, subject, scene, textures;
  bench::IndexBenchOptions index;
  std::size_t maps = 0;      ///< 0 for the topic's default
  std::uint64_t memory = 0;  ///< for bench dag --scene; 0 for its default
  bool quiet = false, sweep = false;
  unsigned threads = 0;
  std::uint32_t device = 0;  ///< for bench shaders
  std::uint64_t hits = 0;    ///< for bench shaders: of a dispatch, at most; 0 for its default
};

inline constexpr std::uint64_t most_lookups = std::uint64_t{1} << 26;  ///< 8 bytes each
inline constexpr std::uint64_t most_stiff_points = std::uint64_t{1}
                                                   << 24;  ///< 32 bytes each, of two kinds at once

struct BenchTopic {
  const char* name;                           ///< as in proofs::Topic::bench, if a topic has it
  std::optional<proofs::Levels> levels = {};  ///< default levels; none if the topic has no levels
  proofs::Level highest = 0;
  unsigned seconds = 0;  ///< at its default levels, on a quiet machine with two cores, about
  bool reads_textures = false;
  bool makes_maps = false;  ///< their number is --maps
  bool draws = true;        ///< the figures have a picture, for --plot
  std::uint64_t most_samples = ~std::uint64_t{0};
  /// Runs the bench. A std::runtime_error counts as EnvironmentError.
  bench::Result (*measure)(const BenchOptions& options, const proofs::Levels& levels) = nullptr;
};

/// The topics in the order in which they run.
std::span<const BenchTopic> bench_topics();

/// Throws proofs::Interrupted, EnvironmentError.
bench::Result measured(const BenchTopic& topic, const BenchOptions& options, const proofs::Levels& levels);

/// Throws proofs::Interrupted after an interrupt: a partial bench is no result.
void stop_if_asked();

/// A progress callback: prints each step's name on stderr, unless quiet, and stops after an interrupt.
std::function<void(const std::string&)> progress_of(const char* bench, const BenchOptions& options);

}  // namespace mmverify::cli
