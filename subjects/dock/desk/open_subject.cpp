#include "subjects/dock/desk/open_subject.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "subjects/dock/load_error.hpp"

namespace mmverify::dock {
namespace {

/// The subject's description, with null for entry points that its header does not have.
mmverify_subject_t as_of_today(const mmverify_subject_t& theirs) {
  mmverify_subject_t ours{};
  // Whole pointers only: a size that ends within a pointer does not count it.
  const std::size_t size = std::min<std::size_t>(theirs.size, sizeof ours) / sizeof(void*) * sizeof(void*);
  std::memcpy(&ours, &theirs, size);
  return ours;
}

/// The subject's description of its support, with zeros for fields that its header does not have.
template <class Support>
Support supported(const Support* theirs) {
  Support ours{};
  if (theirs == nullptr) return ours;
  const std::size_t size = std::min<std::size_t>(theirs->size, sizeof ours) / sizeof(std::uint32_t);
  std::memcpy(&ours, theirs, size * sizeof(std::uint32_t));
  return ours;
}

/// The size of the first version of mmverify_subject_t, which ended with row_corners.
constexpr std::size_t first_size = offsetof(mmverify_subject_t, tree_encode);

std::array<std::uint8_t, calls> given(const mmverify_subject_t& s) {
#define MMVERIFY_GIVEN(name, topic, values, arguments) s.name != nullptr ? std::uint8_t{1} : std::uint8_t{0},
  return {MMVERIFY_ENTRY_POINTS(MMVERIFY_GIVEN)};
#undef MMVERIFY_GIVEN
}

}  // namespace

std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject,
                        Promised& promised, Outcome& outcome) {
  outcome = Outcome::cannot_open;
  void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return load_error(library);
  outcome = Outcome::cannot_load;
  const auto get = reinterpret_cast<Promised::Get>(dlsym(handle, "mmverify_subject_v1"));
  if (get == nullptr) return "it does not export mmverify_subject_v1";
  const mmverify_subject_t* theirs = get();
  if (theirs == nullptr) {
    using Why = const char* (*)();
    const auto why = reinterpret_cast<Why>(dlsym(handle, "mmverify_subject_v1_not_here"));
    const char* reason = why == nullptr ? nullptr : why();
    if (reason == nullptr || *reason == 0) return "mmverify_subject_v1 returned null";
    outcome = Outcome::not_here;
    return reason;
  }
  if (theirs->abi != MMVERIFY_SUBJECT_ABI)
    return "it was built for version " + std::to_string(theirs->abi) + " of the interface, this is version " +
           std::to_string(MMVERIFY_SUBJECT_ABI);
  if (theirs->size < first_size)
    return "its size field is " + std::to_string(theirs->size) +
           ", smaller than mmverify_subject_t; write .size = sizeof(mmverify_subject_t)";
  subject = as_of_today(*theirs);
  promised = Promised(get, theirs);
  description.max_level = subject.max_level;
  description.flags = subject.flags;
  description.has = given(subject);
  description.bake_support = supported(subject.bake_support);
  description.attribute_support = supported(subject.attribute_support);
  std::snprintf(description.name, sizeof description.name, "%s", subject.name == nullptr ? "" : subject.name);
  std::snprintf(description.runs_on, sizeof description.runs_on, "%s",
                subject.runs_on == nullptr ? "" : subject.runs_on);
  outcome = Outcome::ready;
  return {};
}

}  // namespace mmverify::dock
