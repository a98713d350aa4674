// mmverify: an exact referee for opacity micromaps.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <utility>
#include <vector>

#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"

namespace {

/// The exit code, or 4 where standard output did not take all that was said.
int closed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "mmverify: standard output cannot be written\n");
  return code == mmverify::cli::complete ? mmverify::cli::environment : code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace mmverify::cli;
  CLI::App program("mmverify: an exact referee for opacity micromaps", "mmverify");
  program.require_subcommand(1);
  program.set_version_flag("--version", fmt::format("mmverify {} ({}, spec {:.12})", build::version,
                                                    build::compiler, std::string(build::spec_hash)));
  const std::vector<Action> actions{add_list(program),   add_prove(program), add_merge(program),
                                    add_replay(program), add_bench(program), add_gen(program),
                                    add_check(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {
    return program.exit(asked_for);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "mmverify: {}; see `mmverify --help`\n", error.what());
    return ExitCode::usage;
  }
  try {
    const auto commands = program.get_subcommands({});
    for (std::size_t k = 0; k < actions.size(); ++k)
      if (commands[k]->parsed()) return closed(actions[k]());
  } catch (const UsageError& error) {
    fmt::print(stderr, "mmverify: {}\n", error.what());
    return ExitCode::usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mmverify: {}\n", error.what());
    return ExitCode::environment;
  }
  return ExitCode::usage;
}
