// [memory] impl/attribute/lookup.hpp: spans on every SIMD target are the single values; what is no point of the triangle.
// That single values are the specification's is for the laws to say.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "impl/attribute/lookup.hpp"
#include "impl/index/index.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_attribute_lookup_test {

namespace fast = mmverify::impl::attribute;
using fast::VertexOrder;
using mmverify::tests::on_every_target;

constexpr std::array orders{VertexOrder::w_minor, VertexOrder::u_major, VertexOrder::bird};

/// Points in the triangle, beyond it, and numbers that are none.
std::pair<std::vector<float>, std::vector<float>> points(std::size_t count) {
  constexpr float infinity = std::numeric_limits<float>::infinity(),
                  nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> odd{0,
                               -0.0f,
                               1,
                               0.5f,
                               0.25f,
                               nan,
                               infinity,
                               -infinity,
                               -1,
                               2,
                               1e-40f,
                               std::nextafter(1.0f, 0.0f),
                               std::nextafter(0.5f, 0.0f)};
  std::mt19937 random(11);
  std::uniform_real_distribution<float> any(-0.1f, 1.1f);
  std::pair<std::vector<float>, std::vector<float>> found;
  for (std::size_t k = 0; k < count; ++k) {
    found.first.push_back(k % 3 == 0 ? odd[random() % odd.size()] : any(random));
    found.second.push_back(k % 5 == 0 ? odd[random() % odd.size()] : any(random));
  }
  return found;
}

TEST(ImplAttributeLookup, spans_are_the_single_values) {
  on_every_target([] {
    const auto [u, v] = points(4097);
    const std::size_t count = u.size();
    std::vector<std::uint32_t> x0(count), x1(count), x2(count);
    std::vector<float> w0(count), w1(count), w2(count);
    for (const fast::Level n : {0u, 1u, 6u, 8u, 9u, 12u, 16u, 20u}) {
      fast::weights(u, v, n, {w0, w1, w2});
      for (std::size_t k = 0; k < count; ++k)
        ASSERT_EQ((fast::Weights{w0[k], w1[k], w2[k]}), fast::locate(u[k], v[k], n).weights)
            << u[k] << " " << v[k];
      for (const auto order : orders) {
        fast::triplets(order, u, v, n, {x0, x1, x2});
        for (std::size_t k = 0; k < count; ++k)
          ASSERT_EQ((std::array{x0[k], x1[k], x2[k]}), fast::triplet(order, u[k], v[k], n))
              << u[k] << " " << v[k];
      }
    }
  });
}

TEST(ImplAttributeLookup, values_of_spans_are_the_single_ones) {
  on_every_target([] {
    for (const std::size_t count : {0u, 1u, 7u, 16u, 515u}) {
      const auto [u, v] = points(count);
      std::mt19937 random(5);
      for (const fast::Level n : {0u, 1u, 3u, 7u, 8u, 9u})
        for (const auto order : orders) {
          std::vector<std::uint32_t> map(fast::vertex_count(n)), out(count + 2, 99);
          for (std::uint32_t& c : map) c = static_cast<std::uint32_t>(random());
          fast::interpolated_rgba8(order, map, u, v, n, std::span(out).subspan(1, count));
          for (std::size_t k = 0; k < count; ++k)
            ASSERT_EQ(out[k + 1], fast::interpolated_rgba8(order, map, u[k], v[k], n));
          ASSERT_TRUE(out.front() == 99 && out.back() == 99);
        }
    }
  });
}

TEST(ImplAttributeLookup, the_micro_triangle_is_the_one_of_the_index) {
  const auto [u, v] = points(sanitized ? 2'000 : 20'000);
  for (const fast::Level n : {1u, 4u, 9u, 16u})
    for (std::size_t k = 0; k < u.size(); ++k) {
      const fast::MicroTriangle t = fast::locate(u[k], v[k], n).at;
      ASSERT_EQ(fast::face_index(fast::FaceOrder::curve, t, n),
                mmverify::impl::index::from_barycentrics(u[k], v[k], n))
          << u[k] << " " << v[k];
    }
}

TEST(ImplAttributeLookup, whatever_comes_in_weights_are_none_below_0_and_add_up_to_1) {
  const auto [u, v] = points(sanitized ? 2'000 : 20'000);
  for (fast::Level n = 0; n <= 16; ++n)
    for (std::size_t k = 0; k < u.size(); ++k) {
      const fast::Weights w = fast::locate(u[k], v[k], n).weights;
      ASSERT_TRUE(w[0] >= 0 && w[1] >= 0 && w[2] >= 0) << u[k] << " " << v[k];
      ASSERT_NEAR(w[0] + w[1] + w[2], 1, 2e-7) << u[k] << " " << v[k];
      for (const std::uint32_t x : fast::triplet(VertexOrder::bird, u[k], v[k], n))
        ASSERT_LT(x, fast::vertex_count(n));
    }
}

TEST(ImplAttributeLookup, rgba8_of_equal_vertices_is_that_value) {
  for (const std::uint32_t c : {0u, 0xffffffffu, 0x01020304u, 0xfe7f80ffu})
    for (const float w : {0.0f, 0.25f, 1.0f / 3.0f, 0.7f})
      EXPECT_EQ(fast::mixed_rgba8({1.0f - w, w, 0.0f}, c, c, c), c);
  // Halves go up.
  EXPECT_EQ(fast::mixed_rgba8({0.5f, 0.5f, 0.0f}, 0x00000000, 0x01ff0301, 0), 0x01800201u);
}

TEST(ImplAttributeLookup, spans_of_two_lengths_and_maps_of_another_level_are_refused) {
  std::vector<float> three(3, 0.25f), two(2, 7.0f);
  std::vector<std::uint32_t> out(3, 77), map(15);
  EXPECT_THROW(fast::weights(three, three, 4, {three, two, three}), std::invalid_argument);
  EXPECT_THROW(fast::triplets(VertexOrder::bird, three, two, 4, {out, out, out}), std::invalid_argument);
  EXPECT_THROW(fast::interpolated_rgba8(VertexOrder::bird, map, three, three, 3, out), std::invalid_argument);
  EXPECT_THROW(fast::interpolated_rgba8(VertexOrder::bird, map, three, two, 2, out), std::invalid_argument);
  EXPECT_EQ(out, std::vector<std::uint32_t>(3, 77));
}

}  // namespace impl_attribute_lookup_test
