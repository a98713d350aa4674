// impl/scene and proofs/scene: from a plan to maps, arrays, pairs and the laws on them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "impl/index.hpp"
#include "impl/micromap_reorder.hpp"
#include "impl/scene/any_hit.hpp"
#include "impl/scene/bake.hpp"
#include "impl/scene/footprint.hpp"
#include "impl/scene/levels.hpp"
#include "impl/scene/square_maps.hpp"
#include "proofs/scene.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::impl::scene;
namespace micromap = mmverify::impl::micromap;
namespace index = mmverify::impl::index;
using testing::ElementsAre;

/// A disc of alpha in 16 x 16 texels, soft at its rim, off the centre so that nothing is symmetric.
Image disc() {
  Image image{"disc", 16, 16, std::vector<std::uint8_t>(256)};
  auto& alpha = std::get<0>(image.alpha);
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 16; ++x) {
      const double r = std::hypot(static_cast<double>(x) - 6.3, static_cast<double>(y) - 8.9);
      alpha[x + 16 * y] = static_cast<std::uint8_t>(std::clamp(255 * (5.5 - r), 0.0, 255.0));
    }
  return image;
}

/// Two quads with the texture on: one as two triangles that share an edge, one whose triangles are the same
/// UVs with other orders of vertices, and an opaque corner of it, which is uniform.
Scene scene() {
  Scene s;
  s.file = "made.gltf";
  s.images.push_back(disc());
  Material material;
  material.mode = AlphaMode::mask;
  material.texture = BaseColorTexture{0, 0, {}, {}};
  s.materials.push_back(material);
  s.meshes.push_back({"quads", 2, {5, {}}});
  Primitive p;
  p.material = 0;
  p.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4f, 0.5f}, {0.45f, 0.5f}, {0.4f, 0.55f}};
  for (const Uv& uv : p.uvs) p.positions.push_back({uv[0], uv[1], 0});
  p.triangles = {{0, 1, 2}, {2, 3, 0}, {1, 2, 0}, {1, 0, 2}, {4, 5, 6}};
  s.primitives.push_back(p);
  return s;
}

unsigned code(std::span<const std::uint8_t> map, std::uint32_t at, unsigned b = 2) {
  return map[at * b / 8] >> (at * b % 8) & ((1u << b) - 1);
}

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
          // By the corners, as points with three barycentrics.
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
  const Scene s = scene();
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

/// A scene all the way.
struct Made {
  Scene s = scene();
  Plan p = plan(s);
  Levels l;
  Baked b;
  SceneArrays a;
  Pairs q;
  SquareMaps m;
  explicit Made(std::optional<unsigned> level = {}, const BakeOptions& options = {})
      : l(levels(p, {level, 1 << 20})),
        b(bake(s, p, l.of, options)),
        a(arrays(p, b)),
        q(pairs(s, p)),
        m(square_maps(s, p, q)) {}
  proofs::scene::Data data() const { return {s, p, b, a, q, m, 0}; }
};

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
  const Scene s = scene();
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

proofs::Report judged(const proofs::scene::Data& data, std::optional<std::uint64_t> samples = 400) {
  const proofs::scene::SceneLaws laws =
      proofs::scene::scene_laws(data, {samples}, "mmverify scene made.gltf");
  proofs::RunOptions run;
  run.show_progress = false;
  run.mutants = false;
  return proofs::run_jobs(laws.jobs, run, [](const proofs::Result&) {});
}

std::map<std::string, proofs::Verdict> verdicts(const proofs::Report& report) {
  std::map<std::string, proofs::Verdict> weakest;
  for (const proofs::Result& r : report.results) {
    const auto [at, is_new] = weakest.try_emplace(r.law, r.verdict);
    if (r.verdict == proofs::Verdict::refuted || is_new) at->second = r.verdict;
  }
  return weakest;
}

TEST(SceneLaws, HoldOfOurOwnMaps) {
  using enum proofs::Verdict;
  const Made made;
  for (const auto& [law, verdict] : verdicts(judged(made.data(), 40)))
    EXPECT_EQ(verdict, law == "vq.square_map" || law.starts_with("bake.") ? checked : proved) << law;
  for (const auto& [law, verdict] : verdicts(judged(made.data(), std::nullopt)))
    EXPECT_EQ(verdict, law == "vq.square_map" ? checked : proved) << law;
}

TEST(SceneLaws, CatchWrongMaps) {
  using enum proofs::Verdict;
  {  // One micro-triangle of 2048 that is unknown is opaque.
    Made made;
    BakedTriangle& t = made.b.triangles[0];
    std::uint32_t at = 0;
    while (code(t.map, at) != 3) ++at;
    t.map[at / 4] = static_cast<std::uint8_t>(t.map[at / 4] ^ (2u << (2 * (at % 4))));
    --t.states[3], ++t.states[1];
    const proofs::Report report = judged(made.data(), std::nullopt);
    auto found = verdicts(report);
    EXPECT_EQ(found["bake.conservative"], refuted);
    EXPECT_EQ(found["bake.tight"], proved);
    EXPECT_EQ(found["micromap.indirection"], refuted);  // the array was made before
    for (const proofs::Result& r : report.results)
      if (r.law == "bake.conservative" && r.verdict == refuted) {
        EXPECT_EQ(r.counterexamples.at(0).at, "t0:i" + std::to_string(at));
        EXPECT_EQ(r.replayed_by, "mmverify scene made.gltf --replay bake.conservative");
      }
  }
  {  // One that is transparent is unknown.
    Made made;
    BakedTriangle& t = made.b.triangles[1];
    std::uint32_t at = 1023;
    while (code(t.map, at) != 0) --at;
    t.map[at / 4] = static_cast<std::uint8_t>(t.map[at / 4] | 2u << (2 * (at % 4)));
    --t.states[0], ++t.states[2];
    auto found = verdicts(judged(made.data(), std::nullopt));
    EXPECT_EQ(found["bake.conservative"], proved);
    EXPECT_EQ(found["bake.tight"], refuted);
  }
  {  // A code names the neighbour's record.
    Made made;
    std::swap(made.a.primitives[0].geometry.indices[0], made.a.primitives[0].geometry.indices[2]);
    EXPECT_EQ(verdicts(judged(made.data()))["micromap.indirection"], refuted);
  }
  {  // A code beyond the records, and counts that are off.
    Made made;
    made.a.primitives[0].geometry.counts[0].count += 1;
    EXPECT_EQ(verdicts(judged(made.data()))["micromap.valid"], refuted);
  }
  {  // A region that is mixed is called opaque.
    Made made;
    for (impl::vq::Map2& map : made.m.vq2) map.fill(impl::vq::State::O);
    EXPECT_EQ(verdicts(judged(made.data()))["vq.square_map"], refuted);
  }
}

TEST(SceneLaws, AnotherSurfaceIsAnotherRun) {
  const auto fingerprint = [](const Made& made) {
    return proofs::scene::SceneSubject(made.data(), "bake").fingerprint();
  };
  const Made made;
  EXPECT_EQ(fingerprint(made), fingerprint(Made()));
  Made other;
  other.p.surfaces[0].cutoff = 0.25f;
  EXPECT_NE(fingerprint(other), fingerprint(made));
}

TEST(SceneLaws, JudgeTwoStatesAsSuch) {
  const Made made(4, {0, true, 0, {}});
  const auto two_state = [](const Made& m) {
    return proofs::scene::Data{m.s, m.p, m.b, m.a, m.q, m.m, 0, true};
  };
  auto found = verdicts(judged(two_state(made), std::nullopt));
  EXPECT_EQ(found["bake.force2"], proofs::Verdict::proved);
  Made wrong(4, {0, true, 0, {}});
  auto& map = wrong.b.triangles[0].map;
  map[5] = static_cast<std::uint8_t>(map[5] ^ 4);
  EXPECT_EQ(verdicts(judged(two_state(wrong), std::nullopt))["bake.force2"], proofs::Verdict::refuted);
}

TEST(ScenePlan, LeavesOutWhatOneMapCannotSay) {
  const auto why = [](auto change) {
    Scene s = scene();
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

TEST(SceneLaws, NameTheSameCasesAgain) {
  const Made made;
  const proofs::scene::Data data = made.data();
  const proofs::scene::SceneLaws laws = proofs::scene::scene_laws(data, {50}, "");
  for (const proofs::Job& job : laws.jobs)
    if (job.law->id == "bake.tight" && job.levels.first == 5) {
      EXPECT_TRUE(job.law->replay(*job.subject, 5, "t0:i17").holds);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t0:i1024"), proofs::BadCase);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t0:i17x"), proofs::BadCase);
      EXPECT_THROW(job.law->replay(*job.subject, 5, "t2:i0"), proofs::BadCase);
    }
}

}  // namespace
