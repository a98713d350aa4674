// How one map is judged.
#pragma once

#include "proofs/tree/law_parts.hpp"

namespace mmverify::proofs::tree {

/// decode(encode(map)) is the map, its padding bits zero.
Finding round_trip(const TreeSubject& s, const Map& map);

/// A lookup at each index gives the map's state, all at once and again in another order and other batches; at
/// most `most` of them where there are more, of which half lie where the state changes.
Finding lookups(const TreeSubject& s, const Map& map, std::uint64_t most = ~std::uint64_t{0});

/// Decoding and lookups of the map, of two like it but for one state and of one with two nodes exchanged, asked in turn: an
/// answer is not that to an earlier question, however alike the codes begin and end.
Finding asked_in_turn(const TreeSubject& s, const Map& map);

/// Both, encoding once.  Domain: level 2.
Finding round_trip_and_lookups_of_level_2(const TreeSubject& s, const Map& map);

/// A lookup by barycentrics gives the state at the reference's index: at every point whose coordinates are
/// multiples of 1/4N, which are some in every cell, or at `most` of them.
Finding points(const TreeSubject& s, const Map& map, std::uint64_t most = ~std::uint64_t{0});

/// The bytes are the specification's.
Finding stream_is_specified(const TreeSubject& s, const Map& map);

/// leaves = 3 internal + 1, nodes = 4 internal + 1, no more nodes than spec::tree::most_nodes, and bytes for
/// just these.
Finding sizes(const TreeSubject& s, const Map& map);

/// Every truncation of a code, a byte or two more, the code twice, and every flip of one of its bits: refused,
/// or the code of another map.
Finding damage(const TreeSubject& s, const Map& map);

/// What encode and decode do to bytes that nobody encoded: refused, or the one code of the map they mean,
/// exactly where the specification takes them.
Finding bytes_are_canonical(const TreeSubject& s, Level n, Format f, std::span<const std::uint8_t> bytes);

}  // namespace mmverify::proofs::tree
