#include "bench/index.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <span>
#include <stdexcept>

#include "impl/index.hpp"
#include "spec/index.hpp"

namespace mmverify::bench {
namespace {

constexpr std::size_t point_count = 4096;  // inputs and outputs stay in the first-level cache: 48 KiB
constexpr std::array<std::uint32_t, 3> levels{4, 10, 16};
constexpr std::array subjects{"reference-f32", "impl-scalar", "impl-batched"};

struct Points {
  std::vector<float> u, v;
  std::vector<std::uint32_t> out = std::vector<std::uint32_t>(point_count);
};

Points uniform_points(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // The engine's bits are the standard's, a distribution's would be the library's.
  const auto unit = [&random] { return static_cast<float>(random() >> 40) * 0x1p-24f; };
  Points points;
  while (points.u.size() < point_count) {
    const float u = unit(), v = unit();
    const bool inside = u + v <= 1;
    points.u.push_back(inside ? u : 1 - u);
    points.v.push_back(inside ? v : 1 - v);
  }
  return points;
}

// Kept apart from one another and from the harness, so that each compiles as the loop it would be in a
// program.
[[gnu::noinline]] void reference_f32(std::span<const float> u, std::span<const float> v, std::uint32_t level,
                                     std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = spec::index::reference(spec::Point<float>{u[k], v[k]}, level);
}

[[gnu::noinline]] void impl_scalar(std::span<const float> u, std::span<const float> v, std::uint32_t level,
                                   std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = impl::index::from_barycentrics(u[k], v[k], level);
}

void impl_batched(std::span<const float> u, std::span<const float> v, std::uint32_t level,
                  std::span<std::uint32_t> out) {
  impl::index::from_barycentrics(u, v, level, out);
}

using Subject = void (*)(std::span<const float>, std::span<const float>, std::uint32_t,
                         std::span<std::uint32_t>);
constexpr std::array<Subject, subjects.size()> functions{reference_f32, impl_scalar, impl_batched};

std::string row_name(std::size_t subject, std::uint32_t level) {
  return std::string(subjects[subject]).append("/").append(std::to_string(level));
}

// Keeps the times by name instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred)
        throw std::runtime_error("index bench: " + run.run_name.function_name + ": " + run.error_message);
      ns_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime() / static_cast<double>(point_count));
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

double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

}  // namespace

std::vector<IndexRow> run_index_bench(const IndexBenchOptions& options) {
  const std::size_t rounds = std::max<std::size_t>(options.rounds, 1);
  Points points = uniform_points(options.seed);

  for (const std::uint32_t level : levels) {
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      benchmark::RegisterBenchmark(row_name(s, level).c_str(), [&points, level, s](benchmark::State& state) {
        for ([[maybe_unused]] auto pass : state) {
          functions[s](points.u, points.v, level, points.out);
          benchmark::DoNotOptimize(points.out.data());
          benchmark::ClobberMemory();
        }
      })->Iterations(static_cast<benchmark::IterationCount>(std::max<std::size_t>(options.passes, 1)));
    }
  }
  Collector collector;
  for (std::size_t round = 0; round < rounds; ++round) benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();

  std::vector<IndexRow> rows;
  for (const std::uint32_t level : levels) {
    const std::vector<double>& reference = collector.ns(row_name(0, level), rounds);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      const std::vector<double>& ns = collector.ns(row_name(s, level), rounds);
      std::vector<double> ratios(rounds);
      std::transform(ns.begin(), ns.end(), reference.begin(), ratios.begin(), std::divides<>());
      rows.push_back({subjects[s], level, median(ns), median(ratios)});
    }
  }
  return rows;
}

}  // namespace mmverify::bench
