// [release] spec/dag: a graph worked by hand, and what is no container.
#include <gtest/gtest.h>

#include "spec/dag/words.hpp"

namespace spec_dag_test {

using namespace mmverify::spec::dag;
namespace micromap = mmverify::spec::micromap;

constexpr State T = State::T, O = State::O, UO = State::UO;

States tiles(std::initializer_list<States> all) {
  States map;
  for (const States& tile : all) map.insert(map.end(), tile.begin(), tile.end());
  return map;
}
const States all_t(64, T), all_o(64, O);
States first_o() {
  States tile(64, T);
  tile[0] = O;
  return tile;
}
States last_o() {
  States tile(64, T);
  tile[63] = O;
  return tile;
}

void put(Bytes& to, std::initializer_list<int> bytes) {
  for (const int b : bytes) to.push_back(static_cast<std::uint8_t>(b));
}

// Level 4 in 2-state: tiles A, O, T, A.  The node has children 0 and 3 mixed, mask 1001; child 1 is O, plane 0010; two
// references of 16 bits to tile 0: words 0x00020009 and 0.  A takes 64 bits, the node 64, the flat map 256.
// Then B of level 3, which is tile 1; then the first map again; then O at level 5; then T O O O at level 1.
Builder by_hand() {
  Builder b(Format::two_state);
  const States map = tiles({first_o(), all_o, all_t, first_o()});
  b.add(4, map);
  b.add(3, last_o());
  b.add(4, map);
  b.add(5, States(1024, O));
  b.add(1, {T, O, O, O});
  return b;
}

TEST(SpecDag, TheWorkedExampleInWords) {
  const Words words = arrays(by_hand().dag());
  Bytes nodes, tile_words, records;
  put(nodes, {0x09, 0x00, 0x02, 0x00, 0, 0, 0, 0});
  put(tile_words, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80});
  put(records, {4, 3, 0, 0, 0, 0, 0, 0});     // a node, narrow, at word 0
  put(records, {3, 2, 0, 0, 1, 0, 0, 0});     // tile 1
  put(records, {4, 3, 0, 0, 0, 0, 0, 0});     // the first again
  put(records, {5, 1, 0, 0, 1, 0, 0, 0});     // uniform, O
  put(records, {1, 0, 0, 0, 0x0E, 0, 0, 0});  // small
  EXPECT_EQ(words.nodes, nodes);
  EXPECT_EQ(words.tiles, tile_words);
  EXPECT_EQ(words.records, records);
  EXPECT_TRUE(words.flat.empty());
  EXPECT_EQ(bits(by_hand().dag()), 8 * (nodes.size() + tile_words.size() + records.size()));
}

TEST(SpecDag, TheWorkedExampleIsLookedUp) {
  const Dag dag = by_hand().dag();
  EXPECT_EQ(at_index(dag, 0, 0), O);
  EXPECT_EQ(at_index(dag, 0, 1), T);
  EXPECT_EQ(at_index(dag, 0, 64), O);
  EXPECT_EQ(at_index(dag, 0, 191), T);
  EXPECT_EQ(at_index(dag, 0, 192), O);
  EXPECT_EQ(at_index(dag, 1, 63), O);
  EXPECT_EQ(decode(dag, 4), (States{T, O, O, O}));
}

// Four tiles of four kinds, none known: 256 bits of tiles and 96 of the node (1 + 1 + 4 halfwords), the map flat 256.
TEST(SpecDag, WhatTakesMoreIsLaidFlatOnce) {
  States a = first_o(), b = last_o(), c = a, d = b;
  c[1] = O;
  d[62] = O;
  const States map = tiles({a, b, c, d});
  Builder builder(Format::two_state);
  builder.add(4, map);
  builder.add(4, map);
  const Dag& dag = builder.dag();
  EXPECT_EQ(dag.maps[0].kind, Map::Kind::flat);
  EXPECT_EQ(dag.maps[1].kind, Map::Kind::flat);
  EXPECT_EQ(dag.flat.size(), 1u);
  EXPECT_TRUE(dag.tiles.empty());
  EXPECT_TRUE(dag.nodes.empty());
  EXPECT_EQ(decode(dag, 1), map);
  EXPECT_EQ(bits(dag), 2u * 64 + 256);
  EXPECT_LE(bits(dag), most_bits(dag));
}

// 4-state: the high bits of children that are not mixed are in the third halfword, references from the fourth on.
TEST(SpecDag, FourStatesHaveTwoPlanes) {
  Builder builder(Format::four_state);
  builder.add(4, tiles({States(64, UO), first_o(), all_o, all_t}));
  Bytes nodes;
  put(nodes, {0x02, 0, 0x05, 0, 0x01, 0, 0, 0});
  EXPECT_EQ(arrays(builder.dag()).nodes, nodes);
  EXPECT_EQ(at_index(builder.dag(), 0, 0), UO);
}

TEST(SpecDag, AContainerIsThatOfItsMaps) {
  const Dag dag = by_hand().dag();
  const Bytes bytes = container(dag);
  EXPECT_EQ(bytes.size(), header_bytes + 40 + 16 + 8);
  EXPECT_EQ(from_container(bytes), dag);
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(from_container(cut)) << k;
    Bytes flipped = bytes;
    flipped[k] ^= 1;
    EXPECT_FALSE(from_container(flipped)) << k;
  }
}

// RFC 3720, B.4: 32 bytes of zeros.
TEST(SpecDag, TheChecksumIsThatOfTheStandard) { EXPECT_EQ(crc32c(Bytes(32, 0)), 0x8A9136AAu); }

}  // namespace spec_dag_test
