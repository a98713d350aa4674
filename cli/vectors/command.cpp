// mmverify vectors: writes test vectors to compile in or to upload.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "cli/vectors/folder.hpp"
#include "delivery/vectors/families.hpp"
#include "proofs/engine/interrupt.hpp"
#include "subjects/shaders/compile/sha256.hpp"

namespace mmverify::cli {
namespace {

struct VectorsOptions {
  std::string folder;
  std::vector<std::string> families, forms;
};

/// The forms that the user names, or all but Amber's scripts.
vectors::Forms forms_of(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return {has("json"), has("header"), has("binary"), has("amber")};
}

/// The families to write: those that the user names; without names, all that have a file in one of the forms.
/// Errors: UsageError if a named family would have no file, or none is there for the scripts.
std::vector<std::string> families_of(const VectorsOptions& options, const vectors::Forms& forms) {
  const bool scripts_alone = forms.amber && !forms.json && !forms.header && !forms.binary;
  const std::string scripts_of = vectors::amber_family;
  std::vector<std::string> names = options.families;
  if (names.empty() && scripts_alone) return {scripts_of};
  if (names.empty())
    for (const vectors::FamilyRow& row : vectors::families()) names.emplace_back(row.name);
  if (forms.amber && std::find(names.begin(), names.end(), scripts_of) == names.end())
    throw UsageError(
        fmt::format("--form amber: family {} alone has scripts; add it to --family", scripts_of));
  for (const std::string& name : names)
    if (scripts_alone && name != scripts_of)
      throw UsageError(
          fmt::format("--form amber: family {} has no script, {} alone has; add a form, such as "
                      "json, or leave {} out",
                      name, scripts_of, name));
  return names;
}

/// Prints a family's line: "index      points 3,565".
void print(const vectors::Family& family) {
  std::string tables;
  for (const vectors::Table& table : family.tables)
    tables += fmt::format("{}{} {}", tables.empty() ? "" : ", ", table.name, grouped(table.records()));
  say(stdout, "{:<10} {}\n", family.name, tables);
}

int run_vectors(const VectorsOptions& options) {
  if (options.folder == "-")
    throw UsageError(
        fmt::format("-o {}: vectors are several files; name a folder", shell_quoted(options.folder)));
  const vectors::Forms forms = forms_of(options.forms);
  const std::vector<std::string> names = families_of(options, forms);
  const proofs::InterruptGuard guard;
  VectorsFolder folder(options.folder);
  std::vector<vectors::Family> made;
  for (const vectors::FamilyRow& row : vectors::families())
    if (std::find(names.begin(), names.end(), row.name) != names.end()) made.push_back(row.make());
  const auto files = vectors::files_of(made, {build::version, build::spec_hash, shaders::sha256}, forms);
  if (proofs::interrupted()) throw proofs::Interrupted{};
  folder.commit(files);

  std::size_t bytes = 0;
  for (const vectors::File& file : files) bytes += file.second.size();
  for (const vectors::Family& family : made) print(family);
  say(stdout, "{}: {} files, {} bytes\n", options.folder, files.size(), grouped(bytes));
  return ExitCode::complete;
}

}  // namespace

Action add_vectors(CLI::App& program) {
  auto* command = program.add_subcommand(
      "vectors",
      "test vectors for other people's tests: JSON, a C header, a binary to upload, scripts for Amber");
  std::vector<std::string> names;
  for (const vectors::FamilyRow& row : vectors::families()) names.emplace_back(row.name);
  command->footer(
      "Made from the exact specification, the same bytes each time. docs/VECTORS.md says what each family "
      "has, and how\na driver's, a translation layer's or an engine's tests take them in.");
  auto options = std::make_shared<VectorsOptions>();
  command
      ->add_option("-o,--output", options->folder,
                   "where the files go: a folder that is new, is empty or has vectors")
      ->type_name("DIR")
      ->required();
  command->add_option("--family", options->families, "these alone")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  command
      ->add_option("--form", options->forms,
                   "these alone; without it json, header and binary. amber: scripts for Amber that judge an "
                   "index function in GLSL")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember({"json", "header", "binary", "amber"}));
  return [options] { return run_vectors(*options); };
}

}  // namespace mmverify::cli
