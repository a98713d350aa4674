// scene/: triangles on textures, their duplicates, and what the plan leaves out and why.
#include "scene/plan/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "scene/read/load.hpp"
#include "spec/rational.hpp"

namespace {

using namespace mmverify::scene;
using mmverify::spec::Rational;
using testing::ElementsAre;

constexpr float greatest = std::numeric_limits<float>::max();
constexpr float least = std::numeric_limits<float>::denorm_min();

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

Rational exactly(double x) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
  Rational value(static_cast<std::int64_t>(mantissa));
  for (exponent -= 53; exponent > 0; --exponent) value *= 2;
  for (; exponent < 0; ++exponent) value /= 2;
  return value;
}

TEST(ScenePlan, Texels) {
  EXPECT_EQ(in_texels({{{0.1f, 1}, {-3, 0.5f}, {up(1), 7}}}, 956, 1113),
            (TexelTriangle{{{956 * double{0.1f}, 1113}, {-2868, 556.5}, {956 * (1 + 0x1p-23), 7791}}}));
  // Exact to the last bit of the largest product.
  const double x = in_texels({{{down(1), 0}, {}, {}}}, 16383, 1)[0][0];
  EXPECT_EQ(exactly(x), exactly(down(1)) * 16383);
}

TEST(ScenePlan, Shapes) {
  EXPECT_EQ(uv_shape({{{0, 0}, {1, 0}, {0, 1}}}), UvShape::area);
  EXPECT_EQ(uv_shape({{{0, 0}, {0, 1}, {1, 0}}}), UvShape::area);
  EXPECT_EQ(uv_shape({{{3, 4}, {3, 4}, {3, 4}}}), UvShape::point);
  EXPECT_EQ(uv_shape({{{0.0f, 4}, {-0.0f, 4}, {0, 4}}}), UvShape::point);
  EXPECT_EQ(uv_shape({{{3, 4}, {3, 4}, {5, 7}}}), UvShape::line);
  EXPECT_EQ(uv_shape({{{0, 0}, {1, 1}, {0.3f, 0.3f}}}), UvShape::line);
  EXPECT_EQ(uv_shape({{{0, 0}, {1, 1}, {0.3f, up(0.3f)}}}), UvShape::area);
  // 0.1f is thrice no 0.3f, and a third vertex one ulp off the line is off it.
  EXPECT_EQ(uv_shape({{{0, 0}, {0.1f, 0.1f}, {0.3f, 0.3f}}}), UvShape::line);
  EXPECT_EQ(uv_shape({{{0, 0}, {greatest, 0}, {1, least}}}), UvShape::area);
  EXPECT_EQ(uv_shape({{{least, 0}, {greatest, 0}, {-1, 0}}}), UvShape::line);
  EXPECT_EQ(uv_shape({{{1, 0}, {greatest, greatest}, {0, down(0)}}}), UvShape::area);
}

TEST(ScenePlan, ShapesWhereDoublesRound) {
  // The corners lie on v = 3 u, with 22 bits each, so far apart that their differences are rounded.
  std::mt19937 random(13);
  for (int k = 0; k < 500; ++k) {
    const auto on_the_line = [&](int exponent) {
      const float u = std::ldexp(static_cast<float>(random() % 4194304 + 1), exponent);
      return Uv{u, 3 * u};
    };
    UvTriangle uvs{on_the_line(-22), on_the_line(-23), on_the_line(-65)};
    EXPECT_EQ(uv_shape(uvs), UvShape::line);
    uvs[2][1] = up(uvs[2][1]);
    EXPECT_EQ(uv_shape(uvs), UvShape::area);
  }
}

TEST(ScenePlan, Duplicates) {
  const Uv a{0, 0.25f}, b{1, 0.5f}, c{-3, 7};
  const UvTriangle first{a, b, c};
  UvDuplicates all;
  EXPECT_TRUE(all.add(0, first).is_new);
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    const UvTriangle permuted{first[order[0]], first[order[1]], first[order[2]]};
    const auto found = all.add(0, permuted);
    EXPECT_FALSE(found.is_new);
    EXPECT_EQ(found.number, 0u);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(found.order[k], order[k]);
      EXPECT_EQ(permuted[k], first[found.order[k]]);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(all.add(0, {Uv{-0.0f, 0.25f}, b, c}).number, 0u);
  EXPECT_EQ(all.add(1, first).number, 1u);  // on another surface
  EXPECT_EQ(all.add(0, {a, b, Uv{-3, up(7)}}).number, 2u);
  EXPECT_EQ(all.add(0, {Uv{1, 0.25f}, Uv{2, 0.5f}, Uv{-2, 7}}).number, 3u);  // shifted, of no period
  // Several orders fit where corners coincide: the first one is taken.
  EXPECT_EQ(all.add(0, {a, a, b}).number, 4u);
  EXPECT_EQ(all.add(0, {b, a, a}).order, (VertexOrder{2, 0, 1}));
  EXPECT_EQ(all.add(0, {a, b, a}).order, (VertexOrder{0, 2, 1}));
  EXPECT_EQ(all.size(), 5u);
}

TEST(ScenePlan, DuplicatesByPeriodsOfTheTexture) {
  EXPECT_EQ(periods({Wrap::repeat, Wrap::mirrored_repeat, {}, {}, {}}), (Periods{1, 2}));
  EXPECT_EQ(periods({Wrap::clamp_to_edge, Wrap::repeat, {}, {}, {}}), (Periods{0, 1}));
  const UvTriangle first{Uv{0, 0.25f}, Uv{1, 0.5f}, Uv{-3, 7}};
  const auto shifted = [](UvTriangle uvs, float u, float v) {
    for (Uv& corner : uvs) corner = {corner[0] + u, corner[1] + v};
    return uvs;
  };
  UvDuplicates all;
  EXPECT_EQ(all.add(0, first, {1, 2}).number, 0u);
  const auto turned = all.add(0, {Uv{-7, 9}, Uv{-4, 2.25f}, Uv{-3, 2.5f}}, {1, 2});
  EXPECT_EQ(turned.number, 0u);
  EXPECT_EQ(turned.order, (VertexOrder{2, 0, 1}));
  EXPECT_EQ(all.add(0, shifted(first, 1, -4), {1, 2}).number, 0u);
  EXPECT_EQ(all.add(0, shifted(first, 0, 1), {1, 2}).number, 1u);  // half of a mirrored period
  EXPECT_EQ(all.add(0, shifted(first, 0.5f, 0), {1, 2}).number, 2u);
  EXPECT_EQ(all.add(1, first, {0, 0}).number, 3u);
  EXPECT_EQ(all.add(1, shifted(first, 1, 0), {0, 0}).number, 4u);
  // 0.1 + 1 is rounded: another piece of the texture.
  EXPECT_NE(all.add(2, {Uv{0.1f, 0}, {1, 0}, {0, 1}}, {1, 1}).number,
            all.add(2, {Uv{1.1f, 0}, {2, 0}, {1, 1}}, {1, 1}).number);
  // A corner that is too near to 0 to be shifted to 1 keeps all three where they are.
  EXPECT_NE(all.add(3, {Uv{-least, 0}, {-0.5f, 0}, {-0.5f, 1}}, {1, 1}).number,
            all.add(3, {Uv{1, 0}, {0.5f, 0}, {0.5f, 1}}, {1, 1}).number);
  for (const float u : {greatest, -greatest, least, -least, 16777215.5f})
    EXPECT_FALSE(all.add(4, {Uv{u, 0}, {u, u}, {0, 0}}, {1, 2}).number < 5) << u;
}

// A duplicate is exact: its corners differ by whole periods, in rationals.
TEST(ScenePlan, DuplicatesAreExact) {
  std::mt19937 random(29);
  const auto coordinate = [&] {
    const float coarse = static_cast<float>(static_cast<int>(random() % 5) - 2) * 0.5f;
    return random() % 8 == 0 ? up(coarse) : random() % 8 == 0 ? down(coarse) : coarse;
  };
  UvDuplicates all;
  std::vector<UvTriangle> first;
  int shared = 0;
  for (int k = 0; k < 20000; ++k) {
    const UvTriangle uvs{
        Uv{coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const auto found = all.add(0, uvs, {1, 2});
    if (found.is_new) {
      ASSERT_EQ(found.number, first.size());
      first.push_back(uvs);
      continue;
    }
    ++shared;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto by = [&](std::size_t k) {
        return exactly(uvs[k][axis]) - exactly(first[found.number][found.order[k]][axis]);
      };
      ASSERT_EQ(by(0), by(1));
      ASSERT_EQ(by(0), by(2));
      ASSERT_EQ((by(0) / (axis == 0 ? 1 : 2)).denominator(), 1);
    }
  }
  EXPECT_GT(shared, 2000);
}

/// A masked square of two triangles under a 4 x 4 texture.
Scene planned_square() {
  Scene scene;
  Image image;
  image.width = image.height = 4;
  image.alpha = std::vector<std::uint8_t>(16, 200);
  scene.images = {image};
  Material leaf;
  leaf.mode = AlphaMode::mask;
  leaf.texture = BaseColorTexture{};
  leaf.texture->image = 0;
  scene.materials = {leaf};
  scene.meshes = {{"square", 3}};
  Primitive primitive;
  primitive.material = 0;
  primitive.positions.resize(4);
  primitive.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  primitive.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.primitives = {primitive};
  return scene;
}

std::optional<LeftOut> why(const Scene& scene) {
  const Plan planned = plan(scene);
  EXPECT_EQ(planned.primitives.size() + planned.left_out.size(), scene.primitives.size());
  if (planned.left_out.empty()) return {};
  EXPECT_FALSE(sentence(planned.left_out[0].why).empty());
  return planned.left_out[0].why;
}

TEST(ScenePlan, WhatIsBaked) {
  Scene scene = planned_square();
  scene.primitives.push_back(scene.primitives[0]);  // turned and mirrored
  scene.primitives[1].triangles = {{2, 0, 1}, {3, 2, 0}, {3, 3, 3}, {2, 1, 0}};
  scene.primitives[1].mesh = 1;
  scene.meshes.push_back({"other", 10});
  const Plan planned = plan(scene, 2);
  EXPECT_TRUE(planned.left_out.empty());
  ASSERT_EQ(planned.surfaces.size(), 1u);
  ASSERT_EQ(planned.triangles.size(), 3u);
  ASSERT_EQ(planned.primitives.size(), 2u);
  ASSERT_EQ(planned.primitives[1].triangles.size(), 4u);
  EXPECT_EQ(planned.triangles[0].unique, 3u);
  EXPECT_EQ(planned.triangles[0].placed, 3u + 10 + 10);
  EXPECT_EQ(planned.triangles[0].level, (mmverify::impl::bake::UsefulLevel{2, true}));
  EXPECT_EQ(planned.triangles[0].texels, (TexelTriangle{{{0, 4}, {4, 4}, {4, 0}}}));
  EXPECT_EQ(planned.triangles[2].shape, UvShape::point);
  EXPECT_EQ(planned.triangles[2].level, (mmverify::impl::bake::UsefulLevel{0, false}));
  for (const PlannedPrimitive& primitive : planned.primitives)
    for (std::size_t k = 0; k < primitive.triangles.size(); ++k) {
      const Primitive& given = scene.primitives[primitive.primitive];
      const TriangleUse& use = primitive.triangles[k];
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(given.uvs[given.triangles[k][i]], planned.triangles[use.triangle].uvs[use.order[i]]);
    }
  EXPECT_EQ(planned.primitives[1].triangles[0].order, (VertexOrder{2, 0, 1}));
  EXPECT_EQ(planned.primitives[1].triangles[3].order, (VertexOrder{2, 1, 0}));

  // Another cutoff is another micromap; of BLEND there is none.
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].cutoff = 0.25f;
  scene.primitives[1].material = 1;
  EXPECT_EQ(plan(scene).surfaces.size(), 2u);
  scene.materials[0].mode = scene.materials[1].mode = AlphaMode::blend;
  EXPECT_EQ(plan(scene).surfaces.size(), 1u);
  // Vertex alpha that does not vary is one more factor.
  scene.primitives[1].vertex_alpha = {0.5f, 0.5f};
  EXPECT_EQ(plan(scene).surfaces.at(1).vertex_alpha, 0.5f);

  scene.images[0].width = 0;
  EXPECT_THROW(plan(scene), std::invalid_argument);
}

TEST(ScenePlan, WhatIsLeftOut) {
  EXPECT_EQ(why(planned_square()), std::nullopt);
  Scene scene = planned_square();
  scene.primitives[0].triangles.clear();
  EXPECT_EQ(why(scene), LeftOut::no_triangles);
  scene = planned_square();
  scene.meshes.push_back({"unused", 0});
  scene.primitives[0].mesh = 1;
  EXPECT_EQ(why(scene), LeftOut::not_placed);
  scene.meshes[0].uses = 0;  // a file of meshes alone
  EXPECT_EQ(why(scene), std::nullopt);
  scene = planned_square();
  scene.materials[0].mode = AlphaMode::opaque;
  EXPECT_EQ(why(scene), LeftOut::opaque);
  scene.primitives[0].material.reset();
  EXPECT_EQ(why(scene), LeftOut::opaque);
  scene = planned_square();
  scene.materials[0].texture.reset();
  EXPECT_EQ(why(scene), LeftOut::no_texture);
  scene = planned_square();
  scene.materials[0].texture->image.reset();
  EXPECT_EQ(why(scene), LeftOut::no_image);
  scene = planned_square();
  scene.primitives[0].uvs.clear();
  EXPECT_EQ(why(scene), LeftOut::no_uvs);
  scene = planned_square();
  scene.primitives[0].morphs_uvs = true;
  EXPECT_EQ(why(scene), LeftOut::morphed_uvs);
  scene = planned_square();
  scene.primitives[0].vertex_alpha = {0.5f, 1, {}};
  EXPECT_EQ(why(scene), LeftOut::varying_alpha);
  scene.primitives[0].vertex_alpha = {0.5f, 1.5f, {}};
  EXPECT_EQ(why(scene), LeftOut::vertex_alpha);
  scene.primitives[0].vertex_alpha = {1, 1};
  EXPECT_EQ(why(scene), std::nullopt);
  scene = planned_square();
  scene.materials[0].specular_glossiness = true;
  EXPECT_EQ(why(scene), LeftOut::specular_glossiness);
  scene = planned_square();
  scene.materials[0].animated = {"/materials/0/alphaCutoff"};
  EXPECT_EQ(why(scene), LeftOut::animated);
}

TEST(ScenePlan, MaterialVariants) {
  Scene scene = planned_square();
  scene.materials.push_back(scene.materials[0]);
  scene.primitives[0].variants = {{1, {"winter"}}};
  EXPECT_EQ(why(scene), std::nullopt);  // of another colour, perhaps, but of the same alpha
  scene.materials[1].cutoff = 0.75f;
  EXPECT_EQ(why(scene), LeftOut::material_variants);
  scene.materials[1] = scene.materials[0];
  scene.materials[1].texture->transform.offset = {0.5f, 0};
  EXPECT_EQ(why(scene), LeftOut::material_variants);
  scene.materials[1] = scene.materials[0];
  scene.materials[1].animated = {"/materials/1/alphaCutoff"};
  EXPECT_EQ(why(scene), LeftOut::animated);
  scene.materials[0].mode = AlphaMode::opaque;
  EXPECT_EQ(why(scene), LeftOut::material_variants);
  scene.materials[1].mode = AlphaMode::opaque;
  EXPECT_EQ(why(scene), LeftOut::opaque);
}

/// Distinct masked UV triangles: of each material, corners in order; and as the plan has them, of each
/// surface, in whatever order, and shifted by whole periods: counted in rationals by a program of its own.
struct PlannedScene {
  const char* file;
  std::size_t by_material, planned;
};

class PlannedScenes : public testing::TestWithParam<PlannedScene> {};

TEST_P(PlannedScenes, DistinctTriangles) {
  const std::string file = std::string(MMVERIFY_SCENES "/") + GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  const Scene scene = load(file);
  const Plan planned = plan(scene);
  std::set<std::pair<std::size_t, UvTriangle>> by_material;
  std::size_t triangles = 0, covered = 0;
  for (const Primitive& primitive : scene.primitives) {
    if (scene.material_of(primitive).mode != AlphaMode::mask) continue;
    triangles += primitive.triangles.size();
    for (const Triangle& t : primitive.triangles)
      by_material.insert(
          {*primitive.material, {primitive.uvs[t[0]], primitive.uvs[t[1]], primitive.uvs[t[2]]}});
  }
  EXPECT_EQ(by_material.size(), GetParam().by_material);
  std::size_t masked = 0;
  for (const PlannedTriangle& triangle : planned.triangles) {
    if (planned.surfaces[triangle.surface].mode != AlphaMode::mask) continue;
    ++masked;
    covered += triangle.unique;
    EXPECT_EQ(triangle.shape, UvShape::area);
    EXPECT_FALSE(triangle.level.limited);
  }
  EXPECT_EQ(masked, GetParam().planned);
  EXPECT_EQ(covered, triangles);  // every masked triangle of these scenes is baked
}

INSTANTIATE_TEST_SUITE_P(ScenePlan, PlannedScenes,
                         testing::Values(PlannedScene{"ez_forest/ez_forest.gltf", 10, 6},
                                         PlannedScene{"shapespark_garden/shapespark_garden.gltf", 364, 362},
                                         PlannedScene{"lattice_fence/lattice_fence.gltf", 878, 792},
                                         PlannedScene{"scatter_grove/scatter_grove.gltf", 34, 30},
                                         PlannedScene{"littlest_tokyo/littlest_tokyo.gltf", 1056, 1045}),
                         [](const auto& info) {
                           return std::filesystem::path(info.param.file).stem().string();
                         });

}  // namespace
