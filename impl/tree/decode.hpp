// Decoding that reports the fault of bad sequences, and lookups, anywhere in memory.  Internal to impl/tree.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "impl/tree/stream.hpp"

namespace mmverify::impl::tree::detail {

/// The fault of two sequences that are no tree, and its place.
struct Fault {
  enum class In : std::uint8_t { counts, tree, data } in;
  std::uint64_t bit;  ///< bit of that sequence; 0 for the counts
  const char* found;
};

/// decode_stream() over sequences anywhere in memory.
std::optional<Fault> decode(Level n, Format b, std::span<const std::uint8_t> tree, std::uint64_t nodes,
                            std::span<const std::uint8_t> data, std::uint64_t leaves,
                            std::span<std::uint8_t> map);

/// lookup_stream() over sequences anywhere in memory.
std::uint8_t lookup(Level n, Format b, std::span<const std::uint8_t> tree, std::uint64_t nodes,
                    std::span<const std::uint8_t> data, std::uint64_t index) noexcept;

}  // namespace mmverify::impl::tree::detail
