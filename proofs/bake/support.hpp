// What a baker says that it supports: cases are drawn inside it.  mmverify_bake_support in the C header.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/value_set.hpp"

namespace mmverify::proofs::bake {

/// Which unknown a micro-triangle is that is neither O nor T.
enum class UnknownSide : std::uint8_t { any, centroid, coverage, opaque, transparent };

struct Support {
  Level max_level = 12;
  bool two_state = true, four_state = true;
  Set texels, filters, wraps;  ///< of Texel, Filter, Wrap
  bool mask = true, blend = true;
  std::uint32_t max_side = 16384, max_mips = 15;
  bool same_wraps = false, powers_of_two = false, factors = true, margins = true;
  bool float_cutoffs = false;
  std::optional<Cutoff> fixed_cutoff;
  float uv_min = 0, uv_max = 0;  ///< both 0: any
  bool above = false;            ///< Rules
  spec::bake::Contact contact = spec::bake::Contact::closed;
  UnknownSide unknown = UnknownSide::any;
  std::uint32_t weight_bits = 0, coordinate_bits = 0;  ///< 0: exact

  bool bounded() const { return uv_min != 0 || uv_max != 0; }
  bool exact_sampling() const { return weight_bits == 0 && coordinate_bits == 0; }
  /// Of sampling in fixed point nothing is said at the thresholds of BLEND.
  bool judges_blend() const { return blend && exact_sampling(); }
  /// Whether cases and rules are as they are of one that says nothing.
  bool whole() const;
  /// "8 bits, clamp, cutoff as binary32, ...": what is not as it is of one that says nothing; empty: nothing.
  std::string text() const;

  friend bool operator==(const Support&, const Support&) = default;
};

/// Whether the case is one that fitted() leaves as it is, but for its rules: looked at without a texel.
bool covers(const Support& support, const Case& one);

/// The number nearest to the cutoff that binary32 has, in [0, 1]; below 2^-8 it is 0 or 2^-8.
Cutoff float_cutoff(const Cutoff& cutoff);

/// The case changed as little as makes it one that is supported: texels, sides, mips, addressing, factors, cutoff
/// and coordinates, with the subject's rules.  Of several values that would do `salt` picks one.
/// Domain: a case of MASK where only MASK is supported, and so on, is up to this function; level and format are the
/// caller's.
Case fitted(const Support& support, Case one, std::uint64_t salt);

}  // namespace mmverify::proofs::bake
