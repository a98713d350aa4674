#include "cli/bench/sweep.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/index/cells.hpp"
#include "proofs/index/options.hpp"
#include "proofs/index/plain_sweep.hpp"
#include "proofs/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;
using Json = nlohmann::ordered_json;

// The plain loop takes seconds up to here, minutes beyond; its cost a cell grows with the level, so that the
// ratio to that of a lower level is too small, if anything.
constexpr Level last_plain = 12;

double megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Cells of `cells` a second, in millions.
double sweep_rate(std::uint64_t cells, double seconds) { return static_cast<double>(cells) / seconds / 1e6; }

Result swept(const char* subject, Level n, const Run& run) {
  return run_level(*find_law("index.equals_reference"), *find_subject(subject), n, run);
}

}  // namespace

std::string bench_sweep(const Levels& levels, unsigned threads, std::FILE* out) {
  using Clock = std::chrono::steady_clock;
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  oneapi::tbb::task_arena arena(static_cast<int>(threads));
  Run run;
  run.arena = &arena;
  run.options = {&index::in_fixed_point_alone};
  fmt::print(
      out,
      "index.equals_reference, {} thread{}; M/s: million cells a second; growth: time over that of the level "
      "below\n{:>5} {:>15} | {:>10} | {:>8} {:>8} {:>7} {:>6} | {:>8} {:>8} {:>7} {:>6} | {:>5}\n",
      threads, threads == 1 ? "" : "s", "level", "cells", "plain M/s", "step s", "M/s", "ratio", "growth",
      "impl s", "M/s", "ratio", "growth", "MB");
  Json rows = Json::array();
  double plain = 0, before[2] = {0, 0};
  for (Level n = levels.first; n <= levels.last; ++n) {
    const std::uint64_t cells = index::cell_count(n);
    Json row{{"level", n}, {"cells", cells}};
    std::string plain_text = plain > 0 ? fmt::format("({:.1f})", plain) : "-";
    std::uint64_t digest = 0;
    if (n <= last_plain) {
      const auto start = Clock::now();
      digest = index::plain_sweep(n, run).digest();
      plain = sweep_rate(cells, std::chrono::duration<double>(Clock::now() - start).count());
      plain_text = fmt::format("{:.1f}", plain);
      row["plain_per_second"] = plain * 1e6;
    }
    fmt::print(out, "{:>5} {:>15} | {:>10} |", n, grouped(cells), plain_text);
    const char* names[] = {"step", "impl"};
    for (std::size_t k = 0; k < 2; ++k) {
      const Result r = swept(names[k], n, run);
      if (r.verdict != Verdict::proved || (n <= last_plain && r.digest != digest))
        throw EnvironmentError(
            fmt::format("{} at level {} is {}, digest {:016x}; the plain loop's is {:016x}", names[k], n,
                        to_string(r.verdict), r.digest, digest));
      const double speed = sweep_rate(cells, r.seconds);
      fmt::print(out, " {:>8.3f} {:>8.1f} {:>7} {:>6} |", r.seconds, speed,
                 plain > 0 ? fmt::format("{:.1f}", speed / plain) : "-",
                 before[k] > 0 ? fmt::format("{:.2f}", r.seconds / before[k]) : "-");
      before[k] = r.seconds;
      row[names[k]] = {{"seconds", r.seconds}, {"per_second", speed * 1e6}};
      if (plain > 0) row[names[k]]["ratio"] = speed / plain;
    }
    fmt::print(out, " {:>5.0f}\n", megabytes());
    std::fflush(out);
    row["peak_megabytes"] = megabytes();
    rows.push_back(row);
  }
  fmt::print(out,
             "(in parentheses: the plain sweep_rate of the highest level where it was measured, which the "
             "ratio is to)\n");
  const Json j{{"schema", "mmverify.bench/1"},
               {"topic", "sweep"},
               {"tool", tool(Json::object())},
               {"threads", threads},
               {"levels", rows}};
  return j.dump(1) + "\n";
}

}  // namespace mmverify::cli
