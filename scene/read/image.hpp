// Decoders of pictures.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The longest side of an image: impl/bake/bake.hpp bakes no longer one, and devices sample none.
inline constexpr std::uint32_t longest_side = 16384;

/// `kind`: "a WebP", for the message.  Errors: BadScene if a side is 0 or above longest_side.
void check_sides(std::uint64_t width, std::uint64_t height, const char* kind, const std::string& file,
                 const std::string& place);

/// Decodes the picture's alpha into `image`: 16 bits if it is a PNG of 16 bits, an AVIF of more than 8 or a
/// DDS or KTX2 of BC3, floats of an OpenEXR, a KTX2's numbers as they are, else 8, with a PNG's palettes and colour keys (tRNS).  A picture without alpha, such as a JPEG,
/// is opaque.
/// Errors: BadScene if it is no picture that is read, damaged or cut off, or a side is 0 or above longest_side;
/// UnreadExtension for a kind that this program, or this build, does not read.
void decode_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                  const std::string& place);

/// A picture's texels: red, green, blue and alpha of texel (x, y) begin at rgba[4 (x + width y)], rows from the top.
struct ColourImage {
  std::string name;  ///< its URI or name; for messages
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  bool decoded() const { return width != 0; }
};

/// Decodes all four channels: for a PNG of 16 bits, the upper 8 of each.  Errors: as above;
/// UnreadExtension for a DDS, an OpenEXR, and for a KTX2 of BC1 to BC7 or with premultiplied alpha.
void decode_colour(std::span<const unsigned char> bytes, ColourImage& image, const std::string& file,
                   const std::string& place);

}  // namespace mmverify::scene
