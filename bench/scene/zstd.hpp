// zstd, a coder for comparison.
#pragma once

#include <cstdint>
#include <span>

namespace mmverify::bench {

inline constexpr int zstd_level = 19;

/// Bytes of zstd's frame at level 19, the highest that needs no more memory than usual.
std::uint64_t zstd_bytes(std::span<const std::uint8_t> bytes);

}  // namespace mmverify::bench
