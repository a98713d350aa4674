// Alpha out of PNG and JPEG.
#pragma once

#include <span>
#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The longest side: of what is baked from (impl/bake/bake.hpp), and of what devices sample.
inline constexpr std::uint32_t longest_side = 16384;

/// Decodes the picture's alpha into `image`: 16 bits of a PNG of 16 bits, else 8; palettes and colour keys
/// (tRNS) are followed.  A JPEG, or a PNG without either, is opaque.
/// Errors: BadScene where it is neither PNG nor JPEG, damaged or cut off, or a side is 0 or above
/// longest_side.
void decode_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                  const std::string& place);

}  // namespace mmverify::scene
