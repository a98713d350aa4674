// mmverify validate: its arguments.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.hpp"
#include "cli/validate/validate.hpp"

namespace mmverify::cli {

Action add_validate(CLI::App& program) {
  auto* command =
      program.add_subcommand("validate", "what is wrong with files of micromaps, and what to do about it");
  command->footer(
      "The kind is told by content: glTF with opacity micromaps, the JSON sidecar of a raw array "
      "(docs/VALIDATE.md),\n"
      "or one of the library's containers; all of them are found in a folder. Exit code 1 where there is an "
      "error, of several files the worst;\n"
      "docs/ISSUES.md lists all codes.");
  auto options = std::make_shared<ValidateOptions>();
  command->add_option("file", options->files, "files, and folders with files")
      ->type_name("FILE|FOLDER")
      ->required();
  command
      ->add_option(
          "--draft", options->draft,
          "glTF: the draft whose rules are asked; where not given, khr for KHR's name, ext-2 for EXT's")
      ->check(CLI::IsMember({"khr", "ext-1", "ext-2"}));
  command
      ->add_option(
          "--api", options->apis,
          "the APIs that the file is built for, whose rules are asked too; of a sidecar in the place of "
          "its own")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"ext", "khr", "dxr"}));
  command
      ->add_option(
          "--limits", options->limits,
          "the device's limits, JSON as the member limits of a sidecar; in the place of a sidecar's own")
      ->type_name("FILE");
  command->add_flag("--warnings-as-errors", options->warnings_as_errors,
                    "exit code 1 where there is a warning, too, as of maps whose inputs have changed");
  command->add_option("--json", options->json, "write the findings as JSON; - is stdout")
      ->type_name("FILE|-");
  command->add_option("--sarif", options->sarif, "write the findings as SARIF 2.1.0; - is stdout")
      ->type_name("FILE|-");
  return [options] { return validate(*options); };
}

}  // namespace mmverify::cli
