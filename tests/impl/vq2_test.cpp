// impl/vq/vq.hpp, VQ2: the decoders against the specification, the encoder against a solver of another kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"
#include "tests/sanitized.hpp"
#include "tests/vq_cases.hpp"

namespace impl_vq2_test {

namespace spec = mmverify::spec::vq;
using namespace mmverify::impl::vq;
using mmverify::tests::blob, mmverify::tests::noise, mmverify::tests::random_block,
    mmverify::tests::substitutions;
using SpecMap = spec::Map<spec::Vq2>;

SpecMap specified(const Block2& block) { return spec::decode(spec::from_bytes<spec::Vq2>(block)); }

TEST(ImplVq2, DecodesAsSpecified) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const Block2 block = random_block<Block2>(random);
    const SpecMap expected = specified(block);
    const Map2 map = decode(block);
    for (std::uint32_t k = 0; k < 256; ++k) {
      ASSERT_EQ(static_cast<int>(map[k]), static_cast<int>(expected[k])) << k;
      ASSERT_EQ(region(block, k % 16, k / 16), map[k]) << k;
      ASSERT_EQ(region(block, k % 16 + 16, k / 16 + 0xfffffff0), map[k]) << k;
    }
  }
}

// Every code, index, quadrant and transform, each region.
TEST(ImplVq2, DecodesEveryEntryUnderEveryTransform) {
  for (std::uint32_t t = 0; t < 8; ++t)
    for (std::uint8_t code = 0; code < 32; ++code)
      for (std::uint8_t index = 0; index < 8; ++index) {
        spec::Vq2 fields;
        fields.indices.fill(index);
        for (std::size_t q = 1; q < 4; ++q) fields.transforms[q] = spec::Transform::of(t);
        // Only the entry that the index names has the code.
        if (index >= 3 && index < 6) fields.shared[index - 3u] = code;
        if (index >= 6)
          for (auto& own : fields.own) own[index - 6u] = code;
        const Block2 block = spec::bytes(fields);
        const SpecMap expected = spec::decode(fields);
        const Map2 map = decode(block);
        for (std::uint32_t k = 0; k < 256; ++k) {
          ASSERT_EQ(static_cast<int>(map[k]), static_cast<int>(expected[k]));
          ASSERT_EQ(region(block, k % 16, k / 16), map[k]);
        }
      }
}

TEST(ImplVq2, IsConservativeCountsWhatItLosesAndLosesNothingTwice) {
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round) {
    const Map2 map = round % 3 == 0 ? noise<Map2>(random) : blob<Map2>(random, round % 3 == 1 ? 1 : 0.1);
    const Encoded2 encoded = encode_optimal(map);
    const Map2 out = decode(encoded.block);
    ASSERT_EQ(substitutions(map, out), encoded.substitutions);
    const Encoded2 again = encode_optimal(out);
    ASSERT_EQ(again.substitutions, 0u) << "a map that a block can hold";
    ASSERT_EQ(decode(again.block), out);
  }
}

TEST(ImplVq2, AlgorithmOneIsConservativeAndNeverBetter) {
  std::mt19937 random(5);
  for (int round = 0; round < (sanitized ? 6 : 30); ++round) {
    const Map2 map = round % 3 == 0 ? noise<Map2>(random) : blob<Map2>(random, round % 3 == 1 ? 1 : 0.1);
    const Encoded2 encoded = encode_paper(map);
    ASSERT_EQ(substitutions(map, decode(encoded.block)), encoded.substitutions);
    const Encoded2 highest = encode_paper_highest_first(map);
    ASSERT_EQ(substitutions(map, decode(highest.block)), highest.substitutions);
    const std::uint32_t least = encode_optimal(map).substitutions;
    ASSERT_GE(encoded.substitutions, least);
    ASSERT_GE(highest.substitutions, least);
  }
}

/// A map of C with some vectors, each 2x2, region 0 lowest.
Map2 with_vectors(const std::vector<std::pair<std::uint32_t, std::array<State, 4>>>& vectors) {
  Map2 map;
  map.fill(State::C);
  for (const auto& [vector, states] : vectors)
    for (std::uint32_t k = 0; k < 4; ++k)
      map[2 * (vector % 8) + k % 2 + 16 * (2 * (vector / 8) + k / 2)] = states[k];
  return map;
}

// By hand: with nothing to lose Algorithm 1 ends at the first transforms, all identity.  TL (X < 4, Y >= 4)
// has three vectors of its own: those with one C each score lowest and get its two entries, the third, with
// three, a shared one.
TEST(ImplVq2, AlgorithmOneByHand) {
  using enum State;
  const Map2 map = with_vectors({{32, {O, O, O, C}}, {33, {T, C, T, T}}, {34, {C, C, C, O}}});
  const Encoded2 encoded = encode_paper(map);
  EXPECT_EQ(encoded.substitutions, 0u);
  const auto fields = spec::from_bytes<spec::Vq2>(encoded.block);
  for (const auto& t : fields.transforms) EXPECT_EQ(t.number(), 0u);
  EXPECT_EQ(fields.indices[32], 6);  // the last of equal scores is taken first: O, whose number is higher
  EXPECT_EQ(fields.indices[33], 7);
  EXPECT_EQ(fields.indices[34], 3);
  EXPECT_EQ(fields.own[0][0], 16 + 8);  // 1000b: region 3 is C, of {O, C}
  EXPECT_EQ(fields.own[0][1], 2);
  EXPECT_EQ(fields.shared[0], 16 + 7);
}

TEST(ImplVq2, UniformMapsAndOnesThatFitAreKept) {
  for (const State s : {State::T, State::C, State::O}) {
    Map2 map;
    map.fill(s);
    EXPECT_EQ(encode_optimal(map).substitutions, 0u);
    EXPECT_EQ(decode(encode_optimal(map).block), map);
  }
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    const Map2 map = decode(random_block<Block2>(random));
    const Encoded2 encoded = encode_optimal(map);
    ASSERT_EQ(encoded.substitutions, 0u);
    ASSERT_EQ(decode(encoded.block), map);
  }
}

// The optimum from the definition, over the specification's vectors: for every choice of shared vectors, each
// quadrant takes its best transform and pair; a loss is counted region by region.  No sets, no bounds.
std::uint32_t least_substitutions(const Map2& map) {
  using Vector = spec::Vector<2>;
  const auto loss = [](const Vector& from, const Vector& to) {
    std::uint32_t lost = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (to[k] != spec::State::C && to[k] != from[k]) return 100u;
      lost += to[k] != from[k] ? 1u : 0u;
    }
    return lost;
  };
  std::vector<Vector> codebook;
  for (std::uint32_t code = 0; code < 32; ++code) codebook.push_back(spec::decode_mini(code));
  struct Quadrant {
    std::vector<std::vector<std::vector<std::uint32_t>>> losses;  // by transform, entry, vector
    std::vector<std::uint32_t> free;                              // a vector's loss with the uniform ones
  };
  std::array<Quadrant, 4> quadrants;
  std::set<std::uint32_t> used;
  for (std::uint32_t q = 0; q < 4; ++q)
    for (std::uint32_t t = 0; t < (q == 0 ? 1 : 8); ++t) {
      std::vector<std::vector<std::uint32_t>> by_entry(32);
      for (std::uint32_t k = 0; k < 64; ++k) {
        if (static_cast<std::uint32_t>(spec::quadrant_of(k % 8, k / 8)) != q) continue;
        Vector v{};
        for (std::uint32_t r = 0; r < 4; ++r)
          v[r] = static_cast<spec::State>(map[2 * (k % 8) + r % 2 + 16 * (2 * (k / 8) + r / 2)]);
        std::uint32_t free = 100;
        for (const spec::State s : {spec::State::T, spec::State::C, spec::State::O})
          free = std::min(free, loss(v, spec::uniform<2>(s)));
        if (t == 0) quadrants[q].free.push_back(free);
        for (std::uint32_t e = 0; e < 32; ++e) {
          by_entry[e].push_back(loss(v, spec::applied<2>(spec::Transform::of(t), codebook[e])));
          if (by_entry[e].back() < free) used.insert(e);
        }
      }
      quadrants[q].losses.push_back(by_entry);
    }
  if (used.empty()) used.insert(0);
  const std::vector<std::uint32_t> entries(used.begin(), used.end());
  std::uint32_t least = 10'000;
  for (std::size_t a = 0; a < entries.size(); ++a)
    for (std::size_t b = a; b < entries.size(); ++b)
      for (std::size_t c = b; c < entries.size(); ++c) {
        std::uint32_t sum = 0;
        for (const Quadrant& q : quadrants) {
          std::uint32_t of_quadrant = 10'000;
          for (const auto& losses : q.losses) {
            std::vector<std::uint32_t> with_shared = q.free;
            for (std::size_t k = 0; k < 16; ++k)
              with_shared[k] = std::min(
                  {with_shared[k], losses[entries[a]][k], losses[entries[b]][k], losses[entries[c]][k]});
            for (std::size_t d = 0; d < entries.size(); ++d)
              for (std::size_t e = d; e < entries.size(); ++e) {
                std::uint32_t lost = 0;
                for (std::size_t k = 0; k < 16; ++k)
                  lost += std::min({with_shared[k], losses[entries[d]][k], losses[entries[e]][k]});
                of_quadrant = std::min(of_quadrant, lost);
              }
          }
          sum += of_quadrant;
        }
        least = std::min(least, sum);
      }
  return least;
}

/// Few kinds of vectors, so that the plain solver is done soon: the map repeats a few, turned.
Map2 of_few_vectors(std::mt19937& random, std::uint32_t kinds) {
  std::vector<spec::Vector<2>> some(kinds);
  for (auto& v : some) v = spec::decode_mini(random() % 32);
  Map2 map;
  for (std::uint32_t k = 0; k < 64; ++k) {
    const auto& v = some[random() % kinds];
    for (std::uint32_t r = 0; r < 4; ++r)
      map[2 * (k % 8) + r % 2 + 16 * (2 * (k / 8) + r / 2)] = static_cast<State>(v[r]);
  }
  return map;
}

TEST(ImplVq2, IsTheOptimum) {
  std::mt19937 random(4);
  for (std::uint32_t round = 0; round < (sanitized ? 1u : 3u); ++round) {
    const Map2 map = of_few_vectors(random, 4 + round % 3);
    ASSERT_EQ(encode_optimal(map).substitutions, least_substitutions(map)) << round;
  }
}

}  // namespace impl_vq2_test
