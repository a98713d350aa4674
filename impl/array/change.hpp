// Changes of arrays: compact, reorder and concatenate, after which each triangle resolves as before; emulate; and the
// palettes of DGF.
#pragma once

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// The bundle without unused records, and without bytes that belong to no record.  Records keep their order, bases
/// become 0.
/// Domain: each plain index of a part names a record, each record's bytes are in the data; else
/// std::invalid_argument.  An index that its encoding cannot hold: std::length_error.  Time: linear.
/// Law: array.compact, array.changes_on_samples
Bundle compacted(const Bundle& bundle);

/// The bundle with its records in the order of their first use, then the unused ones in their order; bases become 0.
/// Domain, errors, time: as compacted().
/// Law: array.reorder, array.changes_on_samples
Bundle reordered(const Bundle& bundle);

/// The second array behind the first; the second's bases grow by the number of the first's records.  Data or records
/// beyond 2^32: std::length_error.  Domain: as compacted().  A base that passes 2^32 wraps around.
/// Law: array.concatenate, array.changes_on_samples
Bundle concatenated(const Bundle& first, const Bundle& second);

/// The 4-state map at level `most`, for a device that supports no level above: T for a block of T, O for a block of O,
/// else unknown, by micromap::down().  Domain: level above most, up to 12; packed bytes of the level; else
/// std::invalid_argument.  Source: the KHR slides, "Lossy Micromaps".
/// Law: array.emulates, array.emulates_on_samples
Bytes emulated(std::span<const std::uint8_t> four_state, Level level, Level most);

/// DGF: the triangles in order, cut into the fewest blocks of at most `most` distinct codes.  The result: each block's
/// size.
/// Law: array.blocks
std::vector<std::uint64_t> blocks(std::span<const std::uint32_t> codes, std::size_t most = 7);

}  // namespace mmverify::impl::array
