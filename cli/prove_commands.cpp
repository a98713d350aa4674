// What mmverify-prove can do: what ./run prove needs, and what a counterexample asks next.
#include "cli/commands.hpp"

namespace mmverify::cli {

std::vector<Action> add_commands(CLI::App& program) {
  return {add_list(program), add_prove(program), add_replay(program)};
}

}  // namespace mmverify::cli
