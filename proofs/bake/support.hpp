// The support that a baker declares; cases are drawn inside it.  In the C header: mmverify_bake_support.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/value_set.hpp"

namespace mmverify::proofs::bake {

/// The choice between UO and UT for a micro-triangle that is neither O nor T.
enum class UnknownSide : std::uint8_t { any, centroid, coverage, opaque, transparent };

struct Support {
  Level max_level = 12;
  bool two_state = true, four_state = true;
  Set texels, filters, wraps;  ///< of Texel, Filter, Wrap
  bool mask = true, blend = true;
  std::uint32_t max_side = 16384, max_mips = 15;
  bool same_wraps = false, powers_of_two = false, factors = true, margins = true;
  bool moving = false, updates = false;  ///< cases with travel; with a change
  bool float_cutoffs = false;
  std::optional<Cutoff> fixed_cutoff;
  float uv_min = 0, uv_max = 0;  ///< both 0: any
  bool above = false;            ///< Rules
  spec::bake::Contact contact = spec::bake::Contact::closed;
  UnknownSide unknown = UnknownSide::any;
  std::uint32_t weight_bits = 0, coordinate_bits = 0;  ///< 0: exact

  bool bounded() const { return uv_min != 0 || uv_max != 0; }
  bool exact_sampling() const { return weight_bits == 0 && coordinate_bits == 0; }
  /// BLEND's thresholds are not judged if sampling is in fixed point.
  bool judges_blend() const { return blend && exact_sampling(); }
  /// Whether cases and rules need no change.
  bool whole() const;
  /// The restrictions as text, "8 bits, clamp, cutoff as binary32, ..."; empty if there are none.
  std::string text() const;

  friend bool operator==(const Support&, const Support&) = default;
};

/// Whether fitted() leaves the case as it is, except for its rules; no texel is read.
bool covers(const Support& support, const Case& one);

/// The binary32 number in [0, 1] nearest to the cutoff; below 2^-8 it is 0 or 2^-8.
Cutoff float_cutoff(const Cutoff& cutoff);

/// The case with the fewest changes that make it supported: texels, sides, mips, addressing, factors, cutoff and
/// coordinates, with the subject's rules.  `salt` picks one of several possible values.
/// Domain: a case of any alpha mode; level and format are the caller's.
Case fitted(const Support& support, Case one, std::uint64_t salt);

}  // namespace mmverify::proofs::bake
