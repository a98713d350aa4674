// render/: scenes by Embree.  Without Embree all of it is skipped, and so said.
#include "scene/sample/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "display/render/picture.hpp"
#include "display/render/scene/compare.hpp"
#include "proofs/traverse/rays/conformance.hpp"
#include "proofs/traverse/rays/sample_world.hpp"
#include "scene/read/load.hpp"
#include "tests/render/needs_embree.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::render;
using proofs::traverse::ConformanceRay;
using proofs::traverse::SampleWorld;

/// The suite's own scene, ready for rays.
struct Garden {
  scene::Bytes bytes = scene::sample_scene();
  scene::Scene scene = scene::load("sample", bytes);
  scene::Plan plan = scene::plan(scene);
  SceneWorld world = world_of(scene, scene::load_uses("sample", bytes), plan);
  Tracer tracer{world.world};
  Camera camera = overview(box_of(world.world, true), 4.0f / 3);

  static const Garden& get() {
    static const Garden garden;
    return garden;
  }
  Compared compared(CompareOptions options) const {
    options.trace.width = 160;
    options.trace.height = 120;
    return compare(scene, plan, world, tracer, camera, options);
  }
};

TEST(Uses, AreAsManyAsMeshesSay) {
  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  std::vector<std::uint64_t> uses(scene.meshes.size());
  double highest = 0;
  for (const scene::MeshUse& use : scene::load_uses("sample", bytes)) {
    ++uses[use.mesh];
    highest = std::max(highest, use.to_scene.translation[1]);
  }
  for (std::size_t k = 0; k < uses.size(); ++k)
    EXPECT_EQ(uses[k], scene.meshes[k].uses) << scene.meshes[k].name;
  EXPECT_NEAR(highest, 1.2, 1e-6) << "the flower, the highest of all that is placed";
}

TEST(Render, EveryMethodSeesWhatTheTextureAloneSees) {
  NEEDS_EMBREE;
  CompareOptions options;
  options.first = 0;
  options.last = 5;
  options.wanted = {std::begin(methods), std::end(methods)};
  const Compared all = Garden::get().compared(options);
  ASSERT_EQ(all.methods.size(), 4u + 4 * 6);
  const Counts& texture = all.methods.front().counts;
  EXPECT_EQ(texture.shader, texture.candidates);
  EXPECT_GT(texture.candidates, 3000u);
  std::map<unsigned, std::set<std::uint64_t>> by_level;
  for (const MethodFigures& m : all.methods) {
    EXPECT_EQ(m.differing, 0u) << name_of(m.method);
    EXPECT_EQ(m.counts.candidates, texture.candidates) << name_of(m.method);
    EXPECT_EQ(m.counts.ignored + m.counts.opaque + m.counts.shader, m.counts.candidates);
    if (m.method == Method::flat || m.method == Method::tree || m.method == Method::ranked)
      by_level[*m.level].insert(m.counts.shader);
  }
  // Forms of one map answer alike, and finer maps more.
  std::uint64_t before = texture.shader + 1;
  for (const auto& [level, calls] : by_level) {
    EXPECT_EQ(calls.size(), 1u) << level;
    EXPECT_LT(*calls.begin(), before) << level;
    before = *calls.begin();
  }
}

TEST(Render, MeetsWhatTheMapsAreaPredicts) {
  NEEDS_EMBREE;
  CompareOptions options;
  options.first = 2;
  options.last = 6;
  options.wanted = {Method::flat};
  for (const MethodFigures& m : Garden::get().compared(options).methods) {
    if (!m.predicted) continue;
    // 200,000 lines meet tens of thousands of candidates: a standard deviation is a quarter of a point at most.
    EXPECT_NEAR(*m.even, *m.predicted, 0.01) << *m.level;
    // A camera's come from one side, and what stands in front is met more often than what is behind.
    EXPECT_NEAR(m.counts.known(), *m.predicted, 0.05) << *m.level;
  }
}

TEST(Render, EvenRaysMeetSurfacesByTheirArea) {
  NEEDS_EMBREE;
  // A unit square, opaque by its map, and a transparent one of four times its area, across it and away from it.
  World world;
  static const std::vector<std::uint8_t> clear{0};
  world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{clear.data(), 1, 1, 1},
                              impl::bake::Sampling{}, impl::bake::AlphaMode(impl::bake::Mask{}));
  Geometry squares;
  squares.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                       {5, 0, 0}, {5, 2, 0}, {5, 2, 2}, {5, 0, 2}};
  squares.triangles = {{0, 1, 2}, {2, 3, 0}, {4, 5, 6}, {6, 7, 4}};
  squares.uvs.resize(8);
  squares.surface = 0;
  world.geometries = {squares};
  world.meshes = {{0}};
  world.instances.push_back({});
  Micromaps micromaps;
  micromaps.codes = {{~1u, ~1u, ~0u, ~0u}};
  const Tracer tracer(world);
  const auto flat = opacity_of(Method::flat, micromaps);
  constexpr std::uint64_t rays = 400000;
  const Counts counts = tracer.even_rays(*flat, rays, 1);
  EXPECT_EQ(counts.shader, 0u);
  // A flat area A in a ball of radius R is met by A / (2 pi R^2) of its lines: twice A, of its two sides, over the
  // ball's surface.  R is half of the diagonal of 5 x 2 x 2.
  const double disc = 3.14159265 * (25 + 4 + 4) / 4.0;
  EXPECT_NEAR(static_cast<double>(counts.opaque) / rays, 1 / (2 * disc), 0.001);
  EXPECT_NEAR(static_cast<double>(counts.ignored) / rays, 4 / (2 * disc), 0.002);
  EXPECT_EQ(tracer.even_rays(*flat, rays, 1, 1), counts) << "of one thread";
}

TEST(Render, IsTheSameForAnyNumberOfThreads) {
  NEEDS_EMBREE;
  const SampleWorld& sample = SampleWorld::get();
  const Camera camera = on_path(sample.box(), 5, 3, 1);
  const Opacity* const maps = sample.opacity(Method::ranked, 3);
  std::set<std::uint64_t> digests;
  std::vector<Counts> counts;
  std::uint64_t told = 0;
  for (const unsigned threads : {1u, 2u, 5u}) {
    TraceOptions options{.width = 61, .height = 47, .threads = threads};
    std::atomic<std::uint64_t> done = 0;
    options.done = [&done](std::uint64_t rays) { done += rays; };
    const Frame frame = sample.tracer().frame(camera, maps, options);
    digests.insert(digest(frame));
    counts.push_back(frame.counts);
    told = done;
  }
  EXPECT_EQ(digests.size(), 1u);
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_EQ(counts[0], counts[2]);
  EXPECT_EQ(told, 61u * 47);
  EXPECT_GT(counts[0].shader, 0u);
  // Built anew, the volumes are the same, too.
  const Tracer again(sample.world());
  EXPECT_EQ(again.frame(camera, maps, {.width = 61, .height = 47}).counts, counts[0]);
}

TEST(Render, EndsWhereItIsTold) {
  NEEDS_EMBREE;
  const SampleWorld& sample = SampleWorld::get();
  TraceOptions options{.width = 64, .height = 64};
  options.done = [](std::uint64_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(sample.tracer().frame(Camera{}, nullptr, options), std::runtime_error);
  EXPECT_THROW(sample.tracer().frame(Camera{}, nullptr, {.width = 0, .height = 1}), std::invalid_argument);
}

TEST(Render, AFrameThatDiffersIsCounted) {
  NEEDS_EMBREE;
  const SampleWorld& sample = SampleWorld::get();
  const TraceOptions options{.width = 16, .height = 16};
  const Camera camera = overview(sample.box(), 1);
  const Frame a = sample.tracer().frame(camera, nullptr, options);
  Frame b = a;
  EXPECT_EQ(differing(a, b), 0u);
  b.pixels[3].primary.t += 1;
  b.pixels[9].lit = !b.pixels[9].lit;
  EXPECT_EQ(differing(a, b), 2u);
  EXPECT_NE(digest(a), digest(b));
}

/// A unit triangle that is opaque by its texture.
World one_triangle() {
  static const std::vector<std::uint8_t> solid{255};
  World world;
  world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{solid.data(), 1, 1, 1},
                              impl::bake::Sampling{}, impl::bake::AlphaMode(impl::bake::Mask{}));
  Geometry triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  triangle.uvs.resize(3);
  triangle.surface = 0;
  world.geometries = {triangle};
  world.meshes = {{0}};
  return world;
}

Instance scaled(float x, float y, float z, float to_the_right = 0) {
  return {0, {x, 0, 0, 0, y, 0, 0, 0, z, to_the_right, 0, 0}};
}

TEST(Render, SeesAFlatInstanceWhereItIsPlaced) {
  NEEDS_EMBREE;
  // Beside a healthy one, by scales that no ray can be taken through: a flat one, others too small or too large.
  for (const Instance& odd : {scaled(1, 1, 0, 2), scaled(1, 1, 1e-30f, 2), scaled(1, 1, 1e35f, 2)}) {
    World world = one_triangle();
    world.instances = {scaled(1, 1, 1), odd};
    EXPECT_FALSE(has_inverse(odd, 4));
    const Tracer tracer(world);
    for (const float x : {0.25f, 2.25f}) {
      Counts counts;
      const Met met = tracer.first_hit({{x, 0.25f, 1}, {0, 0, -1}}, nullptr, 0, counts);
      EXPECT_FLOAT_EQ(met.t, 1) << x;  // Embree divides by estimates, other ones in each instruction set
      EXPECT_EQ(met.instance, x > 1 ? 1u : 0u);
      EXPECT_EQ(met.geometry, 0u);
    }
  }
  // Without area they are there and met by none.
  for (const Instance& odd : {scaled(0, 0, 0), scaled(0, 1, 1), scaled(1e-20f, 1e-20f, 1e-20f)}) {
    World world = one_triangle();
    world.instances = {scaled(1, 1, 1), odd};
    const Tracer tracer(world);
    const Frame frame = tracer.frame(overview(box_of(world, true), 1), nullptr, {.width = 20, .height = 20});
    EXPECT_GT(frame.counts.candidates, 20u);
  }
  EXPECT_TRUE(has_inverse(scaled(1, -2, 1e-3f), 100));
}

TEST(Render, SeesScenesOfAnySizeFromEverywhere) {
  NEEDS_EMBREE;
  const auto seen = [](const World& world, const Camera& camera) {
    return Tracer(world).frame(camera, nullptr, {.width = 20, .height = 20}).counts;
  };
  World unit_sized = one_triangle();
  unit_sized.instances = {scaled(1, 1, 1)};
  const auto usual = seen(unit_sized, overview(box_of(unit_sized, true), 1)).candidates;
  for (const float size : {1e-9f, 1e-5f, 1e-4f, 1e4f, 1e5f, 1e8f, 1e10f})
    for (const bool by_instance : {true, false}) {
      World world = one_triangle();
      world.instances = {by_instance ? scaled(size, size, size) : scaled(1, 1, 1)};
      if (!by_instance)
        for (Point& p : world.geometries[0].positions)
          for (float& x : p) x *= size;
      const Counts counts = seen(world, overview(box_of(world, true), 1));
      EXPECT_NEAR(static_cast<double>(counts.candidates), static_cast<double>(usual), 6) << size;
    }
  // A path leaves the plane of a flat scene.
  unsigned cameras = 0;
  for (std::uint64_t number = 1; number <= 20; ++number)
    cameras += seen(unit_sized, on_path(box_of(unit_sized, true), 1, number, 1)).candidates > 0;
  EXPECT_GT(cameras, 10u);
}

/// The rays of a level on Embree: what became of each.
struct Shot {
  std::uint64_t rays = 0, right = 0, of_a_neighbour = 0, wrong = 0, missed = 0;
  bool exact = true;  // all distances: Embree divides by an estimate, another one in each instruction set
};
Shot shot(unsigned level, double distance) {
  World world;
  // Below 1/2 everywhere, so that an any-hit call rejects: then a hit is one without a call.
  static const std::vector<std::uint8_t> clear{0};
  world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{clear.data(), 1, 1, 1},
                              impl::bake::Sampling{}, impl::bake::AlphaMode(impl::bake::Mask{}));
  Geometry triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  triangle.uvs = {{0, 0}, {1, 0}, {0, 1}};
  triangle.surface = 0;
  world.geometries = {triangle};
  world.meshes = {{0}};
  world.instances.push_back({});
  const Tracer tracer(world);
  const std::vector<std::uint8_t> map = proofs::traverse::ray_map(level);
  Micromaps micromaps;
  micromaps.array.data = map;
  micromaps.array.records = {{0, static_cast<std::uint16_t>(level), 2}};
  micromaps.codes = {{0}};
  const auto flat = opacity_of(Method::flat, micromaps);
  Shot all;
  proofs::traverse::each_conformance_ray(level, distance, [&](const ConformanceRay& ray) {
    ++all.rays;
    Counts counts;
    const Met met = tracer.first_hit({{ray.u, ray.v, 1}, {0, 0, -1}}, flat.get(), 0, counts);
    if (counts.candidates == 0) {
      ++all.missed;
      return true;
    }
    all.exact = all.exact && (!met.hit() || met.t == 1);
    const auto agrees = [&](std::uint32_t index) {
      switch (proofs::traverse::ray_outcome(proofs::traverse::ray_state(index))) {
        case spec::traverse::Outcome::ignored: return counts.ignored == 1 && !met.hit();
        case spec::traverse::Outcome::opaque:
          return counts.opaque == 1 && met.hit() && std::abs(met.t - 1) < 1e-6F;
        case spec::traverse::Outcome::non_opaque: return counts.shader == 1 && !met.hit();
      }
      return false;
    };
    if (agrees(ray.index))
      ++all.right;
    else if (std::any_of(ray.touching.begin(), ray.touching.end(), agrees))
      ++all.of_a_neighbour;
    else
      ++all.wrong;
    return true;
  });
  return all;
}

TEST(ConformanceRays, HaveTheirStatesOnEmbree) {
  NEEDS_EMBREE;
  for (unsigned level = 0; level <= 6; ++level) {
    const std::uint64_t N = std::uint64_t{1} << level;
    const Shot safe = shot(level, 0.25);
    EXPECT_EQ(safe.rays, N * N);
    EXPECT_EQ(safe.right, safe.rays) << level;
    const Shot middle = shot(level, 0.33);
    EXPECT_EQ(middle.right, N * N) << level;
    const Shot all = shot(level, 0);
    EXPECT_EQ(all.rays, 3 * N * N + 3 * N + 1);
    EXPECT_EQ(all.wrong, 0u) << level;
    // All ties fall as in the reference code where Embree's barycentrics of these rays are exact.
    EXPECT_TRUE(all.of_a_neighbour == 0 || !all.exact) << level;
    EXPECT_EQ(all.missed, 0u) << level;
  }
}

TEST(ConformanceRays, AreAsFarFromAllLinesAsTheySay) {
  for (const double distance : {0.0, 0.1, 0.25, 0.26, 0.3, 0.33, 0.333})
    for (unsigned level = 0; level <= 4; ++level) {
      std::uint64_t count = 0;
      std::set<std::uint32_t> seen;
      proofs::traverse::each_conformance_ray(level, distance, [&](const ConformanceRay& ray) {
        ++count;
        EXPECT_TRUE(std::binary_search(ray.touching.begin(), ray.touching.end(), ray.index));
        if (ray.kind != proofs::Kind::interior) return true;
        EXPECT_FALSE(ray.on_outline);
        EXPECT_EQ(ray.touching.size(), 1u);
        seen.insert(ray.index);
        const double N = static_cast<double>(1u << level);
        for (const double b : {double{ray.u}, double{ray.v}, 1 - double{ray.u} - double{ray.v}})
          EXPECT_GE(std::abs(N * b - std::round(N * b)), std::max(distance, 0.25))
              << level << " " << distance;
        return true;
      });
      EXPECT_EQ(count, proofs::traverse::conformance_rays(level, distance));
      EXPECT_EQ(seen.size(), std::size_t{1} << (2 * level));
    }
}

TEST(ConformanceRays, OfAVertexInsideTouchSixAndOfAnEdgeTwo) {
  proofs::traverse::each_conformance_ray(3, 0, [](const ConformanceRay& ray) {
    const bool on_border = ray.u == 0 || ray.v == 0 || ray.u + ray.v == 1;
    EXPECT_EQ(ray.on_outline, on_border) << ray.u << " " << ray.v;
    const std::size_t touching = ray.touching.size();
    if (ray.kind == proofs::Kind::edge) {
      EXPECT_EQ(touching, on_border ? 1u : 2u);
    } else if (ray.kind == proofs::Kind::vertex) {
      const bool corner = ray.u == 1 || ray.v == 1 || (ray.u == 0 && ray.v == 0);
      EXPECT_EQ(touching, corner ? 1u : on_border ? 3u : 6u);
    }
    return true;
  });
}

TEST(Picture, HeatGoesFromBlueToRed) {
  EXPECT_EQ(heat_colour(0, 9), (std::array<std::uint8_t, 3>{24, 24, 72}));
  EXPECT_EQ(heat_colour(9, 9), (std::array<std::uint8_t, 3>{208, 32, 32}));
  EXPECT_EQ(heat_colour(50, 9), heat_colour(9, 9));
  Frame frame{2, 1, {{}, {}}, {}, 0, 0};
  frame.pixels[1].by_primary.shader = 2;
  frame.pixels[1].by_shadow.shader = 1;
  EXPECT_EQ(scale_of(frame), 3u);
  const Picture map = heat(frame, 3);
  EXPECT_EQ(map.rgb, (std::vector<std::uint8_t>{24, 24, 72, 208, 32, 32}));
  const Picture beside = side_by_side({map, map}, {"a", "b"}, 3);
  EXPECT_EQ(beside.rgb.size(), std::size_t{3} * beside.width * beside.height);
  // The scale's text is whole, and titles longer than their picture stay apart: a letter is 8 pixels wide, a gap, too.
  EXPECT_EQ(beside.width, 8u + 8 + 160 + 8 + 8 * std::string("3 any-hit calls a pixel or more").size() + 8);
  const std::string title(20, 'A');
  EXPECT_EQ(side_by_side({map, map, map}, {title, title, title}, 3).width, 8u + 3 * (20 * 8 + 8));
}

}  // namespace
