#include "scene/read/tga.hpp"

#include <algorithm>

namespace mmverify::scene {
namespace {

using TgaBytes = std::span<const unsigned char>;

constexpr std::size_t header_bytes = 18, map_type_at = 1, type_at = 2, map_length_at = 5, map_bits_at = 7,
                      width_at = 12, height_at = 14, bits_at = 16, descriptor_at = 17;
constexpr unsigned run_length = 8;  // of a type's number

std::size_t tga_word(TgaBytes bytes, std::size_t at) { return bytes[at] | std::size_t{bytes[at + 1]} << 8; }

std::size_t whole_bytes(std::size_t bits) { return (bits + 7) / 8; }

/// The byte at which the texels begin.
std::size_t texels_at(TgaBytes bytes) {
  const std::size_t map =
      bytes[map_type_at] == 0 ? 0 : tga_word(bytes, map_length_at) * whole_bytes(bytes[map_bits_at]);
  return header_bytes + bytes[0] + map;
}

/// Whether packets of runs, from byte `at` on, hold so many texels.
bool has_packets(TgaBytes bytes, std::size_t at, std::size_t texels, std::size_t size) {
  while (texels != 0) {
    if (at >= bytes.size()) return false;
    const std::size_t count = (bytes[at] & 0x7fu) + 1, stored = (bytes[at] & 0x80u) != 0 ? 1 : count;
    if (bytes.size() - at - 1 < stored * size) return false;
    at += 1 + stored * size;
    texels -= std::min(texels, count);
  }
  return true;
}

}  // namespace

bool is_tga(TgaBytes bytes) {
  if (bytes.size() < header_bytes) return false;
  const unsigned type = bytes[type_at], kind = type & ~run_length, bits = bytes[bits_at];
  const bool mapped = kind == 1, coloured = kind == 2, grey = kind == 3;
  if (!(mapped || coloured || grey) || type > 11 || bytes[map_type_at] > 1) return false;
  if (mapped != (bytes[map_type_at] == 1)) return false;
  if (mapped && (bits != 8 || tga_word(bytes, map_length_at) == 0)) return false;
  if (coloured && bits != 15 && bits != 16 && bits != 24 && bits != 32) return false;
  if (grey && bits != 8 && bits != 16) return false;
  const bool reserved = (bytes[descriptor_at] & 0xc0u) != 0;
  return !reserved && tga_word(bytes, width_at) != 0 && tga_word(bytes, height_at) != 0;
}

std::optional<std::string> damage_of_tga(TgaBytes bytes) {
  const std::size_t at = texels_at(bytes), size = whole_bytes(bytes[bits_at]),
                    texels = tga_word(bytes, width_at) * tga_word(bytes, height_at);
  const bool whole =
      at <= bytes.size() && ((bytes[type_at] & run_length) != 0 ? has_packets(bytes, at, texels, size)
                                                                : (bytes.size() - at) / size >= texels);
  if (whole) return std::nullopt;
  return "a TGA that ends before its " + std::to_string(texels) + " texels; truncated file?";
}

}  // namespace mmverify::scene
