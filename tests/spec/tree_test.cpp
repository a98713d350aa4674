// [release] spec/tree/tree.hpp: a tree worked by hand, the closed forms, and what is no tree.
#include "spec/tree/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace spec_tree_test {

using namespace mmverify::spec::tree;
using mmverify::spec::Level;
using mmverify::spec::Point;
using mmverify::spec::Rational;
namespace micromap = mmverify::spec::micromap;

constexpr State T = State::T, O = State::O, UT = State::UT, UO = State::UO;

// Worked by hand, in the manner of the paper's figure 4.  The root's children: 0 is all T, a leaf; 1 is mixed, with
// four leaves; 2 is all UO, a leaf; 3 is mixed again, with three O and a T.  In pre-order:
//   node   root 0  1  1.0 1.1 1.2 1.3  2  3  3.0 3.1 3.2 3.3
//   t        0  1  2   3   4   5   6   7  8   9  10  11  12
//   tree     1  0  1   0   0   0   0   0  1   0   0   0   0
//   data        T      T   O  UT  UO  UO      O   O   O   T
const States figure{T, T, T, T, T, O, UT, UO, UO, UO, UO, UO, O, O, O, T};
const Succinct by_hand{
    {true, false, true, false, false, false, false, false, true, false, false, false, false},
    {T, T, O, UT, UO, UO, O, O, O, T}};

TEST(SpecTree, TheWorkedExampleEncodes) { EXPECT_EQ(encode(figure, 2), by_hand); }

// The tree's 13 bits from the least significant up: 10100000 10000; the values two bits each: T T O UT =
// 0x90, UO UO O O = 0x5F, O T = 0x01.
TEST(SpecTree, TheWorkedExampleInBytes) {
  const Bytes expected{0x05, 0x01, 0x90, 0x5F, 0x01};
  EXPECT_EQ(bytes(by_hand, Format::four_state), expected);
  EXPECT_EQ(from_bytes(expected, Format::four_state), by_hand);
  EXPECT_EQ(decode(by_hand, 2, Format::four_state), figure);
}

// Index 14, digits 3 and 2: past the root (t = 1), over child 0 (t 2, d 1), child 1 (t 7, d 5) and child 2 (t
// 8, d 6), into child 3 (t = 9), over two leaves: t = 11, d = 8.
TEST(SpecTree, TheWorkedExampleIsLookedUp) {
  const StateAndBits found = at_index(by_hand, 2, 14);
  EXPECT_EQ(found.state, O);
  EXPECT_EQ(found.tree_bits, 12u);
  EXPECT_EQ(at_index(by_hand, 2, 0).tree_bits, 2u);
  for (std::size_t k = 0; k < figure.size(); ++k) EXPECT_EQ(at_index(by_hand, 2, k).state, figure[k]) << k;
}

// The middle of the base triangle is in its middle child, 1, and there in the middle again, 1.1.
TEST(SpecTree, APointIsLookedUpByItsSteps) {
  const Rational third(1, 3);
  EXPECT_EQ(at_point(by_hand, Point<Rational>{third, third}).state, O);
  const Rational zero(0), one(1);
  EXPECT_EQ(at_point(by_hand, Point<Rational>{zero, zero}).state, T);  // the w-corner: index 0
  EXPECT_EQ(at_point(by_hand, Point<Rational>{zero, one}).state, T);   // the v-corner: index 15
  EXPECT_EQ(at_point(by_hand, Point<Rational>{one, zero}).state, UO);  // the u-corner: in child 2
}

TEST(SpecTree, AUniformMapIsOneLeaf) {
  for (const State s : {T, O, UT, UO})
    for (Level n = 0; n <= 4; ++n) {
      const Succinct tree = encode(States(micromap::micro_triangles(n), s), n);
      EXPECT_EQ(tree, (Succinct{{false}, {s}}));
      EXPECT_EQ(at_index(tree, n, 0).tree_bits, 1u);
    }
}

/// Neighbours along the curve differ, so that nothing merges.
States alternating(Level n) {
  States map;
  for (std::uint64_t k = 0; k < micromap::micro_triangles(n); ++k) map.push_back(k % 2 == 0 ? T : O);
  return map;
}

TEST(SpecTree, TheAlternatingMapIsAsLargeAsTheClosedForm) {
  // Figure 10's: level 2, 5 internal nodes on top of the 16 leaves.
  EXPECT_EQ(most_nodes(2), 16u + 5u);
  EXPECT_EQ(most_bits(2, Format::two_state), 21u + 16u);
  EXPECT_EQ(most_bits(2, Format::four_state), 21u + 32u);
  for (Level n = 0; n <= 6; ++n) {
    const Succinct tree = encode(alternating(n), n);
    EXPECT_EQ(tree.tree.size(), most_nodes(n));
    EXPECT_EQ(tree.data.size(), micromap::micro_triangles(n));
    std::uint64_t worst = 0;
    for (std::uint64_t k = 0; k < micromap::micro_triangles(n); ++k) {
      const std::uint64_t read = at_index(tree, n, k).tree_bits;
      ASSERT_EQ(read, bits_read_of_largest(n, k)) << n << " " << k;
      worst = std::max(worst, read);
    }
    EXPECT_EQ(worst, most_nodes(n));
  }
}

TEST(SpecTree, LeavesAreThreeTimesTheInternalNodesAndOne) {
  for (unsigned k = 0; k < 65536; ++k) {
    States map;
    for (unsigned i = 0; i < 16; ++i) map.push_back(static_cast<State>(k >> i & 1));
    const Succinct tree = encode(map, 2);
    const auto internal = static_cast<std::size_t>(std::count(tree.tree.begin(), tree.tree.end(), true));
    ASSERT_EQ(tree.data.size(), 3 * internal + 1);
    ASSERT_EQ(tree.tree.size(), 4 * internal + 1);
  }
}

TEST(SpecTree, WhatIsNoTreeIsRefused) {
  const auto refused = [](std::vector<bool> tree, States data, Level n, Format f = Format::four_state) {
    return !decode({std::move(tree), std::move(data)}, n, f).has_value();
  };
  EXPECT_FALSE(refused({true, false, false, false, false}, {T, O, T, O}, 1));
  EXPECT_TRUE(refused({}, {}, 1));                                               // nothing
  EXPECT_TRUE(refused({true, false, false, false}, {T, O, T}, 1));               // ends early
  EXPECT_TRUE(refused({false, false}, {T, T}, 1));                               // ends late
  EXPECT_TRUE(refused({true, false, false, false, false}, {T, O, T}, 1));        // a value short
  EXPECT_TRUE(refused({true, false, false, false, false}, {T, O, T, O, O}, 1));  // one too many
  EXPECT_TRUE(refused({true, false, false, false, false}, {T, O, T, O}, 0));     // below level n
  EXPECT_TRUE(refused({true, false, false, false, false}, {O, O, O, O}, 1));     // four alike
  EXPECT_TRUE(refused({false}, {UT}, 1, Format::two_state));                     // not of the format
  EXPECT_FALSE(from_bytes(Bytes{0x01}, Format::two_state));                      // no bits left
  EXPECT_FALSE(from_bytes(Bytes{0x00, 0x00, 0x00}, Format::two_state));          // a byte too many
  EXPECT_FALSE(from_bytes(Bytes{0x02, 0x00}, Format::two_state));                // a bit after the last
  EXPECT_FALSE(from_bytes(Bytes{0x00, 0x02}, Format::two_state));                // and after the value
  EXPECT_FALSE(from_bytes(Bytes{}, Format::two_state));
}

}  // namespace spec_tree_test
