#include "cli/repair/output.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/output/exit_code.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;
using namespace mmverify::scene;

std::string folder_of(const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string lower_extension(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// A file's name as a URI.  Source: RFC 3986, 2.3: other characters than these are written as %XX.
std::string as_uri(const std::string& name) {
  std::string uri;
  for (const char c : name) {
    const bool stays = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    uri += stays ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string as_text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

/// The files written so far, which go if not all of them can be.
class Committed {
 public:
  ~Committed() {
    std::error_code ignored;
    if (!whole)
      for (const fs::path& path : new_) fs::remove(path, ignored);
  }
  void write(const fs::path& path, const Bytes& bytes) {
    std::error_code error;
    const bool is_new = !fs::exists(path, error);
    for (fs::path folder = path.parent_path(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
      new_.push_back(folder);
    need_folder("-o", path.parent_path().string());
    if (is_new) new_.insert(new_.begin(), path);
    OutputFile(path.string()).commit(as_text(bytes));
  }
  bool whole = false;

 private:
  std::vector<fs::path> new_;  ///< files before their folders
};

}  // namespace

RepairOutput::RepairOutput(const std::string& input, const std::string& output)
    : input_(input), output_(output), same_folder_(false), file_(output) {
  std::error_code error;
  same_folder_ = fs::equivalent(folder_of(input), folder_of(output), error);
  const std::string wanted = lower_extension(input), given = lower_extension(output);
  if (wanted != given && (given == ".glb" || given == ".gltf"))
    throw UsageError(fmt::format("-o {}: repair keeps the form of {}; name a {}", output, input, wanted));
}

void RepairOutput::rename_buffers(EditedFile& file) const {
  if (!same_folder_) return;
  std::size_t number = 0;
  for (auto& [uri, bytes] : file.written().buffers) {
    const std::string name = fs::path(output_).stem().string() +
                             (number == 0 ? "" : fmt::format("_{}", number)) +
                             fs::path(uri).extension().string();
    ++number;
    for (auto& buffer : file.json["buffers"])
      if (buffer.value("uri", std::string()) == uri) buffer["uri"] = as_uri(name);
  }
}

void RepairOutput::commit(const EditedFile& file, const WrittenFile& written) {
  std::map<std::string, Bytes> beside_it = written.buffers;
  if (!same_folder_)
    for (const std::string& uri : file.uris())
      if (!beside_it.contains(uri))
        beside_it[uri] = read_file(mmverify::scene::beside(input_, uri, uri), input_, uri);
  std::vector<NamedPath> inputs{{"FILE", input_}};
  for (const std::string& uri : EditedFile(input_).uris())
    inputs.emplace_back("a file of FILE", mmverify::scene::beside(input_, uri, uri).string());
  Committed committed;
  std::vector<std::pair<fs::path, const Bytes*>> files;
  for (const auto& [uri, bytes] : beside_it) {
    const fs::path path = mmverify::scene::beside(output_, uri, uri);
    for (const NamedPath& one : inputs) refuse_same_file({{"-o", path.string()}, one});
    std::error_code error;
    // A repair into the same folder may be repeated: its buffers are then written anew, as its file is.
    if (!(same_folder_ && fs::exists(output_, error)) && fs::exists(path, error)) {
      if (fs::is_regular_file(path, error) && read_file(path, path.string(), "") == bytes) continue;
      throw EnvironmentError(
          fmt::format("{}: it is there, with other bytes; name another folder", path.string()));
    }
    files.emplace_back(path, &bytes);
  }
  for (const auto& [path, bytes] : files) committed.write(path, *bytes);
  file_.commit(as_text(written.bytes));
  committed.whole = true;
}

}  // namespace mmverify::cli
