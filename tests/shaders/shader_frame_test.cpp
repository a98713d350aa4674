// [release, driver] The renderer's shading beside a device's: one header, attribute_api.glsl, compiled as C++ there and as SPIR-V here, asked
// about every hit of a frame.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "display/render/attribute/cones.hpp"
#include "display/render/scene/colours_of.hpp"
#include "display/render/tracer.hpp"
#include "display/render/vectors.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/device/program.hpp"

namespace mmverify::tests {
namespace {

using render::ColourMaps;
using render::ColoursOf;

/// The hits of a frame on one geometry.
struct Hits {
  std::vector<float> u, v;
  std::vector<std::uint32_t> triangles;
};

/// A geometry's records, and all values behind them.
struct Block {
  std::vector<std::uint32_t> words;
  Block(const ColourMaps& maps, std::uint32_t geometry) {
    const std::uint32_t per_value = maps.of() == ColoursOf::faces ? 1 : 4;
    const auto& records = maps.records(geometry);
    const std::size_t room = (2 * records.size() + 3) / 4 * 4;
    for (const auto& record : records) {
      words.push_back(record.x + static_cast<std::uint32_t>(room / per_value));
      words.push_back(record.y);
    }
    words.resize(room);
    words.insert(words.end(), maps.face_values().begin(), maps.face_values().end());
    for (const auto& value : maps.vertex_values())
      for (const float c : {value.x, value.y, value.z, value.w})
        words.push_back(std::bit_cast<std::uint32_t>(c));
  }
};

std::map<std::uint32_t, Hits> hits_by_geometry(const render::World& world) {
  const render::Tracer tracer(world);
  std::map<std::uint32_t, Hits> by_geometry;
  for (const std::uint64_t camera : {1u, 3u, 4u}) {
    const render::Frame frame =
        tracer.frame(render::on_path(render::box_of(world, true), 1, camera, 4.0f / 3), nullptr,
                     {.width = 320, .height = 240, .shadows = false});
    for (const render::Pixel& pixel : frame.pixels) {
      if (!pixel.primary.hit()) continue;
      Hits& hits = by_geometry[pixel.primary.geometry];
      hits.u.push_back(pixel.at.u);
      hits.v.push_back(pixel.at.v);
      hits.triangles.push_back(pixel.primary.triangle);
    }
  }
  return by_geometry;
}

/// Compares the shader's answers, four words a hit, with the renderer's colours.
void expect_colours(const std::uint32_t* answers, const ColourMaps& maps, std::uint32_t geometry,
                    const Hits& hits, unsigned level) {
  for (std::size_t k = 0; k < hits.u.size(); ++k) {
    const render::Barycentrics b{hits.u[k], hits.v[k]};
    if (maps.of() == ColoursOf::faces) {
      ASSERT_EQ(answers[4 * k], maps.at(geometry, hits.triangles[k], b)) << level << " " << b.u << " " << b.v;
      continue;
    }
    const auto c = maps.interpolated(geometry, hits.triangles[k], b);
    const std::array<float, 4> right{c.x, c.y, c.z, c.w};
    for (std::size_t channel = 0; channel < 4; ++channel)
      ASSERT_EQ(answers[4 * k + channel], std::bit_cast<std::uint32_t>(right[channel]))
          << level << " " << b.u << " " << b.v << " " << channel;
  }
}

TEST(ShaderFrame, shades_every_hit_as_the_renderer_does_bit_for_bit) {
  if (!render::has_embree()) GTEST_SKIP() << render::embree_text();
  std::unique_ptr<shaders::Device> device;
  try {
    device = std::make_unique<shaders::Device>(0, true);
  } catch (const shaders::NoDevice& why) {
    GTEST_SKIP() << "no Vulkan device: " << why.what();
  }
  const shaders::Compiled compiled =
      shaders::compile({std::string(MMVERIFY_ROOT) + "/tests/shaders/frame_colours.comp"});
  shaders::Program program(*device, compiled.manifest.modules.front());

  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  const scene::AttributeScene attributes = scene::load_attributes("sample", bytes);
  const render::SceneWorld world =
      render::world_of(scene, scene::load_uses("sample", bytes), scene::plan(scene));
  const std::map<std::uint32_t, Hits> by_geometry = hits_by_geometry(world.world);

  for (const ColoursOf of : {ColoursOf::faces, ColoursOf::vertices})
    for (const unsigned level : {0u, 3u, 5u}) {
      const ColourMaps maps = render::colours_of(scene, world, attributes, of, level);
      std::size_t compared = 0;
      for (const auto& [geometry, hits] : by_geometry) {
        if (!maps.has(geometry)) continue;
        const Block block(maps, geometry);
        const std::uint32_t* answers =
            program.run({.second = of == ColoursOf::faces ? 0u : 1u,
                         .arrays = {hits.u.data(), hits.v.data(), hits.triangles.data()},
                         .bytes = block.words.data(),
                         .byte_count = 4 * block.words.size(),
                         .count = hits.u.size(),
                         .values = 4});
        expect_colours(answers, maps, geometry, hits, level);
        if (HasFatalFailure()) return;
        compared += hits.u.size();
      }
      EXPECT_GT(compared, 10'000u);
      RecordProperty(std::string(of == ColoursOf::faces ? "faces" : "vertices") + std::to_string(level),
                     static_cast<int>(compared));
    }
}

// Areas of cones and triangles in, levels out: each of a frame's hits, by the text that the renderer's views read.
TEST(ShaderFrame, asks_for_the_level_of_every_hits_cone_as_the_renderer_does) {
  if (!render::has_embree()) GTEST_SKIP() << render::embree_text();
  std::unique_ptr<shaders::Device> device;
  try {
    device = std::make_unique<shaders::Device>(0, true);
  } catch (const shaders::NoDevice& why) {
    GTEST_SKIP() << "no Vulkan device: " << why.what();
  }
  const shaders::Compiled compiled =
      shaders::compile({std::string(MMVERIFY_ROOT) + "/tests/shaders/lod.comp"});
  shaders::Program program(*device, compiled.manifest.modules.front());

  const scene::Bytes bytes = scene::sample_scene();
  const scene::Scene scene = scene::load("sample", bytes);
  const render::SceneWorld world =
      render::world_of(scene, scene::load_uses("sample", bytes), scene::plan(scene));
  const render::Camera camera = render::overview(render::box_of(world.world, false), 4.0f / 3);
  const render::Frame frame =
      render::Tracer(world.world).frame(camera, nullptr, {.width = 320, .height = 240, .shadows = false});
  const float half = std::sqrt(render::dot(camera.up, camera.up));
  std::vector<float> cones, triangles;
  std::vector<std::array<render::Point, 3>> corners;
  for (std::uint32_t at = 0; at < frame.pixels.size(); ++at) {
    const render::Met& met = frame.pixels[at].primary;
    if (!met.hit()) continue;
    const render::Geometry& geometry = world.world.geometries[met.geometry];
    std::array<render::Point, 3>& p = corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = render::placed(world.world.instances[met.instance],
                            geometry.positions[geometry.triangles[met.triangle][k]]);
    const render::Point across = render::cross(render::minus(p[1], p[0]), render::minus(p[2], p[0]));
    triangles.push_back(0.5f * std::sqrt(render::dot(across, across)));
    const render::Ray ray =
        render::ray_of(camera, at % frame.width, at / frame.width, frame.width, frame.height);
    cones.push_back(render::cone_area(render::spread_of_pixel(half, frame.height), met.t,
                                      render::dot(render::unit(across), ray.direction)));
  }
  ASSERT_GT(cones.size(), 10'000u);
  const auto vector = [](const render::Point& q) { return render::glsl::vec3(q[0], q[1], q[2]); };
  for (const std::uint32_t finest : {1u, 5u, 10u}) {
    const std::uint32_t* answers = program.run(
        {.level = finest, .arrays = {cones.data(), triangles.data()}, .count = cones.size(), .values = 2});
    std::set<std::uint32_t> levels;
    for (std::size_t k = 0; k < cones.size(); ++k) {
      const auto& p = corners[k];
      const render::DetailLevel right =
          render::detail_level(finest, cones[k], vector(p[0]), vector(p[1]), vector(p[2]));
      ASSERT_EQ(answers[2 * k], right.level) << finest << " " << cones[k] << " " << triangles[k];
      ASSERT_NEAR(std::bit_cast<float>(answers[2 * k + 1]), right.blend, 0x1p-20);
      levels.insert(right.level);
    }
    EXPECT_GE(levels.size(), std::min(finest, 4u));
  }
}

}  // namespace
}  // namespace mmverify::tests
