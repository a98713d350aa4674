// impl/vq/vq.hpp, encoders of VQ4: what they may do, what they must find, and the bound below them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <vector>

#include "impl/vq/four/bound.hpp"
#include "impl/vq/four/search.hpp"
#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"
#include "tests/vq_cases.hpp"

namespace impl_vq4_encode_test {

namespace spec = mmverify::spec::vq;
using namespace mmverify::impl::vq;
using namespace mmverify::tests;

constexpr Effort efforts[] = {Effort::fast, Effort::balanced, Effort::thorough};

TEST(ImplVq4Encode, UniformMapsAreKept) {
  for (const State s : {State::T, State::C, State::O}) {
    Map4 map;
    map.fill(s);
    for (const Effort effort : efforts) {
      EXPECT_EQ(encode(map, effort).substitutions, 0u);
      EXPECT_EQ(decode(encode(map, effort).block), map);
    }
    EXPECT_EQ(decode(encode_paper(map).block), map);
    EXPECT_EQ(encode_proved(map).least, 0u);
  }
}

TEST(ImplVq4Encode, WhatIsLostIsLostOnce) {
  std::mt19937 random(4);
  for (int round = 0; round < (sanitized ? 4 : 20); ++round) {
    const Map4 out = decode(encode(noise<Map4>(random), Effort::fast).block);
    ASSERT_EQ(encode(out, Effort::fast).substitutions, 0u);
  }
}

/// C everywhere but for these 4x4 vectors, region 0 lowest.
Map4 with_vectors(const std::vector<std::pair<std::uint32_t, spec::Vector<4>>>& vectors) {
  Map4 map;
  map.fill(State::C);
  for (const auto& [vector, states] : vectors)
    for (std::uint32_t k = 0; k < 16; ++k)
      map[4 * (vector % 8) + k % 4 + 32 * (4 * (vector / 8) + k / 4)] = static_cast<State>(states[k]);
  return map;
}

// Nine vectors that only a generic code writes, all in TL, where nothing is turned; there are eight such
// codes.  Each has O in one mini and T in the one beside it and above: no half has one palette.  The ninth
// must give up something: of its three minis the smallest set that leaves a simple, vertical or horizontal
// one.
TEST(ImplVq4Encode, NineGenericVectorsAreOneTooMany) {
  std::vector<std::pair<std::uint32_t, spec::Vector<4>>> vectors;
  for (std::uint32_t k = 0; k < 9; ++k) {
    spec::Vector<4> v = spec::uniform<4>(spec::State::C);
    v[0] = spec::State::O;   // mini 0
    v[3] = spec::State::T;   // mini 1
    v[12] = spec::State::T;  // mini 2
    // Which of the regions 5, 10, 11, 14 are O tells the nine apart: mini 0 again, or mini 3.
    const std::uint32_t others[] = {5, 10, 11, 14};
    for (std::uint32_t bit = 0; bit < 4; ++bit)
      if ((k + 3) >> bit & 1) v[others[bit]] = spec::State::O;
    vectors.push_back({32 + k % 4 + 8 * (k / 4), v});
  }
  const Map4 eight = with_vectors({vectors.begin(), vectors.end() - 1}), nine = with_vectors(vectors);
  EXPECT_EQ(encode(eight, Effort::fast).substitutions, 0u);
  for (const Effort effort : efforts) EXPECT_EQ(encode(nine, effort).substitutions, 1u);
  EXPECT_EQ(encode_proved(nine).encoded.substitutions, 1u);
}

/// The regions that some vectors keep at most with 13 entries, T alone and nothing turned, by trying every
/// way to make groups of them: in each step two groups become one, or a group becomes C.
std::uint32_t most_kept_by_groups(std::vector<std::pair<std::uint32_t, std::uint32_t>> groups) {
  const auto ones = [](std::uint32_t set) {
    std::uint32_t count = 0;
    for (; set != 0; set &= set - 1) ++count;
    return count;
  };
  std::uint32_t most = 0;
  if (groups.size() == 13) {
    for (const auto& [common, vectors] : groups) most += vectors * ones(common);
    return most;
  }
  for (std::size_t a = 0; a < groups.size(); ++a)
    for (std::size_t b = a; b < groups.size(); ++b) {
      auto next = groups;
      if (b != a) next[a] = {groups[a].first & groups[b].first, groups[a].second + groups[b].second};
      next.erase(next.begin() + static_cast<std::ptrdiff_t>(b));
      most = std::max(most, most_kept_by_groups(std::move(next)));
    }
  return most;
}

TEST(ImplVq4Encode, FindsAndProvesTheOptimumOfOneQuadrant) {
  std::mt19937 random(6);
  for (int round = 0; round < (sanitized ? 2 : 8); ++round) {
    std::vector<std::pair<std::uint32_t, spec::Vector<4>>> vectors;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> groups;
    std::uint32_t all = 0;
    for (std::uint32_t k = 0; k < 15; ++k) {
      auto set = static_cast<std::uint32_t>(random() & random()) & 0xffff;
      if (round % 2 == 0) set |= static_cast<std::uint32_t>(random()) & 0xffff;
      if (set == 0 || set == 0xffff) set = 1;
      spec::Vector<4> v = spec::uniform<4>(spec::State::C);
      for (std::uint32_t bit = 0; bit < 16; ++bit)
        if (set >> bit & 1) {
          v[bit] = spec::State::T;
          ++all;
        }
      vectors.push_back({32 + k % 4 + 8 * (k / 4), v});
      groups.push_back({set, 1});
    }
    const Proved4 proved = encode_proved(with_vectors(vectors));
    EXPECT_EQ(proved.encoded.substitutions, all - most_kept_by_groups(groups));
    EXPECT_EQ(proved.least, proved.encoded.substitutions);
  }
}

// The bound alone, without an encoder beside it: never below what every way of grouping shows can be kept,
// however little it may look, and mostly equal to it where it may look on.
TEST(ImplVq4Bound, IsNeverBelowTheBestGrouping) {
  std::mt19937 random(9);
  std::uint32_t met = 0;
  constexpr std::uint32_t rounds = 12;
  for (std::uint32_t round = 0; round < (sanitized ? 3 : rounds); ++round) {
    detail::Bounded4 sources;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> groups;
    for (std::uint32_t k = 0; k < 15; ++k) {
      auto set = static_cast<std::uint32_t>(random() & random());
      if (round % 2 == 0) set &= 0x0f0f0f0f;
      set &= ~(set << 16);  // not O and T at once
      if (set == 0) set = 1;
      sources.v[k] = set;
      sources.most[k] = std::popcount(set);
      sources.price[k] = static_cast<std::int32_t>(random() % 512);
      groups.push_back({set, 1});
    }
    const std::uint32_t most = most_kept_by_groups(groups);
    for (const std::uint32_t nodes : {0u, 1u, 5u, 20u, 300u, 200'000u}) {
      detail::Bounded4 now = sources;
      std::vector<detail::Set4> entries{sources.v[0], sources.v[1]};
      const std::uint32_t bound = detail::most_kept(now, entries, {.enough = 0, .nodes = nodes});
      ASSERT_GE(bound, most) << round << ' ' << nodes;
      met += nodes == 200'000 && bound == most ? 1 : 0;
    }
  }
  EXPECT_GE(met, sanitized ? 1 : rounds / 2);
}

TEST(ImplVq4Encode, ExchangingKeepsMoreThanMerging) {
  std::mt19937 random(10);
  std::uint32_t better = 0;
  for (int round = 0; round < 20; ++round) {
    detail::Sources4 sources;
    for (std::uint32_t k = 0; k < 40; ++k)
      sources.v[sources.count++] = 1 + static_cast<std::uint32_t>(random() & random()) % 0xfffe;
    detail::Codebook4 codebook = detail::merged(sources);
    const std::uint32_t before = codebook.kept;
    detail::exchange(sources, codebook);
    ASSERT_GE(codebook.kept, before);
    better += codebook.kept > before ? 1 : 0;
  }
  EXPECT_GT(better, 0u);
}

// It fits under one choice of transforms alone, with all thirteen entries, and after a hundred choices that
// leave as many distinct vectors: fast must not end before it.
TEST(ImplVq4Encode, FastFindsTheOneChoiceThatFits) {
  using detail::Set4;
  std::vector<Set4> in_tl;
  Set4 vertical = 0, turned = 0;
  for (std::uint32_t y = 0; y < 4; ++y) {
    vertical |= 1u << (4 * y) | 1u << (16 + 3 + 4 * y);
    turned |= 1u << (1 + 4 * y) | 1u << (16 + 2 + 4 * y);
  }
  turned &= ~(1u << 1);
  in_tl.push_back(vertical);
  for (std::uint32_t k = 0; k < 8; ++k) {  // generic codes, all eight
    Set4 set = 1u << 16 | 1u << 3 | 1u << 12;
    constexpr std::uint32_t others[] = {5, 10, 11, 14};
    for (std::uint32_t bit = 0; bit < 4; ++bit)
      if ((k + 3) >> bit & 1) set |= 1u << (16 + others[bit]);
    in_tl.push_back(set);
  }
  constexpr Set4 simple = 0b0000'0000'0001'0111;
  const auto as_stored = detail::stored(simple);
  for (const std::size_t t : {0u, 2u, 7u}) in_tl.push_back(as_stored[t]);
  Map4 map;
  map.fill(State::C);
  const auto put = [&](std::uint32_t x, std::uint32_t y, Set4 set) {
    for (std::uint32_t k = 0; k < 16; ++k)
      map[4 * x + k % 4 + 32 * (4 * y + k / 4)] = (set >> k & 1) != 0          ? State::T
                                                  : (set >> (16 + k) & 1) != 0 ? State::O
                                                                               : State::C;
  };
  for (std::uint32_t k = 0; k < in_tl.size(); ++k) put(k % 4, 4 + k / 4, in_tl[k]);
  put(4, 0, simple);
  put(5, 0, turned);
  for (const Effort effort : efforts) EXPECT_EQ(encode(map, effort).substitutions, 0u);
}

TEST(ImplVq4Encode, DiscontinuousVectorsAreTheOnesThatAreNotValid) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    Map4 map;
    map.fill(State::C);
    for (int k = 0; k < 60; ++k) map[random() % 1024] = static_cast<State>(random() % 3);
    std::uint32_t expected = 0;
    for (std::uint32_t vector = 0; vector < 64; ++vector) {
      spec::Vector<4> v{};
      for (std::uint32_t k = 0; k < 16; ++k)
        v[k] = static_cast<spec::State>(map[4 * (vector % 8) + k % 4 + 32 * (4 * (vector / 8) + k / 4)]);
      expected += spec::valid<4>(v) ? 0 : 1;
    }
    ASSERT_EQ(discontinuous_vectors(map), expected);
  }
}

TEST(ImplVq4Encode, CountsVectorsThatAreNotContinuous) {
  Map4 map;
  map.fill(State::T);
  EXPECT_EQ(discontinuous_vectors(map), 0u);
  map[0] = State::O;
  EXPECT_EQ(discontinuous_vectors(map), 1u);
  map[5 + 32 * 9] = State::O;
  EXPECT_EQ(discontinuous_vectors(map), 2u);
  map.fill(State::T);
  for (std::uint32_t y = 0; y < 32; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) map[x + 32 * y] = State::O;  // whole vectors, T in the next ones
  EXPECT_EQ(discontinuous_vectors(map), 0u);
  Map2 small;
  small.fill(State::O);
  small[17] = State::T;
  EXPECT_EQ(discontinuous_vectors(small), 1u);
}

}  // namespace impl_vq4_encode_test
