// A share of the inputs, for what is too slow for each of them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::fuzz {

/// A number that all bytes of an input determine.  A fuzzer keeps the inputs that reach most, so a byte that chose what
/// is slow would choose it in most of their mutants.  Here each change to any byte chooses anew.
class Share {
 public:
  /// Source: FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv, whose two halves are joined.
  Share(const std::uint8_t* data, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) number_ = (number_ ^ data[k]) * 0x01000193;
    number_ ^= number_ >> 16;
  }

  /// Whether the input is one of the share of 1/n.  The share of 1/2n is a part of that of 1/n.
  bool of(std::uint32_t n) const { return number_ % n == 0; }
  /// A number below `end`, which is another for each input of a share.  Domain: end >= 1.
  std::uint32_t below(std::uint32_t end) const { return (number_ >> 8) % end; }

 private:
  std::uint32_t number_ = 0x811c9dc5;
};

}  // namespace mmverify::fuzz
