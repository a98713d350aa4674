// [release alone] bench/tree*: the peers are right, the maps are what they say, and the sizes, which are exact, keep their
// bounds.
#include "impl/tree/tree.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "bench/tree/bench.hpp"
#include "bench/tree/cache.hpp"
#include "bench/tree/maps.hpp"
#include "bench/tree/obvious.hpp"
#include "bench/tree/sdsl.hpp"
#include "tests/sanitized.hpp"
#include "tests/tree_cases.hpp"

namespace bench_tree_test {

using namespace mmverify::bench;
using namespace mmverify::tests;
using mmverify::impl::tree::encode_stream;
using mmverify::impl::tree::Format;
using mmverify::impl::tree::Level;
using mmverify::impl::tree::Stream;
using mmverify::impl::tree::Tree;
using Bytes = std::vector<std::uint8_t>;

constexpr Format both[] = {Format::two_state, Format::four_state};

TEST(BenchTree, PeersGiveTheMap) {
  for (const Format b : both)
    for (Level n = 0; n <= 5; ++n)
      for (const States& states : assorted(n, b, 20)) {
        const Bytes map = packed(states, b);
        const Stream s = encode_stream(n, b, map);
        ASSERT_EQ(obvious_encode(n, b, map), s);
        Bytes out(map.size(), 0xee);
        obvious_decode(n, b, s, out);
        ASSERT_EQ(out, map);
        const SdslTree peer(n, b, map);
        for (std::uint32_t k = 0; k < states.size(); ++k) ASSERT_EQ(peer[k], states[k]) << n << ' ' << k;
      }
}

std::uint32_t state_at(const Bytes& map, std::uint64_t k, Format b) {
  const std::uint64_t bit = k * width(b);
  return map[bit / 8] >> (bit % 8) & (2 * width(b) - 1);
}

// Filling a node at once must be what asking each of its micro-triangles is: at depth n nothing is filled
// that a finer map splits.  A 4-state map without its unknown bit is the 2-state map.
TEST(BenchTree, LeafMapsOfTheFormatsAgree) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const Level n : {0u, 3u, 6u}) {
      const Bytes two = leaf_map(n, Format::two_state, seed), four = leaf_map(n, Format::four_state, seed);
      for (std::uint64_t k = 0; k < micro_triangles(n); ++k)
        ASSERT_EQ(state_at(two, k, Format::two_state), state_at(four, k, Format::four_state) & 1)
            << seed << ' ' << k;
    }
}

// The micro-triangle in the middle has its parent's centre: child 1.
TEST(BenchTree, LeafMapsOfTheLevelsAgree) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Bytes coarse = leaf_map(4, Format::two_state, seed), fine = leaf_map(5, Format::two_state, seed);
    for (std::uint64_t k = 0; k < micro_triangles(4); ++k)
      ASSERT_EQ(state_at(coarse, k, Format::two_state), state_at(fine, 4 * k + 1, Format::two_state))
          << seed << ' ' << k;
  }
}

TEST(BenchTree, ModelsReadNoLessThanOneLineAnArrayAndNoMoreThanThereAre) {
  for (const Format b : both) {
    const Bytes map = leaf_map(6, b, 3);
    const Stream s = encode_stream(6, b, map);
    const Tree tree = Tree::encode(6, b, map);
    const SdslTree peer(6, b, map);
    std::uint64_t most = 0;
    for (std::uint32_t k = 0; k < micro_triangles(6); ++k) {
      const StreamReads reads = stream_reads(6, s, k);
      most = std::max(most, reads.tree_bits);
      ASSERT_GE(reads.lines, 2u);
      ASSERT_LE(reads.lines, 2 + s.nodes / 512);
      ASSERT_GE(tree_lines(tree, k), 1u);
      ASSERT_LE(tree_lines(tree, k), 1 + tree.bits() / 512);
      ASSERT_GE(peer.lines(k), 3u);
    }
    // The last node of the stream is read by the last index alone, if by any.
    EXPECT_EQ(most, stream_reads(6, s, micro_triangles(6) - 1).tree_bits);
    EXPECT_EQ(most, s.nodes);
  }
}

// Ours over the paper's two sequences, all memory counted: at most 6 % more from level 6 up.
TEST(BenchTree, MemoryIsNearThePapers) {
  if (sanitized) GTEST_SKIP() << "sizes are exact; the release build adds them up";
  for (const Format b : both)
    for (Level n = 6; n <= 9; ++n) {
      std::uint64_t ours = 0, paper = 0;
      for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Bytes map = leaf_map(n, b, seed);
        const Stream s = encode_stream(n, b, map);
        ours += Tree::encode(n, b, map).bits();
        paper += s.nodes + s.leaves * width(b);
      }
      EXPECT_LE(100 * ours, 106 * paper) << n;
    }
}

TEST(BenchTree, FiguresAreComplete) {
  const auto figures = tree_figures({.first = 3, .last = 4, .rounds = 1, .lookups = 2000});
  ASSERT_EQ(figures.size(), 4u);
  for (const TreeFigures& f : figures) {
    EXPECT_EQ(f.maps, tree_map_count(f.level, Format{static_cast<std::uint8_t>(f.bits)}));
    EXPECT_EQ(f.form(TreeForm::flat).bits, f.bits);
    for (const TreeFormFigures& form : f.forms) {
      EXPECT_GT(form.bits, 0);
      EXPECT_GT(form.least_ns, 0);
      EXPECT_LE(form.least_ns, form.ns);
      EXPECT_LE(form.ns, form.most_ns);
      EXPECT_GT(form.chained_ns, 0);
      EXPECT_GE(form.lines, 1);
    }
    for (const double ns :
         {f.obvious_encode, f.encode_stream, f.encode_tree, f.obvious_decode, f.decode_stream, f.decode_tree})
      EXPECT_GT(ns, 0);
    EXPECT_GE(f.bits_read, 1);
    EXPECT_LE(f.bits_read, f.nodes);
  }
  EXPECT_THROW(tree_figures({.first = 4, .last = 3}), std::invalid_argument);
  EXPECT_THROW(tree_figures({.first = 4, .last = 13}), std::invalid_argument);
  EXPECT_THROW(tree_figures({.first = 4, .last = 4, .lookups = 0}), std::invalid_argument);
}

}  // namespace bench_tree_test
