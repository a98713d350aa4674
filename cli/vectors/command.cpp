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
  std::vector<std::string> families;
};

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
  const proofs::InterruptGuard guard;
  VectorsFolder folder(options.folder);
  std::vector<vectors::Family> made;
  for (const vectors::FamilyRow& row : vectors::families())
    if (options.families.empty() ||
        std::find(options.families.begin(), options.families.end(), row.name) != options.families.end())
      made.push_back(row.make());
  const auto files = vectors::files_of(made, {build::version, build::spec_hash, shaders::sha256});
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
      "vectors", "test vectors for other people's tests: JSON, a C header, a binary to upload");
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
  return [options] { return run_vectors(*options); };
}

}  // namespace mmverify::cli
