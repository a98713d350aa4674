// The bits of a word that were never set: a shadow of the word, bit by bit, as in MemorySanitizer.
// Source: E. Stepanov, K. Serebryany, MemorySanitizer: fast detector of uninitialized memory use in C++, CGO
// 2015, section 3.2.
#pragma once

#include "subjects/source/encode/words.hpp"
#include "subjects/source/program.hpp"

namespace mmverify::source {

/// A word and its shadow; a shadow of no bits means that all bits are set.
struct Shadowed {
  Bits word, unset;
};

/// Whether unset bits of that operand make only bits of the result unset; otherwise one of them leaves the
/// whole result open.
bool keeps_bits(Op op, std::size_t operand);

/// The shadow of the operation's result. Domain: keeps_bits of an operand; shift amounts are set.
Bits shadow_of(Definitions& d, const Node& node, const std::vector<Shadowed>& of);

/// The word, with the bits of `free` in place of those never set.
Bits with_free_bits(Definitions& d, const Shadowed& of, const Bits& free);

/// Whether any bit was never set; whether no bit was set.
Condition any_unset(Definitions& d, const Bits& unset);
Condition all_unset(Definitions& d, const Bits& unset);

/// Words whose bits change places; the same for a value and its shadow.
Bits turned(Definitions& d, Op op, const Bits& a);                                    ///< bswap, bitreverse
Bits funnelled(Definitions& d, Op op, const Bits& a, const Bits& b, const Bits& by);  ///< fshl, fshr

}  // namespace mmverify::source
