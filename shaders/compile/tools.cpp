#include "shaders/compile/tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace mmverify::shaders {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view begins = "mmverify-shader-";

/// The folder, opened and locked; -1 where it is somebody's, or gone.
int locked(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return -1;
  struct stat opened {};
  struct stat there {};
  if (flock(folder, LOCK_EX | LOCK_NB) == 0 && fstat(folder, &opened) == 0 &&
      lstat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino && opened.st_dev == there.st_dev &&
      opened.st_uid == geteuid())
    return folder;
  close(folder);
  return -1;
}

/// Removes folders that no process holds.
void sweep() {
  std::error_code error;
  for (fs::directory_iterator at(fs::temp_directory_path(error), error), end; !error && at != end;
       at.increment(error)) {
    const fs::path& path = at->path();
    if (!path.filename().string().starts_with(begins)) continue;
    const int folder = locked(path.string());
    if (folder < 0) continue;
    std::error_code ignored;
    fs::remove_all(path, ignored);
    close(folder);
  }
}

}  // namespace

std::optional<program::ProgramEnd> ended(const std::vector<std::string>& words) {
  using std::chrono_literals::operator""s;
  try {
    return program::run_program(words, {}, {}, {60s, std::uint64_t{1} << 30, std::uint64_t{64} << 20});
  } catch (const program::NoProgram&) {
    return std::nullopt;
  }
}

std::string contents_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file)) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

Folder::Folder() {
  sweep();
  // Somebody else's sweep may take the folder away before it is locked.
  constexpr int tries = 100;
  for (int k = 0; k < tries && lock_ < 0; ++k) {
    path_ = (fs::temp_directory_path() / (std::string(begins) + "XXXXXX")).string();
    if (mkdtemp(path_.data()) == nullptr)
      throw std::runtime_error(fmt::format("{}: {}", path_, std::strerror(errno)));
    lock_ = locked(path_);
  }
  if (lock_ < 0) throw std::runtime_error(path_ + ": no lock on it");
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  close(lock_);
}

std::string Folder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

}  // namespace mmverify::shaders
