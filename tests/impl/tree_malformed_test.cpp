// [sanitized, memory] impl/tree where it is given what is no tree: refused, never read beyond.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "impl/tree/layout.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "tests/tree_cases.hpp"

namespace impl_tree_malformed_test {

using namespace mmverify::impl::tree;
using namespace mmverify::tests;
using Bytes = std::vector<std::uint8_t>;

constexpr Format both[] = {Format::two_state, Format::four_state};

bool decodes(const Stream& s, Level n = 2, Format b = Format::four_state) {
  Bytes out((micro_triangles(n) * width(b) + 7) / 8);
  return decode_stream(n, b, s, out);
}

TEST(ImplTreeMalformed, EachKind) {
  const Stream good = encode_stream(2, Format::four_state, packed(by_hand, Format::four_state));
  ASSERT_TRUE(decodes(good));
  const auto spoilt = [&good](auto spoil) {
    Stream s = good;
    spoil(s);
    return s;
  };
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.nodes = 12; }))) << "no 4 i + 1";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.leaves = 9; }))) << "no 3 i + 1";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.nodes = 9, s.leaves = 7; }))) << "counts of a smaller tree";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.tree.push_back(0); }))) << "a byte too many";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.data.push_back(0); }))) << "a byte too many";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.tree[1] |= 0x80; }))) << "padding of the tree";
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.data[2] |= 0x10; }))) << "padding of the states";
  // The root a leaf, and 12 nodes after it.
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.tree[0] = 0b00000100; }))) << "ends early";
  // 1 1 ... : child 0 is internal too, and the last child's children are missing.
  EXPECT_FALSE(decodes(spoilt([](Stream& s) { s.tree[0] = 0b00000111; }))) << "ends late";
  // The same tree one level up has no room for its lower internal nodes.
  EXPECT_FALSE(decodes(good, 1)) << "below level n";
  // 1 1 0000 1 0000 0 0 at level 1... and more nodes than level 0 has.
  EXPECT_FALSE(decodes(good, 0)) << "more nodes than the level has";
  EXPECT_FALSE(decodes(Stream{{0b00001}, {0b01010101, 0}, 5, 4}, 1)) << "a byte of states too many";
  EXPECT_TRUE(decodes(Stream{{0b00001}, {0b01010100}, 5, 4}, 1));
  EXPECT_FALSE(decodes(Stream{{0b00001}, {0b01010101}, 5, 4}, 1)) << "four sibling leaves of one state";
  EXPECT_FALSE(decodes(Stream{{}, {}, 0, 0}, 1)) << "nothing";
  EXPECT_FALSE(decodes(Stream{{}, {}, 1, 1}, 1)) << "counts without bytes";
  EXPECT_FALSE(decodes(Stream{{0}, {0}, ~std::uint64_t{0} - 2, 0}, 1)) << "counts beyond everything";
}

// Whatever decodes is a stream of encode_stream: of a map of its own.
void expect_refused_or_another(const Stream& s, Level n, Format b, const Bytes& map) {
  Bytes out(map.size());
  if (!decode_stream(n, b, s, out)) return;
  ASSERT_NE(out, map) << "two streams of one map";
  ASSERT_EQ(encode_stream(n, b, out), s);
}

TEST(ImplTreeMalformed, EveryTruncationAndEveryFlippedBit) {
  for (const Format b : both)
    for (const Level n : {1u, 2u, 3u, 4u}) {
      const States states = runs(n, b, 6, 40 + n);
      const Bytes map = packed(states, b);
      const Stream good = encode_stream(n, b, map);
      for (auto part : {&Stream::tree, &Stream::data}) {
        for (std::size_t length = 0; length < (good.*part).size(); ++length) {
          Stream s = good;
          (s.*part).resize(length);
          EXPECT_FALSE(decodes(s, n, b));
          // No read beyond what is there.
          for (std::uint64_t k = 0; k < states.size(); ++k) lookup_stream(n, b, s, k);
        }
        for (std::size_t bit = 0; bit < 8 * (good.*part).size(); ++bit) {
          Stream s = good;
          (s.*part)[bit / 8] = static_cast<std::uint8_t>((s.*part)[bit / 8] ^ 1 << (bit % 8));
          expect_refused_or_another(s, n, b, map);
          for (std::uint64_t k = 0; k < states.size(); ++k) lookup_stream(n, b, s, k);
        }
      }
      for (auto count : {&Stream::nodes, &Stream::leaves})
        for (int bit = 0; bit < 64; ++bit) {
          Stream s = good;
          s.*count ^= std::uint64_t{1} << bit;
          EXPECT_FALSE(decodes(s, n, b));
          lookup_stream(n, b, s, micro_triangles(n) - 1);
        }
    }
}

TEST(ImplTreeMalformed, LookupOfAnythingReadsNothingBeyond) {
  std::mt19937 random(11);
  for (int round = 0; round < 3000; ++round) {
    Stream s;
    s.tree.resize(random() % 12);
    s.data.resize(random() % 6);
    for (std::uint8_t& byte : s.tree) byte = static_cast<std::uint8_t>(round % 3 == 0 ? 255 : random());
    for (std::uint8_t& byte : s.data) byte = static_cast<std::uint8_t>(random());
    s.nodes = round % 2 == 0 ? ~std::uint64_t{0} : random() % 100;
    s.leaves = random() % 100;
    for (const Format b : both) EXPECT_LT(lookup_stream(6, b, s, random() % 4096), 2 * width(b));
  }
}

TEST(ImplTree, RefusesLevelsAndSizesThatMeanNothing) {
  const Bytes four(4);
  Bytes out(4);
  EXPECT_THROW(encode_stream(13, Format::two_state, four), std::invalid_argument);
  EXPECT_THROW(encode_stream(2, Format::two_state, four), std::invalid_argument);
  EXPECT_THROW(encode_stream(2, Format{3}, four), std::invalid_argument);
  EXPECT_THROW(Tree::encode(13, Format::two_state, four), std::invalid_argument);
  EXPECT_THROW(Tree::encode(2, Format::two_state, four), std::invalid_argument);
  EXPECT_THROW(Tree::encode(2, Format::four_state, four, {0, 2}), std::invalid_argument);
  EXPECT_THROW(Tree::encode(2, Format::four_state, four, {1, 0}), std::invalid_argument);
  const Stream s = encode_stream(2, Format::four_state, four);
  EXPECT_THROW(decode_stream(3, Format::four_state, s, out), std::invalid_argument);
  EXPECT_THROW(decode_stream(13, Format::four_state, s, out), std::invalid_argument);
  const Tree tree = Tree::encode(2, Format::four_state, four);
  EXPECT_THROW(tree.decode(std::span(out).first(3)), std::invalid_argument);
  std::vector<std::uint32_t> three(3), zeros(4);
  EXPECT_THROW(tree.lookup(three, out), std::invalid_argument);
  const std::vector<const Tree*> trees{&tree};
  EXPECT_THROW(lookup(trees, three, zeros, out), std::invalid_argument);
  EXPECT_THROW(lookup(trees, zeros, three, out), std::invalid_argument);
  zeros[2] = 1;
  EXPECT_THROW(lookup(trees, zeros, zeros, out), std::invalid_argument) << "a tree beyond the last";
}

}  // namespace impl_tree_malformed_test
