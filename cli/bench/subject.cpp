#include "cli/bench/subject.hpp"

#include <algorithm>

#include "cli/arguments/arguments.hpp"
#include "cli/bench/topics.hpp"
#include "cli/output/exit_code.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "subjects/dock/cost.hpp"

namespace mmverify::cli {

bench::SubjectFigures subject_figures(const std::string& library, std::uint32_t level) {
  using namespace proofs;
  dock::Options options;
  options.stop_if_asked = stop_if_asked;
  const auto subjects = parse_subject(library, options.timeout_seconds);
  dock::Cost cost;
  try {
    cost = dock::measure_cost(library, level, options);
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  // One thread, and a level for which the tables exist: the steady state of a long sweep.
  oneapi::tbb::task_arena arena(1);
  Run run;
  run.arena = &arena;
  const Law& law = *find_law("index.equals_reference");
  run_level(law, *subjects.front(), level, run);
  const proofs::Result judged = run_level(law, *subjects.front(), level, run);
  return {
      .library = library,
      .level = level,
      .batch = dock::batch_size,
      .bare_ns = cost.bare,
      .isolated_ns = cost.isolated,
      .isolated_ratio = cost.ratio,
      .judged_ns = judged.seconds * 1e9 / static_cast<double>(std::max<std::uint64_t>(1, judged.cases_run())),
      .verdict = to_string(judged.verdict)};
}

}  // namespace mmverify::cli
