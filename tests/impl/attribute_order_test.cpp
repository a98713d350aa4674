// [memory] impl/attribute/order.hpp against the specification: single values, and spans on every SIMD target.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "impl/attribute/order.hpp"
#include "spec/attribute/order.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_attribute_order_test {

namespace fast = mmverify::impl::attribute;
namespace spec = mmverify::spec::attribute;
using mmverify::tests::on_every_target;
using Words = std::vector<std::uint32_t>;

constexpr std::array vertex_orders{fast::VertexOrder::w_minor, fast::VertexOrder::u_major,
                                   fast::VertexOrder::bird};
constexpr std::array face_orders{fast::FaceOrder::curve, fast::FaceOrder::rows, fast::FaceOrder::u_major};

spec::VertexOrder to_spec(fast::VertexOrder order) { return static_cast<spec::VertexOrder>(order); }
spec::FaceOrder to_spec(fast::FaceOrder order) { return static_cast<spec::FaceOrder>(order); }

// The laws compare batches and single values up to level 11; here the ends and a sample of the levels above.
std::vector<std::uint32_t> indices(std::uint64_t count) {
  std::mt19937 random(7);
  Words all;
  for (std::uint64_t k = 0; k < 40; ++k) {
    all.push_back(static_cast<std::uint32_t>(std::min(k, count - 1)));
    all.push_back(static_cast<std::uint32_t>(count - 1 - std::min(k, count - 1)));
  }
  std::uniform_int_distribution<std::uint64_t> any(0, count - 1);
  for (int k = 0; k < (sanitized ? 300 : 3000); ++k) all.push_back(static_cast<std::uint32_t>(any(random)));
  return all;
}

TEST(ImplAttributeOrder, spans_of_every_length_and_alignment_are_the_single_values) {
  on_every_target([] {
    for (const fast::Level n : {0u, 1u, 5u, 11u, 16u})
      for (std::size_t length = 0; length <= 41; ++length)
        for (std::size_t skip = 0; skip < 2; ++skip) {
          const Words all = indices(spec::vertex_count(n)), faces = indices(spec::face_count(n));
          // One word on each side that no call may touch.
          Words a(length + 4, 77), b(a), c(a), x(a);
          const auto inner = [&](Words& of) { return std::span(of).subspan(1 + skip, length); };
          const auto untouched = [&](const Words& of) {
            return of[skip] == 77 && of[1 + skip + length] == 77;
          };
          const std::span given = std::span(all).subspan(skip, length),
                          face = std::span(faces).subspan(skip, length);
          for (const auto order : vertex_orders) {
            fast::vertex_at(order, given, n, {inner(a), inner(b)});
            fast::vertex_index(order, inner(a), inner(b), n, inner(x));
            for (std::size_t k = 0; k < length; ++k) {
              ASSERT_EQ((fast::Vertex{inner(a)[k], inner(b)[k]}), fast::vertex_at(order, given[k], n));
              ASSERT_EQ(inner(x)[k], given[k]);
            }
            for (const auto of : face_orders) {
              fast::triplets(of, order, face, n, {inner(a), inner(b), inner(c)});
              fast::faces_of(of, order, inner(a), inner(b), n, inner(x));
              for (std::size_t k = 0; k < length; ++k) {
                const auto want = fast::triplet(order, fast::face_at(of, face[k], n), n);
                ASSERT_EQ((std::array{inner(a)[k], inner(b)[k], inner(c)[k]}), want);
                ASSERT_EQ(inner(x)[k], face[k]);
              }
            }
          }
          for (const auto order : face_orders) {
            fast::face_at(order, face, n, {inner(a), inner(b), inner(c)});
            fast::face_index(order, inner(a), inner(b), inner(c), n, inner(x));
            for (std::size_t k = 0; k < length; ++k) {
              const fast::MicroTriangle t = fast::face_at(order, face[k], n);
              ASSERT_EQ((std::array{inner(a)[k], inner(b)[k], inner(c)[k]}),
                        (std::array{t.iu, t.iv, t.upper ? 1u : 0u}));
              ASSERT_EQ(inner(x)[k], face[k]);
            }
          }
          ASSERT_TRUE(untouched(a) && untouched(b) && untouched(c) && untouched(x));
        }
  });
}

TEST(ImplAttributeOrder, conversion_may_be_in_place_and_takes_more_than_one_piece) {
  on_every_target([] {
    for (const fast::Level n : {3u, 9u, 16u}) {
      const Words all = indices(spec::vertex_count(n)), faces = indices(spec::face_count(n));
      for (const auto from : vertex_orders)
        for (const auto to : vertex_orders) {
          Words x = all;
          fast::convert(from, to, x, n, x);
          for (std::size_t k = 0; k < x.size(); ++k) {
            const fast::Vertex v = fast::vertex_at(from, all[k], n);
            ASSERT_EQ(x[k], fast::vertex_index(to, v.i, v.j, n));
          }
        }
      for (const auto from : face_orders)
        for (const auto to : face_orders) {
          Words x = faces;
          fast::convert(from, to, x, n, x);
          for (std::size_t k = 0; k < x.size(); ++k)
            ASSERT_EQ(x[k], fast::face_index(to, fast::face_at(from, faces[k], n), n));
        }
    }
  });
}

TEST(ImplAttributeOrder, a_level_beyond_16_is_16) {
  EXPECT_EQ(fast::vertex_count(40), fast::vertex_count(16));
  for (const auto order : vertex_orders)
    EXPECT_EQ(fast::vertex_index(order, 5, 9, 40), fast::vertex_index(order, 5, 9, 16));
  EXPECT_EQ(fast::face_at(fast::FaceOrder::u_major, 1'000'000, 17),
            fast::face_at(fast::FaceOrder::u_major, 1'000'000, 16));
}

TEST(ImplAttributeOrder, spans_of_two_lengths_are_refused_and_nothing_is_written) {
  Words three(3, 0), two(2, 77);
  EXPECT_THROW(fast::vertex_index(fast::VertexOrder::bird, three, three, 4, two), std::invalid_argument);
  EXPECT_THROW(fast::vertex_at(fast::VertexOrder::bird, three, 4, {two, three}), std::invalid_argument);
  EXPECT_THROW(fast::face_index(fast::FaceOrder::rows, three, three, three, 4, two), std::invalid_argument);
  EXPECT_THROW(fast::face_at(fast::FaceOrder::rows, three, 4, {three, three, two}), std::invalid_argument);
  EXPECT_THROW(fast::convert(fast::VertexOrder::bird, fast::VertexOrder::u_major, three, 4, two),
               std::invalid_argument);
  EXPECT_THROW(fast::convert(fast::FaceOrder::curve, fast::FaceOrder::rows, three, 4, two),
               std::invalid_argument);
  EXPECT_THROW(fast::triplets(fast::FaceOrder::curve, fast::VertexOrder::bird, three, 4, {two, three, three}),
               std::invalid_argument);
  EXPECT_THROW(fast::faces_of(fast::FaceOrder::curve, fast::VertexOrder::bird, three, three, 4, two),
               std::invalid_argument);
  EXPECT_EQ(two, (Words{77, 77}));
}

}  // namespace impl_attribute_order_test
