// A writer of pictures as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::scene {

/// A PNG of rows of RGB from the top, 8 bits a channel.
/// Domain: rgb.size() = 3 width height, both sides in 1..32768; else std::invalid_argument.
/// std::runtime_error if there is no memory.
std::vector<unsigned char> png(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgb);

}  // namespace mmverify::scene
