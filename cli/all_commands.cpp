// The commands of mmverify.
#include "bench/schema/schema.hpp"
#include "cli/commands.hpp"
#include "delivery/gate/schema.hpp"

namespace mmverify::cli {

std::vector<Action> add_commands(CLI::App& program) {
  gate::use_bench_schema(bench::schema);
  return {add_list(program),    add_prove(program),  add_merge(program),      add_replay(program),
          add_bench(program),   add_scene(program),  add_attributes(program), add_render(program),
          add_views(program),   add_paper(program),  add_gate(program),       add_report(program),
          add_gen(program),     add_check(program),  add_validate(program),   add_repair(program),
          add_vectors(program), add_schema(program), add_completion(program), add_man(program)};
}

}  // namespace mmverify::cli
