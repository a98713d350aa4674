// impl/tree/tree.hpp where no law goes: every pair of depths, counts of every size, spans of every length, memory.
#include "impl/tree/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include "impl/tree/layout.hpp"
#include "impl/tree/stream.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"
#include "tests/tree_cases.hpp"

namespace impl_tree_test {

using namespace mmverify::impl::tree;
using namespace mmverify::tests;
using Bytes = std::vector<std::uint8_t>;

constexpr Format both[] = {Format::two_state, Format::four_state};

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

}  // namespace impl_tree_test
