// Lists of hits for samples: up to sixteen, at distances of every size and beside each other, some reported again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proofs/traverse/subject.hpp"

namespace mmverify::proofs::traverse {

/// What a ray met, and the payload before.
struct HitList {
  Operation operation = Operation::max;
  spec::traverse::Colour payload = {};
  std::vector<Hit> hits = {};
};

/// As many as a subject's case may have.
inline constexpr std::uint64_t most_hits = 16;

/// List k of a seed: 1 + k mod 16 hits, by the operations in turn.  Distances are of six kinds: fractions; up to four units
/// in the last place from each other; two values in all; below 2^-126; beside the largest; of any exponent.  None to all
/// hits are accepted.  Of four hits about one has the distance of the hit before it, one its value, one both.
/// Half of the lists have any payload and any values, each code drawn on its own; those of the others show, whatever comes
/// later, and are premultiplied where the operation is over.
HitList hit_list(std::uint64_t seed, std::uint64_t k);

/// "add:09080706:B0x1.8p+0=04030201,A0x1p+1": operation, payload, and of each hit what it is, its distance, and of one that
/// blends its value.  Values are words in hexadecimal digits, R the last two.
std::string text_of(const HitList& list);
/// Throws BadCase.
HitList hit_list_of(const std::string& text);

}  // namespace mmverify::proofs::traverse
