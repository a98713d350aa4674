// Numbers of given bit widths in bytes, low bit first.  Internal to impl.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::impl::attribute::detail {

/// The number of `width` bits that begins at `bit`; bits beyond the end are 0.  Domain: width in 0..25.
inline std::uint32_t bits_from(std::span<const std::uint8_t> bytes, std::uint64_t bit,
                               std::uint32_t width) noexcept {
  const std::uint64_t first = bit / 8;
  std::uint32_t word = 0;
  for (std::uint64_t k = 0; k < 4 && first + k < bytes.size(); ++k)
    word |= std::uint32_t{bytes[static_cast<std::size_t>(first + k)]} << (8 * k);
  return word >> (bit % 8) & ((std::uint32_t{1} << width) - 1);
}

inline std::uint32_t word_from(std::span<const std::uint8_t> bytes, std::uint64_t at) noexcept {
  std::uint32_t word = 0;
  for (std::uint64_t k = 0; k < 4; ++k)
    word |= std::uint32_t{bytes[static_cast<std::size_t>(at + k)]} << (8 * k);
  return word;
}

/// Half byte k, counted from byte `at`.
inline std::uint32_t half_from(std::span<const std::uint8_t> bytes, std::uint64_t at,
                               std::uint64_t k) noexcept {
  return bytes[static_cast<std::size_t>(at + k / 2)] >> (4 * (k % 2)) & 15u;
}

class BitWriter {
 public:
  /// Domain: width in 0..25, number below 2^width.
  void put(std::uint32_t number, std::uint32_t width) {
    word_ |= std::uint64_t{number} << used_;
    used_ += width;
    bits_ += width;
    for (; used_ >= 8; used_ -= 8, word_ >>= 8) bytes_.push_back(static_cast<std::uint8_t>(word_));
  }
  std::uint64_t bits() const noexcept { return bits_; }
  /// The whole bytes; unused bits of the last are 0.
  const std::vector<std::uint8_t>& finished() {
    if (used_ != 0) bytes_.push_back(static_cast<std::uint8_t>(word_));
    word_ = 0;
    used_ = 0;
    return bytes_;
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint64_t word_ = 0, bits_ = 0;
  std::uint32_t used_ = 0;
};

}  // namespace mmverify::impl::attribute::detail
