// render/: levels of detail by ray cones.
#include "display/render/attribute/cones.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "display/render/scene/texture_looks.hpp"
#include "display/render/scene/views.hpp"
#include "display/render/tracer.hpp"
#include "display/render/vectors.hpp"
#include "impl/attribute/mip.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "tests/render/needs_embree.hpp"

namespace mmverify::tests::cones_test {
namespace {

using namespace mmverify::render;

/// The suite's own scene, as views take it.
struct Sample {
  scene::Bytes bytes = scene::sample_scene();
  scene::Scene loaded = scene::load("sample", bytes);
  SceneWorld world = world_of(loaded, scene::load_uses("sample", bytes), scene::plan(loaded));
  scene::AttributeScene attributes = scene::load_attributes("sample", bytes);
  std::vector<scene::PrimitiveShading> shading = scene::load_shading("sample", bytes);
  Tracer tracer{world.world};
  Camera camera = overview(box_of(world.world, false), 4.0f / 3);

  static const Sample& get() {
    static const Sample sample;
    return sample;
  }
  Frame frame(std::uint32_t height) const {
    return tracer.frame(camera, nullptr, {.width = height * 4 / 3, .height = height, .shadows = false});
  }
  Views views(const Frame& frame) const {
    return {loaded, world, attributes, shading, frame, camera, {.shading = Shading::unlit}};
  }
};

TEST(Cones, HaveTheWidthOfAPixel) {
  // A picture of 90 degrees and 100 rows is 2 wide at distance 1, a row 1/50; a cone is a disc as wide, at distance 3
  // and seen at 60 degrees an ellipse of twice the area.
  const float spread = spread_of_pixel(1, 100);
  EXPECT_NEAR(spread, std::atan(0.02), 1e-7);
  const double radius = 3 * std::tan(std::atan(0.02) / 2);
  EXPECT_NEAR(cone_area(spread, 3, 0.5f), 2 * 3.14159265 * radius * radius, 1e-7);
  EXPECT_EQ(cone_area(spread, 3, -0.5f), cone_area(spread, 3, 0.5f)) << "from behind";
}

// The renderer reads the shaders' text; the library's level is exact, by law attribute.lod_level.
TEST(Cones, AskForTheLibrarysLevelAtEveryHit) {
  NEEDS_EMBREE;
  const Sample& sample = Sample::get();
  double before = -1;
  for (const std::uint32_t height : {12u, 120u, 960u}) {
    const Frame frame = sample.frame(height);
    const Views views = sample.views(frame);
    double sum = 0, hits = 0;
    for (std::uint32_t at = 0; at < frame.pixels.size(); ++at) {
      const Met& met = frame.pixels[at].primary;
      if (!met.hit()) continue;
      const Geometry& geometry = sample.world.world.geometries[met.geometry];
      std::array<Point, 3> p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = placed(sample.world.world.instances[met.instance],
                      geometry.positions[geometry.triangles[met.triangle][k]]);
      const Ray ray = ray_of(sample.camera, at % frame.width, at / frame.width, frame.width, frame.height);
      const Point across = cross(minus(p[1], p[0]), minus(p[2], p[0]));
      const float triangle = 0.5f * std::sqrt(dot(across, across));
      const float half = std::sqrt(dot(sample.camera.up, sample.camera.up));
      const float cone =
          cone_area(spread_of_pixel(half, frame.height), met.t, dot(unit(across), ray.direction));
      for (const unsigned finest : {0u, 3u, 9u}) {
        const DetailLevel detail = views.detail(at, finest);
        ASSERT_EQ(detail.level, impl::attribute::lod_level(cone, triangle, finest)) << height << " " << at;
        ASSERT_NEAR(detail.blend, impl::attribute::lod(cone, triangle, finest).blend, 0x1p-20);
        if (finest == 9) sum += detail.level + double{detail.blend};
      }
      ++hits;
    }
    // Ten times as many rows are a hundredth of the area, 3.3 levels, as far as there are any.
    EXPECT_GT(sum / hits, before + (before < 0 ? 0 : 2)) << height;
    before = sum / hits;
  }
}

TEST(TriangleLooks, ByConesAreMipsAndBetweenThemMeans) {
  const Sample& sample = Sample::get();
  const TextureLooks looks(sample.loaded, sample.world, sample.attributes, sample.shading);
  constexpr unsigned finest = 4;
  std::uint64_t other = 0, triangles = 0;
  for (std::uint32_t g = 0; g < sample.world.world.geometries.size(); ++g)
    for (std::uint32_t t = 0; looks.has_texture(g) && t < sample.world.world.geometries[g].triangles.size();
         ++t)
      for (const ShownFrom from : {ShownFrom::faces, ShownFrom::vertices}) {
        const TriangleLooks chain(looks, g, t, from, finest, true), alone(looks, g, t, from, finest),
            lower(looks, g, t, from, 1);
        const Barycentrics a{0.21f, 0.34f}, b{0.6f, 0.1f};
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_EQ(chain.at(a).colour[c], alone.at(a).colour[c]);
          if (from == ShownFrom::faces) {
            ASSERT_EQ(chain.at(a, {0, 0}).colour[c], chain.at(b, {0, 0}).colour[c]) << "one face";
          } else {
            ASSERT_EQ(chain.at(a, {1, 0}).colour[c], lower.at(a).colour[c]) << "the lower level's samples";
          }
          // One texture of base colours: the look is linear in its mean.
          const double low = chain.at(a, {2, 0}).colour[c], high = chain.at(a, {3, 0}).colour[c];
          ASSERT_NEAR(chain.at(a, {2, 0.25f}).colour[c], 0.75 * low + 0.25 * high, 1e-12);
        }
        other += chain.at(a, {0, 0}).colour != chain.at(a).colour;
        ++triangles;
      }
  EXPECT_GT(other, triangles / 4);
}

TEST(Views, ByConesAreAnotherPictureWhereMapsHaveLevels) {
  NEEDS_EMBREE;
  const Sample& sample = Sample::get();
  const Frame frame = sample.frame(90);
  const Views views = sample.views(frame);
  for (const ShownFrom from : {ShownFrom::faces, ShownFrom::vertices}) {
    EXPECT_EQ(views.picture(from, 0, Detail::cones).rgb, views.picture(from, 0).rgb);
    EXPECT_NE(views.picture(from, 5, Detail::cones).rgb, views.picture(from, 5).rgb);
  }
  EXPECT_EQ(views.picture(ShownFrom::textures, 0, Detail::cones).rgb, views.picture(ShownFrom::textures).rgb);
}

// A normal of length 1 has a code for each axis: its vector is as long again, within the codes' rounding.
TEST(Views, OfNormalsShowUnitVectorsTowardsTheCamera) {
  NEEDS_EMBREE;
  const Sample& sample = Sample::get();
  const Frame frame = sample.frame(60);
  const Views views(sample.loaded, sample.world, sample.attributes, sample.shading, frame, sample.camera,
                    {.shading = Shading::normals});
  const Picture picture = views.picture(ShownFrom::textures);
  std::uint64_t hits = 0, up = 0;
  for (std::size_t at = 0; at < frame.pixels.size(); ++at) {
    if (!frame.pixels[at].primary.hit()) continue;
    std::array<double, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) n[c] = 2 * picture.rgb[3 * at + c] / 255.0 - 1;
    ASSERT_NEAR(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), 1, 0.02) << at;
    up += n[1] > 0.99;
    ++hits;
  }
  // The ground is most of what the camera sees of the scene, and its normal is the scene's y.
  EXPECT_GT(up, hits / 3);
}

}  // namespace
}  // namespace mmverify::tests::cones_test
