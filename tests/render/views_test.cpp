// Views shaded by textures and by attribute micromaps.
#include "display/render/scene/views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "display/render/attribute/shading.hpp"
#include "display/render/scene/texture_looks.hpp"
#include "display/render/tracer.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "tests/render/needs_embree.hpp"

namespace {

using namespace mmverify;
using render::Look;
using render::ShownFrom;
using render::Vector;

// A rough white surface, seen and lit along its normal: h = n, D = 1/pi and V = 1/4 at a = 1, F = 0.04.
TEST(Shading, OfARoughSurfaceFromAboveIsTheFormulasByHand) {
  const Look look{.colour = {1, 0.5, 0}, .metallic = 0, .roughness = 1};
  const Vector up{0, 0, 1};
  const Vector light = render::reflected(look, up, up);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(light[c], 0.96 * look.colour[c] / std::numbers::pi + 0.04 / (4 * std::numbers::pi), 1e-12);
}

TEST(Shading, OfAMetalHasItsColourAndNoDiffusePart) {
  const Look look{.colour = {0.8, 0.4, 0}, .metallic = 1, .roughness = 1};
  const Vector up{0, 0, 1}, light = render::reflected(look, up, up);
  EXPECT_NEAR(light[0], 0.8 / (4 * std::numbers::pi), 1e-12);
  EXPECT_EQ(light[2], 0);
}

// Helmholtz: f(l, v) = f(v, l); what is reflected has the cosine of the light's side.
TEST(Shading, IsReciprocal) {
  std::mt19937 random(5);  // NOLINT: the same at every run
  std::uniform_real_distribution<double> any(-1, 1), share(0, 1);
  for (int k = 0; k < 2000; ++k) {
    const Look look{.colour = {share(random), share(random), share(random)},
                    .metallic = share(random),
                    .roughness = share(random)};
    const Vector l = render::unit(Vector{any(random), any(random), 0.05 + share(random)}),
                 v = render::unit(Vector{any(random), any(random), 0.05 + share(random)});
    const Vector a = render::reflected(look, v, l), b = render::reflected(look, l, v);
    for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(a[c] / l[2], b[c] / v[2], 1e-9 * (1 + a[c] / l[2])) << k;
  }
}

// A mirror sends back no more than it gets, summed over all light that comes in evenly: the masking of its
// microfacets sees to that.  Rough ones lose the light that is mirrored twice.  Of what is no metal this holds near the
// normal alone, as glTF mixes the diffuse part in by 1 - F.
TEST(Shading, OfMirrorsKeepsEnergy) {
  for (const double roughness : {0.5, 1.0})
    for (const auto& [metallic, slope] : {std::pair{1.0, 0.1}, {1.0, 0.5}, {1.0, 0.99}, {0.0, 0.99}}) {
      const Look look{.colour = {1, 1, 1}, .metallic = metallic, .roughness = roughness};
      const Vector v{std::sqrt(1 - slope * slope), 0, slope};
      double sum = 0;
      constexpr int steps = 400;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
          const double z = (i + 0.5) / steps, angle = 2 * std::numbers::pi * (j + 0.5) / steps;
          const double r = std::sqrt(1 - z * z);
          sum += render::reflected(look, v, {r * std::cos(angle), r * std::sin(angle), z})[0];
        }
      sum *= 2 * std::numbers::pi / (steps * steps);
      EXPECT_LT(sum, 1) << roughness << " " << metallic << " " << slope;
      EXPECT_GT(sum, 0.25) << roughness << " " << metallic << " " << slope;
    }
}

TEST(Shading, LightFromBehindIsNone) {
  const Vector light = render::reflected({.colour = {1, 1, 1}}, {0, 0, 1}, {0.6, 0, -0.8});
  EXPECT_EQ(light, (Vector{0, 0, 0}));
}

TEST(Shading, CodesAndLightAreInverse) {
  for (int code = 0; code < 256; ++code) EXPECT_EQ(render::srgb_code(render::srgb_light(code / 255.0)), code);
}

/// The suite's own scene, as views take it.
struct Sample {
  scene::Bytes bytes = scene::sample_scene();
  scene::Scene loaded = scene::load("sample", bytes);
  render::SceneWorld world = render::world_of(loaded, scene::load_uses("sample", bytes), scene::plan(loaded));
  scene::AttributeScene attributes = scene::load_attributes("sample", bytes);
  std::vector<scene::PrimitiveShading> shading = scene::load_shading("sample", bytes);
};

// At a corner of a triangle there is a micro-vertex, whose value is a bilinear sample: what the texture shows, to half a
// code; at the middle of a triangle it is not.
TEST(TextureLooks, OfVerticesAreTheTexturesAtCorners) {
  const Sample sample;
  const render::TextureLooks looks(sample.loaded, sample.world, sample.attributes, sample.shading);
  std::uint64_t corners = 0, apart = 0;
  for (std::uint32_t g = 0; g < sample.world.world.geometries.size(); ++g) {
    if (!looks.has_texture(g)) continue;
    for (std::uint32_t t = 0; t < sample.world.world.geometries[g].triangles.size(); ++t) {
      const render::TriangleLooks textures(looks, g, t, ShownFrom::textures, 0);
      const render::TriangleLooks vertices(looks, g, t, ShownFrom::vertices, 0);
      const auto off = [&](const render::Barycentrics& at) {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
          most = std::max(most, std::fabs(textures.at(at).colour[c] - vertices.at(at).colour[c]));
        return most;
      };
      for (const render::Barycentrics corner : {render::Barycentrics{0, 0}, {1, 0}, {0, 1}}) {
        // Half a code is 0.0045 of light at most: the curve is steepest at the bright end.
        ASSERT_LE(off(corner), 0.0046) << g << " " << t;
        ++corners;
      }
      apart += off({0.31f, 0.27f}) > 0.01;
    }
  }
  EXPECT_GT(corners, 100u);
  EXPECT_GT(apart, 10u);
}

TEST(Views, OfHigherLevelsAreCloserAndOfAnyNumberOfThreadsTheSame) {
  NEEDS_EMBREE;
  const Sample sample;
  const render::Tracer tracer(sample.world.world);
  const render::Camera camera = render::overview(render::box_of(sample.world.world, false), 4.0f / 3);
  const render::Frame frame = tracer.frame(camera, nullptr, {.width = 480, .height = 360});
  const render::Views one(sample.loaded, sample.world, sample.attributes, sample.shading, frame, camera,
                          {.rays = 2, .threads = 1}),
      three(sample.loaded, sample.world, sample.attributes, sample.shading, frame, camera,
            {.rays = 2, .threads = 3});
  const render::Picture textures = one.picture(ShownFrom::textures);
  EXPECT_EQ(textures.width, 240u);
  EXPECT_EQ(textures.height, 180u);
  EXPECT_EQ(one.textured().size(), 240u * 180);
  EXPECT_GT(one.triangles(), 10u);
  const auto apart = [&](const render::Picture& other) {
    double sum = 0;
    for (std::size_t k = 0; k < other.rgb.size(); ++k)
      sum += std::fabs(static_cast<double>(textures.rgb[k]) - other.rgb[k]);
    return sum;
  };
  EXPECT_EQ(apart(three.picture(ShownFrom::textures)), 0);
  for (const ShownFrom from : {ShownFrom::faces, ShownFrom::vertices}) {
    const double before = apart(one.picture(from, 0));
    // The sample's texels are smaller than level 2's micro-triangles: a vertex between has whichever of them is there.
    for (const unsigned level : {from == ShownFrom::faces ? 2u : 6u}) {
      const render::Picture maps = one.picture(from, level);
      EXPECT_EQ(maps.rgb, three.picture(from, level).rgb);
      EXPECT_LT(apart(maps), before) << level;
      EXPECT_GT(apart(maps), 0) << level;
    }
  }
}

TEST(LoadShading, ReadsFactorsAndRefusesWhatIsNone) {
  const auto file = [](const std::string& material) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0},"material":0}]}],"materials":[)" +
        material + "]}";
    return std::vector<unsigned char>(text.begin(), text.end());
  };
  const auto good = scene::load_shading(
      "f", file(R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,0,1],"roughnessFactor":0.25}})"));
  ASSERT_EQ(good.size(), 1u);
  EXPECT_EQ(good[0].colour, (std::array<float, 3>{0.5f, 1, 0}));
  EXPECT_EQ(good[0].roughness, 0.25f);
  EXPECT_EQ(good[0].metallic, 1.0f);
  EXPECT_EQ(good[0].normals.size(), 3u);
  for (const char* const wrong : {R"({"pbrMetallicRoughness":{"roughnessFactor":2}})",
                                  R"({"pbrMetallicRoughness":{"metallicFactor":"1"}})",
                                  R"({"pbrMetallicRoughness":{"baseColorFactor":[2,1,0,1]}})"})
    EXPECT_THROW(scene::load_shading("f", file(wrong)), scene::BadScene) << wrong;
}

}  // namespace
