// scene/: real scenes, which lie beside the checkout where there are any.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/read/bad_scene.hpp"
#include "scene/read/draco.hpp"
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

TEST(SceneLoad, ASceneWithoutItsTextures) {
  const std::string helmet = MMVERIFY_SCENES "/flight_helmet/FlightHelmet.gltf";
  if (!fs::exists(helmet)) GTEST_SKIP() << "there is no " << helmet;
  EXPECT_EQ(complaint_of<BadScene>([&] { load(helmet); }, "loaded"),
            helmet +
                ": images: there are no files 'FlightHelmet_Materials_LeatherPartsMat_Normal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_OcclusionRoughMetal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_BaseColor.png' beside it; is the folder complete?");
}

/// Each triangle's signed area in the texture and its three sides in space, sorted one by one: they are the
/// same for triangles in any order, from any corner on.
std::array<std::vector<double>, 4> measures(const Primitive& primitive) {
  std::array<std::vector<double>, 4> all;
  for (const Triangle& t : primitive.triangles) {
    std::array<double, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Position &a = primitive.positions[t[k]], &b = primitive.positions[t[(k + 1) % 3]];
      sides[k] = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 0; k < 3; ++k) all[k].push_back(sides[k]);
    if (primitive.uvs.empty()) continue;
    const Uv &a = primitive.uvs[t[0]], &b = primitive.uvs[t[1]], &c = primitive.uvs[t[2]];
    all[3].push_back((double{b[0]} - a[0]) * (double{c[1]} - a[1]) -
                     (double{b[1]} - a[1]) * (double{c[0]} - a[0]));
  }
  for (auto& values : all) std::sort(values.begin(), values.end());
  return all;
}

// The same scene twice: as Draco compressed it, and decoded by another tool, by way of text and in another order.
TEST(SceneLoad, DracoByAnotherDecoder) {
  const std::string folder = MMVERIFY_SCENES "/littlest_tokyo/",
                    packed = folder + "LittlestTokyo_original_draco.glb";
  if (!fs::exists(packed)) GTEST_SKIP() << "there is no " << packed;
  if (!has_draco()) {
    EXPECT_EQ(complaint_of<UnreadExtension>([&] { load(packed); }, "loaded").find(packed + ": mesh 0 "), 0u);
    return;
  }
  const Scene scene = load(packed), plain = load(folder + "littlest_tokyo.gltf");
  ASSERT_EQ(scene.primitives.size(), plain.primitives.size());
  for (std::size_t p = 0; p < plain.primitives.size(); ++p) {
    const auto got = measures(scene.primitives[p]), due = measures(plain.primitives[p]);
    for (std::size_t m = 0; m < due.size(); ++m) {
      ASSERT_EQ(got[m].size(), due[m].size()) << p;
      for (std::size_t k = 0; k < due[m].size(); ++k)
        ASSERT_NEAR(got[m][k], due[m][k], 1e-5 * (1 + std::fabs(due[m][k]))) << p << ' ' << m << ' ' << k;
    }
  }
}

}  // namespace
