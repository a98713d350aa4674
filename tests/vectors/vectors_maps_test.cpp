// The vectors of corners, traversal, packing and special indices, held against the library and against what must hold
// whoever made them.
#include <cmath>
#include <map>

#include "impl/index/index.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "impl/traverse/decision.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_maps_test {

using namespace mmverify;
using tests::Reading;
namespace micromap = impl::micromap;

impl::index::Corners corners_of(const Reading& r, std::size_t k) {
  return {impl::index::Vertex{r(k, "i0"), r(k, "j0")}, {r(k, "i1"), r(k, "j1")}, {r(k, "i2"), r(k, "j2")}};
}

TEST(VectorsMaps, CornersAreTheLibrarysAndLeadBack) {
  const Reading curve(tests::family("corners"), "curve");
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const auto n = curve(k, "level"), index = curve(k, "index");
    const impl::index::Corners c = corners_of(curve, k);
    ASSERT_EQ(c, impl::index::corners(index, n)) << k;
    const float N = std::ldexp(1.0f, static_cast<int>(n));
    const auto mean = [N](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
      return static_cast<float>(a + b + d) / (3 * N);
    };
    if (n <= 12) {
      ASSERT_EQ(index,
                impl::index::from_barycentrics(mean(c[0].i, c[1].i, c[2].i), mean(c[0].j, c[1].j, c[2].j), n))
          << k;
    }
  }
  const Reading rows(tests::family("corners"), "rows");
  for (std::size_t k = 0; k < rows.size(); ++k)
    ASSERT_EQ(corners_of(rows, k), impl::index::w_minor_corners(rows(k, "index"))) << k;
}

TEST(VectorsMaps, DecisionsAreTheLibrarys) {
  const Reading decisions(tests::family("traverse"), "decisions");
  std::map<std::uint32_t, std::size_t> outcomes;
  for (std::size_t k = 0; k < decisions.size(); ++k) {
    const auto candidate = decisions(k, "candidate"), instance = decisions(k, "instance"),
               ray = decisions(k, "ray");
    ASSERT_EQ(impl::traverse::undefined(true, candidate, instance, ray), 0u);
    ASSERT_EQ(decisions(k, "outcome"),
              static_cast<std::uint32_t>(impl::traverse::decide(candidate, instance, ray)))
        << k;
    ++outcomes[decisions(k, "outcome")];
  }
  // 10 candidates, 12 sets of flags of an instance, 10 of a ray.
  EXPECT_EQ(decisions.size(), 1200u);
  EXPECT_EQ(outcomes.size(), 3u);
  const Reading undefined(tests::family("traverse"), "undefined");
  std::size_t defined = 0;
  for (std::size_t k = 0; k < undefined.size(); ++k) {
    EXPECT_EQ(undefined.wide(k, "why"),
              impl::traverse::undefined(undefined(k, "enabled") != 0, undefined(k, "candidate"),
                                        undefined(k, "instance"), undefined(k, "ray")))
        << k;
    defined += undefined.wide(k, "why") == 0 ? 1 : 0;
  }
  EXPECT_GT(defined, 0u);
  EXPECT_LT(defined, undefined.size() / 2);
}

TEST(VectorsMaps, StatesAndChangesAreTheLibrarys) {
  const Reading states(tests::family("traverse"), "states");
  ASSERT_EQ(states.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(states(k, "forced"), static_cast<std::uint32_t>(micromap::force2(micromap::State(k))));
    EXPECT_EQ(states(k, "unknown"), k >= 2 ? 1u : 0u);
    EXPECT_EQ(states(k, "as_unknown"), 2 + k % 2);
  }
  const Reading changes(tests::family("traverse"), "changes");
  ASSERT_EQ(changes.size(), 16u);
  for (std::size_t k = 0; k < 16; ++k) {
    micromap::Substitutions one;
    one.count[changes(k, "was")][changes(k, "is")] = 1;
    EXPECT_EQ(changes(k, "lossy"), one.allowed() ? 1u : 0u);
    EXPECT_EQ(changes(k, "conservative"), one.conservative() ? 1u : 0u);
    EXPECT_EQ(changes(k, "stable"), one.force2_stable() ? 1u : 0u);
  }
  const Reading down(tests::family("traverse"), "down");
  ASSERT_EQ(down.size(), 256u);
  for (std::size_t k = 0; k < 256; ++k) {
    const vectors::Bytes children = down.part(k, "children");
    std::uint8_t packed = 0, parent = 0;
    for (unsigned c = 0; c < 4; ++c) packed = static_cast<std::uint8_t>(packed | children[c] << 2 * c);
    micromap::down({&packed, 1}, micromap::Format::four_state, 1, {&parent, 1});
    EXPECT_EQ(down(k, "parent"), parent);
  }
}

std::vector<micromap::State> states_of(const vectors::Bytes& codes) {
  std::vector<micromap::State> states;
  for (const std::uint8_t code : codes) states.push_back(micromap::State(code));
  return states;
}

TEST(VectorsMaps, PackedMapsAreTheLibrarys) {
  const Reading maps(tests::family("packing"), "maps");
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const auto states = states_of(maps.part(k, "states"));
    const auto f = micromap::Format(maps(k, "format"));
    const vectors::Bytes bytes = maps.part(k, "bytes");
    ASSERT_EQ(states.size(), std::size_t{1} << 2 * maps(k, "level"));
    vectors::Bytes packed(micromap::packed_bytes(states.size(), f));
    micromap::pack(states, f, packed);
    EXPECT_EQ(packed, bytes) << k << ' ' << maps.about(k);
    std::vector<micromap::State> read(states.size());
    micromap::unpack(bytes, f, read);
    EXPECT_EQ(read, states);
    if (f == micromap::Format::four_state) {
      vectors::Bytes forced(micromap::packed_bytes(states.size(), micromap::Format::two_state));
      micromap::force2(bytes, states.size(), forced);
      EXPECT_EQ(forced, maps.part(k, "forced"));
    }
    const auto same = micromap::uniform(bytes, f, states.size());
    EXPECT_EQ(maps.optional(k, "uniform"),
              same ? vectors::Optional(static_cast<std::uint32_t>(*same)) : vectors::none);
  }
  const Reading padded(tests::family("packing"), "padded");
  for (std::size_t k = 0; k < padded.size(); ++k) {
    std::vector<micromap::State> read(std::size_t{1} << 2 * padded(k, "level"));
    micromap::unpack(padded.part(k, "bytes"), micromap::Format(padded(k, "format")), read);
    EXPECT_EQ(read, states_of(padded.part(k, "states")));
  }
}

TEST(VectorsMaps, SpecialIndicesAreTheLibrarys) {
  const Reading codes(tests::family("special"), "codes");
  std::map<std::uint32_t, std::size_t> special;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const auto e = micromap::Encoding(codes(k, "encoding"));
    const std::uint32_t code = codes(k, "code");
    const auto state = micromap::special_state(code, e);
    EXPECT_EQ(codes.optional(k, "state"),
              state ? vectors::Optional(static_cast<std::uint32_t>(*state)) : vectors::none)
        << k;
    EXPECT_EQ(codes.optional(k, "index"),
              micromap::is_index(code, e) ? vectors::Optional(code) : vectors::none)
        << k;
    special[codes(k, "encoding")] += state ? 1 : 0;
  }
  for (const auto& [encoding, count] : special) EXPECT_EQ(count, 4u);
  EXPECT_EQ(special.size(), 5u);
}

}  // namespace vectors_maps_test
