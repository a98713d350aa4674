// Bits in byte arrays, least significant first, for the forms of the tree.  Internal to impl/tree.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace mmverify::impl::tree::detail {

static_assert(std::endian::native == std::endian::little,
              "words are loaded from and stored to bytes as they are");

/// Up to 64 bits of a byte array whose end may fall inside the word: missing bits read as zeros.
inline std::uint64_t load_word(const std::uint8_t* bytes, std::size_t available) noexcept {
  std::uint64_t word = 0;
  // A copy of a known size is one load.
  if (available >= sizeof word)
    std::memcpy(&word, bytes, sizeof word);
  else
    std::memcpy(&word, bytes, available);
  return word;
}

constexpr std::uint64_t low_bits(std::uint32_t count) noexcept {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// The number of set flags among four.  A population count is a call on targets without the instruction.
constexpr std::uint32_t ones_of_four(std::uint64_t flags) noexcept {
  return static_cast<std::uint32_t>(0x4332322132212110 >> (4 * flags)) & 15;
}

constexpr std::uint64_t bytes_for(std::uint64_t bits) noexcept { return (bits + 7) / 8; }

inline bool bit_at(const std::uint8_t* bytes, std::uint64_t k) noexcept {
  return (bytes[k / 8] >> k % 8 & 1) != 0;
}

/// Appends bits.  Whole words are stored, so eight bytes beyond the last bit must belong to the array.
class BitWriter {
 public:
  explicit BitWriter(std::uint8_t* bytes, std::uint64_t first_bit = 0) noexcept
      : bytes_(bytes + first_bit / 8), used_(static_cast<std::uint32_t>(first_bit % 8)) {
    word_ = *bytes_ & low_bits(used_);
  }

  /// Domain: count in 0..56, and no bit of value at or above it.
  void put(std::uint64_t value, std::uint32_t count) noexcept {
    word_ |= value << used_;
    used_ += count;
    std::memcpy(bytes_, &word_, sizeof word_);
    const std::uint32_t whole = used_ / 8;  // at most 7
    bytes_ += whole;
    word_ >>= 8 * whole;
    used_ %= 8;
  }

 private:
  std::uint8_t* bytes_;
  std::uint32_t used_;
  std::uint64_t word_ = 0;
};

/// Reads bits in order, and zeros beyond the end: the caller counts the bits that exist.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes, std::uint64_t first_bit = 0) noexcept
      : bytes_(bytes), place_(first_bit) {}

  /// At least the next 57 bits.
  std::uint64_t peek() const noexcept {
    const std::uint64_t byte = place_ / 8;
    if (byte >= bytes_.size()) return 0;
    return load_word(bytes_.data() + byte, bytes_.size() - byte) >> (place_ % 8);
  }
  /// The next bits.  Domain: they exist and lie in one byte.
  std::uint32_t within_byte(std::uint32_t count) const noexcept {
    return bytes_[place_ / 8] >> place_ % 8 & ((1u << count) - 1);
  }
  void skip(std::uint32_t count) noexcept { place_ += count; }
  std::uint64_t place() const noexcept { return place_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::uint64_t place_;
};

/// Sets a run of `bits` bits, a power of two that divides first_bit, to copies of a state.  Domain: below eight bits,
/// the place has zeros.
inline void fill_run(std::uint8_t* bytes, std::uint64_t first_bit, std::uint64_t bits,
                     std::uint64_t states) noexcept {
  std::uint8_t* to = bytes + first_bit / 8;
  switch (bits) {
    case 1:
    case 2:
    case 4:
      *to = static_cast<std::uint8_t>(*to | (states & low_bits(static_cast<std::uint32_t>(bits)))
                                                << (first_bit % 8));
      return;
    case 8: *to = static_cast<std::uint8_t>(states); return;
    case 16: std::memcpy(to, &states, 2); return;
    case 32: std::memcpy(to, &states, 4); return;
    case 64: std::memcpy(to, &states, 8); return;
    default: std::memset(to, static_cast<int>(states & 0xff), bits / 8);
  }
}

/// A word filled with one state of b bits, b = 1 or 2.
constexpr std::uint64_t repeated(std::uint64_t state, std::uint32_t b) noexcept {
  return state * (b == 1 ? ~std::uint64_t{0} : 0x5555555555555555);
}

}  // namespace mmverify::impl::tree::detail
