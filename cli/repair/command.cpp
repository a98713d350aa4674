// mmverify repair: its arguments.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/repair/repair.hpp"

namespace mmverify::cli {

Action add_repair(CLI::App& program) {
  auto* command =
      program.add_subcommand("repair", "put the micromaps of a file right, and leave the rest as it is");
  command->footer(
      "Turned or rewound maps, exchanged states, another order, links and usage counts are put right from "
      "the file alone;\n"
      "--bake bakes the rest. Nothing is written that validate or check maps would refuse: exit code 1. "
      "docs/REPAIR.md");
  auto options = std::make_shared<RepairOptions>();
  command->add_option("file", options->file, "the glTF file: .gltf or .glb")->type_name("FILE")->required();
  command->add_option("-o,--output", options->output, "the file to write")->type_name("FILE")->required();
  command->add_flag("--bake", options->request.bake, "bake the maps that nothing in the file puts right");
  command->add_flag("--details", options->details, "print each triangle, not only how many");
  command->add_option("--json", options->json, "write what was done as JSON; - is stdout")
      ->type_name("FILE|-");
  command
      ->add_option("--samples", options->request.samples,
                   "micro-triangles that each law judges the result by")
      ->check(whole_within(1, std::uint64_t{1} << 40));
  command->add_option("--states", options->states, "2: the maps were forced to 2-state")
      ->check(CLI::IsMember({2, 4}));
  command
      ->add_option("--margin", options->request.margin, "the margin in texels by which the maps were baked")
      ->check(finite_within(0, 64));
  command->add_flag("--quiet", options->quiet, "no progress");
  return [options] {
    options->request.two_state = options->states == 2;
    options->request.show_progress = !options->quiet;
    return repair(*options);
  };
}

}  // namespace mmverify::cli
