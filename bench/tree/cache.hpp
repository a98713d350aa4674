// The number of cache lines that a lookup reads, by a model, not by measurement.
#pragma once

#include <cstddef>
#include <cstdint>

#include "impl/tree/tree.hpp"

namespace mmverify::bench {

/// The parts of a stream that the paper's lookup reads.
struct StreamReads {
  std::uint64_t tree_bits;  ///< figure 9 of the paper
  std::size_t lines;        ///< distinct 64-byte lines of the two sequences, each taken to begin on a line
};

/// The reads of a lookup.  Domain: a stream of encode_stream, index < 4^n.
StreamReads stream_reads(impl::tree::Level n, const impl::tree::Stream& s, std::uint64_t index);

/// The distinct 64-byte lines of a Tree's memory that a lookup reads; the memory is taken to begin on a line.
std::size_t tree_lines(const impl::tree::Tree& tree, std::uint64_t index);

}  // namespace mmverify::bench
