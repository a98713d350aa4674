// Codes that are spoilt on purpose: what may become of one, and what a decoder must do with it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// A string of bytes, handed to a decoder of that level and format.
struct Damaged {
  std::string what;  ///< "bit 17 flipped,"
  Level level;
  Format format;
  Bytes bytes;
};

/// Called for each; returns false to stop.
using TakeDamaged = std::function<bool(const Damaged&)>;

/// What may become of any code, whatever it means: cut, longer, another level or format, flipped bits; at most
/// some dozens, other ones for other maps.  Up to `thorough` bytes every cut and every flip.
void any_damage(const Map& map, const Bytes& code, std::size_t thorough, const TakeDamaged& take);

/// A string in the paper's form and the map that it is the code of; none where it is no map's.
struct Constructed : Damaged {
  std::optional<Map> meant;
};

/// Strings built from the paper's code of the map, so that what they mean is known: four equal leaves in the
/// place of one, at each depth; a tree deeper than the level; a tree with every leaf at the last level; padding bits
/// that are set; a sequence too long or too short; two children exchanged, one state changed, one quarter alone: other
/// maps' codes.
void constructed_codes(const Map& map, const std::function<bool(const Constructed&)>& take);

}  // namespace mmverify::proofs::tree
