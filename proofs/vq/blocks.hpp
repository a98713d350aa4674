// The blocks that decoders are tried on.
#pragma once

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The words of a codebook that the laws of the fast tier put into every entry: of 5 bits all, of 20 those with
/// at most three bits set, or clear.  An entry of fewer bits takes the lowest.
template <class Format>
const std::vector<std::uint32_t>& chosen_words();

/// Eight blocks a chosen word.  Over all of them each entry holds each word under each transform of TR, BL and
/// BR, and every index is in every quadrant of each block.  Entries, transforms and places go through their
/// values in orders of their own.
template <class Format>
std::uint64_t word_blocks();
/// Domain: k < word_blocks.
template <class Format>
Format word_block(std::uint64_t k);

/// All 512 triples of transforms t1, t2, t3 (of TR, BL, BR), each with every shift s of the indices.  In the
/// field of 8 elements (VQ4: of 16), where a number's bits are a polynomial's coefficients, the vector (X, Y)
/// has the index
///   X Y + X (t1 + 2 t3) + Y (t2 + 4 t3) + s.
/// So each index field has each value under each triple, any two of them have every pair of values, and in VQ2
/// they have it under each value of any one transform: the term in t1, t2, t3 and s is linear, and two vectors
/// differ in it.  X Y keeps the fields of one block apart, under the identities too.  Entries are scattered.
template <class Format>
constexpr std::uint64_t index_blocks = std::uint64_t{512} << Format::index_bits;
/// Domain: k < index_blocks.
template <class Format>
Format index_block(std::uint64_t k);

/// Blocks without a pattern, as many as show, beside each combination of a region's index, its transform and
/// the two bits of its entry that it is made of, either value of every other bit of the block:
/// tests/proofs/vq_blocks_test.cpp counts.
template <class Format>
constexpr std::uint64_t scattered_blocks = Format::side == 2 ? 1u << 14 : 1u << 15;
template <class Format>
BlockBytes<Format> scattered_block(std::uint64_t k);

/// Blocks in which every field has each of its values, and any two fields of up to 5 bits every pair: of VQ2
/// without a pattern, of VQ4 with each word of 20 bits, in an order of the field's own.
template <class Format>
constexpr std::uint64_t field_blocks = Format::side == 2 ? 1u << 15 : 1u << 20;
/// Domain: k < field_blocks.
template <class Format>
BlockBytes<Format> field_block(std::uint64_t k);

/// Block k of a seed: all bits are random.  Of every fourth the indices are one, but at one place, in one row,
/// column or quadrant, or on every second place, where they are another; and one entry is another's.  Of one in eight
/// a run of entries repeats every one, two or four.  Of another one all but a run of up to 64 bits is as in the block before.
template <class Format>
BlockBytes<Format> random_block(std::uint64_t seed, std::uint64_t k);

/// Eight blocks a word of 20 bits.  Over all of them each entry holds each of its words under each transform of
/// TR, BL and BR; entries go through their words in orders of their own.
constexpr std::uint64_t every_word_blocks = std::uint64_t{8} << 20;
/// Domain: k < every_word_blocks.
Vq4 every_word_block(std::uint64_t k);

}  // namespace mmverify::proofs::vq
