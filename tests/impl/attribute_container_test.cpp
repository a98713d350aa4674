// [memory] impl/attribute/container.hpp: what is written comes back, and what is refused names its byte and why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "impl/attribute/container.hpp"

namespace impl_attribute_container_test {

using namespace mmverify::impl::attribute;
using Bytes = std::vector<std::uint8_t>;

/// Codes that differ from value to value.
AttributeMaps filled(AttributeMaps maps) {
  const std::size_t codes = maps.maps * values_of_entry(maps) * channels_of(maps);
  for (std::size_t k = 0; k < codes; ++k) maps.codes.push_back(static_cast<std::uint8_t>(k * 7 % 251));
  return maps;
}

AttributeMaps faces() { return filled({.level = 2, .components = 7, .meaning = Meaning::srgb, .maps = 2}); }

AttributeMaps decimated() {
  return filled({.at = MapAt::vertices,
                 .level = 1,
                 .components = 1,
                 .tie = TieRule::none,
                 .decimation = DecimationRule::snapping,
                 .maps = 2,
                 .triangles = {{1, 5}, {0, 2}, {1, 7}}});
}

/// A file with some bytes changed, its checksum put right again.
Bytes changed(const AttributeMaps& maps, const std::function<void(Bytes&)>& change) {
  Bytes bytes = write_attributes(maps);
  change(bytes);
  std::uint32_t crc = ~0u;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    if (k >= 40 && k < 44) continue;
    crc ^= bytes[k];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82f63b78u : crc >> 1;
  }
  for (std::size_t k = 0; k < 4 && bytes.size() >= 44; ++k)
    bytes[40 + k] = static_cast<std::uint8_t>(~crc >> 8 * k);
  return bytes;
}

std::string refusal(const Bytes& bytes) {
  try {
    read_attributes(bytes);
  } catch (const BadAttributeFile& bad) {
    EXPECT_LE(bad.byte(), bytes.size());
    return bad.what();
  }
  return "accepted";
}

/// With one byte of the file another.
std::string with(const AttributeMaps& maps, std::size_t at, std::uint8_t byte) {
  return refusal(changed(maps, [&](Bytes& bytes) { bytes.at(at) = byte; }));
}

TEST(AttributeFile, ComesBackByteForByte) {
  std::vector<AttributeMaps> all{faces(), decimated(), filled({.level = 0, .components = 3, .maps = 3}),
                                 AttributeMaps{}};
  AttributeMaps mips = filled({.level = 3, .components = 1, .mips = true, .maps = 2});
  EXPECT_EQ(values_of_entry(mips), 1u + 4 + 16 + 64);
  all.push_back(mips);
  AttributeMaps rows =
      filled({.face_order = FaceOrder::rows, .level = 2, .tie = TieRule::figure_4, .maps = 1});
  all.push_back(rows);
  AttributeMaps means = decimated();
  means.decimation = DecimationRule::means;
  means.payload = Payload::packed;
  all.push_back(means);
  AttributeMaps packed = faces();
  packed.payload = Payload::packed;
  all.push_back(packed);
  for (const AttributeMaps& maps : all) {
    const Bytes bytes = write_attributes(maps);
    EXPECT_EQ(read_attributes(bytes), maps);
    EXPECT_EQ(write_attributes(read_attributes(bytes)), bytes);
  }
}

TEST(AttributeFile, OfPackedMapsWithErrorsKeepsThemWithin) {
  AttributeMaps maps = faces();
  maps.payload = Payload::packed;
  maps.error = {3, 0, 9, 0};
  const Bytes bytes = write_attributes(maps);
  const AttributeMaps back = read_attributes(bytes);
  ASSERT_EQ(back.codes.size(), maps.codes.size());
  for (std::size_t k = 0; k < maps.codes.size(); ++k)
    EXPECT_LE(std::abs(back.codes[k] - maps.codes[k]), maps.error[k % 3]);
  EXPECT_EQ(write_attributes(back), bytes);
}

TEST(AttributeFile, TheBytesAreThoseOfTheDocument) {
  const Bytes bytes = write_attributes(filled({.level = 0, .components = 3, .maps = 1}));
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 40),
            (Bytes{'m', 'm', 'a', 't', 1, 0, 0, 0, 3, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                   1,   0,   0,   0,   0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(Bytes(bytes.begin() + 44, bytes.end()), (Bytes{0, 7}));
  // Three triangles of decimated(): 3 words, 9 flags in 2 bytes: 101 010 111 from the lowest bit on.
  const Bytes flags = write_attributes(decimated());
  EXPECT_EQ(Bytes(flags.begin() + 44, flags.begin() + 58),
            (Bytes{1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0xd5, 1}));
}

TEST(AttributeFile, OfAnotherHeaderIsRefused) {
  EXPECT_EQ(refusal({}), "byte 0: the end of the file; a header of 44 bytes would do");
  EXPECT_EQ(with(faces(), 2, 'o'), "byte 2: byte 111 of the magic; \"mmat\" would do");
  EXPECT_EQ(with(faces(), 4, 2), "byte 4: version 2; 1 would do");
  EXPECT_EQ(with(faces(), 5, 2), "byte 5: stored at 2; 0 (faces) or 1 (vertices) would do");
  EXPECT_EQ(with(faces(), 6, 3), "byte 6: order 3; 0 (curve), 1 (rows) or 2 (U-major) would do");
  EXPECT_EQ(with(decimated(), 6, 3), "byte 6: order 3; 0 (W-minor), 1 (U-major) or 2 (Bird) would do");
  EXPECT_EQ(with(faces(), 7, 13), "byte 7: level 13; 0 to 12 would do");
  EXPECT_EQ(with(faces(), 8, 0), "byte 8: components 0; 1 to 15 would do");
  EXPECT_EQ(with(faces(), 8, 3), "byte 8: components 3 of meaning 1; 7 or 15 would do");
  EXPECT_EQ(with(faces(), 9, 3), "byte 8: components 7 of meaning 3; 15 would do");
  EXPECT_EQ(with(faces(), 9, 4),
            "byte 9: meaning 4; 0 (linear), 1 (sRGB), 2 (direction) or 3 (direction and length) would do");
  EXPECT_EQ(with(faces(), 10, 0), "byte 10: tie rule 0; 1 (Vulkan) or 2 (figure 4) would do");
  EXPECT_EQ(with(decimated(), 10, 1), "byte 10: tie rule 1; 0, vertices need none would do");
  EXPECT_EQ(with(faces(), 11, 1), "byte 11: decimation of faces; 0 would do");
  EXPECT_EQ(with(decimated(), 11, 3), "byte 11: decimation 3; 0, 1 (snapping) or 2 (means) would do");
  EXPECT_EQ(with(decimated(), 12, 1), "byte 12: mips; 0: only of faces on the curve, plain would do");
  EXPECT_EQ(with(faces(), 12, 2), "byte 12: mips 2; 0 or 1 would do");
  EXPECT_EQ(with(faces(), 13, 2), "byte 13: payload 2; 0 (plain) or 1 (packed) would do");
  EXPECT_EQ(with(faces(), 14, 1), "byte 14: 1; 0, reserved, would do");
  EXPECT_EQ(with(faces(), 16, 1), "byte 16: error 1; 0 to 0 would do");
  EXPECT_EQ(with(faces(), 23, 255), "byte 20: 4278190082 maps; at most 2^31 codes would do");
  EXPECT_EQ(with(faces(), 36, 1), "byte 36: 1; 0, reserved, would do");
}

TEST(AttributeFile, OfAnotherLengthOrContentIsRefused) {
  EXPECT_EQ(with(faces(), 20, 3), "byte 28: 96 bytes of payload; 144 would do");
  EXPECT_EQ(with(decimated(), 24, 9), "byte 70: the end of the file; 9 triangles, up to byte 84, would do");
  EXPECT_EQ(refusal(changed(faces(), [](Bytes& b) { b.pop_back(); })),
            "byte 139: the end of the file; a payload of 96 bytes would do");
  EXPECT_EQ(refusal(changed(faces(), [](Bytes& b) { b.push_back(0); })),
            "byte 140: bytes after the end; a payload of 96 bytes would do");
  Bytes flipped = write_attributes(faces());
  flipped[100] ^= 1;
  EXPECT_THAT(refusal(flipped), testing::StartsWith("byte 40: checksum "));
  EXPECT_EQ(with(decimated(), 48, 2), "byte 48: triangle 1 has map 2; less than 2 would do");
  EXPECT_EQ(with(decimated(), 57, 3), "byte 57: a flag of no triangle; 0 would do");
  AttributeMaps packed = faces();
  packed.payload = Payload::packed;
  // 2 maps of 1 root of 3 channels: 6 bytes, a start; then widths.
  EXPECT_EQ(with(packed, 44 + 10, 0xff), "byte 54: width 15; 0 to 9 would do");
}

TEST(AttributeFile, IsNotWrittenOfWhatDoesNotGoTogether) {
  const auto refused = [](AttributeMaps maps, const std::function<void(AttributeMaps&)>& change) {
    change(maps);
    EXPECT_THROW(write_attributes(maps), std::invalid_argument);
  };
  refused(faces(), [](AttributeMaps& m) { m.codes.pop_back(); });
  refused(faces(), [](AttributeMaps& m) { m.level = 13; });
  refused(faces(), [](AttributeMaps& m) { m.tie = TieRule::none; });
  refused(faces(), [](AttributeMaps& m) { m.triangles = {{2, 0}}; });
  refused(faces(), [](AttributeMaps& m) { m.triangles = {{1, 1}}; });
  refused(decimated(), [](AttributeMaps& m) { m.triangles[0].decimated = 8; });
  refused(faces(), [](AttributeMaps& m) {
    m.payload = Payload::packed;
    m.face_order = FaceOrder::rows;
  });
}

}  // namespace impl_attribute_container_test
