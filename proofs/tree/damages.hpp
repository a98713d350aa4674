// Damaged codes: the ways to damage one, and the right answer of a decoder to it.
#pragma once

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// A string of bytes for a decoder of that level and format.
struct Damaged {
  std::string what;  ///< "bit 17 flipped,"
  Level level;
  Format format;
  Bytes bytes;
};

/// Receives each damaged code; returns false to stop.
using TakeDamaged = std::function<bool(const Damaged&)>;

/// Damage to any code, whatever its form: cut, longer, another level or format, flipped bits.  There are at most some
/// dozens, which depend on the map; up to `thorough` bytes, every cut and every flip.
void any_damage(const Map& map, const Bytes& code, std::size_t thorough, const TakeDamaged& take);

/// A string in the paper's form, and the map whose code it is; nothing if it is no map's code.
struct Constructed : Damaged {
  std::optional<Map> meant;
};

/// Strings with a known meaning, built from the paper's code of the map: four equal leaves instead of one, at each
/// depth; a tree deeper than the level; a tree with every leaf at the last level; set padding bits; a sequence too
/// long or too short.  Other maps' codes: two children exchanged, one state changed, one quarter alone.
void constructed_codes(const Map& map, const std::function<bool(const Constructed&)>& take);

}  // namespace mmverify::proofs::tree
