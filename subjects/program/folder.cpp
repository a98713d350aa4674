#include "subjects/program/folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace mmverify::program {

namespace fs = std::filesystem;

namespace {

/// The folder's descriptor, opened and locked; -1 if another process or user has it, or it is gone.
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

/// Removes the folders whose names begin with `begins` and that no process has locked.
void sweep(const std::string& begins) {
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

Folder::Folder(const std::string& kind) {
  std::error_code none;
  const fs::path home = fs::temp_directory_path(none);
  if (none)
    throw std::runtime_error(
        "no folder for temporary files: TMPDIR, or /tmp if it is not set, is not a folder; set TMPDIR to "
        "one");
  const std::string begins = "mmverify-" + kind + "-";
  sweep(begins);
  // A sweep by another process may remove the folder before it is locked.
  constexpr int tries = 100;
  for (int k = 0; k < tries && lock_ < 0; ++k) {
    path_ = (home / (begins + "XXXXXX")).string();
    if (mkdtemp(path_.data()) == nullptr)
      throw std::runtime_error("no temporary folder " + path_ + ": " + std::strerror(errno));
    lock_ = locked(path_);
  }
  if (lock_ < 0) throw std::runtime_error(path_ + ": no lock on it");
  try {
    check_room();
  } catch (...) {
    remove();
    throw;
  }
}

void Folder::check_room() const {
  struct statvfs system {};
  constexpr std::uint64_t least = 64 << 10;
  if (statvfs(path_.c_str(), &system) == 0 && std::uint64_t{system.f_bavail} * system.f_frsize < least)
    throw std::runtime_error(path_ + ": its file system is full; set TMPDIR to a folder with room");
}

Folder::~Folder() { remove(); }

void Folder::remove() const {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  close(lock_);
}

std::string Folder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

}  // namespace mmverify::program
