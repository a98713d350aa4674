// [release alone] bench/papers: no figure, table, algorithm or equation of the papers is absent, and each item says where
// it is or why it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "bench/papers/drawings.hpp"
#include "bench/papers/item.hpp"
#include "bench/papers/pieces.hpp"
#include "bench/tree/cache.hpp"

namespace bench_papers_test {
namespace {

using namespace mmverify::bench;
using namespace mmverify::bench::papers;

/// The numbered things of a paper, as its text counts them.
struct Numbered {
  const char *paper, *kind;
  int count;
};
constexpr Numbered numbered[] = {{"som", "figure", 13},   {"som", "table", 3},   {"som", "algorithm", 4},
                                 {"som", "equation", 1},  {"com", "figure", 12}, {"com", "table", 2},
                                 {"com", "algorithm", 2}, {"cam", "figure", 11}, {"cam", "table", 3}};

std::set<std::string> ids_of(const Paper& paper) {
  std::set<std::string> ids;
  for (const Item& item : paper.items) ids.insert(item.id);
  return ids;
}

TEST(Papers, have_every_numbered_item) {
  for (const Numbered& of : numbered) {
    const auto paper = std::ranges::find(all(), of.paper, &Paper::id);
    ASSERT_NE(paper, all().end()) << of.paper;
    for (int number = 1; number <= of.count; ++number)
      EXPECT_TRUE(ids_of(*paper).contains(std::string(of.kind) + " " + std::to_string(number)))
          << of.paper << " " << of.kind << " " << number;
  }
}

TEST(Papers, name_an_item_once_and_say_where_it_is) {
  for (const Paper& paper : all()) {
    EXPECT_EQ(ids_of(paper).size(), paper.items.size()) << paper.id;
    for (const Item& item : paper.items) {
      const bool says_why =
          item.status == Status::ok ? !item.why.empty() || !item.show.empty() : !item.why.empty();
      EXPECT_TRUE(says_why) << paper.id << " " << item.id;
    }
  }
}

TEST(Papers, ratios_of_ranges_are_over_their_nearest_end) {
  const Number range{.theirs = {45, 15}}, single{.theirs = {4}};
  EXPECT_EQ(ratio(range, 15), 1);
  EXPECT_EQ(ratio(range, 20), 1);
  EXPECT_EQ(ratio(range, 90), 2);
  EXPECT_EQ(ratio(range, 3), 0.2);
  EXPECT_EQ(ratio(single, 6), 1.5);
}

TEST(Papers, bits_read_are_those_of_each_lookup) {
  constexpr unsigned level = 3;
  // One state that differs in the first and the last quarter, and T and O in turn in the second.
  mmverify::impl::micromap::Bytes map{0x10, 0, 0xaa, 0xaa, 0, 0, 0, 0x80};
  const auto tree =
      mmverify::impl::tree::encode_stream(level, mmverify::impl::micromap::Format::two_state, map);
  const std::vector<std::uint32_t> bits = bits_read_by_index(level, tree);
  ASSERT_EQ(bits.size(), 64u);
  for (std::uint32_t index = 0; index < 64; ++index)
    EXPECT_EQ(bits[index], stream_reads(level, tree, index).tree_bits) << index;
}

/// Five texels of 200 that touch by corners and edges, one alone, and a faint one that joins nothing.
AlphaTexture two_parts() {
  return {"parts", 5, 4, {200, 0,   0, 0, 0,    //
                          0,   200, 0, 0, 200,  //
                          200, 200, 0, 0, 127,  //
                          200, 0,   0, 0, 0}};
}

int sum(const AlphaTexture& texture) {
  return std::accumulate(texture.alpha.begin(), texture.alpha.end(), 0);
}

TEST(Papers, pieces_are_connected_by_eight_neighbours) {
  const std::vector<AlphaTexture> parts = pieces(two_parts(), 0);
  ASSERT_EQ(parts.size(), 2u);
  // The faint texel stays in both: an outline that fades belongs to every part.
  EXPECT_EQ(sum(parts[0]), 5 * 200 + 127);
  EXPECT_EQ(sum(parts[1]), 200 + 127);
  EXPECT_EQ(parts[0].alpha[9], 0);
  EXPECT_EQ(parts[1].alpha[9], 200);
}

TEST(Papers, pieces_below_the_share_are_left_out) {
  EXPECT_EQ(pieces(two_parts(), 1.0 / 6).size(), 2u);
  EXPECT_EQ(pieces(two_parts(), 0.17).size(), 1u);
  EXPECT_TRUE(pieces({"none", 1, 1, {127}}, 0).empty());
}

}  // namespace
}  // namespace bench_papers_test
