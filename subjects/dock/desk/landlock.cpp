#include "subjects/dock/desk/landlock.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace mmverify::dock {
namespace {

// Numbers of include/uapi/linux/landlock.h; the installed header may be older than the kernel.
constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;
constexpr std::uint32_t ask_version = 1, rule_path_beneath = 1;
constexpr std::uint64_t write_file = 1u << 1, refer = 1u << 13, truncate_file = 1u << 14,
                        scope_signal = 1u << 1;
constexpr long version_with_refer = 2, version_with_truncate = 3, version_with_scopes = 6;

struct RulesetAttributes {
  std::uint64_t handled_access_fs, handled_access_net, scoped;
};
struct [[gnu::packed]] PathBeneath {
  std::uint64_t allowed_access;
  std::int32_t parent_fd;
};

/// A set of rules; it refuses these kinds of access unless a rule allows it.
class Ruleset {
 public:
  explicit Ruleset(long version)
      : access_(write_file | (version >= version_with_refer ? refer : 0) |
                (version >= version_with_truncate ? truncate_file : 0)) {
    const RulesetAttributes attributes{access_, 0, version >= version_with_scopes ? scope_signal : 0};
    // Older kernels know the first field only.
    const std::size_t size = version >= version_with_scopes ? sizeof attributes : sizeof(std::uint64_t);
    fd_ = static_cast<int>(syscall(create_ruleset, &attributes, size, 0));
  }
  ~Ruleset() {
    if (fd_ >= 0) close(fd_);
  }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;

  /// Allows writing to the entries of a folder, except for those whose names begin with one of `but`.
  void let_entries(const char* folder, std::initializer_list<std::string_view> but) {
    DIR* const all = opendir(folder);
    if (all == nullptr) return;
    while (const dirent* entry = readdir(all)) {
      const std::string_view name = entry->d_name;
      bool let = name != "." && name != "..";
      for (const std::string_view start : but) let = let && !name.starts_with(start);
      if (let) let_one(dirfd(all), entry->d_name);
    }
    closedir(all);
  }

  bool enforce() const { return fd_ >= 0 && syscall(restrict_self, fd_, 0) == 0; }

 private:
  /// Allows writing to one entry. Links are skipped: their targets have entries of their own.
  void let_one(int folder, const char* name) {
    const int fd = openat(folder, name, O_PATH | O_NOFOLLOW | O_CLOEXEC);
    struct stat about {};
    if (fd >= 0 && fstat(fd, &about) == 0 && !S_ISLNK(about.st_mode)) {
      const PathBeneath rule{S_ISDIR(about.st_mode) ? access_ : access_ & ~refer, fd};
      syscall(add_rule, fd_, rule_path_beneath, &rule, 0);
    }
    if (fd >= 0) close(fd);
  }

  std::uint64_t access_;
  int fd_ = -1;
};

}  // namespace

bool lock_out_terminals_and_processes() {
  const long version = syscall(create_ruleset, nullptr, 0, ask_version);
  if (version < 1) return false;
  Ruleset rules(version);
  rules.let_entries("/", {"proc", "sys", "dev"});
  rules.let_entries("/dev", {"tty", "pts", "ptmx", "console", "vcs", "hvc"});
  return rules.enforce();
}

}  // namespace mmverify::dock
