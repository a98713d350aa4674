// LZ4 and zstd, coders for comparison.  Neither can decode a single value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::bench {

inline constexpr int zstd_level = 19;

/// The bytes of zstd's frame at level 19, the highest that needs no more memory than usual.
std::uint64_t zstd_bytes(std::span<const std::uint8_t> bytes);

enum class Compressor : std::uint8_t { lz4, zstd };

/// lz4: one block by LZ4_compress_HC at its highest level, 12; it looks back over 64 KiB.
/// zstd: one frame at level 19 that looks back over everything, with long-distance matching.
/// Domain: up to 2^30 bytes, or std::invalid_argument is thrown.  std::runtime_error if the library fails.
std::vector<std::uint8_t> compressed(Compressor how, std::span<const std::uint8_t> bytes);

/// The `size` decompressed bytes.  std::runtime_error if their number differs, or `packed` is not from
/// compressed().
std::vector<std::uint8_t> decompressed(Compressor how, std::span<const std::uint8_t> packed,
                                       std::size_t size);

}  // namespace mmverify::bench
