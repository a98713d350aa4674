// Checks of one map.
#pragma once

#include "proofs/tree/law_parts.hpp"

namespace mmverify::proofs::tree {

/// decode(encode(map)) is the map, its padding bits zero.
Finding round_trip(const TreeSubject& s, const Map& map);

/// A lookup at each index gives the map's state, all at once and again in another order and other batches.  With
/// `most`: at most so many indices, half of them at changes of the state.
Finding lookups(const TreeSubject& s, const Map& map, std::uint64_t most = ~std::uint64_t{0});

/// Decodes and looks up the map, two maps that differ from it in one state, and one with two nodes exchanged, by
/// turns. An answer must not be that to an earlier question, however alike the codes begin and end.
Finding asked_in_turn(const TreeSubject& s, const Map& map);

/// round_trip() and lookups() with one encoding.  Domain: level 2.
Finding round_trip_and_lookups_of_level_2(const TreeSubject& s, const Map& map);

/// A lookup by barycentrics gives the state at the reference's index, at every point whose coordinates are multiples
/// of 1/4N (every cell has some), or at `most` of them.
Finding points(const TreeSubject& s, const Map& map, std::uint64_t most = ~std::uint64_t{0});

/// The code has the specification's bytes.
Finding stream_is_specified(const TreeSubject& s, const Map& map);

/// leaves = 3 internal + 1, nodes = 4 internal + 1, at most spec::tree::most_nodes nodes, and exactly the bytes for
/// these.
Finding sizes(const TreeSubject& s, const Map& map);

/// Every truncation of a code, a byte or two more, the code twice, and every flip of one of its bits: refused, or the
/// code of another map.
Finding damage(const TreeSubject& s, const Map& map);

/// A decoder takes bytes exactly if the specification takes them, and they are then the one code of their map.
Finding bytes_are_canonical(const TreeSubject& s, Level n, Format f, std::span<const std::uint8_t> bytes);

}  // namespace mmverify::proofs::tree
