// [memory] The library's edge decimation against the specification, and on what no law asks: bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "impl/attribute/decimation.hpp"
#include "spec/attribute/decimation.hpp"
#include "spec/fixed.hpp"

namespace mmverify::impl::attribute {
namespace impl_attribute_decimation_test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();

TEST(ImplDecimation, leaves_alone_what_is_no_vertex) {
  for (const Vertex x : {Vertex{9, 0}, Vertex{5, 5}, Vertex{~0u, 1}, Vertex{0, ~0u}, Vertex{3, ~0u - 2}}) {
    EXPECT_EQ(snapped(x, 3, 7), x);
    EXPECT_EQ(averaged(x, 3, 7), (std::array{x, x}));
  }
  EXPECT_EQ(snapped({1, 0}, 99, 1), snapped({1, 0}, 16, 1)) << "more is 16";
  EXPECT_EQ(snapped({1, 0}, 3, 9), (Vertex{0, 0})) << "other bits say nothing";
}

TEST(ImplDecimation, mean_of_two_words_is_that_of_their_bytes) {
  for (std::uint32_t x = 0; x < 256; x += 5)
    for (std::uint32_t y = 0; y < 256; ++y) {
      const std::uint32_t a = x | (255 - x) << 8 | y << 16 | 0x01000000u,
                          b = y | 0 << 8 | x << 16 | 0xff000000u;
      const std::uint32_t got = mean_rgba8(a, b);
      EXPECT_EQ(got & 255, (x + y + 1) / 2);
      EXPECT_EQ(got >> 8 & 255, (255 - x + 1) / 2);
      EXPECT_EQ(got >> 16 & 255, (x + y + 1) / 2);
      EXPECT_EQ(got >> 24, 128u);
    }
}

TEST(ImplDecimation, writes_means_into_a_map) {
  // Level 2 by rows: number r(r+1)/2 + j, r = i + j.
  const auto row = [](const Vertex& x) { return (x.i + x.j) * (x.i + x.j + 1) / 2 + x.j; };
  std::vector<std::uint32_t> values(15);
  for (std::uint32_t k = 0; k < 15; ++k) values[k] = 16 * k;
  std::vector<std::uint32_t> expected = values;
  decimate_by_means(std::span(values), 2, 5, row);
  // v = 0: vertices 1 and 6 between 0, 3 and 10; u = 0: 2 and 9 between 0, 5 and 14.
  expected[1] = 8 * (0 + 3), expected[6] = 8 * (3 + 10), expected[2] = 8 * (0 + 5),
  expected[9] = 8 * (5 + 14);
  EXPECT_EQ(values, expected);
  decimate_by_means(std::span(values), 0, 7, row);
  EXPECT_EQ(values, expected) << "level 0 has no odd vertex";
}

double sum(const VertexWeights& w) {
  return static_cast<double>(w.weights[0]) + static_cast<double>(w.weights[1]) +
         static_cast<double>(w.weights[2]);
}

TEST(ImplDecimation, every_bit_pattern_has_three_vertices_of_the_level) {
  const std::array<float, 14> floats{0.0f,      -0.0f,          1.0f,           0.5f,           0.25f,
                                     0x1p-149f, 0x1.fffffep-1f, 0x1.000002p-1f, 2.0f,           -1.0f,
                                     nan,       infinite,       -infinite,      0x1.fffffep127f};
  for (Level n = 0; n <= 17; ++n)
    for (EdgeFlags flags = 0; flags < 9; ++flags)
      for (const float u : floats)
        for (const float v : floats) {
          const VertexWeights w = decimated_lookup(u, v, n, flags);
          const std::uint32_t N = 1u << std::min(n, max_level);
          for (const Vertex& x : w.vertices) EXPECT_LE(x.i + x.j, N);
          EXPECT_TRUE(std::isfinite(sum(w)));
          const auto du = static_cast<double>(u), dv = static_cast<double>(v);
          if (!(u >= 0 && v >= 0 && du <= 1 - dv && dv <= 1 - du)) continue;
          EXPECT_NEAR(sum(w), 1, 2e-7) << u << ' ' << v << ' ' << n << ' ' << flags;
          for (const float weight : w.weights)
            EXPECT_GE(weight, 0.0f) << u << ' ' << v << ' ' << n << ' ' << flags;
        }
}

/// A hit may miss the hypotenuse by an ulp: linear functions are still reproduced.
TEST(ImplDecimation, reproduces_linear_functions_an_ulp_outside) {
  for (Level n = 0; n <= 10; ++n)
    for (EdgeFlags flags = 0; flags < 8; ++flags)
      for (std::uint32_t k = 0; k <= 64; ++k) {
        const float u = static_cast<float>(k) / 64, v = std::nextafter(1 - u, 2.0f);
        if (u > 1 || v > 1) continue;
        const VertexWeights w = decimated_lookup(u, v, n, flags);
        double at_u = 0, at_v = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          at_u += static_cast<double>(w.weights[c]) * w.vertices[c].i;
          at_v += static_cast<double>(w.weights[c]) * w.vertices[c].j;
        }
        EXPECT_NEAR(at_u / (1 << n), static_cast<double>(u), 1e-6);
        EXPECT_NEAR(at_v / (1 << n), static_cast<double>(v), 1e-6);
      }
}

}  // namespace impl_attribute_decimation_test
}  // namespace mmverify::impl::attribute
