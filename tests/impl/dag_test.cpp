// [memory] impl/dag: a map by hand, appending, what is refused and how it is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/dag/container.hpp"
#include "spec/dag/words.hpp"
#include "tests/complaint.hpp"
#include "tests/impl/largest_allocation.hpp"

namespace impl_dag_test {

using namespace mmverify::impl::dag;
using Bytes = std::vector<std::uint8_t>;
using ::testing::HasSubstr;

/// A 2-state map of level 4 or more, of tiles of these words, over and over.
Bytes map_of(Level n, const std::vector<std::uint64_t>& tiles) {
  Bytes map((std::size_t{1} << (2 * n)) / 8);
  for (std::size_t k = 0; k < map.size() / 8; ++k) std::memcpy(&map[8 * k], &tiles[k % tiles.size()], 8);
  return map;
}
constexpr std::uint64_t ones = ~std::uint64_t{0};

/// The container with this number written at `at` and its checksum corrected.
Bytes with(Bytes bytes, std::size_t at, std::uint32_t word) {
  std::memcpy(&bytes[at], &word, sizeof word);
  const std::uint32_t crc = mmverify::spec::dag::checksum(bytes);
  std::memcpy(&bytes[28], &crc, sizeof crc);
  return bytes;
}

std::string complaint(const Bytes& bytes) {
  return mmverify::tests::complaint_of<BadContainer>([&] { load(bytes); });
}

Dag example() {
  Dag dag(Format::two_state);
  dag.add(4, map_of(4, {1, ones, 0, 1}));
  dag.add(7, map_of(7, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, ones, 0, 0, 0, 0, 0}));
  return dag;
}

TEST(Dag, NothingMovesWhenAMapIsAdded) {
  Dag dag = example();
  const std::vector<std::uint64_t> tiles(dag.tiles().begin(), dag.tiles().end());
  const std::vector<std::uint32_t> nodes(dag.nodes().begin(), dag.nodes().end());
  const std::uint64_t before = dag.bits();
  EXPECT_EQ(dag.add(4, map_of(4, {1, ones, 0, 1})), 2u);
  EXPECT_EQ(dag.bits(), before + 64);
  EXPECT_EQ(dag.records()[2].value, dag.records()[0].value);
  dag.add(5, map_of(5, {2, 0, 0, 0}));
  EXPECT_TRUE(std::equal(tiles.begin(), tiles.end(), dag.tiles().begin()));
  EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), dag.nodes().begin()));
}

// Level 7 is 16 children of level 5, all the same node: one node of level 5 and one of level 7, 16 references to it.
TEST(Dag, WhatRepeatsIsStoredOnce) {
  Dag dag(Format::two_state);
  dag.add(7, map_of(7, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, ones, 0, 0, 0, 0, 0}));
  EXPECT_EQ(dag.tiles().size(), 1u);
  EXPECT_EQ(dag.nodes().size(), 2u + 17u);
}

// Numbers of tiles from 65,536 on need 32 bits.  A map of level 12 with four tiles in each node of level 5, all unlike.
TEST(Dag, NodesOfLateTilesAreWide) {
  Bytes map((std::size_t{1} << 24) / 8);
  std::uint64_t next = 0;
  for (std::size_t node = 0; node < (1u << 14); ++node)
    for (const std::size_t k : {0u, 3u, 4u, 15u}) {
      const std::uint64_t tile = ++next << 8;
      std::memcpy(&map[8 * (16 * node + k)], &tile, 8);
    }
  Bytes few = map_of(5, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 3});
  Dag dag(Format::two_state);
  dag.add(12, map);
  ASSERT_EQ(dag.tiles().size(), 65536u);
  dag.add(5, few);
  EXPECT_EQ(dag.records()[1].kind, Kind::node);
  EXPECT_EQ(dag.records()[1].value % 2, 1u);
  Bytes again(map.size());
  dag.decode(0, again);
  EXPECT_EQ(again, map);
  again.resize(few.size());
  dag.decode(1, again);
  EXPECT_EQ(again, few);
  for (std::uint32_t k = 0; k < 1024; ++k) EXPECT_EQ(dag.at(1, k), few[k / 8] >> k % 8 & 1) << k;
  std::vector<std::uint32_t> which(1024, 1), index(1024);
  for (std::uint32_t k = 0; k < 1024; ++k) index[k] = k;
  Bytes states(1024);
  dag.lookup(which, index, states);
  for (std::uint32_t k = 0; k < 1024; ++k) EXPECT_EQ(states[k], few[k / 8] >> k % 8 & 1) << k;
  EXPECT_EQ(save(load(save(dag))), save(dag));
}

TEST(Dag, AddingGoesOnAfterLoading) {
  Dag dag = example(), loaded = load(save(dag));
  for (Dag* each : {&dag, &loaded}) {
    each->add(7, map_of(7, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, ones, 0, 0, 0, 0, 5}));
    each->add(4, map_of(4, {7, 5, 3, 2}));
  }
  EXPECT_EQ(save(loaded), save(dag));
}

TEST(Dag, WhatIsOutsideTheDomainIsSaid) {
  Dag dag = example();
  EXPECT_THROW(dag.add(13, {}), std::invalid_argument);
  EXPECT_THROW(dag.add(4, Bytes(31)), std::invalid_argument);
  EXPECT_THROW(Dag(Format{3}), std::invalid_argument);
  Bytes map(32), state(1);
  EXPECT_THROW(dag.decode(2, map), std::invalid_argument);
  EXPECT_THROW(dag.decode(1, map), std::invalid_argument);
  const std::vector<std::uint32_t> beyond{2}, index{0}, two{0, 0};
  EXPECT_THROW(dag.lookup(beyond, index, state), std::invalid_argument);
  EXPECT_THROW(dag.lookup(two, index, state), std::invalid_argument);
  EXPECT_EQ(dag.maps(), 2u);
}

// 32 bytes of header, records at 32 and 40, one tile at 48, nodes from 56 on: words 0 and 1 the one of level 4, 2 and 3 the
// one of level 5, 4 to 20 that of level 7.
TEST(DagContainer, WhatIsWrongIsNamedWithItsPlace) {
  const Bytes good = save(example());
  ASSERT_EQ(good.size(), 56u + 4 * 21);
  EXPECT_EQ(complaint(good), "none");
  EXPECT_EQ(complaint(Bytes(good.begin(), good.begin() + 20)),
            "byte 20, the header: the end of the input; 32 bytes would do");
  EXPECT_EQ(complaint(with(good, 0, 0x12345678)), "byte 0, the header: 0x12345678; \"mmdg\" would do");
  EXPECT_EQ(complaint(with(good, 12, 2)), "byte 140, the header: the end of the input; 148 bytes would do");
  EXPECT_EQ(complaint(with(good, 32, 0x030D)), "byte 32, record 0: level 13; 0 to 12 would do");
  EXPECT_EQ(complaint(with(good, 32, 0x0304 + (5 << 8))), "byte 33, record 0: kind 8; 0 to 4 would do");
  EXPECT_EQ(complaint(with(good, 32, 0x10304)), "byte 34, record 0: bits that are set; zeros would do");
  EXPECT_EQ(complaint(with(good, 36, 42)), "byte 36, a reference: word 21; one below 21 would do");
  EXPECT_EQ(complaint(with(good, 48, 0)), "byte 48, tile 0: 64 times one state; two states would do");
}

TEST(DagContainer, NodesHaveToBeTheBuilders) {
  const Bytes good = save(example());
  EXPECT_THAT(complaint(with(good, 56, 0x00020019)), HasSubstr("a child beyond the last"));
  EXPECT_THAT(complaint(with(good, 56, 0x00030009)), HasSubstr("a state of a child that is mixed"));
  EXPECT_THAT(complaint(with(good, 60, 0x00010000)), HasSubstr("tile 1; one below 1"));
  EXPECT_THAT(complaint(with(good, 56, 0)), HasSubstr("children of one state"));
  EXPECT_THAT(complaint(with(good, 44, 4)), HasSubstr("word 0; where a node of level 5 begins"));
  EXPECT_THAT(complaint(with(good, 76, 0)), HasSubstr("where a node of level 5 begins"));
}

// Four tiles and a node take more than the map of level 4 flat; once the tiles are there, the node alone takes less.
TEST(DagContainer, AFlatMapIsFlatAgainOnlyWhereItWouldBe) {
  const std::vector<std::uint64_t> tiles{1, 2, 4, 8};
  const auto scene = [&](bool tiles_between) {
    Dag dag(Format::two_state);
    dag.add(4, map_of(4, tiles));
    for (const std::uint64_t tile : tiles)
      if (tiles_between) dag.add(3, map_of(3, {tile}));
    return save(dag);
  };
  // The first record once more, behind the last.
  const auto again = [](Bytes bytes) {
    std::uint32_t maps = 0;
    std::memcpy(&maps, &bytes[8], sizeof maps);
    const Bytes first(bytes.begin() + 32, bytes.begin() + 40);
    bytes.insert(bytes.begin() + 32 + 8 * std::ptrdiff_t{maps}, first.begin(), first.end());
    return with(bytes, 8, maps + 1);
  };
  EXPECT_EQ(load(scene(false)).records()[0].kind, Kind::flat);
  EXPECT_EQ(complaint(again(scene(false))), "none");
  EXPECT_EQ(complaint(scene(true)), "none");
  EXPECT_EQ(complaint(again(scene(true))),
            "byte 73, record 5: a flat map whose tiles and nodes are there by now; a reference to its root "
            "would do");
}

// One node a level and 16 times the one below: ten words mean 16 million states, and none is laid out to see it.
TEST(DagContainer, TakesNoMoreMemoryThanItsBytes) {
  Bytes map = map_of(12, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  Dag dag(Format::two_state);
  dag.add(12, map);
  Bytes bytes = save(dag);
  EXPECT_LT(bytes.size(), 400u);
  mmverify::tests::largest_allocation = 0;
  load(bytes);
  EXPECT_LT(mmverify::tests::largest_allocation, 16u * 1024);
}

}  // namespace impl_dag_test
