#include "scene/read/png.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <string_view>

namespace mmverify::scene {
namespace {

using PngBytes = std::span<const unsigned char>;

constexpr std::size_t signature = 8,
                      around_data = 12;  // its length and type before a chunk's data, its CRC behind

std::uint32_t big_endian(PngBytes bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 |
         std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

struct Chunk {
  std::string_view type;
  PngBytes whole, data;
};

/// The chunk that begins at a byte; none if it is cut off.
std::optional<Chunk> chunk_at(PngBytes bytes, std::size_t at) {
  if (at > bytes.size() || bytes.size() - at < around_data) return std::nullopt;
  const std::size_t length = big_endian(bytes, at);
  if (length > bytes.size() - at - around_data) return std::nullopt;
  return Chunk{{reinterpret_cast<const char*>(bytes.data()) + at + 4, 4},
               bytes.subspan(at, length + around_data),
               bytes.subspan(at + 8, length)};
}

/// Whether a chunk decides texels: critical chunks do, and the transparency of a palette or a colour.
bool decides_texels(std::string_view type) { return (type[0] & 0x20) == 0 || type == "tRNS"; }

bool has_its_crc([[maybe_unused]] const Chunk& chunk) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return true;  // or a fuzzer would get no further
#else
  boost::crc_32_type crc;
  crc.process_bytes(chunk.whole.data() + 4, chunk.data.size() + 4);
  return crc.checksum() == big_endian(chunk.whole, chunk.whole.size() - 4);
#endif
}

}  // namespace

std::optional<std::string> damage_of_png(PngBytes bytes) {
  for (std::size_t at = signature;;) {
    const auto chunk = chunk_at(bytes, at);
    if (!chunk) return "cut off at byte " + std::to_string(at) + ", before its IEND chunk; truncated file?";
    if (decides_texels(chunk->type) && !has_its_crc(*chunk))
      return "its chunk at byte " + std::to_string(at) + " has another CRC than its bytes; damaged file?";
    if (chunk->type == "IEND") return std::nullopt;
    at += chunk->whole.size();
  }
}

std::vector<unsigned char> with_palette_marked(PngBytes bytes) {
  constexpr std::size_t depth_at = 24, colour_type_at = 25, most_colours = 256;
  constexpr unsigned char by_palette = 3;
  if (bytes[colour_type_at] != by_palette) return {};
  std::vector<unsigned char> marked(bytes.begin(), bytes.begin() + signature);
  for (std::size_t at = signature;;) {
    const auto chunk = chunk_at(bytes, at);
    if (!chunk) return {};
    at += chunk->whole.size();
    if (chunk->type == "tRNS") continue;
    if (chunk->type != "PLTE") {
      marked.insert(marked.end(), chunk->whole.begin(), chunk->whole.end());
    } else {
      const std::size_t colours = chunk->data.size() / 3;
      if (colours >= std::size_t{1} << std::min<unsigned>(8, bytes[depth_at])) return {};
      // stb's decoder does not check the CRC.
      constexpr std::size_t length = 3 * most_colours;
      marked.insert(marked.end(), {0, 0, length >> 8, length & 0xff, 'P', 'L', 'T', 'E'});
      for (std::size_t k = 0; k < length; ++k) marked.push_back(k / 3 < colours ? 0x00 : 0xff);
      marked.insert(marked.end(), 4, 0);
    }
    if (chunk->type == "IEND") return marked;
  }
}

}  // namespace mmverify::scene
