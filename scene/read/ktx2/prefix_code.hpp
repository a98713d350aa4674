// Huffman codes of BasisLZ.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/read/low_bits.hpp"

namespace mmverify::scene {

/// A canonical prefix code: shorter codes come first, codes of one length in the order of their symbols, each
/// code from its highest bit on.
/// Source: RFC 1951, 3.2.2.
class PrefixCode {
 public:
  PrefixCode() = default;

  /// `lengths[symbol]` is the length of the symbol's code in bits, at most 16; 0 where it has none.
  /// Errors: DamagedPicture if the codes are more than their lengths leave room for.
  explicit PrefixCode(std::span<const std::uint8_t> lengths);

  /// The next symbol.  Errors: DamagedPicture if the bits end, or are no code.
  std::uint32_t take(LowBits& bits) const;

 private:
  static constexpr unsigned longest = 16;
  std::array<std::uint32_t, longest + 1> counts_{};  ///< codes of each length
  std::vector<std::uint16_t> symbols_;               ///< in the order of their codes
};

/// Reads a code whose lengths are coded themselves.
/// Errors: DamagedPicture, as above, and if the lengths are more or fewer than announced.
/// Source: KTX File Format Specification 2.0, BasisLZ/ETC1S, Compressed Huffman Tables.
PrefixCode take_prefix_code(LowBits& bits);

}  // namespace mmverify::scene
