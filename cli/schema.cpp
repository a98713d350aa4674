// mmverify schema: the JSON Schema of what other commands write.
#include "delivery/gate/schema.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"

namespace mmverify::cli {

Action add_schema(CLI::App& program) {
  auto* command = program.add_subcommand("schema", "the JSON Schema of results: mmverify schema bench");
  auto kind = std::make_shared<std::string>();
  command
      ->add_option("kind", *kind,
                   "of what: result, which prove, scene and render write, or bench, which bench writes")
      ->required()
      ->check(CLI::IsMember({"result", "bench"}));
  return [kind] {
    end_with_the_reader();
    say(stdout, "{}\n", gate::schema_named("mmverify." + *kind + "/1")->document->dump(1));
    return static_cast<int>(ExitCode::complete);
  };
}

}  // namespace mmverify::cli
