// [release] scene/attribute/ on real scenes, which lie beside the checkout where there are any.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "scene/attribute/measure.hpp"
#include "scene/read/bad_scene.hpp"

namespace scene_attribute_real_test {

using namespace mmverify::scene;

/// Counted and measured once by a prototype in Python: codes averaged, FLIP by its authors' program on the whole atlas.
struct Measured {
  unsigned level;
  MapKind kind;
  double rmse, flip, of_textures;
};

struct Asset {
  const char* file;
  std::uint64_t triangles, textures;
  double rmse_tolerance, flip_tolerance;
  std::vector<Measured> base_colour;
  friend void PrintTo(const Asset& a, std::ostream* out) { *out << a.file; }
};

class RealAttributes : public testing::TestWithParam<Asset> {};

TEST_P(RealAttributes, AreThoseOfThePrototype) {
  const std::string file = std::string(MMVERIFY_SCENES "/") + GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  AttributeScene scene = load_attributes(file);
  EXPECT_EQ(scene.triangles, GetParam().triangles);
  EXPECT_EQ(scene.textures.size(), GetParam().textures);
  // Only base colours are measured: the others have no FLIP to compare.
  std::vector<AttributePrimitive> kept;
  for (AttributePrimitive& primitive : scene.primitives)
    std::erase_if(primitive.uses, [&](const AttributeUse& use) {
      return !has(scene.textures[use.texture].set, Attribute::base_color);
    });
  std::erase_if(scene.textures,
                [](const AttributeTexture& texture) { return !has(texture.set, Attribute::base_color); });
  unsigned last = 0;
  for (const Measured& due : GetParam().base_colour) last = std::max(last, due.level);
  const AttributeFigures figures = measure(scene, {.first = 0, .last = last, .averaging = Averaging::codes});
  const AttributeSetFigures& set = figures.sets.at(0);
  for (const Measured& due : GetParam().base_colour)
    for (const MapsAtLevel& at : set.levels) {
      if (at.level != due.level || at.kind != due.kind) continue;
      const std::string what =
          (due.kind == MapKind::faces ? "faces " : "vertices ") + std::to_string(due.level);
      if (due.rmse != 0) {
        EXPECT_NEAR(at.error.rmse.value(), due.rmse, GetParam().rmse_tolerance) << what;
      }
      EXPECT_NEAR(at.error.flip.value(), due.flip, GetParam().flip_tolerance) << what;
      EXPECT_NEAR(100 * static_cast<double>(at.bytes()) / static_cast<double>(set.texture_bytes),
                  due.of_textures, 0.01 * due.of_textures + 0.05)
          << what;
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, RealAttributes,
                         testing::Values(Asset{"avocado/Avocado.gltf",
                                               682,
                                               3,
                                               0.02,
                                               0.002,
                                               {{0, MapKind::faces, 19.13, 0.239, 0.02},
                                                {0, MapKind::vertices, 67.36, 0.370, 0.05},
                                                {2, MapKind::faces, 13.48, 0.154, 0.26},
                                                {2, MapKind::vertices, 20.84, 0.187, 0.24},
                                                {3, MapKind::faces, 9.57, 0.107, 1.04},
                                                {3, MapKind::vertices, 9.87, 0.124, 0.73}}},
                                         Asset{"materials_variants_shoe/MaterialsVariantsShoe.gltf",
                                               22700,
                                               3,
                                               0,
                                               0.001,
                                               {{0, MapKind::faces, 0, 0.054, 0.2},
                                                {0, MapKind::vertices, 0, 0.072, 3.4},
                                                {1, MapKind::faces, 0, 0.045, 4.5},
                                                {1, MapKind::vertices, 0, 0.063, 8.3},
                                                {2, MapKind::faces, 0, 0.030, 22},
                                                {2, MapKind::vertices, 0, 0.043, 21}}}));

TEST(RealAttributesMissing, AreNamed) {
  // Its folder has not the textures of the leather parts.
  const std::string file = MMVERIFY_SCENES "/flight_helmet/FlightHelmet.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  try {
    load_attributes(file);
    FAIL();
  } catch (const BadScene& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("LeatherPartsMat_BaseColor.png"));
    EXPECT_THAT(error.what(), testing::HasSubstr("is the folder complete?"));
  }
}

}  // namespace scene_attribute_real_test
