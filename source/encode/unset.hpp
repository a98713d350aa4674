// Which bits of a word were never set: a shadow of the word, one bit a bit, as MemorySanitizer has it.  Source: E. Stepanov,
// K. Serebryany, MemorySanitizer: fast detector of uninitialized memory use in C++, CGO 2015, section 3.2.
#pragma once

#include "source/encode/words.hpp"
#include "source/program.hpp"

namespace mmverify::source {

/// A word and its shadow; a shadow of no bits: all are set.
struct Shadowed {
  Bits word, unset;
};

/// Whether that operand's bits that were never set come through as bits; else one of them leaves the result open.
bool keeps_bits(Op op, std::size_t operand);

/// The shadow of the operation's result.  Domain: keeps_bits of an operand; what shifts is set.
Bits shadow_of(Definitions& d, const Node& node, const std::vector<Shadowed>& of);

/// The word with the free one's bits where it was never set.
Bits with_free_bits(Definitions& d, const Shadowed& of, const Bits& free);

/// Whether any bit was never set, and whether none was set.
Condition any_unset(Definitions& d, const Bits& unset);
Condition all_unset(Definitions& d, const Bits& unset);

/// Words whose bits change places, values and shadows alike.
Bits turned(Definitions& d, Op op, const Bits& a);                                    ///< bswap, bitreverse
Bits funnelled(Definitions& d, Op op, const Bits& a, const Bits& b, const Bits& by);  ///< fshl, fshr

}  // namespace mmverify::source
