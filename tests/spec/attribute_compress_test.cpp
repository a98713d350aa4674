// [release] spec/attribute/compress*.hpp: steps, counts and bytes worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spec/attribute/compress.hpp"

namespace spec_attribute_compress_test {

using namespace mmverify::spec::attribute;
using Bytes = std::vector<std::uint8_t>;
using testing::ElementsAre;

TEST(AttributeResiduals, OfFourChildrenByHand) {
  // s = floor(15/2) = 7, t = floor(5/2) = 2, parent = ceil(9/2) = 5
  EXPECT_EQ(family_of({10, 5, 1, 4}), (Family{5, {5, -3, 5}}));
  EXPECT_THAT(children_of({5, {5, -3, 5}}), ElementsAre(10, 5, 1, 4));
}

// A step on a pair is a bijection, and a family is three of them; its parent depends on sums alone.
TEST(AttributeResiduals, OfEveryPairComeBack) {
  for (std::int32_t a = 0; a < 256; ++a)
    for (std::int32_t b = 0; b < 256; ++b) {
      const std::int32_t s = half_down(a + b), d = a - b, back = s - half_down(d);
      ASSERT_EQ(back, b);
      ASSERT_EQ(back + d, a);
      ASSERT_TRUE(0 <= s && s < 256);
      const std::int32_t up = half_up(a + b), second = up - half_up(d);
      ASSERT_EQ(second, b);
    }
}

// |4 parent - (a+b+c+d)| <= 2 for all sums: s of a pair with sum x is floor(x/2), t of y the same.
TEST(AttributeResiduals, TheParentIsWithinHalfACodeOfTheMean) {
  for (std::int32_t x = 0; x <= 510; ++x)
    for (std::int32_t y = 0; y <= 510; ++y) {
      const std::int32_t four = 4 * half_up(half_down(x) + half_down(y));
      ASSERT_LE(four, x + y + 2);
      ASSERT_GE(four, x + y - 2);
    }
}

TEST(AttributeResiduals, OfVerticesAreFromTheMeanOfTwoEnds) {
  // Corners w, u, v = 10, 20, 31; level 1 adds the middles of w-v, u-v and w-u: 21 (20.5 up), 26 (25.5 up), 15.
  const std::vector<std::int32_t> map{10, 20, 31, 20, 26, 18};
  const Residuals r = residuals_of(MapAt::vertices, 1, map);
  EXPECT_THAT(r.roots, ElementsAre(10, 20, 31));
  EXPECT_THAT(r.levels, ElementsAre(-1, 0, 3));
  EXPECT_EQ(values_from(MapAt::vertices, 1, r), map);
}

TEST(AttributeResiduals, TriplesAddUp) {
  for (const MapAt at : {MapAt::faces, MapAt::vertices}) {
    std::uint64_t values = roots_of(at);
    for (mmverify::spec::Level m = 1; m <= 12; ++m) {
      EXPECT_EQ(triples_before(at, m), (values - roots_of(at)) / 3);
      values += 3 * triples_of(at, m);
      EXPECT_EQ(values, values_of(at, m));
      std::uint64_t of_blocks = 0;
      for (const std::uint32_t length : block_lengths(at, m)) of_blocks += length;
      EXPECT_EQ(3 * of_blocks + roots_of(at), values);
    }
  }
}

TEST(AttributeError, KeepsEveryCodeWithinEveryError) {
  for (std::int32_t error = 0; error <= 127; ++error)
    for (std::int32_t code = 0; code < 256; ++code) {
      const std::int32_t number = number_of_code(code, error), back = code_of_number(number, error);
      ASSERT_LE(std::abs(back - code), error);
      ASSERT_EQ(number_of_code(back, error), number);
      ASSERT_LE(number, last_number(error));
    }
}

TEST(AttributePacked, ByHand) {
  // One channel, one map of four faces: root 5; residuals 5, -3, 5 are 10, 5, 10 folded, of 4 bits.
  const PackedShape shape{.level = 1, .channels = 1};
  EXPECT_THAT(pack(shape, Bytes{10, 5, 1, 4}), ElementsAre(5, 0, 0, 0, 0, 4, 0x5a, 0x0a));
  EXPECT_EQ(unpack(shape, Bytes{5, 0, 0, 0, 0, 4, 0x5a, 0x0a}), (Bytes{10, 5, 1, 4}));
  // An unused bit, a start, a width that is too wide, a byte more, a byte less.
  EXPECT_EQ(unpack(shape, Bytes{5, 0, 0, 0, 0, 4, 0x5a, 0x1a}), std::nullopt);
  EXPECT_EQ(unpack(shape, Bytes{5, 1, 0, 0, 0, 4, 0x5a, 0x0a}), std::nullopt);
  EXPECT_EQ(unpack(shape, Bytes{5, 0, 0, 0, 0, 5, 0xaa, 0x28}), std::nullopt);
  EXPECT_EQ(unpack(shape, Bytes{5, 0, 0, 0, 0, 4, 0x5a, 0x0a, 0}), std::nullopt);
  EXPECT_EQ(unpack(shape, Bytes{5, 0, 0, 0, 0, 4, 0x5a}), std::nullopt);
  // A root of which the residuals make no codes.
  EXPECT_EQ(unpack(shape, Bytes{1, 0, 0, 0, 0, 4, 0x5a, 0x0a}), std::nullopt);
}

TEST(AttributePacked, OneValueAMapIsItself) {
  const PackedShape shape{.level = 0, .channels = 3, .maps = 2};
  const Bytes codes{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(pack(shape, codes), codes);
  EXPECT_EQ(unpack(shape, codes), codes);
}

TEST(AttributePacked, OneColourTakesItsWidthsAlone) {
  const PackedShape shape{.level = 5, .channels = 4};
  const Bytes codes(4 * 1024, 77);
  // 1 root of 4 channels; 1 + 1 + 4 + 16 blocks: 3 starts and 88 halves.
  EXPECT_EQ(pack(shape, codes).size(), 4u + 3 * 4 + 44);
}

}  // namespace spec_attribute_compress_test
