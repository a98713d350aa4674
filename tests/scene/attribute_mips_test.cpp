// [release] Mips of textures beside those of maps: charts, their borders, what bleeds across them and what does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "scene/attribute/charts.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/attribute/picture.hpp"

namespace scene_attribute_mips_test {

using namespace mmverify::scene;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Optional;

constexpr AttributeSet colours = set_of(Attribute::base_color);

// --- Charts ----------------------------------------------------------------------------------------------------------

TEST(Charts, AreTrianglesWithCommonEdges) {
  const Uv a{0, 0}, b{1, 0}, c{0, 1}, d{1, 1}, minus{-0.0f, 0}, far{3, 3}, farther{4, 3};
  EXPECT_THAT(charts_of(std::vector<UvTriangle>{{a, b, c}, {d, c, b}}), ElementsAre(0, 0));
  EXPECT_THAT(charts_of(std::vector<UvTriangle>{{a, b, c}, {b, minus, far}}), ElementsAre(0, 0));
  // A corner in common is no edge; and the third triangle joins what the first two are.
  EXPECT_THAT(charts_of(std::vector<UvTriangle>{{a, b, c}, {d, far, b}}), ElementsAre(0, 1));
  EXPECT_THAT(charts_of(std::vector<UvTriangle>{{a, b, c}, {d, far, b}, {b, c, d}, {far, farther, a}}),
              ElementsAre(0, 0, 0, 1));
  EXPECT_TRUE(charts_of({}).empty());
}

TEST(Bands, AreByDistance) {
  constexpr std::uint32_t x = no_chart;
  const std::vector<std::uint32_t> row{0, 0, 0, 0, 0, 0, 0, 1, 1, x, 2};
  // From 1 the zeros are 7, 6 ... 1 away; the ones and the two lie beside another.
  EXPECT_THAT(bands_of(row, 11, 1, 1), ElementsAre(2, 2, 2, 2, 2, 1, 0, 0, 0, no_band, 0));
  EXPECT_THAT(bands_of(row, 11, 1, 3), ElementsAre(3, 3, 3, 2, 2, 1, 0, 0, 0, no_band, 0));
  // Without a border nothing is near one: the image's own is none.
  EXPECT_THAT(bands_of(std::vector<std::uint32_t>(4, 5), 2, 2, 0), ElementsAre(1, 1, 1, 1));
}

TEST(Bands, AreThoseOfTheNearestOtherTexel) {
  std::mt19937 engine(3);
  constexpr unsigned last = 3;
  for (int k = 0; k < 40; ++k) {
    const auto width = static_cast<std::uint32_t>(5 + engine() % 20),
               height = static_cast<std::uint32_t>(1 + engine() % 20);
    std::vector<std::uint32_t> charts(std::size_t{width} * height, 0);
    for (unsigned spot = engine() % 4; spot-- > 0;)
      charts[engine() % charts.size()] = engine() % 2 == 0 ? no_chart : 1;
    const std::vector<std::uint8_t> bands = bands_of(charts, width, height, last);
    for (std::size_t t = 0; t < charts.size(); ++t) {
      unsigned nearest = 1u << 20;
      for (std::size_t o = 0; o < charts.size(); ++o) {
        const auto across = std::abs(static_cast<int>(t % width) - static_cast<int>(o % width)),
                   down = std::abs(static_cast<int>(t / width) - static_cast<int>(o / width));
        if (charts[o] != charts[t])
          nearest = std::min(nearest, static_cast<unsigned>(std::max(across, down)));
      }
      unsigned band = 0;
      while (band <= last && nearest > 1u << band) ++band;
      ASSERT_EQ(bands[t], charts[t] == no_chart ? no_band : band) << width << "x" << height << ", " << t;
    }
  }
}

// --- Mips of maps ----------------------------------------------------------------------------------------------------

TEST(MipOfMap, OfFacesIsTheMeanOfFour) {
  const auto grey = [](std::uint8_t c) { return MapValue{c, c, c, 0}; };
  constexpr std::uint8_t base[] = {0, 0, 0, 255, 10, 20, 30, 40, 7, 7, 7, 7, 0, 0, 255, 255};
  std::vector<MapValue> map;
  for (const std::uint8_t code : base) map.push_back(grey(code));
  const CodeMeaning codes(colours, Averaging::codes), light(colours, Averaging::meaning);
  // 63.75, 25, 7, 127.5; and 64, 25, 7, 128 are 56.
  EXPECT_THAT(mip_of_map(map, MapKind::faces, 2, 1, codes),
              ElementsAre(grey(64), grey(25), grey(7), grey(128)));
  EXPECT_THAT(mip_of_map(map, MapKind::faces, 2, 0, codes), ElementsAre(grey(56)));
  EXPECT_EQ(mip_of_map(map, MapKind::faces, 2, 2, codes), map);
  // A quarter and a half of the light are codes 137 and 188.
  const std::vector<MapValue> lit = mip_of_map(map, MapKind::faces, 2, 1, light);
  EXPECT_EQ(lit[0], grey(137));
  EXPECT_EQ(lit[3], grey(188));
}

ColourImage random_image(std::uint32_t side) {
  std::mt19937 engine(11);
  ColourImage image{"random", side, side, {}};
  for (std::uint32_t k = 0; k < 4 * side * side; ++k)
    image.rgba.push_back(static_cast<std::uint8_t>(engine() & 255));
  return image;
}

TEST(MipOfMap, OfVerticesIsTheMapOfTheLowerLevel) {
  const ColourImage image = random_image(16);
  const MapBaker baker(image, {colours, 0, {}}, Averaging::meaning);
  const UvTriangle uvs{{{0.125f, 0.25f}, {0.875f, 0.0f}, {0.5f, 1.0f}}};
  std::vector<MapValue> finest(values_of_map(MapKind::vertices, 4));
  baker.bake(uvs, MapKind::vertices, 4, finest);
  for (unsigned level = 0; level <= 4; ++level) {
    std::vector<MapValue> own(values_of_map(MapKind::vertices, level));
    baker.bake(uvs, MapKind::vertices, level, own);
    EXPECT_EQ(mip_of_map(finest, MapKind::vertices, 4, level, baker.meaning()), own) << level;
  }
}

// --- What bleeds -----------------------------------------------------------------------------------------------------

Sampler clamped() {
  Sampler sampler;
  sampler.wrap_u = sampler.wrap_v = Wrap::clamp_to_edge;
  return sampler;
}

/// 8x8 texels: a white chart of columns 0 to 3, a gutter of one column, a black chart of columns 5 to 7.  Two triangles
/// each.
AttributeScene two_charts(AttributeSet set, std::uint8_t gutter) {
  AttributeScene scene;
  scene.file = "two charts";
  ColourImage image{"atlas", 8, 8, {}};
  for (std::uint32_t k = 0; k < 64; ++k) {
    const std::uint8_t code = k % 8 < 4 ? 255 : k % 8 == 4 ? gutter : 0;
    image.rgba.insert(image.rgba.end(), {code, code, code, 255});
  }
  scene.images.push_back(image);
  scene.textures.push_back({set, 0, clamped()});
  scene.primitives.push_back(
      {0,
       0,
       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}},
       {{0, {{0, 0}, {0.5f, 0}, {0.5f, 1}, {0, 1}, {0.625f, 0}, {1, 0}, {1, 1}, {0.625f, 1}}}}});
  scene.triangles = 4;
  return scene;
}

std::vector<MipStep> steps_of(const AttributeScene& scene, AttributeOptions options) {
  MipErrors mips(options);
  options.atlas = [&mips](const AttributeAtlas& atlas) { mips.take(atlas); };
  measure(scene, options);
  return mips.steps();
}

TEST(MipErrors, TexturesBleedAndFacesDoNot) {
  const AttributeScene scene = two_charts(colours, 0);
  const std::vector<MipStep> steps = steps_of(scene, {.first = 1, .last = 2, .averaging = Averaging::codes});
  ASSERT_EQ(steps.size(), 2u);
  // 56 texels are shown; beside the gutter are columns 3 and 5, within two texels 2, 3, 5 and 6.
  EXPECT_DOUBLE_EQ(steps[0].border_share, 16.0 / 56);
  EXPECT_DOUBLE_EQ(steps[1].border_share, 32.0 / 56);
  // Mip 0 is the texture.  Of mip 1 columns 4 and 5 are one black texel, of which column 3 takes a quarter: 191.
  EXPECT_EQ(steps[0].texture.all.rmse, 0);
  EXPECT_THAT(steps[0].texture.all.flip, Optional(0.0));
  EXPECT_NEAR(steps[1].texture.all.rmse.value(), std::sqrt(8 * 64.0 * 64 / 56), 1e-9);
  EXPECT_THAT(steps[1].texture.border, Optional(DoubleNear(32, 1e-9)));
  EXPECT_THAT(steps[1].texture.interior, Optional(0.0));
  EXPECT_GT(*steps[1].texture.all.flip, 0);
  // Faces: 4 x 16 and 4 x 4 of 56, each on one colour.
  EXPECT_EQ(steps[0].faces.level, 2u);
  EXPECT_EQ(steps[1].faces.level, 1u);
  EXPECT_DOUBLE_EQ(steps[1].faces.values_per_texel, 16.0 / 56);
  for (const MipStep& step : steps) {
    EXPECT_EQ(step.faces.error.all.rmse, 0);
    EXPECT_THAT(step.faces.error.all.flip, Optional(0.0));
    EXPECT_THAT(step.faces.error.border, Optional(0.0));
    EXPECT_THAT(step.faces.error.interior, Optional(0.0));
  }
  // Vertices on the white chart's edge, x = 4, read the gutter: 128.  At level 2 column 3 is halfway from x = 3: 192.
  // At level 1 columns 3 and 2 are 3/4 and 1/4 of the way from x = 2: 160 and 223.
  EXPECT_EQ(steps[0].vertices.level, 2u);
  EXPECT_EQ(steps[1].vertices.level, 1u);
  EXPECT_DOUBLE_EQ(steps[1].vertices.values_per_texel, 24.0 / 56);
  EXPECT_THAT(steps[0].vertices.error.border, Optional(DoubleNear(std::sqrt(8 * 63.0 * 63 / 16), 1e-9)));
  EXPECT_THAT(steps[1].vertices.error.border,
              Optional(DoubleNear(std::sqrt(8 * (95.0 * 95 + 32 * 32) / 32), 1e-9)));
  EXPECT_THAT(steps[0].vertices.error.interior, Optional(0.0));
  EXPECT_THAT(steps[1].vertices.error.interior, Optional(0.0));
}

TEST(Bleeding, HasSmallestCases) {
  const ColourImage image{"chart and background", 2, 1, {255, 255, 255, 255, 0, 0, 0, 255}};
  const MapBaker baker(image, {colours, 0, clamped()}, Averaging::codes);
  const auto first_code = [&](const UvTriangle& uvs, MapKind kind, std::size_t which) {
    std::vector<MapValue> map(values_of_map(kind, 0));
    baker.bake(uvs, kind, 0, map);
    return map[which][0];
  };
  // The triangle lies on the first texel alone; its second corner lies between both.
  const UvTriangle within{{{0, 0}, {0.5f, 0}, {0, 1}}};
  EXPECT_EQ(first_code(within, MapKind::faces, 0), 255);
  EXPECT_EQ(first_code(within, MapKind::vertices, 1), 128);
  // 1/12 of its 3/4 lies on the second texel.
  EXPECT_EQ(first_code({{{0, 0}, {0.75f, 0}, {0, 1}}}, MapKind::faces, 0), 227);
}

TEST(MipErrors, LightBleedsAsLight) {
  const std::vector<MipStep> steps = steps_of(two_charts(colours, 0), {.first = 1, .last = 2});
  // Three quarters of the light are code 225: 30 less than white.
  EXPECT_THAT(steps[1].texture.border, Optional(DoubleNear(15, 1e-9)));
  EXPECT_THAT(steps[1].texture.interior, Optional(0.0));
  EXPECT_EQ(steps[1].faces.error.all.rmse, 0);
}

TEST(MipErrors, OfNormalsHaveNoFlip) {
  const std::vector<MipStep> steps =
      steps_of(two_charts(set_of(Attribute::normal), 128), {.first = 0, .last = 1});
  for (const MipStep& step : steps) EXPECT_FALSE(step.texture.all.flip || step.faces.error.all.flip);
  EXPECT_EQ(steps[0].texture.all.rmse, 0);
}

TEST(MipErrors, AreOfTheChannelsInUse) {
  AttributeScene scene = two_charts(set_of(Attribute::metallic_roughness), 0);
  for (std::size_t k = 0; k < scene.images[0].rgba.size(); k += 4) {
    scene.images[0].rgba[k] = static_cast<std::uint8_t>(k);
    scene.images[0].rgba[k + 1] = 9;
  }
  // Roughness and metalness are green and blue. Only blue differs, and it bleeds as the codes in the first test.
  const std::vector<MipStep> steps = steps_of(scene, {.first = 1, .last = 2});
  EXPECT_THAT(steps[1].texture.border, Optional(DoubleNear(32 / std::sqrt(2.0), 1e-9)));
  EXPECT_EQ(steps[1].faces.error.all.rmse, 0);
}

TEST(MipErrors, WithoutABorderHaveNoneThere) {
  AttributeScene scene = two_charts(colours, 0);
  scene.primitives[0].triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.primitives[0].uses[0].uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const MipStep& step : steps_of(scene, {.first = 0, .last = 2})) {
    EXPECT_EQ(step.border_share, 0);
    EXPECT_FALSE(step.texture.border);
    EXPECT_THAT(step.texture.interior, Optional(step.texture.all.rmse.value()));
  }
}

TEST(MipErrors, TellOfPicturesWhoseBordersShow) {
  const AttributeScene scene = two_charts(colours, 0);
  AttributeOptions options{.first = 1, .last = 2, .averaging = Averaging::codes};
  std::vector<RgbPicture> pictures;
  MipErrors mips(options, [&](const MipPicture& picture) {
    EXPECT_EQ(picture.mip, pictures.size());
    pictures.push_back(side_by_side(picture, 8));
  });
  options.atlas = [&mips](const AttributeAtlas& atlas) { mips.take(atlas); };
  measure(scene, options);
  ASSERT_EQ(pictures.size(), 2u);
  const RgbPicture& mip1 = pictures[1];
  ASSERT_EQ(mip1.width, 3 * 8u + 2 * 4);
  ASSERT_EQ(mip1.height, 2 * 8u + 4);
  const auto red = [&](std::size_t tile, std::size_t row, std::size_t x, std::size_t y) {
    return mip1.rgb[3 * (tile * 12 + x + (row * 12 + y) * mip1.width)];
  };
  // Above: column 3 of the texture's mip, of faces and of vertices.  Below: the gutter is grey, and faces have no error.
  EXPECT_EQ(red(0, 0, 3, 4), 191);
  EXPECT_EQ(red(1, 0, 3, 4), 255);
  EXPECT_EQ(red(2, 0, 3, 4), 160);
  for (const std::size_t tile : {0u, 1u, 2u}) EXPECT_EQ(red(tile, 1, 4, 4), 96);
  EXPECT_EQ(red(1, 1, 3, 4), 0);
  EXPECT_GT(red(2, 1, 3, 4), 0);
}

TEST(MipErrors, StopWhereTheyAreTold) {
  const AttributeScene scene = two_charts(colours, 0);
  unsigned asked = 0;
  AttributeOptions options{.first = 1, .last = 2, .threads = 1};
  options.stop = [&asked] {
    if (++asked == 2) throw std::runtime_error("enough");
  };
  EXPECT_THROW(steps_of(scene, options), std::runtime_error);
  EXPECT_EQ(asked, 2u);
}

}  // namespace scene_attribute_mips_test
