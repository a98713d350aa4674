// [release] Lookups at points of a scene's triangles: where the points lie, what a texture shows there, what is laid out and timed.
#include "bench/scene/attribute_times.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "bench/scene/texture_sample.hpp"
#include "scene/attribute/measure.hpp"

namespace scene_attribute_times_test {

using namespace mmverify::scene;
using mmverify::bench::along_surfaces;
using mmverify::bench::AttributeTimer;
using mmverify::bench::LookupTimes;
using mmverify::bench::LookupWay;
using mmverify::bench::surface_points;
using mmverify::bench::SurfacePoint;
using mmverify::bench::TextureSample;

ColourImage random_image(std::uint32_t width, std::uint32_t height) {
  std::mt19937 engine(7);
  ColourImage image{"random", width, height, {}};
  for (std::uint32_t k = 0; k < 4 * width * height; ++k)
    image.rgba.push_back(static_cast<std::uint8_t>(engine() & 255));
  return image;
}

Sampler wrapped_as(Wrap u, Wrap v) {
  Sampler sampler;
  sampler.wrap_u = u;
  sampler.wrap_v = v;
  return sampler;
}

/// The texel of any number along an axis, as glTF 2.0, 3.8.4.2 has it.
std::int64_t wrapped(std::int64_t x, std::int64_t texels, Wrap wrap) {
  if (wrap == Wrap::clamp_to_edge) return std::clamp<std::int64_t>(x, 0, texels - 1);
  const std::int64_t period = wrap == Wrap::repeat ? texels : 2 * texels;
  const std::int64_t within = ((x % period) + period) % period;
  return within < texels ? within : period - 1 - within;
}

/// A channel between four texels, in binary64.
double expected(const ColourImage& image, const Sampler& sampler, double u, double v, std::size_t channel) {
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  const double f = x - std::floor(x), g = y - std::floor(y);
  const auto at = [&](std::int64_t right, std::int64_t down) {
    const std::int64_t i = wrapped(static_cast<std::int64_t>(std::floor(x)) + right, image.width,
                                   sampler.wrap_u),
                       j = wrapped(static_cast<std::int64_t>(std::floor(y)) + down, image.height,
                                   sampler.wrap_v);
    return static_cast<double>(image.rgba[4 * static_cast<std::size_t>(i + j * image.width) + channel]);
  };
  return (1 - g) * ((1 - f) * at(0, 0) + f * at(1, 0)) + g * ((1 - f) * at(0, 1) + f * at(1, 1));
}

TEST(TextureSample, IsBilinearInEachWrap) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> anywhere(-3, 3);
  const Wrap wraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge};
  for (const auto& [width, height] : {std::pair{1u, 1u}, {5u, 3u}, {8u, 16u}, {1u, 7u}}) {
    const ColourImage image = random_image(width, height);
    for (const Wrap wrap_u : wraps)
      for (const Wrap wrap_v : wraps) {
        const Sampler sampler = wrapped_as(wrap_u, wrap_v);
        const TextureSample sample(image, sampler);
        const auto check = [&, w = width, h = height](float u, float v) {
          const std::uint32_t got = sample.at(u, v);
          for (std::size_t channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(got >> 8 * channel & 255, expected(image, sampler, u, v, channel), 0.51)
                << w << "x" << h << " at " << u << ", " << v << ", wraps " << static_cast<int>(wrap_u)
                << static_cast<int>(wrap_v);
        };
        for (int k = 0; k < 300; ++k) check(anywhere(engine), anywhere(engine));
        for (const float u : {-2.0f, -1.0f, -0.5f, 0.0f, 0.5f, 1.0f, 2.0f, -0x1p-30f, 0x1.fffffep-1f})
          for (const float v : {-1.0f, 0.0f, 1.0f, 1.5f}) check(u, v), check(v, u);
      }
  }
}

/// Half of a texture, its other half as three times as small a triangle, and a triangle without area.
AttributeScene three_triangles() {
  AttributeScene scene;
  scene.file = "three";
  scene.images.push_back(random_image(32, 32));
  scene.textures.push_back({set_of(Attribute::base_color), 0, wrapped_as(Wrap::repeat, Wrap::repeat)});
  scene.primitives.push_back(
      {0, 0, {{0, 1, 2}, {3, 1, 2}, {0, 1, 1}, {0, 1, 2}}, {{0, {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.75f}}}}});
  scene.triangles = 4;
  return scene;
}

std::vector<MapOfTriangle> triangles_of(const AttributeScene& scene) {
  std::vector<MapOfTriangle> all;
  for (const AttributePrimitive& primitive : scene.primitives)
    for (const Triangle& t : primitive.triangles)
      all.push_back(
          {0, {primitive.uses[0].uvs[t[0]], primitive.uses[0].uvs[t[1]], primitive.uses[0].uvs[t[2]]}});
  return all;
}

TEST(SurfacePoints, AreAsManyAsTheAreasAskForAndLieOnTheTriangle) {
  const AttributeScene scene = three_triangles();
  const std::vector<SurfacePoint> points = surface_points(scene, triangles_of(scene), 20000, 1);
  ASSERT_EQ(points.size(), 20000u);
  std::size_t on[4] = {};
  double middle_u = 0, middle_v = 0;
  for (const SurfacePoint& p : points) {
    ASSERT_LT(p.triangle, 4u);
    ++on[p.triangle];
    EXPECT_GE(p.u, 0);
    EXPECT_GE(p.v, 0);
    EXPECT_LE(double{p.u} + double{p.v}, 1);
    middle_u += p.u, middle_v += p.v;
  }
  // Areas of 1/2, 1/8, 0 and 1/2: 4 : 1 : 0 : 4.  Six standard deviations are 0.02.
  EXPECT_NEAR(static_cast<double>(on[0]) / 20000, 4.0 / 9, 0.022);
  EXPECT_NEAR(static_cast<double>(on[1]) / 20000, 1.0 / 9, 0.022);
  EXPECT_EQ(on[2], 0u);
  EXPECT_NEAR(middle_u / 20000, 1.0 / 3, 0.01);
  EXPECT_NEAR(middle_v / 20000, 1.0 / 3, 0.01);
}

TEST(SurfacePoints, OfTrianglesWithoutAreaAreOnAllAlike) {
  const AttributeScene scene = three_triangles();
  const MapOfTriangle flat = triangles_of(scene)[2];
  std::set<std::uint32_t> on;
  for (const SurfacePoint& p : surface_points(scene, std::vector{flat, flat}, 64, 1)) on.insert(p.triangle);
  EXPECT_THAT(on, testing::ElementsAre(0, 1));
}

TEST(SurfacePoints, AlongSurfacesAreTheSamePointsInOrder) {
  const AttributeScene scene = three_triangles();
  const std::vector<SurfacePoint> points = surface_points(scene, triangles_of(scene), 1000, 3);
  const std::vector<SurfacePoint> along = along_surfaces(points);
  const auto key = [](const SurfacePoint& p) { return std::tuple(p.triangle, p.u, p.v); };
  std::multiset<std::tuple<std::uint32_t, float, float>> before, after;
  for (const SurfacePoint& p : points) before.insert(key(p));
  for (const SurfacePoint& p : along) after.insert(key(p));
  EXPECT_EQ(before, after);
  EXPECT_TRUE(std::is_sorted(along.begin(), along.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.triangle < b.triangle;
  }));
  EXPECT_FALSE(std::is_sorted(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.triangle < b.triangle;
  }));
}

TEST(SetMaps, AreKeptForWhoeverAsks) {
  const AttributeScene scene = three_triangles();
  std::size_t told = 0;
  AttributeOptions options{.first = 0, .last = 2};
  options.kept = [&](const SetMaps& maps) {
    ++told;
    const std::size_t size = values_of_map(maps.kind, maps.level);
    ASSERT_EQ(maps.number.size(), 4u);
    EXPECT_EQ(maps.number[3], maps.number[0]);
    const std::set<std::uint32_t> different(maps.number.begin(), maps.number.end());
    EXPECT_EQ(maps.maps.values().size(), different.size() * size);
    const MapBaker baker(scene.images[0], scene.textures[0], options.averaging);
    for (std::size_t k = 0; k < 4; ++k) {
      std::vector<MapValue> map(size);
      baker.bake(maps.triangles.all()[k].uvs, maps.kind, maps.level, map);
      EXPECT_TRUE(std::ranges::equal(maps.maps.values().subspan(maps.number[k] * size, size), map));
    }
  };
  const AttributeFigures figures = measure(scene, options);
  EXPECT_EQ(told, 6u);
}

TEST(AttributeTimer, HasARowForEachWay) {
  const AttributeScene scene = three_triangles();
  AttributeTimer timer(scene, {.points = 500, .rounds = 2});
  AttributeOptions options{.first = 1, .last = 2};
  options.kept = [&](const SetMaps& maps) { timer.take(maps); };
  measure(scene, options);
  std::set<std::pair<unsigned, LookupWay>> rows;
  for (const LookupTimes& times : timer.times()) {
    rows.insert({times.level, times.way});
    EXPECT_EQ(times.points, 500u);
    for (const mmverify::bench::TimesOfOrder& order : times.by_order) {
      EXPECT_GT(order.texture_ns, 0);
      EXPECT_GT(order.map_ns, 0);
    }
  }
  EXPECT_EQ(rows.size(), 2u * 3);
  EXPECT_EQ(timer.times().size(), rows.size());
}

TEST(ErrorAgainstTime, HasAPointForEachWayAndLevelAndTheTextureWithoutError) {
  const AttributeScene scene = three_triangles();
  AttributeTimer timer(scene, {.points = 500, .rounds = 2});
  AttributeOptions options{.first = 0, .last = 2};
  options.kept = [&](const SetMaps& maps) { timer.take(maps); };
  const AttributeFigures figures = measure(scene, options);
  const auto panels = mmverify::bench::error_against_time(figures, timer.times());
  ASSERT_EQ(panels.size(), 2u) << "scattered and along";
  for (std::size_t order = 0; order < 2; ++order) {
    const auto& series = panels[order].series;
    ASSERT_EQ(series.size(), 4u);
    for (const auto& times : timer.times()) {
      const auto& curve = series[static_cast<std::size_t>(times.way)];
      ASSERT_EQ(curve.points.size(), 3u);
      const auto& point = curve.points[times.level];
      const bool named = times.level == 2 || (times.level == 0 && times.way != LookupWay::vertices_bird);
      EXPECT_EQ(point.label, named ? std::to_string(times.level) : "");
      EXPECT_EQ(point.x, times.by_order[order].map_ns);
      const MapKind kind = times.way == LookupWay::face ? MapKind::faces : MapKind::vertices;
      const auto& levels = figures.sets.front().levels;
      const auto& at = *std::find_if(levels.begin(), levels.end(),
                                     [&](const auto& l) { return l.level == times.level && l.kind == kind; });
      EXPECT_EQ(point.y, at.error.rmse);
    }
    ASSERT_EQ(series[3].points.size(), 1u);
    EXPECT_EQ(series[3].points[0].y, 0);
    EXPECT_GT(series[3].points[0].x, 0);
  }
  EXPECT_TRUE(mmverify::bench::error_against_time(figures, {}).empty()) << "no times";
}

}  // namespace scene_attribute_times_test
