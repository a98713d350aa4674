#include "bench/index/times.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "bench/index/subjects.hpp"
#include "bench/timing.hpp"

namespace mmverify::bench {
namespace {

constexpr std::string_view baseline = "reference-f32";

template <class Q>
struct Points {
  std::vector<Q> u, v;
  std::vector<std::uint32_t> out;

  explicit Points(std::uint64_t seed) {
    // 24 KiB of binary32: inputs and outputs stay in the first-level cache.
    constexpr std::size_t count = slow<Q> ? 64 : 2048;
    IndexInputs inputs(received_by<Q>, Inputs::uniform, 0, seed);
    StiffRecipe kind{};
    for (std::size_t k = 0; k < count; ++k) {
      const InputPoint p = inputs.next(kind);
      u.push_back(received<Q>(p.u));
      v.push_back(received<Q>(p.v));
    }
    out.resize(count);
  }
};

/// The number of passes that last about a millisecond: long against the clock's steps, short enough for
/// eleven rounds.
template <class Pass>
benchmark::IterationCount passes(Pass pass) {
  using Clock = std::chrono::steady_clock;
  pass();  // warms the caches
  const auto start = Clock::now();
  pass();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return static_cast<benchmark::IterationCount>(std::clamp(1e-3 / std::max(seconds, 1e-9), 1.0, 1e6));
}

std::string row_name(std::string_view subject, std::uint32_t level) {
  return std::string(subject).append("/").append(std::to_string(level));
}

// A reporter that keeps the times by name instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred)
        throw std::runtime_error("index bench: " + run.run_name.function_name + ": " + run.error_message);
      ns_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime() / run.counters.at("points"));
    }
  }
  const std::vector<double>& ns(const std::string& name, std::size_t rounds) const {
    const auto found = ns_.find(name);
    if (found == ns_.end() || found->second.size() != rounds)
      throw std::runtime_error("index bench: " + name + " was not measured in every round");
    return found->second;
  }

 private:
  std::map<std::string, std::vector<double>> ns_;
};

/// The levels that are timed: 4, 10, 16 and, for binary16, 15, as far as they are in the range, and the last
/// level.
std::set<std::uint32_t> timed_levels(const IndexBenchOptions& options) {
  std::set<std::uint32_t> levels{options.last};
  for (const std::uint32_t level : {4u, 10u, 15u, 16u})
    if (level >= options.first && level <= options.last) levels.insert(level);
  return levels;
}

template <class Q>
void register_subjects(const std::set<std::uint32_t>& levels, std::uint64_t seed) {
  const auto points = std::make_shared<Points<Q>>(seed);
  for (const IndexSubject<Q>& subject : index_subjects<Q>()) {
    for (const std::uint32_t level : levels) {
      if (level > subject.max_level) continue;
      const auto pass = [points, level, loop = subject.timed] {
        loop(points->u, points->v, level, points->out);
        benchmark::DoNotOptimize(points->out.data());
        benchmark::ClobberMemory();
      };
      const auto measure = [pass, count = points->out.size()](benchmark::State& state) {
        for ([[maybe_unused]] auto one : state) pass();
        state.counters["points"] = static_cast<double>(count);
      };
      benchmark::RegisterBenchmark(row_name(subject.name, level).c_str(), measure)->Iterations(passes(pass));
    }
  }
}

}  // namespace

void add_index_times(const IndexBenchOptions& options, std::vector<IndexFigures>& figures) {
  const std::size_t rounds = std::max<std::size_t>(options.rounds, 1);
  const std::set<std::uint32_t> levels = timed_levels(options);
  register_subjects<impl::Binary16>(levels, options.seed);
  register_subjects<float>(levels, options.seed);
  register_subjects<double>(levels, options.seed);
  register_subjects<spec::Fixed64>(levels, options.seed);
  register_subjects<spec::Rational>(levels, options.seed);

  Collector collector;
  for (std::size_t round = 0; round < rounds; ++round) benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();

  for (IndexFigures& subject : figures) {
    for (const std::uint32_t level : levels) {
      if (level > subject.max_level) continue;
      const std::vector<double>& reference = collector.ns(row_name(baseline, level), rounds);
      const std::vector<double>& ns = collector.ns(row_name(subject.name, level), rounds);
      std::vector<double> ratios(rounds);
      std::transform(ns.begin(), ns.end(), reference.begin(), ratios.begin(), std::divides<>());
      const Spread spread = spread_of(ns);
      subject.times.push_back({level, spread.median, spread.least, spread.most, median(ratios)});
    }
  }
}

}  // namespace mmverify::bench
