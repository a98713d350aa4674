// mmverify: an exact referee for opacity micromaps.
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/arguments/first_word.hpp"
#include "cli/arguments/old_spellings.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "proofs/engine/interrupt.hpp"

namespace {

int complain(int code, const std::string& what, const std::string& more = "") {
  mmverify::cli::say(stderr, "mmverify: {}{}\n", mmverify::cli::printable(what), more);
  return code;
}

/// Refuses an empty text: it usually comes from a script's unset variable.
std::string not_empty(std::string& text) {
  return text.empty() ? "it is given as an empty text; is a variable not set? Name it, or leave it out" : "";
}

void refuse_empty_texts(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() != 0)
        option->transform(CLI::Validator(not_empty, ""));  // before the option's own checks
}

/// Allows as many threads as --threads says: by default TBB has no more than there are cores.
class ThreadsAsked {
 public:
  explicit ThreadsAsked(const CLI::App& command) {
    const CLI::Option* option = command.get_option_no_throw("--threads");
    if (option == nullptr || option->count() == 0) return;
    const auto threads = option->as<std::size_t>();
    if (threads > std::thread::hardware_concurrency())
      allowed_.emplace(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<oneapi::tbb::global_control> allowed_;
};

}  // namespace

int main(int argc, char** argv) {
  using namespace mmverify::cli;
  reserve_standard_streams();
  mmverify::proofs::end_after_interrupt(800, ExitCode::interrupted);
  // It outlives main(): a signal while the process ends changes no exit code.
  [[maybe_unused]] static const auto* const guard = new mmverify::proofs::InterruptGuard;
  std::signal(SIGPIPE, SIG_IGN);
  // Exceeding the limit of a file's size is then an error of write(), reported there.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App program("mmverify: an exact referee for opacity micromaps", "mmverify");
  program.require_subcommand(1);
  program.footer("Documents: PREFIX/share/doc/mmverify/README.md, for a program in PREFIX/bin");
  program.set_version_flag(
      "--version", fmt::format("mmverify {}\nspecification {:.16}; spec, impl and proofs {:.16}\n{}, {}\n{}",
                               build::version, std::string(build::spec_hash), std::string(build::source_hash),
                               build::compiler, build::flags, build::libraries));
  const std::vector<Action> actions = add_commands(program);
  refuse_empty_texts(program);
  try {
    std::vector<std::string> arguments =
        with_known_command(program, in_todays_spelling({argv + std::min(argc, 1), argv + argc}));
    std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 takes
    program.parse(std::move(arguments));
  } catch (const CLI::Success& asked_for) {
    return after_printing(program.exit(asked_for));
  } catch (const CLI::ExtrasError& error) {
    const std::string meant = meant_option(program);
    return complain(ExitCode::usage, error.what() + meant, meant.empty() ? see_help(program) : "");
  } catch (const CLI::ParseError& error) {
    return complain(ExitCode::usage, error.what() + meant_member(error.what()), see_help(program));
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  }
  try {
    const auto commands = program.get_subcommands({});
    for (std::size_t k = 0; k < actions.size(); ++k) {
      if (!commands[k]->parsed()) continue;
      const ThreadsAsked threads(*commands[k]);
      return after_printing(actions[k]());
    }
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const mmverify::proofs::Interrupted&) {
    return complain(ExitCode::interrupted, "interrupted; no file was left half written");
  } catch (const std::exception& error) {
    return complain(ExitCode::environment, error.what());
  }
  return ExitCode::usage;
}
