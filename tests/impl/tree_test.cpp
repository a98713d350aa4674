// impl/tree/stream.hpp and impl/tree/tree.hpp against the flat map, the exact specification and trees by hand.
#include "impl/tree/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "impl/index/index.hpp"
#include "impl/tree/container.hpp"
#include "impl/tree/layout.hpp"
#include "impl/tree/stream.hpp"
#include "spec/fixed.hpp"
#include "spec/tree/tree.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"
#include "tests/tree_cases.hpp"

namespace impl_tree_test {

using namespace mmverify::impl::tree;
using namespace mmverify::tests;
namespace spec = mmverify::spec;
using Bytes = std::vector<std::uint8_t>;

constexpr Format both[] = {Format::two_state, Format::four_state};

std::vector<bool> bits_of(const Bytes& bytes, std::uint64_t count) {
  std::vector<bool> bits;
  for (std::uint64_t t = 0; t < count; ++t) bits.push_back((bytes[t / 8] >> (t % 8) & 1) != 0);
  return bits;
}

spec::tree::Succinct specified(const States& states, Level n) {
  std::vector<spec::micromap::State> map;
  for (const std::uint8_t state : states) map.push_back(static_cast<spec::micromap::State>(state));
  return spec::tree::encode(map, n);
}

// The stream is the specification's, bit for bit.
void expect_specified(const States& states, Level n, Format b, const Stream& s) {
  const spec::tree::Succinct expected = specified(states, n);
  ASSERT_EQ(s.nodes, expected.tree.size());
  ASSERT_EQ(s.leaves, expected.data.size());
  const auto format =
      b == Format::two_state ? spec::micromap::Format::two_state : spec::micromap::Format::four_state;
  Bytes all = s.tree;
  all.insert(all.end(), s.data.begin(), s.data.end());
  ASSERT_EQ(all, spec::tree::bytes(expected, format));
}

// Every form gives the map back, and each of its states.
void expect_all_forms(const States& states, Level n, Format b) {
  const Bytes map = packed(states, b);
  Bytes out(map.size(), 0xee);
  const Stream s = encode_stream(n, b, map);
  ASSERT_TRUE(decode_stream(n, b, s, out));
  ASSERT_EQ(out, map);

  const Tree tree = Tree::encode(n, b, map);
  out.assign(map.size(), 0xee);
  tree.decode(out);
  ASSERT_EQ(out, map);
  ASSERT_EQ(tree.level(), n);
  ASSERT_EQ(tree.format(), b);

  std::vector<std::uint32_t> index(states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    index[k] = static_cast<std::uint32_t>(k);
    ASSERT_EQ(lookup_stream(n, b, s, k), states[k]) << "index " << k;
    ASSERT_EQ(tree[k], states[k]) << "index " << k;
  }
  States found(states.size(), 0xee);
  tree.lookup(index, found);
  ASSERT_EQ(found, states);

  ASSERT_EQ(read(write(n, b, map)).map, map);
}

// -----------------------------------------------------------------------------------------------------------
// By hand
// -----------------------------------------------------------------------------------------------------------

TEST(ImplTree, WorkedExample) {
  const Bytes map = packed(by_hand, Format::four_state);
  EXPECT_EQ(map, (Bytes{0b01010101, 0b01000000, 0b10101010, 0b11111101}));
  const Stream s = encode_stream(2, Format::four_state, map);
  EXPECT_EQ(s.nodes, 13u);
  EXPECT_EQ(s.leaves, 10u);
  EXPECT_EQ(s.tree, (Bytes{0b00000101, 0b00000001}));
  EXPECT_EQ(s.data, (Bytes{0b00000001, 0b11011001, 0b00001111}));
  EXPECT_EQ(bits_of(s.tree, 13), (std::vector<bool>{true, false, true, false, false, false, false, false,
                                                    true, false, false, false, false}));
  expect_all_forms(by_hand, 2, Format::four_state);
  expect_specified(by_hand, 2, Format::four_state, s);
}

TEST(ImplTree, UniformMapIsOneLeaf) {
  for (const Format b : both)
    for (Level n = 0; n <= 6; ++n)
      for (std::uint8_t state = 0; state < 2 * width(b); ++state) {
        const Stream s = encode_stream(n, b, packed(States(micro_triangles(n), state), b));
        EXPECT_EQ(s, (Stream{{0}, {state}, 1, 1}));
      }
}

TEST(ImplTree, PaddingBitsAreIgnoredAndWrittenAsZeros) {
  // Level 1, two states: four bits of eight; level 0: one or two of eight.
  EXPECT_EQ(encode_stream(1, Format::two_state, Bytes{0xf5}),
            encode_stream(1, Format::two_state, Bytes{0x05}));
  EXPECT_EQ(encode_stream(0, Format::two_state, Bytes{0xfe}), (Stream{{0}, {0}, 1, 1}));
  EXPECT_EQ(encode_stream(0, Format::four_state, Bytes{0xfe}), (Stream{{0}, {2}, 1, 1}));
  Bytes out(1);
  Tree::encode(1, Format::two_state, Bytes{0xf5}).decode(out);
  EXPECT_EQ(out, Bytes{0x05});
  Tree::encode(0, Format::four_state, Bytes{0xfe}).decode(out);
  EXPECT_EQ(out, Bytes{0x02});
}

// -----------------------------------------------------------------------------------------------------------
// Samples
// -----------------------------------------------------------------------------------------------------------

// No form has more than 2^25 nodes; a quotient that only grows is right where it is right at each end.
TEST(ImplTree, TheWordOfANodeIsAQuotient) {
  for (const std::uint32_t count_size : {0u, 1u, 2u}) {
    mmverify::impl::tree::detail::Layout layout{};
    layout.count_size = count_size;
    const std::uint64_t per_word = layout.per_word();
    for (std::uint64_t w = 0; w * per_word <= 1u << 25; w += sanitized ? 97 : 1) {
      ASSERT_EQ(layout.word_of(w * per_word), w);
      ASSERT_EQ(layout.word_of(w * per_word + per_word - 1), w);
    }
  }
}

// Whatever the depths of its nodes and its blocks, a form is of the same map.
TEST(ImplTree, EveryPairOfDepths) {
  for (const Format b : both)
    for (Level n = 0; n <= 6; ++n)
      for (const States& states : assorted(n, b, 3))
        for (Level block = 0; block < std::max<Level>(n, 1); ++block)
          for (Level top = 0; top <= block; ++top) {
            const Bytes map = packed(states, b);
            const Tree tree = Tree::encode(n, b, map, {top, block});
            Bytes out(map.size(), 0xee);
            tree.decode(out);
            ASSERT_EQ(out, map) << n << ": " << top << ", " << block;
            std::vector<std::uint32_t> index(states.size());
            std::iota(index.begin(), index.end(), 0u);
            States found(states.size(), 0xee);
            tree.lookup(index, found);
            ASSERT_EQ(found, states) << n << ": " << top << ", " << block;
            for (std::size_t k = 0; k < states.size(); ++k)
              ASSERT_EQ(tree[k], states[k]) << n << ": " << top << ", " << block << ", index " << k;
          }
}

// A count takes 8 bits up to 255 ones, 16 up to 65,535 and 24 beyond: both sides of each border, the ones
// first, so that the last words' counts are the greatest.
TEST(ImplTree, CountsOfEverySize) {
  struct Case {
    Level n;
    std::uint64_t ones;
    std::uint32_t size;
  };
  for (const auto& [n, ones, size] : {Case{6, 255, 0}, Case{6, 256, 1}, Case{6, 257, 1}, Case{10, 65'535, 1},
                                      Case{10, 65'536, 2}, Case{10, 65'537, 2}, Case{10, 131'071, 2}}) {
    const std::uint64_t parents = micro_triangles(n - 1);
    Bytes map(parents / 2);
    for (std::uint64_t k = 0; k < parents; ++k) {
      const std::uint64_t states = k < ones ? 1 + k * 7 % 14 : (k / 5) % 2 * 15;
      map[k / 2] = static_cast<std::uint8_t>(map[k / 2] | states << (4 * (k % 2)));
    }
    const Tree tree = Tree::encode(n, Format::two_state, map, {n - 1, n - 1});
    ASSERT_EQ(mmverify::impl::tree::detail::Layout::of(tree.memory()).count_size, size) << ones;
    Bytes out(map.size());
    tree.decode(out);
    ASSERT_EQ(out, map) << ones;
    std::vector<std::uint32_t> index;
    for (std::uint64_t k = 0; k < micro_triangles(n); k += n == 6 ? 1 : 5)
      index.push_back(static_cast<std::uint32_t>(k));
    const auto state = [&map](std::uint32_t k) { return map[k / 8] >> (k % 8) & 1; };
    for (const std::uint32_t k : index) ASSERT_EQ(tree[k], state(k)) << ones << ": " << k;
    on_every_target([&, ones = ones] {
      States found(index.size(), 0xee);
      tree.lookup(index, found);
      for (std::size_t k = 0; k < index.size(); ++k)
        ASSERT_EQ(found[k], state(index[k])) << ones << ": " << index[k];
    });
  }
}

// The memory of every map, sparse ones too: 18/17 of the paper's and the header where a form of that size is;
// and no form takes more than one with no node at all but the root, and the map.
TEST(ImplTree, MemoryIsAsTheBannerSays) {
  for (const Format b : both)
    for (Level n = 1; n <= 7; ++n)
      for (const States& states : assorted(n, b, 40)) {
        const Bytes map = packed(states, b);
        const Stream s = encode_stream(n, b, map);
        const std::uint64_t paper = s.nodes + s.leaves * width(b), ours = Tree::encode(n, b, map).bits();
        std::uint64_t least = ~std::uint64_t{0};
        for (Level block = 0; block < n; ++block)
          for (Level top = 0; top <= block; ++top)
            least = std::min(least, Tree::encode(n, b, map, {top, block}).bits());
        ASSERT_LE(ours, std::max(least, paper + paper / 17 + 64)) << n;
        ASSERT_LE(ours, 8 * map.size() + 64 + 64 + 8) << n;
      }
}

TEST(ImplTree, SpansEqualTheSingleLookupAtEveryLength) {
  on_every_target([] {
    std::vector<Tree> trees;
    std::vector<States> maps;
    for (const Format b : both)
      for (Level n = 0; n <= 7; ++n)
        for (const States& states : assorted(n, b, 6)) {
          trees.push_back(Tree::encode(n, b, packed(states, b)));
          maps.push_back(states);
        }
    std::vector<const Tree*> pointers;
    for (const Tree& tree : trees) pointers.push_back(&tree);
    std::mt19937 random(5);
    // Beyond two groups of 128.
    std::vector<std::size_t> counts(68);
    std::iota(counts.begin(), counts.end(), std::size_t{0});
    counts.insert(counts.end(), {127, 128, 129, 200, 256, 300});
    for (const std::size_t count : counts) {
      // Vectors of the exact size, so that a sanitizer sees a read beyond either end.
      std::vector<std::uint32_t> which(count), index(count);
      States found(count + 1, 0xee);
      for (std::size_t k = 0; k < count; ++k) {
        which[k] = static_cast<std::uint32_t>(random() % trees.size());
        index[k] = static_cast<std::uint32_t>(random() % maps[which[k]].size());
      }
      lookup(pointers, which, index, std::span(found).first(count));
      for (std::size_t k = 0; k < count; ++k)
        ASSERT_EQ(found[k], maps[which[k]][index[k]]) << which[k] << ' ' << index[k];
      ASSERT_EQ(found.back(), 0xee) << "wrote beyond the end";

      const std::size_t one = count % trees.size();
      for (std::uint32_t& k : index) k = static_cast<std::uint32_t>(random() % maps[one].size());
      trees[one].lookup(index, std::span(found).first(count));
      for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(found[k], maps[one][index[k]]);
    }
  });
}

// -----------------------------------------------------------------------------------------------------------
// The largest
// -----------------------------------------------------------------------------------------------------------

// No two siblings alike: the paper's figure 10, every node internal.
TEST(ImplTree, WorstCaseOfEveryLevel) {
  for (const Format b : both)
    for (Level n = 0; n <= max_level; ++n) {
      States states(micro_triangles(n));
      for (std::size_t k = 0; k < states.size(); ++k)
        states[k] = static_cast<std::uint8_t>(k & (width(b) == 1 ? 1 : 3));
      const Bytes map = packed(states, b);
      const Stream s = encode_stream(n, b, map);
      // 1 + 4 + ... + 4^n nodes.
      ASSERT_EQ(s.nodes, (micro_triangles(n + 1) - 1) / 3) << n;
      ASSERT_EQ(s.leaves, micro_triangles(n)) << n;
      Bytes out(map.size());
      ASSERT_TRUE(decode_stream(n, b, s, out));
      ASSERT_EQ(out, map);
      const Tree tree = Tree::encode(n, b, map);
      out.assign(map.size(), 0xee);
      tree.decode(out);
      ASSERT_EQ(out, map);
      if (n >= 6) {
        EXPECT_LE(tree.bits(), s.nodes + s.leaves * width(b)) << n;
      }
      const std::uint64_t stride = n < 8 ? 1 : 4093;
      for (std::uint64_t k = 0; k < states.size(); k += stride)
        ASSERT_EQ(tree[k], states[k]) << n << ' ' << k;
      ASSERT_EQ(tree[states.size() - 1], states.back());
      EXPECT_EQ(lookup_stream(n, b, s, states.size() - 1), states.back());
      EXPECT_EQ(write(n, b, map).size(), container_header + (n == 0 ? 1 : map.size()));
    }
}

TEST(ImplTree, LevelTwelveOfRuns) {
  for (const Format b : both)
    for (const std::uint64_t longest : {30u, 3000u}) {
      const States states = runs(12, b, longest, 3);
      const Bytes map = packed(states, b);
      Bytes out(map.size());
      ASSERT_TRUE(decode_stream(12, b, encode_stream(12, b, map), out));
      ASSERT_EQ(out, map);
      const Tree tree = Tree::encode(12, b, map);
      out.assign(map.size(), 0xee);
      tree.decode(out);
      ASSERT_EQ(out, map);
      for (std::uint64_t k = 0; k < states.size(); k += 61) ASSERT_EQ(tree[k], states[k]) << k;
      ASSERT_EQ(read(write(12, b, map)).map, map);
    }
}

}  // namespace impl_tree_test
