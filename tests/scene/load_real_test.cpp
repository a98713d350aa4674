// scene/: real scenes, which lie beside the checkout where there are any.
#include <gtest/gtest.h>

#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/read/triangles.hpp"
#include "tests/complaint.hpp"
#include "tests/folder.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;

/// A line of the table in the folder's README.
struct RealScene {
  const char* file;
  TriangleCounts all, masked;
  std::size_t mask_materials, alpha_textures;

  friend void PrintTo(const RealScene& s, std::ostream* out) { *out << s.file; }
};

class RealScenes : public testing::TestWithParam<RealScene> {};

TEST_P(RealScenes, ReadAsTheirTableSays) {
  const RealScene& due = GetParam();
  const std::string file = std::string(MMVERIFY_SCENES "/") + due.file;
  if (!fs::exists(file)) GTEST_SKIP() << "there is no " << file;
  const Scene scene = load(file);
  TriangleCounts masked;
  std::set<std::size_t> textures;
  for (const Primitive& primitive : scene.primitives) {
    const Material& material = scene.material_of(primitive);
    if (material.mode != AlphaMode::mask) continue;
    masked.unique += primitive.triangles.size();
    masked.placed += primitive.triangles.size() * scene.meshes[primitive.mesh].uses;
    textures.insert(material.texture.value().image.value());
  }
  EXPECT_EQ(count_triangles(scene).unique, due.all.unique);
  EXPECT_EQ(count_triangles(scene).placed, due.all.placed);
  EXPECT_EQ(masked.unique, due.masked.unique);
  EXPECT_EQ(masked.placed, due.masked.placed);
  EXPECT_EQ(textures.size(), due.alpha_textures);
  EXPECT_EQ(std::count_if(scene.materials.begin(), scene.materials.end(),
                          [](const Material& material) { return material.mode == AlphaMode::mask; }),
            static_cast<std::ptrdiff_t>(due.mask_materials));
  for (const std::size_t texture : textures) EXPECT_TRUE(scene.images[texture].decoded());
}

INSTANTIATE_TEST_SUITE_P(
    SceneLoad, RealScenes,
    testing::Values(RealScene{"avocado/Avocado.gltf", {682, 682}, {}, 0, 0},
                    RealScene{"materials_variants_shoe/MaterialsVariantsShoe.gltf", {22700, 22700}, {}, 0, 0},
                    RealScene{"flight_helmet/FlightHelmet_noleather.gltf", {94722, 94722}, {}, 0, 0},
                    RealScene{"littlest_tokyo/littlest_tokyo.gltf", {141802, 141802}, {6741, 6741}, 3, 1},
                    RealScene{"lattice_fence/lattice_fence.gltf", {892, 8336}, {878, 7902}, 1, 1},
                    RealScene{
                        "shapespark_garden/shapespark_garden.gltf", {7667, 15070}, {5398, 10534}, 21, 21},
                    RealScene{"scatter_grove/scatter_grove.gltf", {8420, 149970}, {4138, 78020}, 5, 5},
                    RealScene{"ez_forest/ez_forest.gltf", {59640, 630910}, {30032, 304160}, 5, 3}),
    [](const auto& info) { return fs::path(info.param.file).stem().string(); });

TEST(SceneLoad, TheTwoBadScenes) {
  const std::string folder = MMVERIFY_SCENES "/";
  const std::string helmet = folder + "flight_helmet/FlightHelmet.gltf";
  const std::string tokyo = folder + "littlest_tokyo/LittlestTokyo_original_draco.glb";
  if (!fs::exists(helmet) || !fs::exists(tokyo))
    GTEST_SKIP() << "there is no " << helmet << " or no " << tokyo;
  const auto message = [](const std::string& file) -> std::string {
    return complaint_of<BadScene>([&] { load(file); }, "loaded");
  };
  EXPECT_EQ(message(helmet),
            helmet +
                ": images: there are no files 'FlightHelmet_Materials_LeatherPartsMat_Normal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_OcclusionRoughMetal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_BaseColor.png' beside it; is the folder complete?");
  EXPECT_EQ(message(tokyo), tokyo +
                                ": extensionsRequired: KHR_draco_mesh_compression is not read here: the "
                                "geometry is compressed; decompress it first (gltf-transform copy)");
}

}  // namespace
