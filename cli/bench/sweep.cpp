#include "cli/bench/sweep.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <thread>

#include "cli/output/exit_code.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/options.hpp"
#include "proofs/points/cells.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

using proofs::Level;
using proofs::Run;

// The highest level of the plain loop: it takes seconds up to here, minutes beyond. Its cost per cell grows
// with the level, so a ratio to the cost at a lower level errs on the small side.
constexpr Level last_plain = 12;

double megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct PlainLoop {
  double per_second;
  std::uint64_t digest;
};

PlainLoop plain_loop(Level n, const Run& run) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::uint64_t digest = proofs::index::plain_sweep(n, run).digest();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return {static_cast<double>(proofs::points::cell_count(n)) / seconds, digest};
}

/// Times a sweep of the subject. plain: the plain loop at this level, if it was run.
bench::Swept swept(const char* subject, Level n, const Run& run, const std::optional<PlainLoop>& plain) {
  using proofs::Verdict;
  const proofs::Result r =
      run_level(*proofs::find_law("index.equals_reference"), *proofs::find_subject(subject), n, run);
  if (r.verdict != Verdict::proved || (plain && r.digest != plain->digest))
    throw EnvironmentError(fmt::format("{} at level {} is {}, digest {:016x}; the plain loop's is {:016x}",
                                       subject, n, to_string(r.verdict), r.digest,
                                       plain ? plain->digest : 0));
  return {.seconds = r.seconds, .per_second = static_cast<double>(proofs::points::cell_count(n)) / r.seconds};
}

}  // namespace

bench::SweepFigures sweep_figures(const proofs::Levels& levels, unsigned threads,
                                  const std::function<void(const std::string&)>& progress) {
  bench::SweepFigures figures;
  figures.threads = threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : threads;
  figures.last_plain = last_plain;
  oneapi::tbb::task_arena arena(static_cast<int>(figures.threads));
  Run run;
  run.arena = &arena;
  run.options = {&proofs::index::in_fixed_point_alone};
  std::optional<double> plain_rate;
  for (Level n = levels.first; n <= levels.last; ++n) {
    progress(fmt::format("level {}", n));
    bench::SweepLevel row{.level = n, .cells = proofs::points::cell_count(n)};
    std::optional<PlainLoop> plain;
    if (n <= last_plain) plain = plain_loop(n, run);
    if (plain) plain_rate = row.plain_per_second = plain->per_second;
    const auto measure = [&](const char* subject, bench::Swept bench::SweepLevel::*of) {
      bench::Swept& figure = row.*of = swept(subject, n, run, plain);
      if (plain_rate) figure.ratio = figure.per_second / *plain_rate;
      if (!figures.levels.empty()) figure.growth = figure.seconds / (figures.levels.back().*of).seconds;
    };
    measure("step", &bench::SweepLevel::step);
    measure("impl", &bench::SweepLevel::impl);
    row.peak_megabytes = megabytes();
    figures.levels.push_back(row);
  }
  return figures;
}

}  // namespace mmverify::cli
