#include "bench/scene/compressors.hpp"

#include <lz4.h>
#include <lz4hc.h>
#include <zstd.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <stdexcept>
#include <string>

namespace mmverify::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t most_bytes = std::size_t{1} << 30;
constexpr int least_window = 10, most_window = 30;  // logarithms; the latter holds most_bytes

std::size_t checked_zstd(std::size_t result) {
  if (ZSTD_isError(result) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(result));
  return result;
}

Bytes zstd_packed(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  const auto set = [&](ZSTD_cParameter what, int value) {
    checked_zstd(ZSTD_CCtx_setParameter(context.get(), what, value));
  };
  set(ZSTD_c_compressionLevel, zstd_level);
  set(ZSTD_c_enableLongDistanceMatching, 1);
  set(ZSTD_c_windowLog,
      std::clamp(static_cast<int>(std::bit_width(bytes.size())), least_window, most_window));
  Bytes frame(ZSTD_compressBound(bytes.size()));
  frame.resize(
      checked_zstd(ZSTD_compress2(context.get(), frame.data(), frame.size(), bytes.data(), bytes.size())));
  return frame;
}

Bytes zstd_unpacked(std::span<const std::uint8_t> packed, std::size_t size) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  checked_zstd(ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, most_window));
  Bytes bytes(size);
  if (checked_zstd(ZSTD_decompressDCtx(context.get(), bytes.data(), size, packed.data(), packed.size())) !=
      size)
    throw std::runtime_error("zstd: the frame holds fewer bytes");
  return bytes;
}

/// A pointer that is not null: LZ4 reads at its pointers even for 0 bytes, and an empty vector's may be null.
const char* not_null(const void* bytes) { return bytes != nullptr ? static_cast<const char*>(bytes) : ""; }

Bytes lz4_packed(std::span<const std::uint8_t> bytes) {
  const auto size = static_cast<int>(bytes.size());
  Bytes block(static_cast<std::size_t>(LZ4_compressBound(size)));
  const int packed = LZ4_compress_HC(not_null(bytes.data()), reinterpret_cast<char*>(block.data()), size,
                                     static_cast<int>(block.size()), LZ4HC_CLEVEL_MAX);
  if (packed <= 0) throw std::runtime_error("lz4: cannot compress");
  block.resize(static_cast<std::size_t>(packed));
  return block;
}

Bytes lz4_unpacked(std::span<const std::uint8_t> packed, std::size_t size) {
  if (size == 0 && packed.size() == 1 && packed[0] == 0) return {};
  Bytes bytes(size);
  const int got = LZ4_decompress_safe(not_null(packed.data()), reinterpret_cast<char*>(bytes.data()),
                                      static_cast<int>(packed.size()), static_cast<int>(size));
  if (got < 0 || static_cast<std::size_t>(got) != size)
    throw std::runtime_error("lz4: the block does not hold these bytes");
  return bytes;
}

}  // namespace

std::uint64_t zstd_bytes(std::span<const std::uint8_t> bytes) {
  Bytes frame(ZSTD_compressBound(bytes.size()));
  return checked_zstd(ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), zstd_level));
}

std::vector<std::uint8_t> compressed(Compressor how, std::span<const std::uint8_t> bytes) {
  if (bytes.size() > most_bytes) throw std::invalid_argument("compressed: more than 2^30 bytes");
  return how == Compressor::lz4 ? lz4_packed(bytes) : zstd_packed(bytes);
}

std::vector<std::uint8_t> decompressed(Compressor how, std::span<const std::uint8_t> packed,
                                       std::size_t size) {
  if (size > most_bytes || packed.size() > 2 * most_bytes - 1)
    throw std::runtime_error("decompressed: more than compressed() takes");
  return how == Compressor::lz4 ? lz4_unpacked(packed, size) : zstd_unpacked(packed, size);
}

}  // namespace mmverify::bench
