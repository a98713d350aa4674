// [driver] Our includes on a device, as far as no entry point asks them: levels of detail, and the attribute API.
// Skipped where there is no device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "impl/attribute/mip.hpp"
#include "impl/attribute/order.hpp"
#include "impl/index/index.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/device/program.hpp"

namespace mmverify::tests {
namespace {

using impl::attribute::FaceOrder;
using impl::attribute::VertexOrder;

class ShaderProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    try {
      device_ = std::make_unique<shaders::Device>(0, true);
    } catch (const shaders::NoDevice& why) {
      why_not_ = why.what();
    }
  }
  static void TearDownTestSuite() { device_.reset(); }
  void SetUp() override {
    if (device_ == nullptr) GTEST_SKIP() << "no Vulkan device: " << why_not_;
  }

  struct Ready {
    shaders::Compiled compiled;
    std::unique_ptr<shaders::Program> program;
  };
  static Ready ready(const std::string& name) {
    Ready r{shaders::compile({std::string(MMVERIFY_ROOT) + "/tests/shaders/" + name}), nullptr};
    r.program = std::make_unique<shaders::Program>(*device_, r.compiled.manifest.modules.front());
    return r;
  }

 private:
  static inline std::unique_ptr<shaders::Device> device_;
  static inline std::string why_not_;
};

TEST_F(ShaderProgram, level_of_detail_is_exact_next_to_powers_of_four) {
  std::vector<float> cones, triangles;
  const auto add = [&](float cone, float triangle) {
    if (std::isinf(triangle)) return;
    cones.push_back(cone);
    triangles.push_back(triangle);
  };
  std::mt19937 random(1);  // NOLINT: the same at every run
  std::uniform_real_distribution<float> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-140, 100);
  for (int k = 0; k < 20'000; ++k) {
    const float cone = std::ldexp(mantissa(random), exponent(random));
    for (const int m : {0, 1, 2, 7, 15, 16}) {
      const float triangle = std::ldexp(cone, 2 * m);
      add(cone, triangle);
      add(cone, std::nextafter(triangle, 0.0f));
      add(cone, std::nextafter(triangle, std::numeric_limits<float>::infinity()));
    }
  }
  const float least = std::numeric_limits<float>::denorm_min(),
              none = std::numeric_limits<float>::quiet_NaN();
  for (const float cone : {0.0f, -0.0f, -1.0f, none, least, 3 * least, 1.0f})
    for (const float triangle : {0.0f, -1.0f, none, least, 12 * least, 4.0f, 1.0e38f}) add(cone, triangle);

  const Ready lod = ready("lod.comp");
  for (const std::uint32_t level : {0u, 1u, 12u, 16u}) {
    const std::uint32_t* answers = lod.program->run(
        {.level = level, .arrays = {cones.data(), triangles.data()}, .count = cones.size(), .values = 2});
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < cones.size(); ++k) {
      const std::uint32_t m = impl::attribute::lod_level(cones[k], triangles[k], level);
      const float blend = std::bit_cast<float>(answers[2 * k + 1]);
      wrong += answers[2 * k] != m ? 1 : 0;
      ASSERT_TRUE(blend >= 0 && blend < 1) << cones[k] << " " << triangles[k] << ": " << blend;
      // Vulkan's log2 is within 2^-21 near 1 and 3 units elsewhere: half of that, and the division before it.
      ASSERT_NEAR(blend, impl::attribute::lod(cones[k], triangles[k], level).blend, 0x1p-20)
          << cones[k] << " " << triangles[k];
    }
    EXPECT_EQ(wrong, 0u) << "level " << level;
  }
}

/// Points k/64 of the triangle, which binary32 holds.
struct Points {
  std::vector<float> u, v;
  Points() {
    constexpr int side = 64;
    for (int i = 0; i <= side; ++i)
      for (int j = 0; i + j <= side; ++j) {
        u.push_back(static_cast<float>(i) / side);
        v.push_back(static_cast<float>(j) / side);
      }
  }
};

/// Maps one after the other, and a record each.
struct Maps {
  std::vector<float> values;
  std::vector<std::uint32_t> records;
  void begin(std::uint32_t level, std::uint32_t order, std::uint32_t edges, bool mips) {
    records.push_back(static_cast<std::uint32_t>(values.size()));
    records.push_back(level | order << 5 | edges << 7 | (mips ? 1u << 10 : 0u));
  }
};

enum class Of : std::uint32_t { vertices, faces };
std::vector<float> read(shaders::Program& program, const Maps& maps, const Points& p, std::uint32_t triangle,
                        Of of, std::uint32_t level) {
  std::vector<std::uint32_t> records = maps.records;
  records.resize(p.u.size());
  const std::uint32_t* words = program.run({.level = level,
                                            .first = triangle,
                                            .second = static_cast<std::uint32_t>(of),
                                            .arrays = {p.u.data(), p.v.data(), records.data()},
                                            .bytes = maps.values.data(),
                                            .byte_count = maps.values.size() * sizeof(float),
                                            .count = p.u.size()});
  std::vector<float> found(p.u.size());
  std::memcpy(found.data(), words, found.size() * sizeof(float));
  return found;
}

/// A map of vertices: value(i, j) in the order.
void add_vertices(Maps& maps, std::uint32_t level, VertexOrder order, std::uint32_t edges,
                  const std::function<float(std::uint32_t, std::uint32_t)>& value) {
  maps.begin(level, static_cast<std::uint32_t>(order), edges, false);
  const std::size_t first = maps.values.size();
  maps.values.resize(first + impl::attribute::vertex_count(level));
  const std::uint32_t N = 1u << level;
  for (std::uint32_t i = 0; i <= N; ++i)
    for (std::uint32_t j = 0; i + j <= N; ++j)
      maps.values[first + impl::attribute::vertex_index(order, i, j, level)] = value(i, j);
}

TEST_F(ShaderProgram, figure_5_reproduces_what_is_linear_in_every_order_and_detail) {
  const Ready figure = ready("figure_5.comp");
  const Points p;
  Maps maps;
  std::vector<std::uint32_t> levels;
  for (const VertexOrder order : {VertexOrder::w_minor, VertexOrder::u_major, VertexOrder::bird})
    for (const std::uint32_t level : {0u, 1u, 2u, 5u})
      for (const std::uint32_t edges : {0u, 7u}) {
        const float N = static_cast<float>(1u << level);
        // 3u + 5v + 7w, exactly: N divides evenly.
        add_vertices(maps, level, order, edges, [N](std::uint32_t i, std::uint32_t j) {
          return 7 + (-4 * static_cast<float>(i) - 2 * static_cast<float>(j)) / N;
        });
        levels.push_back(level);
      }
  for (std::uint32_t t = 0; t < levels.size(); ++t)
    for (std::uint32_t m = 0; m <= levels[t]; ++m) {
      const auto found = read(*figure.program, maps, p, t, Of::vertices, m);
      for (std::size_t k = 0; k < found.size(); ++k)
        ASSERT_NEAR(found[k], 7 - 4 * p.u[k] - 2 * p.v[k], 0x1p-20)
            << t << " " << m << " " << p.u[k] << " " << p.v[k];
    }
}

TEST_F(ShaderProgram, figure_5_leaves_no_step_at_an_edge_with_a_coarser_neighbour) {
  const Ready figure = ready("figure_5.comp");
  Points p;
  constexpr std::uint32_t level = 3;
  const auto noise = [](std::uint32_t i, std::uint32_t j) {
    return static_cast<float>((i * 2654435761u ^ j * 40503u) >> 7 & 255u);
  };
  Maps maps;
  add_vertices(maps, level, VertexOrder::bird, 7, noise);
  add_vertices(maps, level - 1, VertexOrder::w_minor, 0,
               [&](std::uint32_t i, std::uint32_t j) { return noise(2 * i, 2 * j); });
  add_vertices(maps, level, VertexOrder::bird, 0, noise);
  const auto fine = read(*figure.program, maps, p, 0, Of::vertices, level);
  const auto coarse = read(*figure.program, maps, p, 1, Of::vertices, level - 1);
  const auto plain = read(*figure.program, maps, p, 2, Of::vertices, level);
  std::size_t on_edge = 0, steps_without = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) {
    if (p.u[k] != 0 && p.v[k] != 0 && p.u[k] + p.v[k] != 1) continue;
    ++on_edge;
    // Codes up to 255 at weights of 1/8: all sums are exact.
    EXPECT_EQ(fine[k], coarse[k]) << p.u[k] << " " << p.v[k];
    steps_without += plain[k] != coarse[k] ? 1 : 0;
  }
  EXPECT_EQ(on_edge, 3u * 64);
  EXPECT_GT(steps_without, 100u);  // or this would show nothing
}

TEST_F(ShaderProgram, figure_5_reads_faces_in_every_order_and_detail) {
  const Ready figure = ready("figure_5.comp");
  const Points p;
  constexpr std::uint32_t level = 4;
  Maps maps;
  for (const FaceOrder order : {FaceOrder::curve, FaceOrder::rows, FaceOrder::u_major}) {
    maps.begin(level, static_cast<std::uint32_t>(order), 0, true);
    // A face holds its number on the curve, and its level.
    for (std::uint32_t m = 0; m <= level; ++m)
      for (std::uint32_t k = 0; k < 1u << 2 * m; ++k) {
        const auto face = impl::attribute::face_at(order, k, m);
        maps.values.push_back(static_cast<float>(impl::attribute::face_index(FaceOrder::curve, face, m)) +
                              static_cast<float>(m) / 16);
      }
  }
  for (std::uint32_t t = 0; t < 3; ++t)
    for (std::uint32_t m = 0; m <= level; ++m) {
      const auto found = read(*figure.program, maps, p, t, Of::faces, m);
      for (std::size_t k = 0; k < found.size(); ++k)
        ASSERT_EQ(found[k], static_cast<float>(impl::index::from_barycentrics(p.u[k], p.v[k], m)) +
                                static_cast<float>(m) / 16);
    }
}

}  // namespace
}  // namespace mmverify::tests
