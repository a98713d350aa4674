// mmverify gate: compares a result with a baseline.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/results/read_json.hpp"
#include "delivery/gate/compare.hpp"
#include "delivery/gate/runs.hpp"

namespace mmverify::cli {
namespace {

using gate::Baseline;
using gate::Change;
using gate::Comparison;
using gate::Difference;

struct GateOptions {
  std::string baseline, result;
  std::vector<std::string> runs;  ///< more runs of the same command, for their speeds
  double tolerance = 1.5;
  bool bless = false, all = false;
};

/// Reads a file and applies `read`; error messages name the file.
template <class Read>
auto of_file(const std::string& path, Read read) {
  const auto file = read_json(path);
  try {
    gate::refuse_misfits(file, path);
  } catch (const gate::NoResult& why) {
    throw EnvironmentError(why.what());
  }
  try {
    return read(file);
  } catch (const gate::NoResult& why) {
    throw EnvironmentError(fmt::format("{}: {}", path, why.what()));
  }
}

const char* word(Change change) {
  switch (change) {
    case Change::worse: return "worse";
    case Change::better: return "better";
    case Change::changed: return "changed";
    case Change::gone: return "gone";
    case Change::added: return "new";
    default: return "faster";
  }
}

void print(const Difference& d) {
  std::string line = fmt::format("{:<8}{}", word(d.change), d.group);
  if (!d.figure.empty()) line += fmt::format("{}{}", d.group.empty() ? "" : ": ", d.figure);
  if (!d.before.empty() && !d.after.empty())
    line += fmt::format(" {} -> {}", gate::unquoted(d.before), gate::unquoted(d.after));
  else if (!d.figure.empty())
    line += fmt::format(" {}", gate::unquoted(d.before.empty() ? d.after : d.before));
  say(stdout, "{}\n", printable(line));
}

constexpr Change kinds_of_finding[] = {Change::worse, Change::better, Change::changed,
                                       Change::gone,  Change::added,  Change::faster};

void print(const Comparison& comparison, const GateOptions& options) {
  // One change may move thousands of figures; a few of each kind identify it.
  constexpr std::size_t most = 20;
  for (const Change change : kinds_of_finding) {
    std::size_t shown = 0;
    for (const Difference& d : comparison.differences)
      if (d.change == change && (options.all || ++shown <= most)) print(d);
    if (!options.all && shown > most)
      say(stdout, "{:<8}and {} more; see --all\n", word(change), shown - most);
  }
  std::string counts;
  for (const Change change : kinds_of_finding)
    if (const std::size_t n = comparison.count(change); n != 0)
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", grouped(n), word(change));
  say(stdout, "gate: {}: {} figures compared, {} of them speeds, to within a factor of {:.4g}; {}\n",
      comparison.red() ? "red" : "green", grouped(comparison.figures), grouped(comparison.speeds),
      options.tolerance, counts.empty() ? "none differs" : counts);
}

/// Names both processors if they differ: ratios carry over from machine to machine only roughly.
void name_processors(const Comparison& comparison, const gate::Figures& result) {
  if (!comparison.other_processor.empty())
    say(stdout, "gate: speeds were measured on two processors: the baseline's {}, the result's {}\n",
        printable(comparison.other_processor), printable(result.processor));
}

/// Counts the results that are failures: a baseline of them would pin the failures.
void name_faults(const gate::Figures& result) {
  for (const char* const verdict : {"refuted", "broken", "incomplete"}) {
    std::size_t count = 0;
    for (const auto& [name, figures] : result.groups)
      if (const auto found = figures.find("verdict"); found != figures.end())
        count += gate::unquoted(found->second.value.text) == verdict;
    if (count != 0)
      say(stdout, "gate: {} {} {}\n", grouped(count), count == 1 ? "result is" : "results are", verdict);
  }
}

/// The baseline at `path`. Throws if there is any other file, which must not be overwritten.
nlohmann::ordered_json old_baseline(const std::string& path) {
  std::string why = "it has another schema";
  try {
    nlohmann::ordered_json old = read_json(path);
    if (gate::is_baseline(old)) return old;
  } catch (const EnvironmentError& error) {
    why = error.what();
  }
  throw UsageError(fmt::format(
      "--baseline {}: not a baseline ({}), so it is not overwritten; remove it, or name another file", path,
      why));
}

/// Refuses a run in which no law judged anything: it cannot serve as a baseline.
void refuse_nothing_judged(const std::string& path, const gate::Figures& result) {
  std::size_t results = 0, judged = 0, others = 0;
  for (const auto& [name, figures] : result.groups) {
    const auto verdict = figures.find("verdict");
    if (verdict == figures.end()) {
      others += figures.contains("killed") ? 0 : 1;
      continue;
    }
    ++results;
    judged += gate::unquoted(verdict->second.value.text) == "not_applicable" ? 0 : 1;
  }
  if (results != 0 && judged == 0 && others == 0)
    throw UsageError(
        fmt::format("{}: nothing was judged: all {} results are not_applicable", path, grouped(results)));
}

int bless(const GateOptions& options, const gate::Figures& result) {
  std::error_code none;
  if (std::filesystem::equivalent(options.baseline, options.result, none))
    throw UsageError(
        fmt::format("--baseline {}: this is the result itself; name another file", options.baseline));
  std::optional<nlohmann::ordered_json> old;
  if (std::filesystem::is_regular_file(options.baseline, none) &&
      std::filesystem::file_size(options.baseline, none) != 0)
    old = old_baseline(options.baseline);
  // Shows the old baseline's differences before it is overwritten; it may belong to another run.
  try {
    if (old) print(compare(gate::baseline_of(*old), result, options.tolerance), options);
  } catch (const std::exception& error) {
    say(stdout, "gate: the old baseline cannot be compared: {}\n", printable(error.what()));
  }
  OutputFile(options.baseline).commit(to_json(gate::baseline_of(result)));
  name_faults(result);
  say(stdout, "gate: {} now has the figures of {}: {} groups\n", printable(options.baseline),
      printable(options.result), grouped(result.groups.size()));
  return ExitCode::complete;
}

int run_gate(const GateOptions& options) {
  const auto figures = [](const std::string& path) {
    return of_file(path, [](const auto& json) { return gate::figures_of(json); });
  };
  gate::Figures result = figures(options.result);
  for (const std::string& path : options.runs) {
    try {
      take_better_speeds(result, figures(path));
    } catch (const gate::NoResult& why) {
      throw UsageError(fmt::format("--speeds {}: {}", path, why.what()));
    }
  }
  refuse_nothing_judged(options.result, result);
  if (options.bless) return bless(options, result);
  if (std::error_code none; !std::filesystem::exists(options.baseline, none))
    throw EnvironmentError(fmt::format("{}: there is no baseline yet; --bless makes one of {}",
                                       options.baseline, options.result));
  const Baseline baseline =
      of_file(options.baseline, [](const auto& json) { return gate::baseline_of(json); });
  Comparison comparison;
  try {
    comparison = compare(baseline, result, options.tolerance);
  } catch (const gate::NoResult& why) {
    throw UsageError(fmt::format("{}: {}", options.result, why.what()));
  }
  print(comparison, options);
  if (comparison.figures == 0)
    say(stdout,
        "Nothing was compared: the two share no law and subject; a library is known by its file's name\n");
  name_processors(comparison, result);
  name_faults(result);
  if (comparison.has_fallen())
    say(stdout, "A law that held before is refuted or broken: its counterexample is in {}\n",
        shell_quoted(options.result));
  else if (!comparison.differences.empty() && comparison.figures != 0)
    say(stdout, "If that is how it should be: mmverify gate --baseline {} {} --bless\n",
        shell_quoted(options.baseline), shell_quoted(options.result));
  return comparison.red() ? ExitCode::failed : ExitCode::complete;
}

}  // namespace

Action add_gate(CLI::App& program) {
  auto* command = program.add_subcommand("gate", "compare a result with a baseline; exit 1 where it differs");
  command->footer(
      "Verdicts, counts, mismatches, sizes, substitutions and needless unknowns are compared exactly: what "
      "is\n"
      "better than the baseline is red, too, until it is blessed. Speeds are compared as the ratios that one "
      "run\n"
      "took itself, never as times; a better speed is reported, and is not red.");
  auto options = std::make_shared<GateOptions>();
  command->add_option("--baseline", options->baseline, "what --bless wrote, or an earlier result")
      ->type_name("FILE")
      ->required();
  command->add_option("result", options->result, "what prove, scene or bench wrote with --json")
      ->type_name("RESULT.json")
      ->required();
  command
      ->add_option("--speeds", options->runs,
                   "another run of the same, may be given again: of each speed the best counts, which other "
                   "work on the machine spoils least")
      ->type_name("RUN.json")
      ->allow_extra_args(false);
  command->add_flag("--bless", options->bless, "write the result's figures as the new baseline");
  command->add_flag("--all", options->all, "print every difference");
  command
      ->add_option("--tolerance", options->tolerance,
                   "the factor by which a ratio of times may be worse; 1.5 where not given")
      ->type_name("FACTOR")
      ->check(finite_within(1.01, 1000));
  return [options] { return run_gate(*options); };
}

}  // namespace mmverify::cli
