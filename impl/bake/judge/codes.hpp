// Packed states from marks.  Internal to impl/bake.
#pragma once

#include <cstdint>

#include "impl/bake/exact/base.hpp"
#include "impl/bake/marks.hpp"

namespace mmverify::impl::bake::detail {

// Packed codes: T 0, O 1, UT 2, UO 3.
inline constexpr unsigned opaque_code = 1, unknown = 2;

/// Set beside the certain marks if further marks may exist.
inline constexpr Marks uncertain = 4;

/// The code of a micro-triangle with one mark.
inline unsigned known_code(Marks all) noexcept { return all == opaque ? opaque_code : 0; }

inline unsigned code_of(const ExactBase::Answer& answer) noexcept {
  if (answer.marks != both) return known_code(answer.marks);
  return answer.leans_to_opaque ? unknown | 1 : unknown;
}

}  // namespace mmverify::impl::bake::detail
