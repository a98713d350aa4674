// [sanitized, memory] impl/tree/container.hpp: bytes by hand, every way of being wrong, and what is taken of memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "impl/tree/container.hpp"
#include "tests/complaint.hpp"
#include "tests/impl/largest_allocation.hpp"
#include "tests/tree_cases.hpp"

namespace {

using namespace mmverify::impl::tree;
using namespace mmverify::tests;
using Bytes = std::vector<std::uint8_t>;
using ::testing::HasSubstr;

constexpr Format both[] = {Format::two_state, Format::four_state};

/// CRC-32C by its definition, a bit at a time.
std::uint32_t crc32c(const Bytes& bytes) {
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82f63b78u : crc >> 1;
  }
  return ~crc;
}

void set_word(Bytes& bytes, std::size_t at, std::uint32_t word) {
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<std::uint8_t>(word >> (8 * k));
}

/// Puts the checksum right, so that what is behind it is looked at.
Bytes sealed(Bytes bytes) {
  Bytes covered(bytes.begin(), bytes.begin() + 12);
  covered.insert(covered.end(), bytes.begin() + 16, bytes.end());
  set_word(bytes, 12, crc32c(covered));
  return bytes;
}

std::string complaint(const Bytes& bytes) {
  return complaint_of<BadContainer>([&] { read(bytes); });
}

const Bytes header_flat{'m', 'm', 't', 'r', 1, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};

// The tree of impl_tree_test's worked example takes five bytes, the map four: flat.
const Bytes small_map{0b01010101, 0b01000000, 0b10101010, 0b11111101};

Bytes flat_example() {
  Bytes bytes = header_flat;
  bytes.insert(bytes.end(), small_map.begin(), small_map.end());
  return sealed(bytes);
}

// Level 2, all UO: one leaf.  A byte of tree, 0; a byte of states, 3; no internal node.
Bytes tree_example() { return sealed({'m', 'm', 't', 'r', 1, 2, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3}); }

TEST(TreeContainer, ChecksumOfTheTestIsCastagnolis) {
  EXPECT_EQ(crc32c({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xe3069283u);
}

TEST(TreeContainer, WorkedExamples) {
  EXPECT_EQ(write(2, Format::four_state, small_map), flat_example());
  EXPECT_EQ(read(flat_example()).map, small_map);
  EXPECT_EQ(write(2, Format::four_state, Bytes(4, 0xff)), tree_example());
  const Contents contents = read(tree_example());
  EXPECT_EQ(contents.map, Bytes(4, 0xff));
  EXPECT_EQ(contents.level, 2u);
  EXPECT_EQ(contents.format, Format::four_state);
}

TEST(TreeContainer, NeverGrowsByMoreThanTheHeaderAndComesBack) {
  for (const Format b : both)
    for (Level n = 0; n <= 7; ++n)
      for (const States& states : assorted(n, b, 30)) {
        const Bytes map = packed(states, b), bytes = write(n, b, map);
        ASSERT_LE(bytes.size(), map.size() + container_header);
        const Contents contents = read(bytes);
        ASSERT_EQ(contents.map, map);
        ASSERT_EQ(contents.level, n);
        ASSERT_EQ(contents.format, b);
      }
}

TEST(TreeContainer, PaddingIsZeroed) {
  EXPECT_EQ(write(1, Format::two_state, Bytes{0xf5}), write(1, Format::two_state, Bytes{0x05}));
  EXPECT_EQ(write(0, Format::two_state, Bytes{0xff}), write(0, Format::two_state, Bytes{0x01}));
}

TEST(TreeContainer, EachComplaintNamesPlaceFindAndRemedy) {
  const auto with = [](Bytes bytes, std::size_t at, std::uint8_t value) {
    bytes[at] = value;
    return sealed(bytes);
  };
  const Bytes flat = flat_example(), tree = tree_example();
  EXPECT_EQ(complaint({}), "byte 0: the end of the input; a header of 16 bytes would do");
  EXPECT_EQ(complaint(Bytes(flat.begin(), flat.begin() + 15)),
            "byte 15: the end of the input; a header of 16 bytes would do");
  EXPECT_EQ(complaint(with(flat, 0, 'M')), "byte 0: 0x72746d4d; \"mmtr\" would do");
  EXPECT_EQ(complaint(with(flat, 4, 2)), "byte 4: version 2; version 1 would do");
  EXPECT_EQ(complaint(with(flat, 5, 13)), "byte 5: level 13; 0 to 12 would do");
  EXPECT_THAT(complaint(with(flat, 6, 0)), HasSubstr("byte 6: format 0; "));
  EXPECT_THAT(complaint(with(flat, 6, 3)), HasSubstr("byte 6: format 3; "));
  EXPECT_THAT(complaint(with(flat, 7, 2)), HasSubstr("byte 7: kind 2; "));
  EXPECT_THAT(complaint(with(flat, 8, 1)), HasSubstr("byte 8: 1 internal nodes of a flat map; 0 would do"));
  EXPECT_THAT(complaint(with(tree, 8, 6)), HasSubstr("byte 8: 6 internal nodes; at most 5 would do"));
  // Five internal nodes are 21 bits and 16 states: 3 + 4 bytes for a map of 4.
  EXPECT_THAT(complaint(with(tree, 8, 5)), HasSubstr("the flat map would do"));
  Bytes longer = flat;
  longer.push_back(0);
  EXPECT_EQ(complaint(sealed(longer)), "byte 20: bytes after the end; 20 bytes would do");
  EXPECT_EQ(complaint(sealed(Bytes(flat.begin(), flat.end() - 1))),
            "byte 19: the end of the input; 20 bytes would do");
  Bytes wrong = flat;
  wrong[12] ^= 1;
  EXPECT_THAT(complaint(wrong), HasSubstr("byte 12: checksum 0x"));
  // All of one state, flat: a tree of 2 bytes says the same.
  Bytes uniform = header_flat;
  uniform.resize(20, 0x55);
  EXPECT_THAT(complaint(sealed(uniform)), HasSubstr("byte 7: a flat map whose tree is smaller"));
  EXPECT_THAT(complaint(with(tree, 16, 2)),
              HasSubstr("byte 16: a padding bit that is set, bit 1 of the tree"));
  EXPECT_THAT(complaint(with(tree, 17, 7)),
              HasSubstr("byte 17: a padding bit that is set, bit 2 of the states"));
  // Level 1 as it is kept, 4 bits of states; then one bit too many.
  const Bytes one = write(1, Format::two_state, Bytes{0x05});
  EXPECT_THAT(complaint(with(one, 16, 0x15)), HasSubstr("byte 16: a padding bit that is set"));
}

TEST(TreeContainer, FaultsOfTheTreeArePlaced) {
  // Level 4, four states, a few leaves: 16 quarters of the first child apart.
  States states(256, 0);
  states[5] = 1;
  const Bytes good = write(4, Format::four_state, packed(states, Format::four_state));
  ASSERT_EQ(good[7], 1) << "kept as a tree";
  ASSERT_EQ(good[8], 4) << "one internal node on each level";
  // 17 nodes: 1 1 1 0 1 0000 00 000 000; bit 16 is the last.
  Bytes bad = good;
  bad[16] ^= 1;
  EXPECT_THAT(complaint(sealed(bad)),
              HasSubstr("byte 16: nodes after the end of the tree, bit 1 of the tree"));
  bad = good;
  bad[16] |= 0x20;  // below level 4
  EXPECT_THAT(complaint(sealed(bad)),
              HasSubstr("byte 16: an internal node on the last level, bit 5 of the tree"));
  bad = good;
  bad[17] |= 0x80;  // bit 15, and its children are missing
  EXPECT_THAT(complaint(sealed(bad)),
              HasSubstr("byte 18: an end before the last subtree, bit 17 of the tree"));
  bad = good;
  for (std::size_t k = 19; k < bad.size(); ++k) bad[k] = 0;  // every state T
  EXPECT_THAT(complaint(sealed(bad)), HasSubstr("the last of four sibling leaves of one state"));
}

TEST(TreeContainer, EveryTruncationAndEveryFlippedBitIsRefused) {
  for (const Format b : both)
    for (const Level n : {0u, 1u, 2u, 4u, 5u})
      for (const std::uint64_t longest : {2u, 40u}) {
        const Bytes good = write(n, b, packed(runs(n, b, longest, 7 + n), b));
        ASSERT_NO_THROW(read(good));
        for (std::size_t length = 0; length < good.size(); ++length)
          EXPECT_THROW(read(std::span(good).first(length)), BadContainer) << length;
        for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
          Bytes bad = good;
          bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ 1 << (bit % 8));
          // A checksum of 32 bits sees every single one.
          EXPECT_THROW(read(bad), BadContainer) << "bit " << bit;
          if (bit / 32 == 3) continue;
          // With the checksum put right: refused, or the container of another map.
          bad = sealed(bad);
          try {
            const Contents contents = read(bad);
            EXPECT_EQ(write(contents.level, contents.format, contents.map), bad) << "bit " << bit;
          } catch (const BadContainer&) {
          }
        }
      }
}

TEST(TreeContainer, TakesNoMemoryForWhatIsOnlyAnnounced) {
  // Level 12, four states, with as many internal nodes as a tree may have there; no more than the header.
  Bytes bytes{'m', 'm', 't', 'r', 1, 12, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  set_word(bytes, 8, 1'000'000);
  bytes = sealed(bytes);
  largest_allocation = 0;
  EXPECT_THROW(read(bytes), BadContainer);
  EXPECT_LT(largest_allocation, 1024u);
  bytes[7] = 0;
  set_word(bytes, 8, 0);
  bytes = sealed(bytes);
  largest_allocation = 0;
  EXPECT_THROW(read(bytes), BadContainer);
  EXPECT_LT(largest_allocation, 1024u);
  // A uniform map of level 12 in 18 bytes is 4 MiB.
  const Bytes uniform = write(12, Format::four_state, Bytes(std::size_t{4} << 20, 0xaa));
  ASSERT_EQ(uniform.size(), 18u);
  largest_allocation = 0;
  EXPECT_EQ(read(uniform).map, Bytes(std::size_t{4} << 20, 0xaa));
  EXPECT_LE(largest_allocation, std::size_t{4} << 20);
}

}  // namespace
