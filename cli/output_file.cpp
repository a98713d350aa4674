#include "cli/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "cli/exit_code.hpp"

namespace mmverify::cli {
namespace {
[[noreturn]] void fail(const std::string& path, const char* what) {
  throw EnvironmentError(fmt::format("{}: {}: {}", path, what, std::strerror(errno)));
}

bool special(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}
}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (special(path_)) {
    // A pipe or a device is written as it is; a folder says so here.
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    temporary_ = fmt::format("{}.{}.part", path_, getpid());
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  if (descriptor_ < 0) fail(path_, "cannot be written");
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::commit(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = write(descriptor_, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, "cannot be written to the end");
    at += static_cast<std::size_t>(written);
  }
  if (temporary_.empty()) return;
  if (fsync(descriptor_) != 0) fail(path_, "cannot be written to the end");
  const int done = close(descriptor_);
  descriptor_ = -1;
  if (done != 0) fail(path_, "cannot be written to the end");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "cannot be put in place");
  temporary_.clear();
}

}  // namespace mmverify::cli
