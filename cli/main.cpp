// mmverify: an exact referee for opacity micromaps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/text.hpp"
#include "proofs/engine/interrupt.hpp"

namespace {

/// The exit code, or 4 where standard output did not take all that was said.
int closed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "mmverify: standard output cannot be written\n");
  return code == mmverify::cli::complete ? mmverify::cli::environment : code;
}

int complain(int code, const std::string& what, const char* more = "") {
  fmt::print(stderr, "mmverify: {}{}\n", mmverify::cli::printable(what), more);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace mmverify::cli;
  // A file that may not grow is an error of its own, said where it happens.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App program("mmverify: an exact referee for opacity micromaps", "mmverify");
  program.require_subcommand(1);
  program.set_version_flag(
      "--version", fmt::format("mmverify {}\nspecification {:.16}; spec, impl and proofs {:.16}\n{}, {}\n{}",
                               build::version, std::string(build::spec_hash), std::string(build::source_hash),
                               build::compiler, build::flags, build::libraries));
  const std::vector<Action> actions{add_list(program),   add_prove(program), add_merge(program),
                                    add_replay(program), add_bench(program), add_scene(program),
                                    add_render(program), add_gate(program),  add_report(program),
                                    add_gen(program),    add_check(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {
    return program.exit(asked_for);
  } catch (const CLI::ParseError& error) {
    return complain(ExitCode::usage, error.what(), "; see `mmverify --help`");
  }
  try {
    const auto commands = program.get_subcommands({});
    for (std::size_t k = 0; k < actions.size(); ++k)
      if (commands[k]->parsed()) return closed(actions[k]());
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const mmverify::proofs::Interrupted&) {
    return complain(ExitCode::interrupted, "interrupted; no file was left half written");
  } catch (const std::exception& error) {
    return complain(ExitCode::environment, error.what());
  }
  return ExitCode::usage;
}
