// render/: bitmasks beside the texture, pictures of 2 states, and ambient occlusion.
#include "display/render/bitmask.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "display/render/scene/compare.hpp"
#include "display/render/vectors.hpp"
#include "proofs/traverse/rays/sample_world.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "tests/render/needs_embree.hpp"

namespace mmverify::tests::bitmask_test {
namespace {

using namespace mmverify::render;
using impl::bake::Wrap;
using impl::micromap::State;

constexpr int side = 4;

/// Codes on both sides of 1/2, 128 of them whole squares apart.
std::vector<std::uint8_t> codes() {
  return {0, 40, 200, 255, 120, 130, 90, 10, 255, 128, 127, 60, 255, 250, 255, 100};
}

/// One triangle over the square from -2 to 2 in both coordinates: u = 4 v - 2, twice the barycentrics.
World world_of_one(const std::vector<std::uint8_t>& texels, impl::bake::Filter filter, Wrap wrap) {
  impl::bake::Sampling sampling;
  sampling.filter = filter;
  sampling.u = sampling.v = wrap;
  World world;
  world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{texels.data(), side, side, side}, sampling,
                              impl::bake::AlphaMode(impl::bake::Cutoff{1, 2}));
  Geometry geometry;
  geometry.positions.resize(3);
  geometry.triangles = {{0, 1, 2}};
  geometry.uvs = {{-2, -2}, {6, -2}, {-2, 6}};
  geometry.surface = 0;
  world.geometries = {geometry};
  return world;
}

/// The bilinear sum of codes at steps of a 16th of a texel, times 32^2.  Texels as the world has them.
std::int64_t bilinear(const Surface& surface, std::int64_t x32, std::int64_t y32) {
  const std::int64_t x = x32 - 16, y = y32 - 16, i = x >> 5, j = y >> 5, fx = x & 31, fy = y & 31;
  const auto code = [&](std::int64_t a, std::int64_t b) { return std::int64_t{surface.code(a, b)}; };
  return (32 - fy) * ((32 - fx) * code(i, j) + fx * code(i + 1, j)) +
         fy * ((32 - fx) * code(i, j + 1) + fx * code(i + 1, j + 1));
}

TEST(Bitmask, OfFourStatesIsKnownExactlyWhereAllOfASquareIs) {
  const std::vector<std::uint8_t> texels = codes();
  std::set<State> states;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::clamp_to_border}) {
    const World world = world_of_one(texels, impl::bake::Filter::bilinear, wrap);
    const auto mask = bitmask_of(world, 4);
    const Surface& surface = world.surfaces[0];
    for (std::int64_t y = -8; y < 16; ++y)
      for (std::int64_t x = -8; x < 16 - (y + 8); ++x) {
        std::int64_t least = INT64_MAX, most = 0;
        for (std::int64_t a = 0; a <= 32; ++a)
          for (std::int64_t b = 0; b <= 32; ++b) {
            const std::int64_t sum = bilinear(surface, 32 * x + a, 32 * y + b);
            least = std::min(least, sum);
            most = std::max(most, sum);
          }
        // A code k is opaque from 127.5 on.
        const std::int64_t half = 255 * 512;
        const State right = least >= half ? State::O : most < half ? State::T : State::UT;
        // The texel's middle, on the triangle: 32 texels along each edge.
        const Barycentrics b{(static_cast<float>(x) + 8.5f) / 32, (static_cast<float>(y) + 8.5f) / 32};
        const State got = mask->at(0, 0, b).value();
        states.insert(got);
        const bool inside = x >= 0 && x < side && y >= 0 && y < side;
        // Beyond the texture a clamped square has the state of the texel that it repeats, which may know less.
        if (inside || wrap != Wrap::clamp_to_edge) {
          ASSERT_EQ(got, right) << x << " " << y << " " << static_cast<int>(wrap);
        } else {
          ASSERT_TRUE(got == right || got == State::UT) << x << " " << y;
        }
      }
  }
  EXPECT_EQ(states.size(), 3u);
}

TEST(Bitmask, OfOneBitIsTheTexelsCodeAndABitATexel) {
  const std::vector<std::uint8_t> texels = codes();
  const World world = world_of_one(texels, impl::bake::Filter::bilinear, Wrap::repeat);
  const auto mask = bitmask_of(world, 2);
  EXPECT_EQ(mask->bytes(), 2u);
  EXPECT_EQ(bitmask_of(world, 4)->bytes(), 4u);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool opaque = texels[static_cast<std::size_t>(x + side * y)] >= 128;
      // The first point of a texel's square is the texel's own, and so is one just before its end.
      for (const float in : {0.0f, 0.5f, 1 - 0x1p-10f})
        EXPECT_EQ(
            mask->at(0, 0, {(static_cast<float>(x) + 8 + in) / 32, (static_cast<float>(y) + 8 + in) / 32}),
            opaque ? State::O : State::T)
            << x << " " << y << " " << in;
    }
}

TEST(Bitmask, OfANearestTextureAsksNothingAndUnplannedTrianglesHaveNone) {
  const std::vector<std::uint8_t> texels = codes();
  World world = world_of_one(texels, impl::bake::Filter::nearest, Wrap::mirrored_repeat);
  const auto mask = bitmask_of(world, 4);
  for (int i = 0; i < 64; ++i)
    for (int j = 0; i + j < 64; ++j) {
      const Barycentrics b{static_cast<float>(i) / 64, static_cast<float>(j) / 64};
      const bool opaque = world.surfaces[0].opaque(world.geometries[0].uv_of(0), b, 0.5f);
      ASSERT_EQ(mask->at(0, 0, b), opaque ? State::O : State::T) << i << " " << j;
    }
  world.geometries[0].planned = false;
  EXPECT_FALSE(mask->at(0, 0, {0, 0}));
}

/// The suite's own scene by some methods.
Compared compared(CompareOptions options) {
  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  const scene::Plan plan = scene::plan(scene);
  const SceneWorld world = world_of(scene, scene::load_uses("sample", bytes), plan);
  options.trace.width = 160;
  options.trace.height = 120;
  return compare(scene, plan, world, Tracer(world.world), overview(box_of(world.world, true), 4.0f / 3),
                 options);
}

TEST(TwoStates, EachLevelIsAPictureOfItsOwnAndEachFormOfItTheSame) {
  NEEDS_EMBREE;
  const Compared all = compared({.first = 1,
                                 .last = 6,
                                 .wanted = {Method::flat, Method::tree, Method::ranked, Method::bitmask},
                                 .states = 2});
  ASSERT_EQ(all.methods.size(), 2u + 3 * 6);
  std::vector<double> flips;
  std::uint64_t left_out = 0;
  for (const MethodFigures& m : all.methods) {
    if (m.method == Method::texture) continue;
    EXPECT_EQ(m.apart, 0u) << name_of(m.method);
    EXPECT_GT(m.differing, 0u) << name_of(m.method) << " of 2 states is the texture's";
    // The texture decides for triangles that the plan leaves out, and for no other.
    left_out = m.counts.candidates - m.counts.planned;
    EXPECT_EQ(m.counts.shader, left_out) << name_of(m.method);
    if (m.method == Method::flat) flips.push_back(m.flip.value());
  }
  EXPECT_GT(left_out, 0u);
  EXPECT_EQ(std::set<double>(flips.begin(), flips.end()).size(), 6u) << "level by level another picture";
  EXPECT_LT(flips.back(), flips.front() / 2);
}

TEST(AmbientOcclusion, DirectionsFollowTheCosine) {
  const Point normal = unit({0.3f, -0.5f, 0.8f});
  double first = 0, second = 0;
  constexpr int count = 200'000;
  for (int k = 0; k < count; ++k) {
    const Point direction = about_normal(normal, mixed(static_cast<std::uint64_t>(k)));
    ASSERT_NEAR(dot(direction, direction), 1, 1e-5);
    const double cosine = dot(direction, normal);
    ASSERT_GE(cosine, -1e-6);
    first += cosine / count;
    second += cosine * cosine / count;
  }
  // Density cos/pi: the means are 2 int c^2 dc = 2/3 and 2 int c^3 dc = 1/2; five standard deviations.
  EXPECT_NEAR(first, 2.0 / 3, 5 * std::sqrt(1.0 / 18 / count));
  EXPECT_NEAR(second, 0.5, 5 * std::sqrt(1.0 / 12 / count));
}

/// A wide floor, with a wide wall on one side of x = 0 if there is one.
World floor_and_wall(bool wall) {
  constexpr float far = 1e4f;
  Geometry geometry;
  geometry.positions = {{-far, 0, -far}, {far, 0, -far}, {far, 0, far}, {-far, 0, far}};
  geometry.triangles = {{0, 2, 1}, {0, 3, 2}};
  if (wall) {
    geometry.positions.insert(geometry.positions.end(),
                              {{0, 0, -far}, {0, 2 * far, -far}, {0, 2 * far, far}, {0, 0, far}});
    geometry.triangles.insert(geometry.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  }
  World world;
  world.geometries = {geometry};
  world.meshes = {{0}};
  world.instances.push_back({});
  return world;
}

TEST(AmbientOcclusion, OfAFreeFloorIsNoneAndAtAWallHalf) {
  NEEDS_EMBREE;
  // The camera looks down at a piece of floor close to the wall, as far as that is wide.
  const Camera camera = looking({30, 20, 0}, {30, 0, 0}, 0.2f, 1);
  TraceOptions options{.width = 16, .height = 16, .shadows = false, .ambient = most_ambient};
  for (const bool wall : {false, true}) {
    const World world = floor_and_wall(wall);
    const Frame frame = Tracer(world).frame(camera, nullptr, options);
    double open = 0, rays = 0;
    for (const Pixel& pixel : frame.pixels) {
      ASSERT_TRUE(pixel.primary.hit());
      open += std::popcount(pixel.open);
      rays += most_ambient;
    }
    EXPECT_EQ(frame.counts.ambient_rays, static_cast<std::uint64_t>(rays));
    // The wall takes the half of the directions, but for 30/10,000 of the way to its end.
    EXPECT_NEAR(open / rays, wall ? 0.5 : 1, wall ? 5 * 0.5 / std::sqrt(rays) + 0.003 : 0) << wall;
  }
}

TEST(AmbientOcclusion, IsTheSameByEachMethodAndNumberOfThreadsAndAnotherWithAnotherSeed) {
  NEEDS_EMBREE;
  const auto& sample = proofs::traverse::SampleWorld::get();
  const Camera camera = on_path(sample.box(), 5, 3, 1);
  TraceOptions options{.width = 40, .height = 30, .ambient = 7};
  const Frame texture = sample.tracer().frame(camera, nullptr, options);
  std::set<std::uint64_t> opens;
  for (const Pixel& pixel : texture.pixels) opens.insert(pixel.open);
  EXPECT_GT(opens.size(), 20u);
  for (const Method method : methods) {
    const Frame frame = sample.tracer().frame(camera, sample.opacity(method, 3), options);
    EXPECT_EQ(differing(texture, frame), 0u) << name_of(method);
    EXPECT_EQ(digest(frame), digest(texture)) << name_of(method);
    if (method == Method::flat) {
      EXPECT_LT(frame.counts.shader, texture.counts.shader);
    }
  }
  options.threads = 3;
  EXPECT_EQ(digest(sample.tracer().frame(camera, nullptr, options)), digest(texture));
  options.seed = 2;
  EXPECT_NE(digest(sample.tracer().frame(camera, nullptr, options)), digest(texture));
  options.ambient = most_ambient + 1;
  EXPECT_THROW(sample.tracer().frame(camera, nullptr, options), std::invalid_argument);
}

}  // namespace
}  // namespace mmverify::tests::bitmask_test
