// The succinct tree as the paper writes it: a bit a node in pre-order, and the leaves' states beside them.
//
// A map of level n has the states of 4^n micro-triangles in the order of the curve, b bits each, the first in the least
// significant bits of the first byte: ceil(4^n b / 8) bytes, padding bits ignored on reading and zero on writing.  The
// digits of an index in base 4, the most significant first, name the children on its way down from the root.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impl/micromap/micromap.hpp"

namespace mmverify::impl::tree {

using micromap::Format, micromap::Level;

/// The highest supported level: 16,777,216 micro-triangles, a map of 2 or 4 MiB.
inline constexpr Level max_level = 12;

/// The two bit sequences, least significant bit first, padded with zeros to whole bytes.
struct Stream {
  std::vector<std::uint8_t> tree;  ///< a node in pre-order, child 0 first: 1 internal, 0 leaf
  std::vector<std::uint8_t> data;  ///< the states of the leaves in the same order, b bits each
  std::uint64_t nodes = 0;         ///< bits in tree
  std::uint64_t leaves = 0;        ///< states in data; (3 nodes + 1) / 4
  friend bool operator==(const Stream&, const Stream&) = default;
};

/// The tree of a map.  Four sibling leaves never have one state, so a map has one stream.
/// Domain: n in 0..12 and a map of its size, or std::invalid_argument is thrown.  Time: it reads the map once; the rest
/// is linear in the tree.
/// Source: Succinct Opacity Micromaps, Algorithms 1 and 2, with the children pushed from the last to the first, so that
/// child 0 comes first.
/// Law: tree.equals_spec
Stream encode_stream(Level n, Format b, std::span<const std::uint8_t> map);

/// Writes the map of a stream; padding bits are zero.
/// False, with any contents of the map, if the stream is no tree of encode_stream(): nodes or leaves that are not 4 i +
/// 1 and 3 i + 1 for one i, a sequence of another length, a padding bit that is set, a tree that ends early or late or
/// goes below level n, four sibling leaves of one state.
/// Domain: n in 0..12 and a map of its size, or std::invalid_argument is thrown; any stream.
/// Law: tree.round_trip, tree.canonical, tree.malformed
bool decode_stream(Level n, Format b, const Stream& s, std::span<std::uint8_t> map);

/// One state, straight from the two sequences: Algorithm 3, a bit at a time, as it is printed.
///   t, d = 0; while tree[t]: t = t+1, then skip as many subtrees as the next digit of the index,
///   counting their leaves in d; the state is data[d]
/// Domain: n in 0..12, index < 4^n (its low 2n bits count); any stream.  If the stream ends before the leaf, or goes
/// below level n, the answer is 0; nothing beyond its vectors is read.
/// Source: Succinct Opacity Micromaps, Algorithm 3.
/// Law: tree.lookup_is_decode, tree.on_samples
std::uint8_t lookup_stream(Level n, Format b, const Stream& s, std::uint64_t index);

}  // namespace mmverify::impl::tree
