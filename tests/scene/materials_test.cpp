// [release] The figures of materials, level by level, and their pictures.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/bake/any_hit.hpp"
#include "scene/bake/arrays.hpp"
#include "scene/bake/material_figures.hpp"
#include "scene/picture/opacity_picture.hpp"
#include "scene/pipeline.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"

namespace mmverify::tests {
namespace {

using namespace mmverify::scene;
using impl::micromap::Format;
using impl::micromap::State;

constexpr unsigned finest = 5;

struct Sample {
  Scene scene = load("sample", sample_scene());
  Plan plan = mmverify::scene::plan(scene);
  Baked baked(unsigned level) const {
    return bake(scene, plan, std::vector<unsigned>(plan.triangles.size(), level));
  }
};

// A map of four merged children is that of a bake one level coarser, for MASK and BLEND.
TEST(Materials, CoarserFiguresAreThoseOfACoarserBake) {
  Sample sample;
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
    for (Surface& surface : sample.plan.surfaces) surface.mode = mode;
    const MaterialFigures all = total(material_figures(sample.scene, sample.plan, sample.baked(finest)));
    ASSERT_EQ(all.levels.size(), finest + 1);
    for (unsigned n = 0; n <= finest; ++n) {
      const Baked coarse = sample.baked(n);
      EXPECT_NEAR(all.levels[n].unknown, any_hit_shares(sample.scene, sample.plan, coarse).unknown, 1e-12)
          << n;
      // The sides of unknown states may differ, and so whether a map without known states is uniform.
      std::uint64_t maps = 0, bytes = 0, unknown = 0;
      for (const BakedTriangle& t : coarse.triangles) {
        unknown += t.states[0] + t.states[1] == 0 ? 1 : 0;
        if (t.uniform) continue;
        ++maps;
        bytes += t.map.size();
      }
      EXPECT_NEAR(double(all.levels[n].maps), double(maps), n == finest ? 0 : double(unknown)) << n;
      const auto most = static_cast<double>(
          impl::micromap::packed_bytes(impl::micromap::micro_triangles(n), Format::four_state));
      EXPECT_NEAR(double(all.levels[n].bytes), double(bytes), n == finest ? 0 : double(unknown) * most) << n;
    }
  }
}

TEST(Materials, EachHasItsTrianglesAndItsArea) {
  const Sample sample;
  const Baked baked = sample.baked(3);
  const std::vector<MaterialFigures> figures = material_figures(sample.scene, sample.plan, baked);
  ASSERT_GT(figures.size(), 1u);
  std::uint64_t triangles = 0;
  double area = 0;
  for (const MaterialFigures& one : figures) {
    triangles += one.triangles, area += one.area;
    // Its own triangles alone, counted by hand.
    Plan alone = sample.plan;
    std::erase_if(alone.primitives, [&](const PlannedPrimitive& p) {
      return sample.scene.primitives[p.primitive].material != one.material;
    });
    const AnyHitShares shares = any_hit_shares(sample.scene, alone, baked);
    EXPECT_NEAR(one.area, shares.area, 1e-9 * shares.area);
    EXPECT_NEAR(one.levels.back().unknown, shares.unknown, 1e-12);
  }
  EXPECT_EQ(triangles, counts(sample.plan).unique);
  EXPECT_NEAR(area, any_hit_shares(sample.scene, sample.plan, baked).area, 1e-9 * area);
}

TEST(Materials, TheLevelForAShareIsTheCoarsestThatSuffices) {
  MaterialFigures figures;
  figures.levels = {{0, 0, 1.0}, {1, 9, 0.5}, {1, 12, 0.2}, {1, 24, 0.1}};
  EXPECT_EQ(level_for(figures, 1), 0u);
  EXPECT_EQ(level_for(figures, 0.5), 1u);
  EXPECT_EQ(level_for(figures, 0.49), 2u);
  EXPECT_EQ(level_for(figures, 0.1), 3u);
  EXPECT_EQ(level_for(figures, 0.05), std::nullopt);
}

/// One triangle over the lower left half of a white texture, at level 1: children T, O, UT, UO in the curve's order.
struct Drawn {
  Image image{"white", 8, 8, std::vector<std::uint8_t>(64, 255)};
  Surface surface;
  UvTriangle uvs{{{0, 0}, {1, 0}, {0, 1}}};
  BakedTriangle map;
  Drawn() {
    surface.sampler.wrap_u = surface.sampler.wrap_v = Wrap::clamp_to_edge;
    map.level = 1;
    impl::micromap::Bytes packed(1);
    const std::array states{State::T, State::O, State::UT, State::UO};
    impl::micromap::pack(states, Format::four_state, packed);
    map.map = packed;
  }
  /// The colour at a UV; the picture's border is 2 % of the box.
  std::array<int, 3> at(const RgbPicture& picture, double u, double v) const {
    const auto pixel = [](double x, std::uint32_t size) {
      return static_cast<std::size_t>((x + 0.02) / 1.04 * size);
    };
    const std::size_t k = 3 * (pixel(u, picture.width) + picture.width * pixel(v, picture.height));
    return {picture.rgb[k], picture.rgb[k + 1], picture.rgb[k + 2]};
  }
};

TEST(Materials, APictureTintsEachState) {
  const Drawn drawn;
  const RgbPicture picture = opacity_picture(drawn.image, drawn.surface, {{drawn.uvs, drawn.map}}, 256);
  EXPECT_EQ(picture.width, 256u);
  EXPECT_EQ(picture.height, 256u);
  // Child 0 is at vertex 0, child 1 in the middle, child 2 at vertex 1, child 3 at vertex 2.
  const auto blue = drawn.at(picture, 0.1, 0.1), green = drawn.at(picture, 0.35, 0.35);
  EXPECT_LT(blue[0], blue[2]);
  EXPECT_LT(blue[1], blue[2]);
  EXPECT_GT(green[1], green[0]);
  EXPECT_GT(green[1], green[2]);
  for (const auto& orange : {drawn.at(picture, 0.8, 0.1), drawn.at(picture, 0.1, 0.8)}) {
    EXPECT_GT(orange[0], orange[1]);
    EXPECT_GT(orange[1], orange[2]);
  }
  EXPECT_EQ(drawn.at(picture, 0.8, 0.8), (std::array<int, 3>{255, 255, 255})) << "no triangle is there";
}

TEST(Materials, APictureMarksOneMicroTriangle) {
  const Drawn drawn;
  const RgbPicture picture = opacity_picture(drawn.image, drawn.surface, {{drawn.uvs, drawn.map}}, 256, 2);
  const auto red = drawn.at(picture, 0.8, 0.1);
  EXPECT_GT(red[0], 2 * red[1] - 30);
  EXPECT_EQ(red[1], red[2]);
}

// A triangle a thousand repeats away is drawn in the texture.
TEST(Materials, APictureMovesMapsByWholeRepeats) {
  Drawn drawn;
  drawn.surface.sampler.wrap_u = Wrap::repeat;
  drawn.surface.sampler.wrap_v = Wrap::mirrored_repeat;
  const RgbPicture here = opacity_picture(drawn.image, drawn.surface, {{drawn.uvs, drawn.map}}, 64);
  for (Uv& uv : drawn.uvs) uv = {uv[0] + 1000, uv[1] + 1000};
  const RgbPicture there = opacity_picture(drawn.image, drawn.surface, {{drawn.uvs, drawn.map}}, 64);
  EXPECT_EQ(here.rgb, there.rgb);
}

// An odd number of repeats away, a mirrored texture is drawn upside down.
TEST(Materials, APictureKeepsOddRepeatsOfAMirroredTexture) {
  Drawn drawn;
  drawn.surface.sampler.wrap_v = Wrap::mirrored_repeat;
  drawn.uvs[2][1] = 0.875f;  // no pixel's centre lies on an edge
  auto& texels = std::get<0>(drawn.image.alpha);
  for (std::size_t k = 0; k < texels.size(); ++k) texels[k] = static_cast<std::uint8_t>(32 * (k / 8));
  Image flipped = drawn.image;
  auto& alpha = std::get<0>(flipped.alpha);
  for (std::size_t y = 0; y < flipped.height; ++y)
    std::copy_n(&texels[y * flipped.width], flipped.width, &alpha[(flipped.height - 1 - y) * flipped.width]);
  const RgbPicture expected = opacity_picture(flipped, drawn.surface, {{drawn.uvs, drawn.map}}, 64);
  for (Uv& uv : drawn.uvs) uv[1] += 1001;
  const RgbPicture picture = opacity_picture(drawn.image, drawn.surface, {{drawn.uvs, drawn.map}}, 64);
  EXPECT_EQ(picture.rgb, expected.rgb);
}

TEST(Materials, EachMaterialOfThePlanHasAPicture) {
  const Sample sample;
  const Baked baked = sample.baked(2);
  for (const MaterialFigures& one : material_figures(sample.scene, sample.plan, baked))
    EXPECT_TRUE(material_picture(sample.scene, sample.plan, baked, one.material, 64));
  EXPECT_FALSE(material_picture(sample.scene, sample.plan, baked, 10'000, 64));
}

}  // namespace
}  // namespace mmverify::tests
