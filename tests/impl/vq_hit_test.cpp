// impl/vq/vq.hpp, hits: the region that the specification names, on edges and an ulp beside them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"
#include "tests/vq_cases.hpp"

namespace impl_vq_hit_test {

namespace spec = mmverify::spec::vq;
using namespace mmverify::impl::vq;
using mmverify::spec::Rational;

/// Every quarter of a region along a side, each with its neighbours, and numbers that 1 - u swallows.
std::vector<float> coordinates(int side) {
  std::vector<float> all{1e-30f, std::numeric_limits<float>::denorm_min(), std::ldexp(1.0f, -29),
                         std::ldexp(1.0f, -28), std::ldexp(1.0f, -54)};
  for (int k = 0; k <= 4 * side; ++k) {
    const float at = static_cast<float>(k) / static_cast<float>(4 * side);
    all.push_back(at);
    if (k > 0) all.push_back(std::nextafter(at, 0.0f));
    if (k < 4 * side) all.push_back(std::nextafter(at, 1.0f));
  }
  return all;
}

/// m 2^e is exact.
Rational exact(float x) {
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 24));
  const auto power = mmverify::spec::Integer(1) << std::abs(exponent - 24);
  return exponent >= 24 ? Rational(mantissa * power) : Rational(mantissa, power);
}

template <std::size_t side, class Block>
void expect_specified(const Block& block) {
  const auto map = decode(block);
  const std::vector<float> all = coordinates(static_cast<int>(side));
  std::size_t asked = 0;
  for (const float u : all)
    for (const float v : all) {
      if (double{u} + double{v} > 1 || ++asked % (side == 16 ? 3 : 11) != 0) continue;
      for (const bool upper : {false, true}) {
        const spec::Region r =
            spec::region_of<side>(upper ? spec::Half::upper : spec::Half::lower, exact(u), exact(v));
        ASSERT_EQ(state_at(block, upper ? Half::upper : Half::lower, u, v), map[r.x + side * r.y])
            << u << ' ' << v << ' ' << upper;
      }
    }
}

TEST(ImplVqHit, IsTheSpecifiedRegion) {
  std::mt19937 random(1);
  expect_specified<16>(mmverify::tests::random_block<Block2>(random));
  expect_specified<32>(mmverify::tests::random_block<Block4>(random));
}

TEST(ImplVqHit, OutsideTheTriangleIsSomeRegion) {
  std::mt19937 random(2);
  const auto block = mmverify::tests::random_block<Block4>(random);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float u : {-1.0f, 2.0f, inf, -inf, nan})
    for (const Half half : {Half::lower, Half::upper})
      EXPECT_LE(static_cast<int>(state_at(block, half, u, 0.5f)), 2);
}

}  // namespace impl_vq_hit_test
