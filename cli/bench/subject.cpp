#include "cli/bench/subject.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "dock/cost.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry.hpp"

namespace mmverify::cli {

std::string bench_subject(const std::string& library, std::uint32_t level, std::FILE* out) {
  using namespace proofs;
  constexpr dock::Options options;
  const auto subjects = parse_subject(library, options.timeout_seconds);
  dock::Cost cost;
  try {
    cost = dock::measure_cost(library, level, options);
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  // One thread, and a level that was asked before: what a long sweep pays.
  oneapi::tbb::task_arena arena(1);
  Run run;
  run.arena = &arena;
  const Law& law = *find_law("index.equals_reference");
  run_level(law, *subjects.front(), level, run);
  const Result result = run_level(law, *subjects.front(), level, run);
  const double check =
      result.seconds * 1e9 / static_cast<double>(std::max<std::uint64_t>(1, result.cases_run()));
  fmt::print(out, "{} at level {}, one thread, batches of {}\n", library, level, dock::batch_size);
  fmt::print(out, "{:<44} {:>8} {:>8}\n", "", "ns each", "ratio");
  fmt::print(out, "{:<44} {:>8.2f} {:>8.2f}\n", "bare loop in this process", cost.bare, 1.0);
  fmt::print(out, "{:<44} {:>8.2f} {:>8.2f}\n", "asked in a worker process", cost.isolated, cost.ratio);
  fmt::print(out, "{:<44} {:>8.2f} {:>8.2f}\n", "judged (index.equals_reference, all of it)", check,
             check / cost.bare);
  const nlohmann::ordered_json j{{"schema", "mmverify.bench/1"},
                                 {"topic", "subject"},
                                 {"tool", tool(nlohmann::ordered_json::object())},
                                 {"subject", library},
                                 {"level", level},
                                 {"bare_ns", cost.bare},
                                 {"isolated_ns", cost.isolated},
                                 {"isolated_ratio", cost.ratio},
                                 {"judged_ns", check},
                                 {"judged_ratio", check / cost.bare},
                                 {"verdict", to_string(result.verdict)}};
  return j.dump(1) + "\n";
}

}  // namespace mmverify::cli
