// Decoders of WebP and AVIF: WebP's is there if its library was at build time, AVIF's if its library is found when a file
// needs it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace mmverify::scene {

/// A picture's texels, four channels each, rows from the top, of 255 or of 65535.
struct RgbaImage {
  std::uint32_t width = 0, height = 0;
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> rgba;
};

/// A WebP of one picture; without alpha it is opaque.
/// Errors: BadScene if it is damaged, an animation, or a side is above longest_side; UnreadExtension in a
/// build without the library.
RgbaImage decode_webp(std::span<const unsigned char> bytes, const std::string& file,
                      const std::string& place);

/// Why no AVIF can be decoded: a build without its headers, or no library on this machine.  Opens the library, once.
std::optional<std::string> why_no_avif();

/// An AVIF's picture, not premultiplied: 8 bits for 8, else each code of 10 or 12 bits as the nearest of 65535;
/// 8 bits of each if `eight`.
/// Errors: BadScene if it is damaged or a side is above longest_side; UnreadExtension if it is turned, mirrored
/// or cropped, and if why_no_avif() says so.
RgbaImage decode_avif(std::span<const unsigned char> bytes, bool eight, const std::string& file,
                      const std::string& place);

}  // namespace mmverify::scene
