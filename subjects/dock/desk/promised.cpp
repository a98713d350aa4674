#include "subjects/dock/desk/promised.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "subjects/dock/entry_points.hpp"

namespace mmverify::dock {
namespace {

/// Whether the process can read the eight bytes. The kernel reads a signal mask before it refuses `how`.
bool can_be_read(const std::byte* at) {
  constexpr int no_such_how = -1;
  constexpr std::size_t mask_bytes = 8;
  return syscall(SYS_rt_sigprocmask, no_such_how, at, nullptr, mask_bytes) == 0 || errno != EFAULT;
}

std::string name_of_field(std::size_t offset) {
  constexpr struct {
    std::size_t begin;
    const char* name;
  } others[] = {{offsetof(mmverify_subject_t, abi), "abi"},
                {offsetof(mmverify_subject_t, size), "size"},
                {offsetof(mmverify_subject_t, name), "name"},
                {offsetof(mmverify_subject_t, max_level), "max_level"},
                {offsetof(mmverify_subject_t, flags), "flags"},
                {offsetof(mmverify_subject_t, bake_support), "bake_support"},
                {offsetof(mmverify_subject_t, attribute_support), "attribute_support"},
                {offsetof(mmverify_subject_t, runs_on), "runs_on"}};
  std::size_t last = 0;
  std::string name;
  const auto consider = [&](std::size_t begin, const char* its) {
    if (begin > offset || (!name.empty() && begin < last)) return;
    last = begin;
    name = its;
  };
  for (const auto& [begin, its] : others) consider(begin, its);
  for (const EntryPoint& e : entry_points) consider(e.offset, e.name);
  return name;
}

}  // namespace

Promised::Promised(Get get, const mmverify_subject_t* theirs) : get_(get), theirs_(theirs) {
  const auto* first = reinterpret_cast<const std::byte*>(theirs);
  bytes_.assign(first, first + std::min<std::size_t>(theirs->size, sizeof *theirs));
}

std::string Promised::difference(const mmverify_subject_t* with) const {
  const auto* now = reinterpret_cast<const std::byte*>(with);
  constexpr std::size_t word = 8;
  if (!can_be_read(now) || !can_be_read(now + bytes_.size() - word)) return "can no longer be read";
  // The texts may be made anew.
  const auto is_text = [](std::size_t at) {
    return at / word == offsetof(mmverify_subject_t, name) / word ||
           at / word == offsetof(mmverify_subject_t, runs_on) / word;
  };
  for (std::size_t at = 0; at < bytes_.size(); ++at)
    if (bytes_[at] != now[at] && !is_text(at)) return "changed in its field " + name_of_field(at);
  return {};
}

std::string Promised::change() const {
  if (theirs_ == nullptr) return {};
  const std::string how = difference(theirs_);
  return how.empty() ? how : "its mmverify_subject_t " + how;
}

std::string Promised::change_when_asked_again() const {
  if (theirs_ == nullptr) return {};
  const mmverify_subject_t* again = nullptr;
  try {
    again = get_();
  } catch (...) {
    return "threw an exception when mmverify_subject_v1 was called again";
  }
  if (again == nullptr) return "mmverify_subject_v1, called again, returned null";
  const std::string how = difference(again);
  return how.empty() ? how : "mmverify_subject_v1 was called again, and its mmverify_subject_t " + how;
}

}  // namespace mmverify::dock
