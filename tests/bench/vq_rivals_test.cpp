// [release alone] bench/vq/rivals: trees and brushes give maps back, or C; by hand, against every pruning, and on real shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "bench/vq/rivals/brushes.hpp"
#include "bench/vq/rivals/painter.hpp"
#include "bench/vq/rivals/quad_tree.hpp"
#include "bench/vq/rivals/rivals.hpp"
#include "bench/vq/rivals/wavelet.hpp"
#include "spec/vq/vq.hpp"
#include "tests/vq_cases.hpp"

namespace bench_vq_rivals_test {

using namespace mmverify::bench;
using namespace mmverify::bench::rivals;
namespace spec = mmverify::spec::vq;
using mmverify::tests::blob;
using mmverify::tests::noise;
using Map = std::vector<State>;
using mmverify::impl::vq::Map2;
using mmverify::impl::vq::Map4;

constexpr std::uint32_t enough = 1 << 14;

/// The map that a string of T, C and O spells, rows from the bottom; spaces are for the reader.
Map map_of(const std::string& states) {
  Map map;
  for (const char s : states)
    if (s != ' ') map.push_back(s == 'T' ? State::T : s == 'C' ? State::C : State::O);
  return map;
}

TEST(BenchVqRivals, BitsAreCounted) {
  std::mt19937 random(1);
  Bits bits;
  std::vector<std::uint32_t> each;
  for (int k = 0; k < 200; ++k) each.push_back(static_cast<std::uint32_t>(random() % 3 == 0));
  for (const std::uint32_t bit : each) bits.put(bit, 1);
  EXPECT_EQ(bits.size, 200u);
  for (std::uint32_t first = 0; first < 200; ++first)
    for (std::uint32_t count = 0; first + count <= 200; ++count) {
      const auto begin = each.begin() + first;
      ASSERT_EQ(ones(bits.words, first, count), std::count(begin, begin + count, 1u))
          << first << ' ' << count;
      if (first % 2 != 0 || count % 2 != 0) continue;
      std::uint32_t pairs = 0;
      for (std::uint32_t k = first; k < first + count; k += 2) pairs += each[k] & each[k + 1];
      ASSERT_EQ(threes(bits.words, first, count / 2), pairs) << first << ' ' << count;
    }
  // Across the border of two words.
  Bits long_ones;
  for (std::uint32_t k = 0; k < 20; ++k) long_ones.put(0x15555 + k, 17);
  for (std::uint32_t k = 0; k < 20; ++k) EXPECT_EQ(field(long_ones.words, 17 * k, 17), 0x15555 + k);
}

// One C in the corner of 4x4 T, by the layouts in the headers.
TEST(BenchVqRivals, BlocksByHand) {
  const Map map = map_of("CTTT TTTT TTTT TTTT");
  // Root split; children split, T, T, T; the 2x2 has C at 0 and the palette of T.
  const Bits tree = QuadTree{.root = 4}.encode(map, enough);
  EXPECT_EQ(tree.size, 2u + 4 * 2 + 5);
  EXPECT_EQ(tree.words.at(0), 3u | 3u << 2 | 1u << 10);
  // C; it differs; T - C is 2 at three children; the first differs; T - C is 2 at three regions.
  const Bits wavelet = Wavelet{.root = 4}.encode(map, enough);
  EXPECT_EQ(wavelet.size, 2u + 1 + 5 + 4 + 4);
  EXPECT_EQ(wavelet.words.at(0), 1u | 1u << 2 | (2 + 3 * 2 + 9 * 2) << 3 | 1u << 8 | 15u << 12);

  // A bit less, and the 2x2 is C; no room for children, and the root is.
  const auto lost = [&](const Map& out) { return std::count(out.begin(), out.end(), State::C) - 1; };
  EXPECT_EQ(lost(pruned(map, 4, QuadTree::cost, 15)), 0);
  EXPECT_EQ(lost(pruned(map, 4, QuadTree::cost, 14)), 3);
  EXPECT_EQ(lost(pruned(map, 4, QuadTree::cost, 10)), 3);
  EXPECT_EQ(lost(pruned(map, 4, QuadTree::cost, 9)), 15);
  EXPECT_EQ(lost(pruned(map, 4, QuadTree::cost, 2)), 15);
  EXPECT_THROW(pruned(map, 4, QuadTree::cost, 1), std::invalid_argument);
  EXPECT_EQ(lost(pruned(map, 4, Wavelet::cost, 16)), 0);
  EXPECT_EQ(lost(pruned(map, 4, Wavelet::cost, 15)), 3);
  EXPECT_EQ(lost(pruned(map, 4, Wavelet::cost, 11)), 15);
}

TEST(BenchVqRivals, OBesideTKeepsTheHeavier) {
  EXPECT_EQ(without_o_beside_t(map_of("OOOT")), map_of("OOOC"));
  EXPECT_EQ(without_o_beside_t(map_of("OTCC")), map_of("OCCC"));
  EXPECT_EQ(without_o_beside_t(map_of("OOTC"), {.t = 3, .o = 1}), map_of("CCTC"));
  EXPECT_EQ(without_o_beside_t(map_of("OCCO")), map_of("OCCO"));
}

template <class Tree>
void expect_whole(const Tree& tree, std::uint32_t side, const Map& map) {
  const Bits bits = tree.encode(map, enough);
  ASSERT_EQ(bits.size, tree_bits(map, tree.root, Tree::cost));
  ASSERT_EQ(tree.decode(bits.words, side), map);
  for (std::uint32_t k = 0; k < map.size(); ++k)
    ASSERT_EQ(tree.region(bits.words, side, k % side, k / side), map[k]) << k;
}

// Each of the 31 vectors of figure 4 in two places of 4x4, beside each other one.
TEST(BenchVqRivals, TreesGiveEveryPairOfVectorsBack) {
  for (std::uint32_t one = 0; one < 32; ++one)
    for (std::uint32_t other = 0; other < 32; ++other)
      for (const std::uint32_t place : {1u, 2u, 3u}) {
        Map map(16, State::T);
        const auto lay = [&](std::uint32_t code, std::uint32_t at) {
          const auto vector = spec::decode_mini(code);
          for (std::uint32_t k = 0; k < 4; ++k)
            map[at % 2 * 2 + k % 2 + 4 * (at / 2 * 2 + k / 2)] = static_cast<State>(vector[k]);
        };
        lay(one, 0);
        lay(other, place);
        for (const std::uint32_t root : {2u, 4u}) {
          expect_whole(QuadTree{.root = root}, 4, map);
          expect_whole(Wavelet{.root = root}, 4, map);
        }
      }
}

TEST(BenchVqRivals, TreesGiveLeavesBack) {
  for (const OpacityMaps& maps : leaf_opacity_maps(4, 1))
    for (const std::uint32_t root : {2u, 4u, 8u, 16u}) {
      expect_whole(QuadTree{.root = root}, 16, {maps.regions_16.begin(), maps.regions_16.end()});
      expect_whole(Wavelet{.root = root}, 16, {maps.regions_16.begin(), maps.regions_16.end()});
      expect_whole(QuadTree{.root = 2 * root}, 32, {maps.regions_32.begin(), maps.regions_32.end()});
      expect_whole(Wavelet{.root = 2 * root}, 32, {maps.regions_32.begin(), maps.regions_32.end()});
    }
}

/// One way to code a square: its bits beyond those of its node, and its loss.
struct Choice {
  std::uint32_t bits, loss;
};

std::vector<Choice> choices(const Map& map, std::uint32_t side, std::uint32_t x, std::uint32_t y,
                            std::uint32_t square, const TreeCost& cost, Weights weights) {
  std::uint32_t loss = 0;
  for (std::uint32_t k = 0; k < square * square; ++k)
    loss += weights.of(map[x + k % square + side * (y + k / square)]);
  if (uniform(map, side, x, y, square)) return {{0, 0}};
  if (square == 2) return {{0, loss}, {cost.last, 0}};
  std::vector<Choice> all{{cost.inner + 4 * cost.node, 0}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    std::vector<Choice> more;
    for (const Choice& before : all)
      for (const Choice& child :
           choices(map, side, x + k % 2 * square / 2, y + k / 2 * square / 2, square / 2, cost, weights))
        more.push_back({before.bits + child.bits, before.loss + child.loss});
    all = more;
  }
  all.push_back({0, loss});
  return all;
}

TEST(BenchVqRivals, NoPruningLosesLess) {
  std::mt19937 random(3);
  for (int round = 0; round < 6; ++round) {
    Map map(64);
    for (State& s : map) s = static_cast<State>(random() % 3);
    // Some uniform squares, so that trees have unequal depths.
    for (std::uint32_t k = 0; k < 64; ++k)
      if (round % 2 == 0 && k % 8 < 4 && k / 8 < 4) map[k] = State::O;
    const Weights weights = round < 2 ? Weights{} : Weights{.t = 1, .o = 5};
    map = without_o_beside_t(map, weights);
    for (const TreeCost& cost : {QuadTree::cost, Wavelet::cost}) {
      std::vector<Choice> every = choices(map, 8, 0, 0, 8, cost, weights);
      for (Choice& c : every) c.bits += cost.root + cost.node;
      for (std::uint32_t budget = 3; budget < 160; budget += 7) {
        std::uint32_t least = std::numeric_limits<std::uint32_t>::max(), loss = 0;
        for (const Choice& c : every)
          if (c.bits <= budget) least = std::min(least, c.loss);
        const Map out = pruned(map, 8, cost, budget, weights);
        for (std::size_t k = 0; k < 64; ++k) {
          ASSERT_TRUE(out[k] == map[k] || out[k] == State::C);
          loss += out[k] == map[k] ? 0 : weights.of(map[k]);
        }
        EXPECT_EQ(loss, least) << budget;
        EXPECT_LE(tree_bits(out, 8, cost), budget);
      }
    }
  }
}

template <class AnyMap, class Codec>
void expect_conservative(const Codec& codec, const AnyMap& map) {
  constexpr std::uint32_t side = mmverify::tests::side_of<AnyMap>, budget = side * 16;
  Bits bits = codec.encode(map, budget);
  ASSERT_LE(bits.size, budget);
  bits.words.resize(budget / 64);
  const Map out = codec.decode(bits.words, side);
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    ASSERT_TRUE(out[k] == map[k] || out[k] == State::C) << k;
    ASSERT_EQ(codec.region(bits.words, side, k % side, k / side), out[k]) << k;
  }
}

template <class AnyMap>
void expect_trees_conservative(const AnyMap& map) {
  constexpr std::uint32_t side = mmverify::tests::side_of<AnyMap>;
  for (const std::uint32_t root : {4u, side}) {
    expect_conservative(QuadTree{.root = root}, map);
    expect_conservative(QuadTree{.root = root, .weights = {.t = 5, .o = 1}}, map);
    expect_conservative(Wavelet{.root = root}, map);
  }
}

template <class AnyMap>
void expect_all_conservative(const AnyMap& map) {
  expect_trees_conservative(map);
  expect_conservative(Brushes{.mutations = 300}, map);
}

TEST(BenchVqRivals, NeverTurnAKnownStateIntoTheOther) {
  std::mt19937 random(5);
  expect_all_conservative(blob<Map2>(random, 0));
  expect_all_conservative(blob<Map2>(random, 1));
  expect_all_conservative(blob<Map4>(random, 1));
  expect_all_conservative(noise<Map2>(random));
  expect_trees_conservative(noise<Map4>(random));
  for (const State s : {State::T, State::C, State::O}) {
    Map2 map;
    map.fill(s);
    expect_all_conservative(map);
  }
}

TEST(BenchVqRivals, AnOThatComesFirstIsLostLast) {
  std::mt19937 random(7);
  const auto lost = [](const Map4& map, Weights weights, State of) {
    const QuadTree tree{.root = 4, .weights = weights};
    const Map out = tree.decode(tree.encode(map, 300).words, 32);
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < map.size(); ++k) count += map[k] == of && out[k] != of ? 1 : 0;
    return count;
  };
  std::uint32_t even_o = 0, first_o = 0;
  for (int k = 0; k < 5; ++k) {
    const Map4 map = blob<Map4>(random, 0.5);
    const std::uint32_t even = lost(map, {}, State::O), first = lost(map, {.t = 1, .o = 1025}, State::O);
    EXPECT_LE(first, even);
    EXPECT_GE(first + lost(map, {.t = 1, .o = 1025}, State::T), even + lost(map, {}, State::T));
    even_o += even;
    first_o += first;
  }
  EXPECT_LT(first_o, even_o);
}

// ---- Brushes

std::uint32_t area(const Brush& brush) {
  std::uint32_t count = 0;
  for (std::int32_t y = -40; y <= 40; ++y)
    for (std::int32_t x = -40; x <= 40; ++x) count += covers(brush, x, y) ? 1 : 0;
  return count;
}

TEST(BenchVqRivals, BrushesHaveTheirShapes) {
  for (const BrushShape shape :
       {BrushShape::square, BrushShape::disc, BrushShape::half_bar, BrushShape::quarter_bar})
    for (std::uint32_t direction = 0; direction < 8; ++direction)
      EXPECT_EQ(area({.shape = shape, .direction = direction}), 1u) << "a point";
  EXPECT_EQ(area({.shape = BrushShape::square, .size = 1}), 9u);
  EXPECT_EQ(area({.shape = BrushShape::square, .direction = 2, .size = 1}), 5u)
      << "|dx + dy|, |dx - dy| <= 1";
  EXPECT_EQ(area({.shape = BrushShape::disc, .size = 1}), 9u) << "dx^2 + dy^2 <= 2";
  EXPECT_EQ(area({.shape = BrushShape::disc, .size = 2}), 21u) << "<= 6: 5x5 without corners";
  EXPECT_EQ(area({.shape = BrushShape::half_bar, .size = 2}), 15u) << "5 by 3";
  EXPECT_EQ(area({.shape = BrushShape::quarter_bar, .size = 4}), 27u) << "9 by 3";
  EXPECT_TRUE(covers({.shape = BrushShape::quarter_bar, .direction = 4, .size = 4, .x = 5, .y = 5}, 6, 9));
  EXPECT_FALSE(covers({.shape = BrushShape::quarter_bar, .direction = 4, .size = 4, .x = 5, .y = 5}, 9, 6));
  EXPECT_TRUE(covers({.shape = BrushShape::quarter_bar, .direction = 1, .size = 4, .x = 5, .y = 5}, 7, 6));
  EXPECT_FALSE(covers({.shape = BrushShape::quarter_bar, .direction = 1, .size = 4, .x = 5, .y = 5}, 3, 6));
  EXPECT_EQ(Brushes::most(16, 256), 13u);
  EXPECT_EQ(Brushes::most(32, 512), 23u);
}

// 6.1's example: a square of O on a larger one of C; here on T below, to see the ring.
TEST(BenchVqRivals, TheTopBrushWins) {
  const Brush brushes[] = {{.size = 2, .x = 8, .y = 6, .colour = State::O},
                           {.size = 3, .x = 8, .y = 6, .colour = State::C},
                           {.size = 15, .x = 8, .y = 8, .colour = State::T}};
  Bits bits;
  for (const Brush& b : brushes) {
    bits.put(static_cast<std::uint32_t>(b.shape) | b.direction << 2, 5);
    bits.put(b.size | b.x << 4 | b.y << 8, 12);
    bits.put(static_cast<std::uint32_t>(b.colour), 2);
  }
  while (bits.size < 256) bits.put(1, 1);  // colour 3: none
  const Map map = Brushes{}.decode(bits.words, 16);
  for (std::uint32_t y = 0; y < 16; ++y)
    for (std::uint32_t x = 0; x < 16; ++x) {
      const bool o = x >= 6 && x <= 10 && y >= 4 && y <= 8, ring = x >= 5 && x <= 11 && y >= 3 && y <= 9;
      EXPECT_EQ(map[x + 16 * y], o ? State::O : ring ? State::C : State::T) << x << ' ' << y;
    }
  // And the encoder finds such a painting.
  const Bits again = Brushes{}.encode(map, 256);
  EXPECT_EQ(Brushes{}.decode(again.words, 16), map);
}

TEST(BenchVqRivals, MutationsKeepNoLess) {
  std::mt19937 random(11);
  for (int k = 0; k < 3; ++k) {
    const Map2 map = blob<Map2>(random, 0.7);
    const Painter painter(map, 16);
    const auto greedy = painter.greedy(13), mutated = painter.mutated(greedy, 13, 5000, 1);
    EXPECT_GE(painter.kept(mutated), painter.kept(greedy));
    EXPECT_EQ(mutated.size(), 13u);
    // From bare ground they find something, too.
    EXPECT_GT(painter.kept(painter.mutated({}, 13, 5000, 1)), 0);
  }
  Map2 map;
  map.fill(State::T);
  EXPECT_EQ(Painter(map, 16).kept({{.size = 15, .x = 8, .y = 8, .colour = State::O}}), -1);
}

TEST(BenchVqRivals, RefuseWhatIsNoMap) {
  EXPECT_THROW(QuadTree{}.encode(Map(15), 256), std::invalid_argument);
  EXPECT_THROW(QuadTree{.root = 8}.encode(Map(16), 256), std::invalid_argument);
  EXPECT_THROW(Wavelet{.root = 3}.encode(Map(256), 256), std::invalid_argument);
  EXPECT_THROW(Wavelet{.root = 4}.encode(Map(256), 16 * 3 - 1), std::invalid_argument);
  EXPECT_THROW(Brushes{}.encode(Map(64), 256), std::invalid_argument);
  EXPECT_THROW(Brushes{}.encode(Map(256), 18), std::invalid_argument);
}

// ---- Three states read as two

TEST(BenchVqRivals, ReadingsOfC) {
  const Map map = map_of("OCTC OOCT CTOO CCOC");
  EXPECT_EQ(opaque_eighths(map, 4, 1, 0), 7u) << "O, C, O, O";
  EXPECT_EQ(opaque_eighths(map, 4, 3, 0), 2u) << "T, C, C, T";
  EXPECT_EQ(opaque_eighths(map, 4, 0, 3), 3u) << "C, T, C, C";
  std::mt19937 random(13);
  std::array<std::array<std::uint32_t, 16>, all_readings.size()> seen{};
  std::array<std::uint32_t, 16> hits{};
  for (int k = 0; k < 160000; ++k) {
    const float u = static_cast<float>(random() >> 8) / 16777216,
                v = static_cast<float>(random() >> 8) / 16777216;
    const auto at = static_cast<std::uint32_t>(u * 4) + 4 * static_cast<std::uint32_t>(v * 4);
    ++hits[at];
    for (std::size_t r = 0; r < all_readings.size(); ++r)
      seen[r][at] += opaque(map, 4, u, v, all_readings[r]) ? 1 : 0;
  }
  // 10,000 hits a region: five standard deviations are 2.5 % at most.
  const auto share = [&](std::size_t r, std::uint32_t at) {
    return static_cast<double>(seen[r][at]) / static_cast<double>(hits[at]);
  };
  for (std::uint32_t at = 0; at < 16; ++at) {
    if (map[at] == State::C) continue;
    for (std::size_t r = 0; r < all_readings.size(); ++r)
      EXPECT_EQ(share(r, at), map[at] == State::O ? 1 : 0) << r << ' ' << at;
  }
  const double of_vector[] = {7 / 8., 2 / 8., 3 / 8., 7 / 8.};
  for (const std::uint32_t at : {1u, 3u, 6u, 8u, 12u, 13u, 15u}) {
    const std::uint32_t vector = at % 4 / 2 + 2 * (at / 8);
    EXPECT_EQ(share(0, at), 0);
    EXPECT_EQ(share(1, at), 1);
    EXPECT_EQ(share(2, at), of_vector[vector] > 0.5 ? 1 : 0) << at;
    EXPECT_NEAR(share(3, at), 0.5, 0.025) << at;
    EXPECT_NEAR(share(4, at), of_vector[vector], 0.025) << at;
  }
}

TEST(BenchVqRivals, HitsAgreeWithTheMaps) {
  for (const OpacityMaps& maps : leaf_opacity_maps(3, 1)) {
    ASSERT_EQ(maps.hits.size(), 4096u);
    std::uint32_t known = 0;
    for (const SampledHit& hit : maps.hits) {
      const State s = maps.regions_32[static_cast<std::uint32_t>(hit.u * 32) +
                                      32 * static_cast<std::uint32_t>(hit.v * 32)];
      if (s == State::C) continue;
      ++known;
      ASSERT_EQ(hit.opaque, s == State::O) << maps.of << ' ' << hit.u << ' ' << hit.v;
    }
    EXPECT_GT(known, 1000u);
  }
}

TEST(BenchVqRivals, FiguresAreThoseOfTheCodecs) {
  const auto maps = leaf_opacity_maps(2, 1);
  const Figures all = figures(maps, 1, 1, [](const std::string&) {});
  ASSERT_EQ(all.codecs.size(), 14u);
  ASSERT_EQ(all.read.size(), 14u);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto* codecs = &all.codecs[7 * side];
    for (std::size_t k = 0; k < 7; ++k) {
      EXPECT_EQ(codecs[k].states, codecs[0].states);
      EXPECT_EQ(codecs[k].bits, side == 0 ? 256u : 512u);
      EXPECT_GT(codecs[k].region_ns, 0);
      ASSERT_EQ(codecs[k].lost.size(), 2u);
      EXPECT_EQ(codecs[k].lost[0] + codecs[k].lost[1], codecs[k].substitutions);
      EXPECT_EQ(codecs[k].lossless_bits.has_value(), k >= 1 && k <= 4);
    }
    EXPECT_LE(codecs[6].substitutions, codecs[5].substitutions) << "mutations keep no less";
    const auto* read = &all.read[7 * side];
    EXPECT_EQ(read[0].lost_t + read[0].lost_o, 0u);
    EXPECT_EQ(read[1].lost_t + read[1].lost_o, codecs[0].substitutions);
    EXPECT_EQ(read[4].lost_t + read[4].lost_o, codecs[1].substitutions);
    EXPECT_LE(read[2].lost_o, read[1].lost_o) << "O alone";
    EXPECT_LE(read[3].lost_t, read[1].lost_t) << "T alone";
    for (std::size_t k = 0; k < 7; ++k) {
      // Hits on C are wrong as T or as O, each by one of the two; others never.
      EXPECT_NEAR(read[k].by[0].wrong + read[k].by[1].wrong, read[k].checked, 1e-12);
      EXPECT_LE(read[k].by[2].wrong, read[k].checked);
    }
  }
  std::uint32_t fit = 0;
  for (const OpacityMaps& m : maps) fit += tree_bits(m.regions_16, 4, QuadTree::cost) <= 256 ? 1 : 0;
  EXPECT_EQ(all.codecs[1].whole, fit);
}

}  // namespace bench_vq_rivals_test
