#include "cli/prove/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>

namespace mmverify::cli {
namespace {

using namespace proofs;

/// The times of a law's tasks: their sums, and the longest path of one.
struct LawTime {
  std::string law;
  std::size_t tasks = 0;
  double seconds = 0, processor = 0, mutants = 0, path = 0;

  void add(const Spent& task) {
    ++tasks;
    seconds += task.seconds;
    processor += task.processor;
    if (task.mutant) mutants += task.processor;
    path = std::max(path, task.path);
  }

  std::string line() const {
    return fmt::format("{:<40} {:>6} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}", law, tasks, seconds, processor,
                       mutants, path);
  }
};

}  // namespace

std::vector<std::string> time_table(const Report& report, double processor_seconds) {
  std::map<std::string, LawTime> by_law;
  LawTime all{"all laws"};
  const Spent* longest = nullptr;
  for (const Spent& task : report.spent) {
    LawTime& law = by_law[task.law->id];
    law.law = task.law->id;
    law.add(task);
    all.add(task);
    if (longest == nullptr || longest->path < task.path) longest = &task;
  }
  std::vector<LawTime> laws;
  for (const auto& [id, law] : by_law) laws.push_back(law);
  std::stable_sort(laws.begin(), laws.end(),
                   [](const LawTime& a, const LawTime& b) { return a.processor > b.processor; });
  std::vector<std::string> lines{fmt::format("{:<40} {:>6} {:>9} {:>9} {:>9} {:>9}", "law", "tasks",
                                             "seconds", "CPU s", "mutants", "path")};
  for (const LawTime& law : laws) lines.push_back(law.line());
  lines.push_back(all.line());
  lines.push_back(fmt::format("the whole program: {:.1f} CPU-s in {:.1f} s; {} threads, {:.0f} % busy",
                              processor_seconds, report.seconds, report.threads,
                              100 * processor_seconds / (report.seconds * report.threads)));
  if (longest != nullptr)
    lines.push_back(fmt::format("critical path: {:.2f} s, {} {}{}", longest->path, longest->law->id,
                                longest->mutant ? "mutant " : "subject ", longest->subject));
  return lines;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace mmverify::cli
