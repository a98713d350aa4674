// [release] The record of a bake: each input that changes is named, and no other one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scene/record/bake_record.hpp"
#include "tests/scene/made_scene.hpp"

namespace mmverify::tests {
namespace scene_record_test {

using namespace mmverify::scene;

/// Turns the UVs of a primitive, as another transform or another UV set does.
void turn_uvs(Scene& scene) {
  for (Uv& uv : scene.primitives[0].uvs) uv = {uv[1], 1 - uv[0]};
}

BaseColorTexture& texture(Scene& scene) { return *scene.materials[0].texture; }

struct Case {
  std::function<void(Scene&)> change;
  std::vector<std::string> says;
};

TEST(BakeRecord, NumbersAreTheShortestDecimals) {
  Scene scene = made_scene();
  const std::pair<float, const char*> numbers[] = {{0.1f, "0.1"},
                                                   {0.5f, "0.5"},
                                                   {1, "1"},
                                                   {10, "10"},
                                                   {16777217.0f, "16777216"},
                                                   {0.33333334f, "0.33333334"},
                                                   {1e-45f, "1e-45"}};
  for (const auto& [number, text] : numbers) {
    scene.materials[0].cutoff = number;
    EXPECT_THAT(bake_record(scene, scene.primitives[0], {}),
                testing::HasSubstr(std::string("\"alphaCutoff\":") + text + ","));
  }
}

TEST(BakeRecord, NamesEachInputThatChanged) {
  const std::vector<Case> cases{
      {[](Scene&) {}, {}},
      {[](Scene& s) { s.materials[0].cutoff = 0.75f; }, {"cutoff was 0.5, is 0.75"}},
      {[](Scene& s) { s.materials[0].mode = AlphaMode::blend; }, {R"(alphaMode was "MASK", is "BLEND")"}},
      {[](Scene& s) { s.materials[0].base_color_alpha = 0.25f; },
       {"the alpha of baseColorFactor was 1, is 0.25"}},
      {[](Scene& s) {
         s.primitives[0].vertex_alpha = VertexAlpha{0.5f, 0.5f};
       },
       {"the alpha of COLOR_0 was 1, is 0.5"}},
      {[](Scene& s) { texture(s).sampler.wrap_v = Wrap::clamp_to_edge; },
       {R"(the sampler was "REPEAT, REPEAT, linear", is "REPEAT, CLAMP_TO_EDGE, linear")"}},
      {[](Scene& s) { std::get<0>(s.images[0].alpha)[0] ^= 1; }, {"the texture's alpha changed"}},
      {turn_uvs, {"the triangles and their UVs changed"}},
      {[](Scene& s) { std::swap(s.primitives[0].triangles[0], s.primitives[0].triangles[1]); },
       {"the triangles and their UVs changed"}},
      {[](Scene& s) { std::swap(s.primitives[0].triangles[0][0], s.primitives[0].triangles[0][1]); },
       {"the triangles and their UVs changed"}},
      {[](Scene& s) {
         s.materials[0].cutoff = 0.25f;
         turn_uvs(s);
       },
       {"cutoff was 0.5, is 0.25", "the triangles and their UVs changed"}},
      // Another UV set, or transform, moves the UVs: they are not named besides.
      {[](Scene& s) {
         texture(s).uv_set = 1;
         turn_uvs(s);
       },
       {"texCoord was 0, is 1"}},
      {[](Scene& s) {
         texture(s).transform.offset = {0.5f, 0};
         turn_uvs(s);
       },
       {"KHR_texture_transform was [0,0,1,1,0], is [0.5,0,1,1,0]"}},
      {[](Scene& s) {
         texture(s).transform.offset = {0.5f, 0};
         std::get<0>(s.images[0].alpha)[0] ^= 1;
       },
       {"KHR_texture_transform was [0,0,1,1,0], is [0.5,0,1,1,0]", "the texture's alpha changed"}},
      {[](Scene& s) { s.materials[0].mode = AlphaMode::opaque; }, {"alphaMode is OPAQUE now"}},
      {[](Scene& s) { s.images[0].width = 0; }, {"the alpha texture, or its UVs, are gone"}},
  };
  const Scene then = made_scene();
  const std::string record = bake_record(then, then.primitives[0], {});
  for (std::size_t k = 0; k < cases.size(); ++k) {
    Scene now = then;
    cases[k].change(now);
    EXPECT_EQ(changes_since(record, now, now.primitives[0]), cases[k].says) << "case " << k;
  }
}

TEST(BakeRecord, ComparesNoOtherVersionAndNoMemberThatIsMissing) {
  const Scene scene = made_scene();
  const Primitive& primitive = scene.primitives[0];
  EXPECT_TRUE(changes_since(R"({"version": 2, "alphaCutoff": 0.75})", scene, primitive).empty());
  EXPECT_TRUE(changes_since(R"({"version": 1})", scene, primitive).empty());
  EXPECT_EQ(changes_since(R"({"version": 1, "alphaCutoff": 0.75})", scene, primitive),
            std::vector<std::string>{"cutoff was 0.75, is 0.5"});
  for (const char* no_object : {"", "[]", "{", "3", "null"})
    EXPECT_THROW(changes_since(no_object, scene, primitive), std::invalid_argument) << no_object;
}

}  // namespace scene_record_test
}  // namespace mmverify::tests
