// The commands: each adds itself to the program's arguments, and runs if it was chosen.
#pragma once

#include <functional>
#include <vector>

namespace CLI {
class App;
}

namespace mmverify::cli {

/// The work of a command, once its arguments are read; returns the exit code.
using Action = std::function<int()>;

/// The program's commands in the order of --help: all commands of mmverify (all_commands.cpp), or only those
/// that ./run prove compiles (prove_commands.cpp).
std::vector<Action> add_commands(CLI::App& program);

Action add_list(CLI::App& program);
Action add_prove(CLI::App& program);
Action add_merge(CLI::App& program);
Action add_replay(CLI::App& program);
Action add_bench(CLI::App& program);
Action add_scene(CLI::App& program);
Action add_attributes(CLI::App& program);
Action add_render(CLI::App& program);
Action add_views(CLI::App& program);
Action add_paper(CLI::App& program);
Action add_gate(CLI::App& program);
Action add_report(CLI::App& program);
Action add_gen(CLI::App& program);
Action add_check(CLI::App& program);
Action add_validate(CLI::App& program);
Action add_repair(CLI::App& program);
Action add_vectors(CLI::App& program);
Action add_schema(CLI::App& program);
Action add_completion(CLI::App& program);
Action add_man(CLI::App& program);

}  // namespace mmverify::cli
