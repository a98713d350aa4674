// A picture in RGB.
#pragma once

#include <cstdint>
#include <vector>

namespace mmverify::scene {

/// Rows from the top, 8 bits a channel.
struct RgbPicture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace mmverify::scene
