// [release] Plans of a scene's triangles: which need no map, which level each has, and what that takes; by hand and beside measure().
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "scene/attribute/planned_maps.hpp"

namespace scene_attribute_plan_test {

using namespace mmverify::scene;

/// A picture whose red channel is code(x, y).
template <class Code>
ColourImage picture(std::uint32_t side, Code code) {
  ColourImage image{"picture", side, side, {}};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::uint32_t c = 0; c < 4; ++c)
        image.rgba.push_back(c == 0 ? static_cast<std::uint8_t>(code(x, y)) : 0);
  return image;
}

/// Occlusion is red alone, and linear; clamped, so that a corner reads no texel of the other side.
AttributeScene scene_of(ColourImage image, std::vector<Triangle> triangles, std::vector<Uv> uvs,
                        Attribute attribute = Attribute::occlusion) {
  AttributeScene scene;
  scene.file = "plan";
  scene.images.push_back(std::move(image));
  Sampler sampler;
  sampler.wrap_u = sampler.wrap_v = Wrap::clamp_to_edge;
  scene.textures.push_back({set_of(attribute), 0, sampler});
  scene.triangles = triangles.size();
  scene.primitives.push_back({0, 0, std::move(triangles), {{0, std::move(uvs)}}});
  return scene;
}

PlannedMaps planned(const AttributeScene& scene, double wanted, unsigned first = 0, unsigned last = 5,
                    MapKind kind = MapKind::vertices) {
  const std::vector<PlannedMaps> all =
      planned_maps(scene, {.first = first, .last = last}, std::vector{wanted});
  EXPECT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].kind, MapKind::faces);
  EXPECT_EQ(all[1].kind, MapKind::vertices);
  return all[kind == MapKind::faces ? 0 : 1];
}

std::vector<std::uint64_t> by_level(const PlannedMaps& plan, std::uint64_t PlannedLevel::*what) {
  std::vector<std::uint64_t> all;
  for (const PlannedLevel& at : plan.levels) all.push_back(at.*what);
  return all;
}

std::uint32_t checker(std::uint32_t x, std::uint32_t y) { return (x + y) % 2 * 255; }

using testing::ElementsAre;

TEST(PlannedMaps, OfAConstantHalfAreOneValue) {
  // Texels 0..7 are 100.  Two triangles lie on them, left of the middle of texel 7; the third on the checkerboard.
  const AttributeScene scene =
      scene_of(picture(16, [](auto x, auto y) { return x < 8 ? 100 : checker(x, y); }),
               {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}},
               {{0, 0}, {7 / 16.0f, 0}, {0, 1}, {7 / 16.0f, 1}, {0.75f, 0}, {1, 0}, {0.75f, 0.25f}});
  const PlannedMaps plan = planned(scene, 0);
  EXPECT_EQ(plan.triangles, 3u);
  EXPECT_EQ(plan.special, 2u);
  EXPECT_EQ(plan.palette, 1u);
  EXPECT_EQ(plan.maps(), 1u);
  EXPECT_EQ(plan.not_kept, 0u);
  EXPECT_EQ(plan.distinct(), 1u);
  // The third triangle has 4 texels a side, as in the checkerboard test below.
  EXPECT_THAT(by_level(plan, &PlannedLevel::planned), ElementsAre(0, 0, 0, 1, 0, 0));
}

TEST(PlannedMaps, OfAConstantTextureTakeAPaletteOfOneValue) {
  const AttributeScene scene = scene_of(picture(4, [](auto, auto) { return 7; }), {{0, 1, 2}, {2, 1, 3}},
                                        {{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  const PlannedMaps plan = planned(scene, 0);
  EXPECT_EQ(plan.special, 2u);
  EXPECT_EQ(plan.value_bytes(), 4u);
  EXPECT_EQ(plan.error.rmse, 0);
  EXPECT_THAT(by_level(plan, &PlannedLevel::planned), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST(PlannedMaps, OfACheckerboardNeedTheLevelWhoseVerticesAreItsTexels) {
  // 4 x 4 texels: centres are vertices from level 3 on; below, all vertices but those on the border lie between four.
  const AttributeScene scene = scene_of(picture(4, checker), {{0, 1, 2}}, {{0, 0}, {1, 0}, {0, 1}});
  const PlannedMaps exact = planned(scene, 0);
  EXPECT_THAT(by_level(exact, &PlannedLevel::lowest), ElementsAre(0, 0, 0, 1, 0, 0));
  EXPECT_THAT(by_level(exact, &PlannedLevel::planned), ElementsAre(0, 0, 0, 1, 0, 0));
  EXPECT_EQ(exact.error.rmse, 0);
  EXPECT_EQ(exact.value_bytes(), 45u * 4);
  // Half of ten texels is 0, half 255: one value in the middle is off by 127 and a half.
  EXPECT_EQ(planned(scene, 128).special, 1u);
  EXPECT_EQ(planned(scene, 127).special, 0u);
  // The last measured level does not keep the error where the level that would is not measured.
  const PlannedMaps coarse = planned(scene, 0, 0, 2);
  EXPECT_THAT(by_level(coarse, &PlannedLevel::planned), ElementsAre(0, 0, 1));
  EXPECT_EQ(coarse.not_kept, 1u);
  // And none below the first has it.
  EXPECT_THAT(by_level(planned(scene, 0, 4, 5), &PlannedLevel::planned), ElementsAre(1, 0));
}

/// Two triangles of 8 x 8 texels with a diagonal between: one shows a checkerboard and needs level 4, the other a ramp,
/// 10 a texel, which level 0 keeps to within 5.  The checkerboard ends `margin` texels before the diagonal.
AttributeScene two_triangles(std::uint32_t margin) {
  return scene_of(picture(8, [=](auto x, auto y) { return x + y + margin < 7 ? checker(x + 1, y) : 10 * x; }),
                  {{0, 1, 2}, {2, 1, 3}}, {{0, 0}, {1, 0}, {0, 1}, {1, 1}});
}

TEST(PlannedMaps, OfNeighboursDifferByOneAndTheFinerEdgeIsDecimated) {
  // The decimated values on the diagonal are means of 10 k and 10 (k + 1); at its two ends they are off by less than 5.
  const PlannedMaps plan = planned(two_triangles(1), 5);
  EXPECT_EQ(plan.special, 0u);
  EXPECT_EQ(plan.not_kept, 0u);
  EXPECT_THAT(by_level(plan, &PlannedLevel::lowest), ElementsAre(1, 0, 0, 0, 1, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::planned), ElementsAre(0, 0, 0, 1, 1, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::decimated), ElementsAre(0, 0, 0, 0, 1, 0));
  EXPECT_EQ(plan.value_bytes(), (45u + 153) * 4);
  EXPECT_LE(plan.error.rmse.value(), 5);
  EXPECT_GT(plan.error.rmse.value(), 0);
}

TEST(PlannedMaps, OfANeighbourAreRaisedWhereADecimatedEdgeBreaksTheError) {
  // Next to the diagonal the checkerboard is 255, and a quarter of each value between two texels: about 55 off, of 8
  // texels of 36.
  const PlannedMaps plan = planned(two_triangles(0), 5);
  EXPECT_THAT(by_level(plan, &PlannedLevel::lowest), ElementsAre(1, 0, 0, 0, 1, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::planned), ElementsAre(0, 0, 0, 0, 2, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::decimated), ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(plan.error.rmse, 0);
}

TEST(PlannedMaps, OfFacesNeedTheLevelWhoseFacesLieWithinTexels) {
  // 4 x 4 texels: from level 2 on each face is half of a texel, or less.
  const AttributeScene scene = scene_of(picture(4, checker), {{0, 1, 2}}, {{0, 0}, {1, 0}, {0, 1}});
  const PlannedMaps exact = planned(scene, 0, 0, 5, MapKind::faces);
  EXPECT_THAT(by_level(exact, &PlannedLevel::planned), ElementsAre(0, 0, 1, 0, 0, 0));
  EXPECT_EQ(exact.error.rmse, 0);
  EXPECT_EQ(exact.value_bytes(), 16u * 4);
  // One value, the mean, is level 0's, too.
  EXPECT_EQ(planned(scene, 128, 0, 5, MapKind::faces).special, 1u);
}

TEST(PlannedMaps, OfFacesBindNoNeighbour) {
  // The checkerboard needs level 3.  Of the ramp level 2 has faces of half of 2 x 2 texels, off by 3 and 8, 4.2 on average;
  // level 1 has 11.
  const PlannedMaps plan = planned(two_triangles(1), 5, 0, 5, MapKind::faces);
  EXPECT_THAT(by_level(plan, &PlannedLevel::lowest), ElementsAre(0, 0, 1, 1, 0, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::planned), ElementsAre(0, 0, 1, 1, 0, 0));
  EXPECT_THAT(by_level(plan, &PlannedLevel::decimated), ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(plan.value_bytes(), (16u + 64) * 4);
}

TEST(PlannedMaps, OfTrianglesWithoutCommonVerticesAreNotGraded) {
  AttributeScene scene = two_triangles(0);
  AttributePrimitive& primitive = scene.primitives.front();
  primitive.triangles[1] = {4, 5, 3};
  primitive.uses[0].uvs.push_back({0, 1});
  primitive.uses[0].uvs.push_back({1, 0});
  EXPECT_THAT(by_level(planned(scene, 5), &PlannedLevel::planned), ElementsAre(1, 0, 0, 0, 1, 0));
}

ColourImage noise() {
  std::mt19937 engine(5);
  ColourImage image{"noise", 16, 16, {}};
  for (std::size_t k = 0; k < std::size_t{4} * 16 * 16; ++k)
    image.rgba.push_back(static_cast<std::uint8_t>(engine() & 255));
  return image;
}

TEST(PlannedMaps, OfOneLevelAreThoseThatAreMeasured) {
  // Three triangles, two of them equal, of noise: none is constant, and with one level there is nothing to grade.
  for (const Attribute attribute : {Attribute::base_color, Attribute::normal, Attribute::metallic_roughness})
    for (const unsigned level : {0u, 2u, 3u}) {
      const AttributeScene scene =
          scene_of(noise(), {{0, 1, 2}, {2, 1, 3}, {0, 1, 2}}, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, attribute);
      const AttributeFigures figures = measure(scene, {.first = level, .last = level});
      for (const MapsAtLevel& uniform : figures.sets.front().levels) {
        const PlannedMaps plan = planned(scene, 0, level, level, uniform.kind);
        EXPECT_EQ(plan.distinct(), 2u);
        EXPECT_EQ(plan.value_bytes(), uniform.bytes());
        EXPECT_EQ(plan.not_kept, 3u);
        EXPECT_DOUBLE_EQ(plan.error.rmse.value(), uniform.error.rmse.value());
        EXPECT_EQ(plan.error.flip.has_value(), attribute == Attribute::base_color);
        EXPECT_DOUBLE_EQ(plan.error.flip.value_or(0), uniform.error.flip.value_or(0));
      }
    }
}

TEST(PlannedMaps, AreOnePlanASetAKindAndAnError) {
  const AttributeScene scene = scene_of(noise(), {{0, 1, 2}}, {{0, 0}, {1, 0}, {0, 1}});
  const std::vector<PlannedMaps> all = planned_maps(scene, {.first = 0, .last = 3}, std::vector{3.0, 0.0});
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(all[k].kind, k < 2 ? MapKind::faces : MapKind::vertices);
    EXPECT_EQ(all[k].wanted, k % 2 == 0 ? 3 : 0);
  }
}

TEST(PlannedMaps, RefuseWhatIsOutsideTheirDomain) {
  const AttributeScene scene = scene_of(noise(), {{0, 1, 2}}, {{0, 0}, {1, 0}, {0, 1}});
  EXPECT_THROW(planned_maps(scene, {.first = 2, .last = 1}, std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(planned_maps(scene, {.first = 0, .last = 11}, std::vector{1.0}), std::invalid_argument);
  EXPECT_THROW(planned_maps(scene, {}, std::vector{-1.0}), std::invalid_argument);
  const AttributeOptions stopped{.first = 0, .last = 1, .stop = [] { throw std::runtime_error("stop"); }};
  EXPECT_THROW(planned_maps(scene, stopped, std::vector{1.0}), std::runtime_error);
}

}  // namespace scene_attribute_plan_test
