#include "cli/vectors/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/output/exit_code.hpp"
#include "cli/output/output_file.hpp"
#include "delivery/vectors/families.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot(const std::string& place, const char* what, const std::error_code& error) {
  throw EnvironmentError(fmt::format("{}: {}: {}", place, what, error.message()));
}

/// Whether a folder of vectors may have a file of this name: a forged manifest may list any other.
bool is_of_vectors(const std::string& name) {
  if (name == vectors::header_name || name == vectors::binary_name) return true;
  for (const char* script : vectors::amber_names)
    if (name == script) return true;
  const auto& all = vectors::families();
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& family) { return name == std::string(family.name) + ".json"; });
}

/// The files that a folder's manifest lists, with the manifest; none if it has no manifest of vectors.
std::set<std::string> listed_in(const fs::path& folder) {
  std::ifstream in(folder / vectors::manifest_name);
  const auto manifest = nlohmann::json::parse(in, nullptr, false);
  if (!manifest.is_object() || !manifest.contains("schema") || !manifest["schema"].is_string()) return {};
  // A folder of this or an earlier form may be replaced.
  if (!manifest["schema"].get<std::string>().starts_with("mmverify.vectors/")) return {};
  std::set<std::string> names{vectors::manifest_name};
  const auto files = manifest.find("files");
  if (files != manifest.end() && files->is_array())
    for (const auto& file : *files)
      if (file.is_object() && file.contains("file") && file["file"].is_string() &&
          is_of_vectors(file["file"]))
        names.insert(file["file"]);
  return names;
}

std::set<std::string> names_in(const fs::path& folder, const std::string& asked) {
  std::error_code error;
  std::set<std::string> found;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    found.insert(at->path().filename().string());
  if (error) cannot(asked, "cannot be listed", error);
  return found;
}

}  // namespace

VectorsFolder::VectorsFolder(const std::string& asked) : asked_(asked) {
  std::error_code error;
  const fs::path given(asked), name = given.has_filename() ? given : given.parent_path();
  const bool there = fs::exists(name, error);
  if (there && !fs::is_directory(name, error))
    throw EnvironmentError(fmt::format("{}: is no folder; vectors are several files", asked));
  folder_ = there ? fs::canonical(name, error) : fs::absolute(name, error);
  if (error) cannot(asked, "cannot be found", error);
  if (there) before_ = names_in(folder_, asked);
  const std::set<std::string> listed = before_.empty() ? before_ : listed_in(folder_);
  for (const std::string& file : before_)
    if (!listed.contains(file))
      throw EnvironmentError(
          fmt::format("{}: has {}, which no earlier run has written; name a folder that is new, empty or has "
                      "vectors alone",
                      asked, file));
  remove_left_over(folder_.string());
  stage_ = name_until_whole(folder_.string());
  fs::create_directories(stage_.parent_path(), error);
  const bool made = !error && fs::create_directory(stage_, error);
  if (!made) cannot(asked, "cannot be written", error);
  lock_ = open(stage_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ >= 0) flock(lock_, LOCK_EX | LOCK_NB);  // protects it from another run's remove_left_over()
}

VectorsFolder::~VectorsFolder() {
  std::error_code none;
  fs::remove_all(stage_, none);
  if (lock_ >= 0) close(lock_);
}

void VectorsFolder::commit(std::span<const vectors::File> files) {
  for (const auto& [file, bytes] : files) try {
      OutputFile((stage_ / file).string()).commit(bytes);
    } catch (const EnvironmentError& why) {
      // The message names the requested folder: the user does not know of the temporary one.
      throw EnvironmentError(asked_ + std::string(why.what()).substr(stage_.string().size()));
    }
  std::error_code error;
  if (!fs::exists(folder_, error)) {
    fs::rename(stage_, folder_, error);
    if (error) cannot(asked_, "cannot be put in place", error);
    return;
  }
  fs::remove(folder_ / vectors::manifest_name, error);
  for (const auto& [file, bytes] : files) {
    fs::rename(stage_ / file, folder_ / file, error);
    if (error) cannot(asked_ + "/" + file, "cannot be put in place", error);
    before_.erase(file);
  }
  for (const std::string& old : before_) fs::remove(folder_ / old, error);
}

}  // namespace mmverify::cli
