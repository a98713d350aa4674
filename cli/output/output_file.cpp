#include "cli/output/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include "cli/output/exit_code.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw EnvironmentError(fmt::format("{}: {}: {}", path, what, std::strerror(errno)));
}

/// Whether the path is a stream of a process, such as /dev/stdout, whose link cannot be followed.
bool is_stream(const fs::path& path) {
  std::error_code error;
  return fs::canonical(path.parent_path().empty() ? "." : path.parent_path(), error)
      .native()
      .starts_with("/proc/");
}

/// The file behind the path's links, existing or not; nothing for a circle of links.
std::optional<fs::path> behind_links(fs::path path) {
  constexpr int most_links = 40;  // the kernel's own limit
  std::error_code error;
  for (int k = 0; k < most_links; ++k) {
    if (is_stream(path) || !fs::is_symlink(fs::symlink_status(path, error))) return path;
    const fs::path to = fs::read_symlink(path, error);
    if (error) return std::nullopt;
    path = path.parent_path() / to;
  }
  return std::nullopt;
}

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto place = [&error](const std::string& path) {
    const auto target = behind_links(path);
    return target ? fs::weakly_canonical(fs::absolute(*target, error), error) : fs::path();
  };
  const fs::path first = place(a);
  return !first.empty() && first == place(b);
}

constexpr char ending[] = ".part";
constexpr std::size_t digits = 16;

}  // namespace

std::string name_until_whole(const std::string& target) {
  std::random_device random;  // not seeded: other processes must not guess the name
  return fmt::format("{}.{:08x}{:08x}{}", target, random(), random(), ending);
}

void remove_left_over(const std::string& target) {
  const fs::path path = target;
  const std::string begins = path.filename().string() + ".";
  const std::size_t length = begins.size() + digits + sizeof ending - 1;
  std::error_code error;
  for (fs::directory_iterator at(path.parent_path().empty() ? "." : path.parent_path(), error), end;
       !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.size() != length || !name.starts_with(begins) || !name.ends_with(ending)) continue;
    const int file = open(at->path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) continue;
    std::error_code ignored;
    if (flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove_all(at->path(), ignored);
    close(file);
  }
}

OutputFile::OutputFile(const std::string& path) : path_(path) {
  const auto target = behind_links(path);
  if (!target) {
    errno = ELOOP;
    fail(path_, "cannot be written");
  }
  struct stat there {};
  if (stat(target->c_str(), &there) == 0) old_ = there;
  if (is_stream(*target) || (old_ && !S_ISREG(old_->st_mode))) {
    // open() reports an error for a folder.
    descriptor_ = open(target->c_str(), O_WRONLY | O_CLOEXEC);
  } else if (!old_ || access(target->c_str(), W_OK) == 0) {
    target_ = target->string();
    open_beside();
  }
  if (descriptor_ < 0) fail(path_, "cannot be written");
}

void OutputFile::open_beside() {
  remove_left_over(target_);
  const mode_t mode = old_ ? 0600 : 0666;
#ifdef O_TMPFILE
  const fs::path folder = fs::path(target_).parent_path();
  if (access("/proc/self/fd", X_OK) == 0)  // name_it() needs it
    descriptor_ = open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
#endif
  if (descriptor_ < 0) {
    temporary_ = name_until_whole(target_);
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  }
  if (descriptor_ >= 0) flock(descriptor_, LOCK_EX | LOCK_NB);  // against remove_left_over()
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::remove_old() const {
  if (!target_.empty()) unlink(target_.c_str());
}

/// Gives the new file the mode and owner of the one that it replaces, so that nobody else may read it.
void OutputFile::take_mode() const {
  if (!old_) return;
  struct stat mine {};
  const bool same_owner =
      (fstat(descriptor_, &mine) == 0 && mine.st_uid == old_->st_uid && mine.st_gid == old_->st_gid) ||
      fchown(descriptor_, old_->st_uid, old_->st_gid) == 0;
  // If the owner differs, the group does too, and gets no access.
  fchmod(descriptor_, old_->st_mode & (same_owner ? 0777u : 0707u));
}

/// Gives a nameless file a name, for rename() to move.
void OutputFile::name_it() {
  const std::string name = name_until_whole(target_), self = fmt::format("/proc/self/fd/{}", descriptor_);
  if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0)
    fail(path_, "cannot be put in place");
  temporary_ = name;
}

void OutputFile::commit(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = write(descriptor_, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, "cannot be written to the end");
    at += static_cast<std::size_t>(written);
  }
  if (target_.empty()) return;
  take_mode();
  if (fsync(descriptor_) != 0) fail(path_, "cannot be written to the end");
  if (temporary_.empty()) name_it();
  const int done = close(descriptor_);
  descriptor_ = -1;
  if (done != 0) fail(path_, "cannot be written to the end");
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, "cannot be put in place");
  temporary_.clear();
}

void refuse_same_file(const std::vector<NamedPath>& arguments) {
  for (std::size_t a = 0; a < arguments.size(); ++a)
    for (std::size_t b = a + 1; b < arguments.size(); ++b)
      if (arguments[b].second != "-" && same_file(arguments[a].second, arguments[b].second))
        throw UsageError(fmt::format("{} and {} name the same file, {}; name two", arguments[a].first,
                                     arguments[b].first, arguments[b].second));
}

void refuse_no_folder(const char* option, const std::string& folder) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return;
  throw EnvironmentError(fmt::format("{} {}: there is no such folder", option, folder));
}

void need_folder(const char* option, const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
    throw EnvironmentError(fmt::format("{} {}: no folder, and none can be made", option, folder));
}

}  // namespace mmverify::cli
