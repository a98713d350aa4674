// [release] Triangles whose UVs an animation moves: the range is read, and the maps hold wherever it moves them.
#include <cmath>
#include <functional>

#include "impl/micromap/micromap.hpp"
#include "scene/bake/bake.hpp"
#include "scene/bake/surface_baker.hpp"
#include "scene/plan/plan.hpp"
#include "tests/scene/loaded_scene.hpp"

namespace scene_moving_test {

using namespace mmverify::tests;
using testing::ElementsAre;

constexpr char transform[] = "/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";

/// A channel of KHR_animation_pointer for material 0, with its keys' times and values.
void move(GltfFile& file, const std::string& property, const std::string& interpolation,
          const std::vector<float>& times, const std::vector<float>& values) {
  const int components = property == "rotation" ? 1 : 2;
  const auto input = file.add_accessor<float>(times, 5126, "SCALAR", 1);
  const auto output = file.add_accessor<float>(values, 5126, components == 1 ? "SCALAR" : "VEC2", components);
  file.add("animations",
           {{"channels",
             {{{"sampler", 0},
               {"target",
                {{"path", "pointer"},
                 {"extensions",
                  {{"KHR_animation_pointer",
                    {{"pointer", std::string("/materials/0") + transform + property}}}}}}}}}},
            {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}});
}

GltfFile square_with_transform() {
  GltfFile file = square();
  file.base_color()["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0.25}}};
  return file;
}

TEST(SceneMoving, RangesHoldTheRestAndAllKeys) {
  GltfFile file = square_with_transform();
  move(file, "offset", "LINEAR", {0, 1}, {0.75f, 0, -0.25f, 0.125f});
  move(file, "scale", "STEP", {0, 1}, {1, 2, 0.5f, 4});
  const Scene scene = load_glb(file);
  ASSERT_TRUE(scene.materials[0].moving);
  const TransformRange& range = *scene.materials[0].moving;
  EXPECT_EQ(range.least.offset, (Uv{-0.25f, 0}));
  EXPECT_EQ(range.greatest.offset, (Uv{0.75f, 0.25f}));  // 0.25 is the value at rest
  EXPECT_EQ(range.least.scale, (Uv{0.5f, 1}));
  EXPECT_EQ(range.greatest.scale, (Uv{1, 4}));
  EXPECT_EQ(range.least.rotation, 0);
  // Vertex (0, 1): u = offset; v = offset + scale: 0 + 1 to 1/4 + 4.
  const MovingUvs& uvs = *scene.primitives[0].moving_uvs;
  EXPECT_EQ(uvs.middles[0], (Uv{0.25f, 2.625f}));
  // The vertices at u = 1 move the most along u: from -1/4 + 1/2 to 3/4 + 1, by 3/4 about 1.
  EXPECT_EQ(uvs.travel, (Uv{0.75f, 1.625f}));
}

TEST(SceneMoving, CubicSplinesStayWithinTheirHull) {
  GltfFile file = square_with_transform();
  // One segment of 3 s from 0 to 1 with tangents 2 and -1: points 0, 2, 2, 1.
  move(file, "offset", "CUBICSPLINE", {0, 3}, {0, 0, 0, 0, 2, 0, -1, 0, 1, 0, 0, 0});
  const Scene scene = load_glb(file);
  ASSERT_TRUE(scene.materials[0].moving);
  const TransformRange& range = *scene.materials[0].moving;
  EXPECT_NEAR(range.greatest.offset[0], 2, 1e-6);
  EXPECT_GE(range.greatest.offset[0], 2);
  for (int k = 0; k <= 100; ++k) {  // the polynomial of glTF's appendix C
    const double t = k / 100.0, t2 = t * t, t3 = t2 * t;
    const double value = (t3 - 2 * t2 + t) * 3 * 2 + (3 * t2 - 2 * t3) * 1 + (t3 - t2) * 3 * -1;
    EXPECT_LE(value, range.greatest.offset[0]);
    EXPECT_GE(value, range.least.offset[0]);
  }
}

TEST(SceneMoving, RotationsHoldEveryAngle) {
  const TransformRange range{{{0, 0}, {1, 1}, 0.5f}, {{0, 0}, {1, 1}, 4}};
  for (const Uv uv : {Uv{1, 0}, Uv{0.25f, -2}, Uv{-3, 1}}) {
    const auto [least, greatest] = transformed(range, uv);
    const double radius = std::hypot(double{uv[0]}, double{uv[1]});
    for (int k = 0; k <= 1000; ++k) {
      const Uv at =
          transformed(TextureTransform{{0, 0}, {1, 1}, 0.5f + 3.5f * static_cast<float>(k) / 1000}, uv);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_LE(least[axis], at[axis]);
        EXPECT_GE(greatest[axis], at[axis]);
      }
    }
    for (std::size_t axis = 0; axis < 2; ++axis) EXPECT_LE(greatest[axis] - least[axis], 4 * radius);
  }
}

TEST(SceneMoving, OthersAreLeftOut) {
  GltfFile file = square_with_transform();
  move(file, "offset", "LINEAR", {0, 1}, {0, 0, 1, 1, 2, 2});  // three values of two keys
  EXPECT_FALSE(load_glb(file).materials[0].moving);
  file = square_with_transform();
  move(file, "texCoord", "STEP", {0, 1}, {0, 0, 1, 1});
  EXPECT_FALSE(load_glb(file).materials[0].moving);
  file = square_with_transform();
  move(file, "offset", "LINEAR", {0, 1}, {0, 0, 1, 1});
  const Scene scene = load_glb(file);
  ASSERT_TRUE(scene.materials[0].moving);
  ASSERT_EQ(plan(scene).left_out.size(), 1u);
  EXPECT_EQ(plan(scene).left_out[0].why, LeftOut::animated);
  EXPECT_TRUE(plan(scene, finest_level, VaryingAlpha::planned, MovingTextures::planned).left_out.empty());
}

TEST(SceneMoving, BrokenSamplersAreNamedAndLeaveTheFileReadable) {
  const auto unmoved = [](const std::function<void(Json&)>& breaks) {
    GltfFile file = square_with_transform();
    move(file, "offset", "LINEAR", {0, 1}, {0, 0, 1, 1});
    breaks(file.json["animations"][0]);
    const Scene scene = load_glb(file);
    EXPECT_FALSE(scene.materials[0].moving);
    EXPECT_EQ(plan(scene, finest_level, VaryingAlpha::planned, MovingTextures::planned).left_out.size(), 1u);
    return scene.materials[0].unmoved;
  };
  const auto sampler = [&](const char* member, const Json& value) {
    return unmoved([&](Json& animation) { animation["samplers"][0][member] = value; });
  };
  EXPECT_EQ(sampler("output", 9999), "animation 0 sampler 0 output is no index of an accessor");
  EXPECT_EQ(sampler("output", -2), "animation 0 sampler 0 output is no index of an accessor");
  EXPECT_EQ(sampler("input", "0"), "animation 0 sampler 0 input is no index of an accessor");
  EXPECT_EQ(sampler("interpolation", 3), "animation 0 sampler 0: its interpolation is no string");
  EXPECT_EQ(sampler("interpolation", "SMOOTH"), "animation 0 sampler 0: its interpolation is none of glTF's");
  EXPECT_EQ(sampler("interpolation", "CUBICSPLINE"),
            "animation 0 sampler 0: its values do not fit its 2 keys");
  EXPECT_EQ(unmoved([](Json& animation) { animation["samplers"] = Json::object(); }),
            "animation 0: a channel without a sampler");
  EXPECT_EQ(unmoved([](Json& animation) { animation["channels"][0]["sampler"] = 1; }),
            "animation 0: a channel without a sampler");
  EXPECT_EQ(unmoved([](Json& animation) { animation["channels"][0].erase("sampler"); }),
            "animation 0: a channel without a sampler");
}

TEST(SceneMoving, KeysThatAreNotFiniteAreNamed) {
  GltfFile file = square_with_transform();
  move(file, "offset", "LINEAR", {0, 1}, {0, 0, HUGE_VALF, 1});
  EXPECT_THAT(load_glb(file).materials[0].unmoved, testing::HasSubstr("animation 0 sampler 0 output"));
}

/// Counts of states of a moving map, and the exact states at some offsets.
TEST(SceneMoving, MapsHoldAtEveryOffset) {
  GltfFile file = square_with_transform();
  move(file, "offset", "LINEAR", {0, 1}, {0.46875f, 0.25f, 0.53125f, 0.28125f});
  file.json["materials"][0]["alphaCutoff"] = 0.4;
  const Scene scene = load_glb(file);
  const Plan moving = plan(scene, finest_level, VaryingAlpha::planned, MovingTextures::planned);
  constexpr unsigned level = 4;
  const std::vector<unsigned> levels(moving.triangles.size(), level);
  const Baked maps = bake(scene, moving, levels);
  std::size_t known = 0;
  for (std::size_t t = 0; t < maps.triangles.size(); ++t) {
    ASSERT_FALSE(maps.triangles[t].uniform);
    std::vector<mmverify::impl::micromap::State> states(256);
    mmverify::impl::micromap::unpack(maps.triangles[t].map, maps.triangles[t].format, states);
    const Surface& surface = moving.surfaces[0];
    const auto baker = surface_baker(scene, surface);
    for (const float du : {-0.03125f, 0.0f, 0.01f, 0.03125f})
      for (const float dv : {-0.015625f, 0.0f, 0.015625f}) {
        std::vector<std::uint8_t> still(64);
        mmverify::impl::bake::BaseTriangle uv;
        for (std::size_t k = 0; k < 3; ++k)
          uv[k] = {moving.triangles[t].uvs[k][0] + du, moving.triangles[t].uvs[k][1] + dv};
        baker.bake(uv, level, still);
        for (std::size_t k = 0; k < 256; ++k) {
          const auto moved = static_cast<unsigned>(states[k]);
          if (moved > 1) continue;
          ++known;
          EXPECT_EQ(still[k / 4] >> 2 * (k % 4) & 3, moved) << k;
        }
      }
  }
  EXPECT_GT(known, 1000u);
}

}  // namespace scene_moving_test
