// Arrays that are there, changed so that each triangle resolves as before: compact, reorder, concatenate, emulate; and
// DGF's palettes.
#pragma once

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// Without the records that nobody refers to and the bytes of no record; the rest in its order, bases 0.
/// Domain: each plain index of a part names a record, each record's bytes are in the data; else
/// std::invalid_argument.  An index that its encoding cannot hold: std::length_error.  Time: linear.
Bundle compacted(const Bundle& bundle);

/// All records: those in use first, in the order of first use, then the others in their order; bases 0.  As above.
Bundle reordered(const Bundle& bundle);

/// One array behind another; the second's bases grow by the first's records.  Data or records beyond 2^32:
/// std::length_error.  Domain: as above; a base that then passes 2^32 begins anew at 0.
Bundle concatenated(const Bundle& first, const Bundle& second);

/// The 4-state map at level `most`, for a device that has none above: T for a block of T, O for a block of O, else
/// unknown, by micromap::down().  Domain: level above most, up to 12; packed bytes of the level; else
/// std::invalid_argument.  Source: the KHR slides, "Lossy Micromaps".
Bytes emulated(std::span<const std::uint8_t> four_state, Level level, Level most);

/// DGF: triangles in order, cut into the fewest blocks of at most `most` distinct codes; how many triangles each has.
std::vector<std::uint64_t> blocks(std::span<const std::uint32_t> codes, std::size_t most = 7);

}  // namespace mmverify::impl::array
