// [release] Hits that blend, by Embree.  Without Embree skipped, and so said.
#include "display/render/blend.hpp"

#include <gtest/gtest.h>

#include "display/render/picture.hpp"
#include "display/render/scene/colours_of.hpp"
#include "display/render/scene/compare.hpp"
#include "proofs/traverse/rays/sample_world.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "tests/render/needs_embree.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::render;
using impl::traverse::Operation;
using proofs::traverse::SampleWorld;

/// Panes across the z axis at z = -1, -2, -3, the middle one a wall without a surface.
struct Panes {
  std::vector<std::uint8_t> texel{255};
  World world;
  ColourMaps colours{ColoursOf::faces, 0, 3};
  Panes() {
    world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{texel.data(), 1, 1, 1},
                                impl::bake::Sampling{}, impl::bake::AlphaMode(impl::bake::Mask{}));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const float z = -1.0f - static_cast<float>(k);
      Geometry pane;
      pane.positions = {{-9, -9, z}, {9, -9, z}, {0, 9, z}};
      pane.triangles = {{0, 1, 2}};
      pane.uvs.resize(3);
      if (k != 1) {
        pane.surface = 0;
        colours.give(k, {colours.add(std::array<std::uint32_t, 1>{k == 0 ? 0xff102030u : 0xff405060u})});
      }
      world.geometries.push_back(pane);
    }
    world.meshes = {{0, 1, 2}};
    world.instances.push_back({});
  }
};

TEST(Blend, EndsAtTheWall) {
  NEEDS_EMBREE;
  const Panes panes;
  const Tracer tracer(panes.world);
  const BlendFrame frame =
      tracer.blend_frame(Camera{}, nullptr, {.colours = &panes.colours}, {.width = 1, .height = 1});
  EXPECT_EQ(frame.pixels[0].payload, 0xff102030u) << "of the pane before the wall alone";
  EXPECT_EQ(frame.pixels[0].accepted.geometry, 1u);
  // The tracer may meet the pane behind the wall first.
  EXPECT_TRUE(frame.pixels[0].as_met == 0xff102030u || frame.pixels[0].as_met == 0xff405060u);
}

// Some panes behind the wall are met before it, whatever order a tracer takes; none of them is seen.
TEST(Blend, SeesNothingBehindTheWall) {
  NEEDS_EMBREE;
  constexpr std::uint32_t count = 64, wall = 23;
  std::vector<std::uint8_t> texel{255};
  World world;
  world.surfaces.emplace_back(impl::bake::TexelView<std::uint8_t>{texel.data(), 1, 1, 1},
                              impl::bake::Sampling{}, impl::bake::AlphaMode(impl::bake::Mask{}));
  ColourMaps colours{ColoursOf::faces, 0, count};
  Geometry panes, wall_alone;
  for (std::uint32_t k = 0; k < count; ++k) {
    // Panes behind the wall are turned so far that their boxes begin before all others.
    const std::uint32_t place = count - 1 - k;
    const float z = -1.0f - static_cast<float>(place), turned = place > wall ? -z : 0.0f;
    const std::array<Point, 3> corners{Point{-90, -90, z - turned}, Point{90, -90, z + turned},
                                       Point{0, 90, z}};
    Geometry& one = place == wall ? wall_alone : panes;
    const auto from = static_cast<std::uint32_t>(one.positions.size());
    one.positions.insert(one.positions.end(), corners.begin(), corners.end());
    one.triangles.push_back({from, from + 1, from + 2});
    one.uvs.resize(one.positions.size());
  }
  panes.surface = 0;
  world.geometries = {panes, wall_alone};
  world.meshes = {{0, 1}};
  world.instances.push_back({});
  colours.give(0,
               std::vector<std::uint32_t>(count - 1, colours.add(std::array<std::uint32_t, 1>{0x00000001u})));
  const BlendFrame frame = Tracer(world).blend_frame(
      Camera{}, nullptr, {.operation = Operation::add, .colours = &colours}, {.width = 1, .height = 1});
  EXPECT_EQ(frame.pixels[0].payload, wall) << "one of each pane before the wall";
  EXPECT_GT(frame.pixels[0].as_met, wall) << "the test has to meet some behind it";
}

TEST(Blend, GoesThroughWhatBlends) {
  NEEDS_EMBREE;
  Panes panes;
  panes.world.meshes = {{0, 2}};
  const Tracer tracer(panes.world);
  const auto payload = [&](Operation o) {
    return tracer
        .blend_frame(Camera{}, nullptr, {.operation = o, .colours = &panes.colours},
                     {.width = 1, .height = 1})
        .pixels[0];
  };
  EXPECT_EQ(payload(Operation::max).payload, 0xff405060u);
  EXPECT_EQ(payload(Operation::min).payload, 0xff102030u);
  EXPECT_EQ(payload(Operation::add).payload, 0xff507090u);
  EXPECT_FALSE(payload(Operation::add).accepted.hit());
}

TEST(Blend, OfAGeometryWithoutMapsIsGrey) {
  NEEDS_EMBREE;
  Panes panes;
  panes.world.meshes = {{0}};
  const Tracer tracer(panes.world);
  const BlendFrame frame = tracer.blend_frame(Camera{}, nullptr, {}, {.width = 1, .height = 1});
  EXPECT_EQ(frame.pixels[0].payload, grey_of(0));
}

TEST(Blend, SavesCallsAndChangesNoPixel) {
  NEEDS_EMBREE;
  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  const scene::Plan plan = scene::plan(scene);
  const SceneWorld world = world_of(scene, scene::load_uses("sample", bytes), plan);
  const Tracer tracer(world.world);
  const ColourMaps colours =
      colours_of(scene, world, scene::load_attributes("sample", bytes), ColoursOf::faces, 2);
  for (const Operation o : {Operation::max, Operation::min, Operation::add}) {
    CompareOptions options{.first = 3, .last = 4, .wanted = {Method::flat, Method::ranked, Method::vq2}};
    options.trace = {.width = 80, .height = 60};
    options.blending = Blending{.operation = o, .colours = &colours};
    const Compared all =
        compare(scene, plan, world, tracer, overview(box_of(world.world, true), 4.0f / 3), options);
    ASSERT_EQ(all.blends.size(), 1u + 2 * 5);
    const BlendFigures& texture = all.blends.front();
    EXPECT_EQ(texture.counts.shader, texture.counts.candidates);
    for (const BlendFigures& b : all.blends) {
      EXPECT_EQ(b.differing, 0u) << name_of(b.method);
      EXPECT_EQ(b.counts.candidates, texture.counts.candidates);
      EXPECT_EQ(b.counts.ignored + b.counts.opaque + b.counts.shader, b.counts.candidates);
      if (b.method == Method::texture) continue;
      EXPECT_EQ(b.counts.opaque == 0, b.by == BlendedBy::shader);
      EXPECT_GT(b.saved, 0) << name_of(b.method);
    }
    // The same maps: fixed functions save the calls that they make, and no other.
    for (std::size_t k = 1; k < all.blends.size(); k += 2)
      EXPECT_EQ(all.blends[k].counts.shader,
                all.blends[k + 1].counts.shader + all.blends[k + 1].counts.opaque);
  }
}

TEST(Blend, IsTheSameForAnyNumberOfThreads) {
  NEEDS_EMBREE;
  const SampleWorld& sample = SampleWorld::get();
  const Camera camera = on_path(sample.box(), 5, 3, 1);
  const Blending blending{.colours = &sample.colours()};
  const BlendFrame one = sample.tracer().blend_frame(camera, sample.opacity(Method::ranked, 3), blending,
                                                     {.width = 61, .height = 47, .threads = 1}),
                   five = sample.tracer().blend_frame(camera, sample.opacity(Method::ranked, 3), blending,
                                                      {.width = 61, .height = 47, .threads = 5});
  EXPECT_EQ(differing(one, five), 0u);
  EXPECT_EQ(one.counts, five.counts);
  EXPECT_EQ(spoiled_as_met(one), spoiled_as_met(five));
  EXPECT_GT(one.counts.opaque, 0u);
  EXPECT_THROW(static_cast<void>(differing(one, BlendFrame{})), std::invalid_argument);
}

TEST(Blend, PictureShowsTheGreaterCode) {
  Panes panes;
  BlendFrame frame{1, 1, {{}}, {}, 0, 0};
  frame.pixels[0].payload = 0xff0a0b0c;
  const Picture dark = blended(panes.world, frame, {.operation = Operation::max});
  EXPECT_EQ(dark.rgb, (std::vector<std::uint8_t>{12, 11, 10}));
  frame.pixels[0].accepted = {1, 0, 0, 0};
  frame.pixels[0].shade = 1;
  const Picture lit = blended(panes.world, frame, {.operation = Operation::max, .colours = &panes.colours});
  EXPECT_EQ(lit.rgb, (std::vector<std::uint8_t>{0x30, 0x20, 0x10})) << "brighter than the payload";
}

}  // namespace
