// Attribute micromaps in the renderer, which reads subjects/shaders/attribute_api.glsl as C++: beside the library's own lookups.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "display/render/attribute/colour_maps.hpp"
#include "display/render/scene/colours_of.hpp"
#include "impl/attribute/lookup.hpp"
#include "impl/index/index.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"

namespace {

using namespace mmverify;
using render::Barycentrics;
using render::ColourMaps;
using render::ColoursOf;

/// Corners, edges, ties, and points between.
std::vector<Barycentrics> points() {
  std::vector<Barycentrics> all;
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; i + j <= 64; ++j) all.push_back({static_cast<float>(i) / 64, static_cast<float>(j) / 64});
  std::mt19937 random(1);  // NOLINT: the same at every run
  std::uniform_real_distribution<float> any(0, 1);
  for (int k = 0; k < 20'000; ++k) all.push_back(render::in_triangle(any(random), any(random)));
  return all;
}

std::vector<std::uint32_t> noise(std::size_t count) {
  std::mt19937 random(2);  // NOLINT: the same at every run
  std::vector<std::uint32_t> values(count);
  for (std::uint32_t& value : values) value = static_cast<std::uint32_t>(random());
  return values;
}

TEST(ColourMaps, OfFacesAreThoseOfTheMicroTriangle) {
  for (const unsigned level : {0u, 1u, 3u, 6u}) {
    ColourMaps maps(ColoursOf::faces, level, 2);
    const auto before = noise(1u << 2 * level);
    maps.add(std::vector<std::uint32_t>(before.size()));
    const std::uint32_t number = maps.add(before);
    maps.give(1, {0, number});
    EXPECT_FALSE(maps.has(0));
    for (const Barycentrics& b : points()) {
      ASSERT_EQ(maps.at(1, 1, b), before[impl::index::from_barycentrics(b.u, b.v, level)])
          << b.u << " " << b.v;
      ASSERT_EQ(maps.at(1, 0, b), 0u);
    }
  }
}

TEST(ColourMaps, OfVerticesAreWithinACodeOfTheLibrarys) {
  for (const unsigned level : {0u, 1u, 4u}) {
    ColourMaps maps(ColoursOf::vertices, level, 1);
    const auto values = noise(impl::attribute::vertex_count(level));
    maps.give(0, {maps.add(values)});
    std::uint64_t other = 0;
    const auto all = points();
    for (const Barycentrics& b : all) {
      const std::uint32_t got = maps.at(0, 0, b),
                          right = impl::attribute::interpolated_rgba8(impl::attribute::VertexOrder::w_minor,
                                                                      values, b.u, b.v, level);
      // One divides codes by 255 first: a value at a half may be rounded the other way.
      for (unsigned shift = 0; shift < 32; shift += 8)
        ASSERT_LE(std::abs(static_cast<int>(got >> shift & 255) - static_cast<int>(right >> shift & 255)), 1)
            << level << " " << b.u << " " << b.v;
      other += got != right;
    }
    EXPECT_LT(other, all.size() / 100) << level;
  }
}

TEST(ColourMaps, RefuseWhatIsNoMap) {
  EXPECT_THROW(ColourMaps(ColoursOf::faces, 11, 1), std::invalid_argument);
  ColourMaps maps(ColoursOf::vertices, 2, 1);
  EXPECT_THROW(maps.add(noise(16)), std::invalid_argument);
  EXPECT_EQ(maps.add(noise(15)), 0u);
  EXPECT_EQ(maps.bytes(), 15u * 16);
}

TEST(ColourMaps, OfASceneHaveTheColoursOfItsTexture) {
  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  const scene::AttributeScene attributes = scene::load_attributes("sample", bytes);
  const auto world = render::world_of(scene, scene::load_uses("sample", bytes), scene::plan(scene));
  const ColourMaps maps = render::colours_of(scene, world, attributes, ColoursOf::vertices, 0);
  std::uint64_t with = 0;
  for (std::uint32_t g = 0; g < world.world.geometries.size(); ++g) with += maps.has(g);
  ASSERT_GT(with, 0u);
  // Level 0 of vertices: the texture at each corner, which the maps of one face more have, too.
  EXPECT_EQ(maps.vertex_values().size() % 3, 0u);
  for (const auto& value : maps.vertex_values()) {
    ASSERT_GE(value.x, 0);
    ASSERT_LE(value.x, 1);
    ASSERT_EQ(value.w, 1);
  }
}

}  // namespace
