#include "dock/desk/open_subject.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
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

/// What it says that it supports, fields that its header did not have yet zero.
template <class Support>
Support supported(const Support* theirs) {
  Support ours{};
  if (theirs == nullptr) return ours;
  const std::size_t size = std::min<std::size_t>(theirs->size, sizeof ours) / sizeof(std::uint32_t);
  std::memcpy(&ours, theirs, size * sizeof(std::uint32_t));
  return ours;
}

/// A set of values below a number.
bool within(std::uint32_t set, std::uint32_t values) { return set >> values == 0; }

/// What in it cannot be, or nothing.
std::string contradiction(const mmverify_bake_support_t& s) {
  if (s.max_level > 12) return "max_level is above 12";
  if ((s.formats & 1u) != 0 || !within(s.formats, 3)) return "formats is no set of formats";
  if ((s.texels & 1u) != 0 || !within(s.texels, 4)) return "texels is no set of texel types";
  if (!within(s.filters, 2)) return "filters is no set of filters";
  if (!within(s.wraps, 5)) return "wraps is no set of addressing modes";
  if (!within(s.alpha_modes, 2)) return "alpha_modes is no set of alpha modes";
  if (s.max_side != 0 && (s.max_side < 4 || s.max_side > 16384)) return "max_side is not 4 to 16384";
  if (!within(s.restrictions, 5)) return "restrictions has a bit that means nothing";
  if (s.fixed_cutoff != 0 && !(s.fixed_cutoff >= 0x1p-8f && s.fixed_cutoff <= 1))
    return "fixed_cutoff is not 1/256 to 1";
  if (s.opaque > MMVERIFY_OPAQUE_ABOVE_CUTOFF || s.contact > MMVERIFY_OPEN_MICRO_TRIANGLES ||
      s.unknown > MMVERIFY_UNKNOWN_TRANSPARENT)
    return "opaque, contact or unknown is no such rule";
  if (!(std::isfinite(s.uv_min) && std::isfinite(s.uv_max)) ||
      ((s.uv_min != 0 || s.uv_max != 0) && !(s.uv_min < s.uv_max)))
    return "uv_min is not below uv_max";
  if (s.weight_bits > 23 || s.coordinate_bits > 23) return "weight_bits or coordinate_bits is above 23";
  return {};
}

std::string contradiction(const mmverify_attribute_support_t& s) {
  if (s.max_level > 12) return "max_level is above 12";
  if (!within(s.meanings, 4)) return "meanings is no set of meanings";
  if (!within(s.filters, 2)) return "filters is no set of filters";
  if (!within(s.wraps, 5)) return "wraps is no set of addressing modes";
  if ((s.restrictions & ~MMVERIFY_BAKE_SAME_WRAPS) != 0) return "restrictions has a bit that means nothing";
  if (s.tolerance > 16) return "tolerance is above 16";
  return {};
}

/// Bytes of the first version of mmverify_subject_t, which ended with row_corners.
constexpr std::size_t first_size = offsetof(mmverify_subject_t, tree_encode);

std::array<bool, calls> given(const mmverify_subject_t& s) {
#define MMVERIFY_GIVEN(name, topic, values, arguments) s.name != nullptr,
  return {MMVERIFY_ENTRY_POINTS(MMVERIFY_GIVEN)};
#undef MMVERIFY_GIVEN
}

}  // namespace

std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject,
                        Outcome& outcome) {
  outcome = Outcome::cannot_load;
  void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return load_error(library);
  using Get = const mmverify_subject_t* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(handle, "mmverify_subject_v1"));
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
  if (theirs->size < first_size) return "its size field is smaller than mmverify_subject_t";
  subject = as_of_today(*theirs);
  if (subject.max_level > 16) return "its max_level is above 16";
  if ((subject.flags & MMVERIFY_CORNERS_OF_CHILDREN) != 0 && (subject.flags & MMVERIFY_CORNERS_BASE_U_V) != 0)
    return "its flags declare two orders of corners";
  description.max_level = subject.max_level;
  description.flags = subject.flags;
  description.has = given(subject);
  description.bake_support = supported(subject.bake_support);
  if (const std::string wrong = contradiction(description.bake_support); !wrong.empty())
    return "of its bake_support " + wrong;
  description.attribute_support = supported(subject.attribute_support);
  if (const std::string wrong = contradiction(description.attribute_support); !wrong.empty())
    return "of its attribute_support " + wrong;
  if (std::count(description.has.begin(), description.has.end(), true) == 0)
    return "all its entry points are null";
  std::snprintf(description.name, sizeof description.name, "%s", subject.name == nullptr ? "" : subject.name);
  std::snprintf(description.runs_on, sizeof description.runs_on, "%s",
                subject.runs_on == nullptr ? "" : subject.runs_on);
  outcome = Outcome::ready;
  return {};
}

}  // namespace mmverify::dock
