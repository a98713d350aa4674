#include "dock/desk/open_subject.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "dock/load_error.hpp"

namespace mmverify::dock {
namespace {

/// The subject's description, entry points that its header did not have yet null.
mmverify_subject_t as_of_today(const mmverify_subject_t& theirs) {
  mmverify_subject_t ours{};
  // Whole pointers only: a size in the middle of one says nothing of it.
  const std::size_t size = std::min<std::size_t>(theirs.size, sizeof ours) / sizeof(void*) * sizeof(void*);
  std::memcpy(&ours, &theirs, size);
  return ours;
}

/// Bytes of the first version of mmverify_subject_t, which ended with row_corners.
constexpr std::size_t first_size = offsetof(mmverify_subject_t, tree_encode);

std::array<bool, calls> given(const mmverify_subject_t& s) {
#define MMVERIFY_GIVEN(name, topic, values, arguments) s.name != nullptr,
  return {MMVERIFY_ENTRY_POINTS(MMVERIFY_GIVEN)};
#undef MMVERIFY_GIVEN
}

}  // namespace

std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject) {
  void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return load_error(library);
  using Get = const mmverify_subject_t* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(handle, "mmverify_subject_v1"));
  if (get == nullptr) return "it does not export mmverify_subject_v1";
  const mmverify_subject_t* theirs = get();
  if (theirs == nullptr) return "mmverify_subject_v1 returned null";
  if (theirs->abi != MMVERIFY_SUBJECT_ABI)
    return "it was built for version " + std::to_string(theirs->abi) + " of the interface, this is version " +
           std::to_string(MMVERIFY_SUBJECT_ABI);
  if (theirs->size < first_size) return "its size field is smaller than mmverify_subject_t";
  subject = as_of_today(*theirs);
  if (subject.max_level > 16) return "its max_level is above 16";
  description.max_level = subject.max_level;
  description.flags = subject.flags;
  description.has = given(subject);
  if (std::count(description.has.begin(), description.has.end(), true) == 0)
    return "all its entry points are null";
  std::snprintf(description.name, sizeof description.name, "%s", subject.name == nullptr ? "" : subject.name);
  return {};
}

}  // namespace mmverify::dock
