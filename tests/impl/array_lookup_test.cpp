// [memory] impl/array/lookup.hpp: states at points and counts of references, as the specification reads the same array.
#include <gtest/gtest.h>

#include <random>

#include "impl/array/build.hpp"
#include "impl/array/lookup.hpp"
#include "spec/array/resolve.hpp"
#include "spec/index/index.hpp"
#include "spec/rational.hpp"
#include "tests/complaint.hpp"

namespace impl_array_lookup_test {

using namespace mmverify::impl::array;
namespace slow = mmverify::spec::array;
using mmverify::spec::Rational;

/// A build of random maps of levels 0 to 3, some of which are uniform or equal, behind two records.
Built random_build(std::mt19937& random, Encoding encoding, bool special) {
  std::vector<Bytes> bytes;
  std::vector<PackedMap> maps;
  for (int k = 0; k < 24; ++k) {
    const auto level = static_cast<Level>(random() % 4);
    const Format format = random() % 2 == 0 ? Format::two_state : Format::four_state;
    const std::uint64_t count = mmverify::impl::micromap::micro_triangles(level);
    std::vector<State> states(count);
    const unsigned kinds = random() % 3 == 0 ? 1 : format == Format::two_state ? 2 : 4;
    for (State& s : states) s = static_cast<State>(random() % kinds);
    Bytes& to = bytes.emplace_back(mmverify::impl::micromap::packed_bytes(count, format));
    mmverify::impl::micromap::pack(states, format, to);
    maps.push_back({level, format, {}});
  }
  for (std::size_t k = 0; k < maps.size(); ++k) maps[k].bytes = bytes[k];
  return build(std::span(maps).first(2), maps,
               {.encoding = encoding, .base = static_cast<std::uint32_t>(random() % 3), .special = special});
}

slow::Bundle as_specified(const Built& built) {
  slow::Bundle b;
  for (const auto& r : built.array.records) b.array.records.push_back({r.offset, r.level, r.format});
  b.array.data = built.array.data;
  b.parts.push_back({static_cast<slow::Encoding>(built.part.encoding), built.part.base, built.part.indices});
  return b;
}

/// The state by the specification: the target's, or that of its map at the index of the rational point (u, v)/32.
State specified(const slow::Bundle& b, std::uint64_t t, int u, int v) {
  const slow::Target to = slow::target(b, b.parts[0], t);
  if (to.kind == slow::Target::Kind::special) return static_cast<State>(to.state);
  const slow::Map map = slow::map_of(b.array, to.record);
  const mmverify::spec::Point<Rational> p{Rational(u, 32), Rational(v, 32)};
  return static_cast<State>(map.states[mmverify::spec::index::reference(p, map.level)]);
}

TEST(ArrayLookup, StatesAtPointsAreTheSpecifications) {
  std::mt19937 random(5);
  for (const Encoding e : {Encoding::u8, Encoding::u16, Encoding::u32})
    for (const bool special : {true, false}) {
      const Built built = random_build(random, e, special);
      const slow::Bundle b = as_specified(built);
      // Multiples of 1/32 are floats; of level 3 they have interiors, edges and vertices.
      for (std::uint64_t t = 0; t < 24; ++t)
        for (int u = 0; u <= 32; ++u)
          for (int v = 0; u + v <= 32; ++v)
            ASSERT_EQ(
                state_at(built.array, built.part, t, static_cast<float>(u) / 32, static_cast<float>(v) / 32),
                specified(b, t, u, v))
                << t << ' ' << u << ' ' << v;
      EXPECT_EQ(state_at(built.array, built.part, 24, 0, 0), std::nullopt);
    }
}

TEST(ArrayLookup, CountsAreTheSpecificationsAndTheBuilds) {
  std::mt19937 random(6);
  for (int round = 0; round < 50; ++round) {
    const Built built = random_build(random, Encoding::u16, round % 2 == 0);
    const slow::Bundle b = as_specified(built);
    std::vector<UsageCount> right;
    for (const auto& [key, count] : slow::geometry_histogram(b.array, b.parts[0]))
      right.push_back({static_cast<std::uint32_t>(count), key.first, static_cast<std::uint32_t>(key.second)});
    EXPECT_EQ(geometry_counts(built.array.records, built.part), right);
  }
}

TEST(ArrayLookup, NoRecordHasNoState) {
  // Records of level 0: one beyond the data, one of level 13, one of format 3; the code 3 names none.
  mmverify::impl::micromap::Array array{{{1, 0, 2}, {0, 13, 2}, {0, 0, 3}}, {0x01}};
  const Part part{Encoding::u8, 0, {0, 1, 2, 3, 0xfc}};
  for (std::uint64_t t = 0; t < 4; ++t) EXPECT_EQ(state_at(array, part, t, 0, 0), std::nullopt) << t;
  EXPECT_EQ(state_at(array, part, 4, 0, 0), State::UO);
  array.records[0].offset = 0;
  EXPECT_EQ(state_at(array, part, 0, 0, 0), State::O);
  EXPECT_EQ(
      mmverify::tests::complaint_of<std::invalid_argument>([&] { geometry_counts(array.records, part); }),
      "array::geometry_counts: triangle 3: no record 3");
}

}  // namespace impl_array_lookup_test
