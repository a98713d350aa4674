// The valid-usage identifiers of Vulkan that a finding breaks.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "impl/micromap/validate.hpp"

namespace mmverify::scene {

/// The cases of a rule that Vulkan tells apart, as bits of a set.
using Cases = unsigned;
namespace cases {
inline constexpr Cases always = 0;
inline constexpr Cases two_state = 1;         ///< a record or a usage count of format 1
inline constexpr Cases four_state = 2;        ///< of format 2
inline constexpr Cases array = 4;             ///< the array's usage counts
inline constexpr Cases geometry = 8;          ///< a geometry's usage counts
inline constexpr Cases with_indices = 16;     ///< the geometry has an index buffer
inline constexpr Cases without_indices = 32;  ///< indexType is NONE
inline constexpr Cases null_micromap = 64;    ///< the array has no records
inline constexpr Cases has_records = 128;
}  // namespace cases

/// One identifier: the finding's code, and when it applies.
struct Vuid {
  std::string_view code;
  impl::micromap::Sets api;  ///< EXT or KHR
  Cases when;                ///< all of these cases hold
  std::string_view name;
  /// One of the checks on the GPU that Vulkan-ValidationLayers lacks by its issue 12585.
  bool missing_there = false;
};

/// All identifiers, in the order of docs/ISSUES.md.  Source: Vulkan-Docs 1.4.360, commit 090f1b19.
std::span<const Vuid> vuids();

/// The names for a finding of a code in these cases, by the APIs of `sets`.  A glTF file or an array file that is judged
/// for no API has those of both, since it may be built for either.
std::vector<std::string_view> vuids_of(std::string_view code, impl::micromap::Sets sets, Cases cases);

/// The cases of a violation of `in`.
Cases cases_of(const impl::micromap::Violation& violation, const impl::micromap::Input& in);

}  // namespace mmverify::scene
