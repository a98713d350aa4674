// Files of attribute micromaps, and packed maps, on raw bytes: a refusal, or maps that write back to the very same bytes.
//
// Input: a byte, whose remainder by 4 names the form of the rest:
//   0  a file
//   1  a file whose checksum is corrected first, so that the reader reaches the bytes behind it
//   2  codes to pack; 3 packed bytes.  Both begin with a shape: a byte whose bit 0 means vertices, bits 1..2 the level,
//      0..3, bits 3..4 the channels less one, bits 5..6 the maps less one; then an error for each channel, its remainder by
//      128.  Missing codes are zeros.
// With PLANTED the harness's reader of files accepts the flags of no triangle if flags mean means.
//
// Covers: impl/attribute/container.* impl/attribute/compress.hpp impl/attribute/compress/*
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "impl/attribute/container.hpp"
#include "spec/attribute/compress.hpp"

namespace {

namespace fast = mmverify::impl::attribute;
namespace slow = mmverify::spec::attribute;
using Bytes = std::vector<std::uint8_t>;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "attribute_container: %s\n", what);
  std::abort();
}

slow::PackedShape specified(const fast::PackedShape& s) {
  return {static_cast<slow::MapAt>(s.at), s.level, s.channels, s.maps, s.error};
}

/// The codes of packed bytes; none if they are refused.  The specification must accept the same bytes.
std::optional<Bytes> unpacked(const fast::PackedShape& shape, const Bytes& bytes) {
  std::optional<Bytes> codes;
  try {
    const fast::PackedMaps maps(shape, bytes);
    codes = maps.codes();
    const auto values = static_cast<std::uint32_t>(fast::values_of_map(shape.at, shape.level));
    for (std::uint32_t map = 0; map < shape.maps; ++map)
      for (std::uint32_t x = 0; x < values; ++x) {
        const auto one = maps.value(map, x);
        for (std::size_t c = 0; c < shape.channels; ++c)
          require(one[c] == (*codes)[(std::size_t{map} * values + x) * shape.channels + c],
                  "a value read alone is another");
      }
    require(fast::pack(shape, *codes) == bytes, "other packed bytes of the same maps");
  } catch (const fast::BadPacked& bad) {
    require(bad.byte() <= bytes.size(), "the place named lies in the packed bytes");
  }
  require(slow::unpack(specified(shape), bytes) == codes, "the specification unpacks otherwise");
  return codes;
}

void packed(const fast::PackedShape& shape, Bytes codes) {
  codes.resize(static_cast<std::size_t>(fast::plain_bytes(shape)));
  const Bytes bytes = fast::pack(shape, codes);
  require(bytes == slow::pack(specified(shape), codes), "the specification packs otherwise");
  const auto back = unpacked(shape, bytes);
  require(back.has_value(), "packed maps are refused");
  for (std::size_t k = 0; k < codes.size(); ++k)
    require(std::abs((*back)[k] - codes[k]) <= shape.error[k % shape.channels], "a code beyond its error");
  const double entropy = fast::residual_entropy(shape, codes);
  require(entropy >= 0 && entropy <= 16.0 * static_cast<double>(codes.size()), "an entropy of no residuals");
}

/// CRC-32C, a bit at a time, of all bytes but its own.
std::uint32_t crc32c(const Bytes& bytes) {
  std::uint32_t crc = ~0u;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    if (k >= 40 && k < 44) continue;
    crc ^= bytes[k];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82f63b78u : crc >> 1;
  }
  return ~crc;
}

void put_right(Bytes& bytes) {
  if (bytes.size() < 44) return;
  const std::uint32_t crc = crc32c(bytes);
  for (std::size_t k = 0; k < 4; ++k) bytes[40 + k] = static_cast<std::uint8_t>(crc >> 8 * k);
}

/// The reader under test; with PLANTED a wrong one.
fast::AttributeMaps read(const Bytes& bytes) {
#ifdef PLANTED
  Bytes other = bytes;
  if (bytes.size() > 44 && bytes[11] == 2 && bytes[25] + bytes[26] + bytes[27] == 0) {
    const std::size_t triangles = bytes[24], last = 44 + 4 * triangles + (3 * triangles + 7) / 8 - 1;
    if (triangles % 8 != 0 && last < bytes.size())
      other[last] = static_cast<std::uint8_t>(other[last] & ((1u << 3 * triangles % 8) - 1));
    put_right(other);
  }
  return fast::read_attributes(other);
#else
  return fast::read_attributes(bytes);
#endif
}

void file(const Bytes& bytes) {
  fast::AttributeMaps maps;
  try {
    maps = read(bytes);
  } catch (const fast::BadAttributeFile& bad) {
    require(bad.byte() <= bytes.size(), "the place named lies in the file");
    return;
  }
  require(fast::write_attributes(maps) == bytes, "other bytes of the same maps");
  // The header is read once more, by its byte positions.
  std::uint32_t checksum = 0;
  for (std::size_t at = 44; at-- > 40;) checksum = checksum << 8 | bytes[at];
  require(crc32c(bytes) == checksum, "a wrong checksum taken");
  const auto order = maps.at == fast::MapAt::faces ? static_cast<std::uint32_t>(maps.face_order)
                                                   : static_cast<std::uint32_t>(maps.vertex_order);
  require(bytes[5] == static_cast<std::uint8_t>(maps.at) && bytes[6] == order && bytes[7] == maps.level &&
              bytes[8] == maps.components && bytes[9] == static_cast<std::uint8_t>(maps.meaning) &&
              bytes[12] == (maps.mips ? 1 : 0),
          "a header read otherwise");
  require(maps.codes.size() == maps.maps * fast::values_of_entry(maps) * fast::channels_of(maps),
          "codes that are missing");
  for (const fast::MapUse& use : maps.triangles)
    require(use.map < maps.maps && use.decimated < 8, "a triangle of no map");
  if (maps.payload == fast::Payload::plain || maps.level > 3 || maps.codes.size() > 4096) return;
  const fast::PackedShape shape{maps.at, maps.level, fast::channels_of(maps), maps.maps, maps.error};
  const std::size_t triangles = maps.triangles.size();
  const std::size_t payload =
      44 + 4 * triangles + (maps.decimation == fast::DecimationRule::none ? 0 : (3 * triangles + 7) / 8);
  const auto codes =
      unpacked(shape, Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(payload), bytes.end()));
  require(codes == maps.codes, "a payload read otherwise");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const unsigned how = data[0] % 4;
  Bytes rest(data + 1, data + size);
  if (how < 2) {
    if (how == 1) put_right(rest);
    file(rest);
    return 0;
  }
  Bytes head(rest);
  head.resize(std::max<std::size_t>(head.size(), 5));
  fast::PackedShape shape;
  shape.at = static_cast<fast::MapAt>(head[0] & 1);
  shape.level = head[0] >> 1 & 3;
  shape.channels = 1 + (head[0] >> 3 & 3u);
  shape.maps = 1 + (head[0] >> 5 & 3u);
  for (std::size_t c = 0; c < shape.channels; ++c) shape.error[c] = head[1 + c] & 127;
  const Bytes content(head.begin() + 1 + static_cast<std::ptrdiff_t>(shape.channels), head.end());
  if (how == 2)
    packed(shape, content);
  else
    unpacked(shape, content);
  return 0;
}
