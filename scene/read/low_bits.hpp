// Bits of bytes, each byte from its lowest bit on.
#pragma once

#include <cstdint>
#include <span>

#include "scene/read/damaged_picture.hpp"

namespace mmverify::scene {

class LowBits {
 public:
  explicit LowBits(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  /// The next `count` bits as a number, the first one lowest.  Domain: count <= 32.
  /// Errors: DamagedPicture beyond the last bit.
  std::uint32_t take(unsigned count) {
    if (count > 8 * bytes_.size() - at_) throw DamagedPicture("its bits end early; truncated file?");
    std::uint32_t value = 0;
    for (unsigned k = 0; k < count; ++k, ++at_) value |= (bytes_[at_ / 8] >> (at_ % 8) & 1u) << k;
    return value;
  }

 private:
  std::span<const unsigned char> bytes_;
  std::size_t at_ = 0;
};

}  // namespace mmverify::scene
