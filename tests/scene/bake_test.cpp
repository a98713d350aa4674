// scene/ and proofs/scene: from a plan to maps, arrays, pairs and the laws on them.
#include "scene/bake/bake.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "impl/index/index.hpp"
#include "impl/micromap/reorder.hpp"
#include "scene/bake/any_hit.hpp"
#include "scene/bake/footprint.hpp"
#include "scene/bake/square_maps.hpp"
#include "scene/plan/levels.hpp"
#include "tests/scene/made_scene.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::scene;
using namespace mmverify::tests;
namespace micromap = mmverify::impl::micromap;
namespace index = mmverify::impl::index;
using testing::ElementsAre;

TEST(MicromapReorder, NamesTheSamePlaces) {
  std::mt19937 random(1);
  for (const micromap::Level level : {0u, 1u, 2u, 3u, 5u}) {
    const std::uint64_t count = micromap::micro_triangles(level);
    for (const micromap::Format f : {micromap::Format::two_state, micromap::Format::four_state}) {
      micromap::Bytes map(micromap::packed_bytes(count, f)), out(map.size(), 0xff);
      for (auto& byte : map) byte = static_cast<std::uint8_t>(random());
      micromap::VertexOrder order{0, 1, 2};
      do {
        micromap::reorder(map, level, f, order, out);
        for (std::uint32_t k = 0; k < count; ++k) {
          // The centre of a micro-triangle by its corners, as points with three barycentrics.
          std::array<double, 3> at{};
          for (const index::Vertex& v : index::corners(k, level)) {
            at[order[1]] += v.i;
            at[order[2]] += v.j;
            at[order[0]] += static_cast<double>((1u << level) - v.i - v.j);
          }
          const double all = 3.0 * (1u << level);
          const std::uint32_t was = index::from_barycentrics(static_cast<float>(at[1] / all),
                                                             static_cast<float>(at[2] / all), level);
          ASSERT_EQ(code(out, k, micromap::bits(f)), code(map, was, micromap::bits(f))) << level << ' ' << k;
        }
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

TEST(MicromapReorder, RefusesWhatIsNone) {
  micromap::Bytes map(1), out(1), large(2);
  EXPECT_THROW(micromap::reorder(map, 1, micromap::Format::four_state, {0, 1, 1}, out),
               std::invalid_argument);
  EXPECT_THROW(micromap::reorder(map, 1, micromap::Format::four_state, {0, 1, 2}, large),
               std::invalid_argument);
  EXPECT_THROW(micromap::reorder(map, 17, micromap::Format::four_state, {0, 1, 2}, out),
               std::invalid_argument);
}

TEST(SceneLevels, LowersTheFinestUntilTheyFit) {
  const Scene s = made_scene();
  const Plan p = plan(s);
  ASSERT_EQ(p.triangles.size(), 3u);                    // two halves of the quad, and the corner
  EXPECT_THAT(levels(p, {}).of, ElementsAre(5, 5, 1));  // diagonal 22.6 texels, 1.1 texels
  EXPECT_THAT(levels(p, {3, 1 << 20}).of, ElementsAre(3, 3, 3));
  const Levels lowered = levels(p, {{}, 2 * 64 + 1});
  EXPECT_THAT(lowered.of, ElementsAre(4, 4, 1));
  EXPECT_EQ(lowered.lowered, 2u);
  EXPECT_EQ(lowered.micro_triangles, 2u * 256 + 4);
  EXPECT_EQ(levels(p, {{}, 2 * 64}).of[0], 3u);
  EXPECT_THROW(levels(p, {{}, 2}), std::invalid_argument);
  EXPECT_THROW(levels(p, {13, 1 << 20}), std::invalid_argument);
}

TEST(SceneBake, IsTheSameForAnyNumberOfThreads) {
  const Made one({}, {1, false, 0, {}}), three({}, {3, false, 0, {}});
  for (std::size_t k = 0; k < one.b.triangles.size(); ++k)
    EXPECT_EQ(one.b.triangles[k].map, three.b.triangles[k].map);
  EXPECT_EQ(one.a.array.data, three.a.array.data);
}

TEST(SceneBake, UniformTrianglesAreSpecialAndDuplicatesShareMaps) {
  const Made made;
  ASSERT_TRUE(made.b.triangles[2].uniform);
  EXPECT_EQ(*made.b.triangles[2].uniform, micromap::State::O);
  // The first half, the second, and the first's two other orders; the corner is special.
  EXPECT_EQ(made.a.array.records.size(), 4u);
  EXPECT_EQ(made.a.reordered, 2u);
  EXPECT_EQ(made.a.special, 1u);
  EXPECT_EQ(made.a.encoding, micromap::Encoding::u16);
  const auto& indices = made.a.primitives.at(0).geometry.indices;
  EXPECT_THAT(indices, ElementsAre(0, 0, 1, 0, 2, 0, 3, 0, 0xfe, 0xff));
}

TEST(SceneBake, TwoStatesWhereTheyWillDo) {
  const Made made(2, {0, true, 0, {}});
  for (const BakedTriangle& t : made.b.triangles) {
    EXPECT_EQ(t.states[2] + t.states[3], 0u);
    EXPECT_TRUE(t.uniform || t.format == micromap::Format::two_state);
  }
}

TEST(SceneBake, WhatItIsToldEndsIt) {
  const Scene s = made_scene();
  const Plan p = plan(s);
  const std::vector<unsigned> of{3, 3, 3};
  EXPECT_THROW(bake(s, p, of, {1, false, 0, [](std::uint64_t) { throw 17; }}), int);
  EXPECT_THROW(bake(s, p, std::vector<unsigned>{3}), std::invalid_argument);
}

TEST(ScenePairs, ShareAnEdgeAndLieInTheUnitSquare) {
  const Made made;
  // Triangle 0 finds 1; 2 finds 3, with the same three corners; the corner has no partner.
  EXPECT_EQ(made.q.unique, 2u);
  EXPECT_EQ(made.q.unpaired, 1u);
  const Pair& pair = made.q.distinct.at(0);
  EXPECT_EQ(pair.unique, 1u);
  EXPECT_EQ(pair.placed, 2u);
  // The shared edge joins (1,0) and (0,1) of the map; both triangles name its ends alike.
  const auto uv = [&](const TriangleUse& use, std::size_t k) {
    return made.p.triangles[use.triangle].uvs[use.order[k]];
  };
  EXPECT_EQ(uv(pair.lower, 1), uv(pair.upper, 2));
  EXPECT_EQ(uv(pair.lower, 2), uv(pair.upper, 1));
  EXPECT_NE(uv(pair.lower, 0), uv(pair.upper, 0));
}

TEST(SceneSquareMaps, AreTheTwoTrianglesTogether) {
  // Lower: micro-triangle k has code k mod 4 at level 1; by hand from the corners of the curve's four.
  const std::vector<std::uint8_t> lower{0b11'00'01'00}, upper{0b01'01'01'01};
  std::vector<impl::vq::State> states(4);
  square_map(lower, upper, 1, states);
  using enum impl::vq::State;
  // (0,0): children 0 (T) and 1 (O) of the lower; (1,0): child 2 (T) and an O of the upper; (0,1): child 3
  // (UO).
  EXPECT_THAT(states, ElementsAre(C, C, C, O));
  const std::vector<std::uint8_t> all_t{0};
  square_map(all_t, all_t, 1, states);
  EXPECT_THAT(states, ElementsAre(T, T, T, T));
  EXPECT_THROW(square_map(all_t, all_t, 2, states), std::invalid_argument);
}

TEST(SceneFootprint, AddsUp) {
  const Made made(4);
  const Footprint f = footprint(made.s, made.p, made.a);
  EXPECT_EQ(f.records, made.a.array.records.size());
  EXPECT_EQ(f.record_bytes, 8 * f.records);
  EXPECT_EQ(f.index_bytes, 2u * 5);
  EXPECT_EQ(f.mode[1].records, f.records);
  EXPECT_EQ(f.mode[1].data, f.records * 64);
  EXPECT_EQ(f.mode[0].data, f.mode[0].records * 32);
  EXPECT_EQ(f.texture, 256u);
  EXPECT_EQ(f.mode[0].bitmask, 32u);
  EXPECT_EQ(f.vertex_data, 12u * 5 + 8 * 7);
  EXPECT_LT(f.mode[1].tree, f.mode[1].data);
}

TEST(SceneSaved, IsByAreaAndPlacement) {
  Made made;
  const AnyHitShares all = any_hit_shares(made.s, made.p, made.b);
  // Four halves of the unit square and a corner of 1/800, five times as large.
  EXPECT_NEAR(all.area, 5 * (4 * 0.5 + 0.05 * 0.05 / 2), 1e-6);
  EXPECT_NEAR(all.transparent + all.opaque + all.unknown, 1, 1e-12);
  // One more placement, twice as long in x: twice the area of a flat quad.
  made.s.meshes[0].placements.others.push_back({{2, 0, 0, 0, 1, 0, 0, 0, 1}, 1});
  EXPECT_NEAR(any_hit_shares(made.s, made.p, made.b).area, all.area * 7 / 5, 1e-6);
}

TEST(ScenePlan, LeavesOutWhatOneMapCannotSay) {
  const auto why = [](auto change) {
    Scene s = made_scene();
    change(s);
    const Plan p = plan(s);
    return p.left_out.empty() ? std::optional<LeftOut>() : p.left_out[0].why;
  };
  EXPECT_EQ(why([](Scene&) {}), std::nullopt);
  EXPECT_EQ(why([](Scene& s) {
              s.materials[0].texture->sampler.magnification = Filter::linear;
              s.materials[0].texture->sampler.minification = Filter::nearest;
            }),
            LeftOut::two_filters);
  EXPECT_EQ(why([](Scene& s) { s.primitives[0].vertex_alpha = VertexAlpha{2, 2}; }), LeftOut::vertex_alpha);
  EXPECT_EQ(why([](Scene& s) { s.primitives[0].uvs[3][1] = -0x1p20f; }), LeftOut::far_uvs);
}

}  // namespace
