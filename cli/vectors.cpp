// mmverify vectors: test vectors that others compile in or upload.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/arguments.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output_file.hpp"
#include "shaders/compile/sha256.hpp"
#include "vectors/families.hpp"
#include "vectors/forms/forms.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;
using vectors::Family;
using vectors::File;

struct VectorsOptions {
  std::string folder;
  std::vector<std::string> families;
};

[[noreturn]] void cannot(const fs::path& place, const char* what, const std::error_code& error) {
  throw EnvironmentError(fmt::format("{}: {}: {}", place.string(), what, error.message()));
}

/// The names that a folder's manifest lists, its own among them; none where it has no manifest of vectors.
std::set<std::string> listed_in(const fs::path& folder) {
  std::ifstream in(folder / vectors::manifest_name);
  const auto manifest = nlohmann::json::parse(in, nullptr, false);
  if (!manifest.is_object() || manifest.value("schema", nlohmann::json()) != vectors::schema_name) return {};
  std::set<std::string> names{vectors::manifest_name};
  for (const auto& file : manifest.value("files", nlohmann::json::array()))
    if (file.is_object() && file.contains("file") && file["file"].is_string()) names.insert(file["file"]);
  return names;
}

/// The files of a folder, which is not there, is empty or has vectors alone; else EnvironmentError.
std::set<std::string> vectors_in(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return {};
  if (!fs::is_directory(folder, error))
    throw EnvironmentError(fmt::format("{}: is no folder; vectors are several files", folder.string()));
  std::set<std::string> found;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    found.insert(at->path().filename().string());
  if (error) cannot(folder, "cannot be listed", error);
  const std::set<std::string> listed = found.empty() ? found : listed_in(folder);
  for (const std::string& name : found)
    if (!listed.contains(name))
      throw EnvironmentError(
          fmt::format("{}: has {}, which no earlier run has written; name a folder that is new, empty or "
                      "has vectors alone",
                      folder.string(), name));
  return found;
}

/// A folder beside the one that is asked for, removed with all that is left in it.
class Stage {
 public:
  explicit Stage(const fs::path& folder) : path_(fmt::format("{}.{}.part", folder.string(), getpid())) {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) cannot(folder, "cannot be written", error);
  }
  ~Stage() {
    std::error_code none;
    fs::remove_all(path_, none);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// All files, or none: a folder that is new appears whole.  In one that is there the manifest goes first and comes last,
/// so that it stands for whole vectors alone.
void write(const fs::path& asked, const std::vector<File>& files) {
  const fs::path name = asked.has_filename() ? asked : asked.parent_path();
  std::error_code error;
  const fs::path folder = fs::exists(name, error) ? fs::canonical(name, error) : fs::absolute(name, error);
  std::set<std::string> before = vectors_in(folder);
  const Stage stage(folder);
  for (const auto& [file, bytes] : files) OutputFile((stage.path() / file).string()).commit(bytes);
  if (!fs::exists(folder, error)) {
    fs::rename(stage.path(), folder, error);
    if (error) cannot(folder, "cannot be put in place", error);
    return;
  }
  fs::remove(folder / vectors::manifest_name, error);
  for (const auto& [file, bytes] : files) {
    fs::rename(stage.path() / file, folder / file, error);
    if (error) cannot(folder / file, "cannot be put in place", error);
    before.erase(file);
  }
  for (const std::string& old : before) fs::remove(folder / old, error);
}

int run_vectors(const VectorsOptions& options) {
  if (options.folder == "-") throw UsageError("-o -: vectors are several files; name a folder");
  std::vector<Family> made;
  for (const vectors::FamilyRow& row : vectors::families())
    if (options.families.empty() || std::ranges::find(options.families, row.name) != options.families.end())
      made.push_back(row.make());
  const std::vector<File> files =
      vectors::files_of(made, {build::version, build::spec_hash, shaders::sha256});
  write(options.folder, files);

  for (const Family& family : made) {
    std::string tables;
    for (const vectors::Table& table : family.tables)
      tables += fmt::format("{}{} {}", tables.empty() ? "" : ", ", table.name, grouped(table.records()));
    fmt::print("{:<10} {}\n", family.name, tables);
  }
  std::size_t bytes = 0;
  for (const File& file : files) bytes += file.second.size();
  fmt::print("{}: {} files, {} bytes\n", options.folder, files.size(), grouped(bytes));
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
      "has, "
      "and how\na driver's, a translation layer's or an engine's tests take them in.");
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
