// The commands of mmverify as WebAssembly.
#include "cli/commands.hpp"

namespace mmverify::cli {

std::vector<Action> add_commands(CLI::App& program) {
  return {add_list(program),     add_prove(program),  add_merge(program), add_replay(program),
          add_scene(program),    add_gate(program),   add_gen(program),   add_check(program),
          add_validate(program), add_vectors(program)};
}

}  // namespace mmverify::cli
