// impl/attribute/compress.hpp: what is refused, and where; sizes and entropies that are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "impl/attribute/compress.hpp"

namespace impl_attribute_compress_test {

using namespace mmverify::impl::attribute;
using Bytes = std::vector<std::uint8_t>;

const PackedShape four_faces{.level = 1, .channels = 1};
const Bytes good{5, 0, 0, 0, 0, 4, 0x5a, 0x0a};

/// "byte N: ..." of what is refused.
std::string refusal(const PackedShape& shape, const Bytes& bytes) {
  try {
    PackedMaps(shape, bytes);
  } catch (const BadPacked& bad) {
    EXPECT_LE(bad.byte(), bytes.size());
    return bad.what();
  }
  return "accepted";
}

TEST(AttributePackedBytes, AreThoseOfTheSpecification) {
  EXPECT_EQ(pack(four_faces, Bytes{10, 5, 1, 4}), good);
  EXPECT_EQ(PackedMaps(four_faces, good).codes(), (Bytes{10, 5, 1, 4}));
}

TEST(AttributePackedBytes, AreRefusedWithPlaceAndReason) {
  const auto spoilt = [](std::size_t at, std::uint8_t byte) {
    Bytes bytes = good;
    bytes[at] = byte;
    return refusal(four_faces, bytes);
  };
  EXPECT_EQ(refusal(four_faces, {}), "byte 0: the end of the input; 6 bytes and more would do");
  EXPECT_EQ(spoilt(1, 9), "byte 1: start 9; 0 would do");
  EXPECT_EQ(spoilt(5, 10), "byte 5: width 10; 0 to 9 would do");
  EXPECT_EQ(spoilt(5, 0x14), "byte 5: a width of no block; 0 would do");
  EXPECT_EQ(spoilt(5, 9), "byte 8: the end of the input; 10 bytes would do");
  EXPECT_EQ(spoilt(7, 0x1a), "byte 7: an unused bit that is set; 0 would do");
  EXPECT_EQ(spoilt(0, 1), "byte 6: residuals that make -3 of value 2 of map 0, channel 0; 0 to 255 would do");
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_EQ(refusal(four_faces, longer), "byte 8: bytes after the end; 8 bytes would do");
  EXPECT_EQ(refusal(four_faces, {5, 0, 0, 0, 0, 5, 0xaa, 0x28}), "byte 5: width 5; 4 would do");
  PackedShape coarse = four_faces;
  coarse.error[0] = 127;
  EXPECT_EQ(refusal(coarse, good), "byte 0: root 5; 0 to 1 would do");
}

TEST(AttributePackedBytes, ShapesBeyondTheDomainAreRefused) {
  const auto refused = [](const std::function<void(PackedShape&)>& change) {
    PackedShape shape = four_faces;
    change(shape);
    EXPECT_THROW(plain_bytes(shape), std::invalid_argument);
    EXPECT_THROW(pack(shape, Bytes(4)), std::invalid_argument);
    EXPECT_THROW(PackedMaps(shape, good), std::invalid_argument);
  };
  refused([](PackedShape& s) { s.level = 13; });
  refused([](PackedShape& s) { s.channels = 0; });
  refused([](PackedShape& s) { s.channels = 5; });
  refused([](PackedShape& s) { s.error[0] = 128; });
  refused([](PackedShape& s) { s.error[1] = 1; });
  refused([](PackedShape& s) { s.maps = 1u << 30; });
  refused([](PackedShape& s) { s.at = static_cast<MapAt>(2); });
  EXPECT_THROW(pack(four_faces, Bytes(5)), std::invalid_argument);
  Bytes room(3);
  EXPECT_THROW(PackedMaps(four_faces, good).map(0, room), std::invalid_argument);
}

TEST(AttributePackedBytes, OfNoMapsAreNone) {
  const PackedShape shape{.level = 3, .maps = 0};
  EXPECT_THAT(pack(shape, {}), testing::IsEmpty());
  EXPECT_THAT(PackedMaps(shape, {}).codes(), testing::IsEmpty());
}

TEST(AttributePackedBytes, AValueBeyondTheDomainIsNothing) {
  const PackedMaps maps(four_faces, good);
  const std::array<std::uint8_t, 4> nothing{};
  EXPECT_EQ(maps.value(1, 0), nothing);
  EXPECT_EQ(maps.value(0, 2, 0), nothing);
  EXPECT_EQ(maps.value(0, 4), nothing);
}

TEST(AttributePackedEntropy, OfWhatIsKnown) {
  // One colour: nothing to be told.
  EXPECT_EQ(residual_entropy({.level = 2, .channels = 1}, Bytes(16, 9)), 0);
  // Two roots of one channel, each once: a bit each.
  EXPECT_EQ(residual_entropy({.level = 0, .channels = 1, .maps = 2}, Bytes{1, 2}), 2);
  // Four maps of 4 faces: residuals 0 and, once in three, the step of one of four maps.
  const Bytes codes{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0};
  // Roots 0, 0, 0, 1; residuals 2, 0, 1 and nine zeros.
  const double roots = 4 * 2 - 3 * std::log2(3.0), levels = 12 * std::log2(12.0) - 10 * std::log2(10.0);
  EXPECT_NEAR(residual_entropy({.level = 1, .channels = 1, .maps = 4}, codes), roots + levels, 1e-9);
}

}  // namespace impl_attribute_compress_test
