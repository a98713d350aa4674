// mmverify completion and mmverify man: describe the command line for shells and for man(1).
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/bench/topics.hpp"
#include "cli/build_info.hpp"
#include "cli/describe/manual.hpp"
#include "cli/describe/shells.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/registry/topics.hpp"

namespace mmverify::cli {
namespace {

/// Adds words that the options do not list themselves: the names of laws, topics and subjects.
void add_known_words(describe::Program& program) {
  std::vector<std::string> laws, topics, subjects, benches;
  for (const proofs::Law& law : proofs::laws()) laws.push_back(law.id);
  for (const proofs::Topic& topic : proofs::topics()) topics.emplace_back(topic.name);
  for (const auto& subject : proofs::subjects()) subjects.push_back(subject->name());
  for (const BenchTopic& topic : bench_topics()) benches.emplace_back(topic.name);
  benches.emplace_back("shaders");
  const auto add = [&](const describe::Command& command, describe::Option& option) {
    const auto names = [&](const std::vector<std::string>& more) {
      option.words.insert(option.words.end(), more.begin(), more.end());
    };
    if (option.value.starts_with("LAW")) names(laws);
    if (option.value == "LAW|TOPIC") names(topics);
    if (option.value.starts_with("NAME|FILE.so")) names(subjects);
    if (option.value == "TOPIC" && command.name == "bench") names(benches);
  };
  for (describe::Command& command : program.commands) {
    for (describe::Option& option : command.options) add(command, option);
    for (describe::Option& option : command.positionals) add(command, option);
  }
}

/// The date of SOURCE_DATE_EPOCH, which builders of packages set; empty if it is not set.
/// https://reproducible-builds.org/specs/source-date-epoch/
std::string date_of_source() {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr || *text == 0) return {};
  if (const std::string wrong = whole_within(0, 253402300799)(text);
      !wrong.empty())  // the end of the year 9999
    throw UsageError("SOURCE_DATE_EPOCH: " + wrong);
  const auto day = std::chrono::floor<std::chrono::days>(
      std::chrono::sys_seconds(std::chrono::seconds(std::strtoll(text, nullptr, 10))));
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

}  // namespace

Action add_completion(CLI::App& program) {
  auto* command =
      program.add_subcommand("completion", "a script that completes this command line in a shell");
  auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "the shell, as in: source <(mmverify completion bash)")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return [&program, shell] {
    end_with_the_reader();
    describe::Program described = describe::described(program);
    add_known_words(described);
    say(stdout, "{}",
        *shell == "bash"  ? describe::bash_completion(described)
        : *shell == "zsh" ? describe::zsh_completion(described)
                          : describe::fish_completion(described));
    return static_cast<int>(ExitCode::complete);
  };
}

Action add_man(CLI::App& program) {
  program.add_subcommand("man", "the manual page: mmverify man | man -l -");
  return [&program] {
    end_with_the_reader();
    say(stdout, "{}", describe::manual(describe::described(program), build::version, date_of_source()));
    return static_cast<int>(ExitCode::complete);
  };
}

}  // namespace mmverify::cli
