#include "bench/scene/zstd.hpp"

#include <zstd.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::bench {

std::uint64_t zstd_bytes(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> frame(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), zstd_level);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  return size;
}

}  // namespace mmverify::bench
