// Lists of hits for samples: up to sixteen, at distances of every size and next to each other, some reported twice.
#pragma once

#include "proofs/traverse/subject.hpp"

namespace mmverify::proofs::traverse {

/// The hits of a ray, and the payload before them.
struct HitList {
  Operation operation = Operation::max;
  spec::traverse::Colour payload = {};
  std::vector<Hit> hits = {};
};

/// The most hits that a subject's case may have.
inline constexpr std::uint64_t most_hits = 16;

/// List k of a seed: 1 + k mod 16 hits, by the operations in turn.  Distances are of six kinds: fractions; up to four
/// units in the last place from each other; two values in all; below 2^-126; beside the largest; of any exponent.
/// None to all hits are accepted.  Of four hits about one has the distance of the hit before it, one its value, one
/// both.
/// Half of the lists have any payload and any values, each code drawn on its own.  The values of the others have an
/// effect that later hits do not hide, and are premultiplied for the operation over.
HitList hit_list(std::uint64_t seed, std::uint64_t k);

/// A list as text, "add:09080706:B0x1.8p+0=04030201,A0x1p+1": operation and payload; for each hit A or B, its
/// distance, and for B, a hit that blends, its value.  Values are words in hexadecimal digits, R the last two.
std::string text_of(const HitList& list);
/// Throws BadCase.
HitList hit_list_of(const std::string& text);

}  // namespace mmverify::proofs::traverse
