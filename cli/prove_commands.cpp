// The commands of mmverify-prove: those that ./run prove and the replay of a counterexample need.
#include "cli/commands.hpp"

namespace mmverify::cli {

std::vector<Action> add_commands(CLI::App& program) {
  return {add_list(program), add_prove(program), add_replay(program)};
}

}  // namespace mmverify::cli
