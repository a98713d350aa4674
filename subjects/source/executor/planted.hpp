// Kinds of obligations, and deliberate mistakes of the executor, which its tests must notice.
#pragma once

#include <array>
#include <string_view>

namespace mmverify::source::executor {

/// The kinds of obligations: what a law checks, and what C leaves undefined.
enum class Duty {
  checks,
  bounds,
  pointers,
  life,
  unset,
  alignment,
  shifts,
  overflow,
  division,
  overlap,
  constants,
  promises,
  ends
};

inline constexpr std::array<std::string_view, 13> duties{
    "checks",   "bounds",   "pointers", "life",      "unset",    "alignment", "shifts",
    "overflow", "division", "overlap",  "constants", "promises", "ends"};

enum class Mistake {
  none,
  signed_compare,  ///< unsigned numbers are compared as signed ones
  sign_lost,       ///< a signed number is widened with zeros
  shift_without_sign,
  other_branch,    ///< a branch goes the other way
  other_side,      ///< paths that meet take each other's values
  bytes_reversed,  ///< a number of several bytes is read backwards, unless it was stored whole
  write_anywhere,  ///< a write at a place that the inputs choose goes to all places
  borrow_lost,     ///< a - b without the last carry
  remainder_for_quotient,
  copy_short,      ///< memcpy leaves out the last byte
  shared_by_value  ///< a struct that is passed by value is the caller's own
};

inline constexpr std::array<std::string_view, 12> mistakes{
    "none",       "signed-compare", "sign-lost",      "shift-without-sign", "other-branch",
    "other-side", "bytes-reversed", "write-anywhere", "borrow-lost",        "remainder-for-quotient",
    "copy-short", "shared-by-value"};

/// The mistake that this process makes.
inline Mistake planted = Mistake::none;

}  // namespace mmverify::source::executor
