// The baker's parts: wide whole numbers, and the texels that a run of indices reaches.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "impl/bake/texture/wrap.hpp"
#include "impl/common/wide.hpp"
#include "spec/bake/texture.hpp"
#include "spec/rational.hpp"

namespace impl_bake_parts_test {

namespace spec = mmverify::spec::bake;
using namespace mmverify::impl::bake;
using mmverify::spec::Integer;

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

spec::Wrap specified(Wrap wrap) { return static_cast<spec::Wrap>(wrap); }

TEST(ImplBakeWide, ArithmeticIsThatOfIntegers) {
  using mmverify::impl::Wide;
  std::mt19937_64 random(1);
  const auto some = [&](std::int64_t& a) {
    a = static_cast<std::int64_t>(random() >> (random() % 64));
    if (random() % 2 != 0) a = -a;
    return Wide<6>(a);
  };
  const auto same = [](const Wide<6>& x, Integer y) {
    // x - y, limb by limb: y is built from its digits.
    const bool negative = y < 0;
    if (negative) y = -y;
    Wide<6> built(0);
    for (int k = 5; k >= 0; --k) {
      const auto half = [&](int shift) {
        return static_cast<std::int64_t>(Integer((y >> (64 * k + shift)) & 0xffffffff));
      };
      built = ((built << 32) + Wide<6>(half(32)));
      built = ((built << 32) + Wide<6>(half(0)));
    }
    return x == (negative ? -built : built);
  };
  for (int round = 0; round < 20000; ++round) {
    std::int64_t a, b, c, d;
    const Wide<6> x = some(a), y = some(b), z = some(c), w = some(d);
    const Integer product = Integer(a) * b * c, other = Integer(d) * d * (round % 3 == 0 ? a : b);
    const Wide<6> first = x * y * z, second = w * w * (round % 3 == 0 ? x : y);
    ASSERT_TRUE(same(first, product));
    ASSERT_TRUE(same(first - second, product - other));
    ASSERT_TRUE(same(first + second, product + other));
    ASSERT_EQ(first < second, product < other);
    ASSERT_EQ(first <= second, product <= other);
    const int shift = static_cast<int>(random() % 180);
    ASSERT_TRUE(same(first << shift, product << shift));
    const Integer size = product < 0 ? Integer(-product) : product;
    const auto bits = size == 0 ? 0 : static_cast<int>(msb(size)) + 1;
    const Integer high = bits > 64 ? Integer(size >> (bits - 64)) : Integer(size << (64 - bits));
    ASSERT_EQ(leading(first.negative() ? -first : first), static_cast<std::uint64_t>(high));
  }
}

TEST(ImplBakeWrap, TexelsAndRunsAreTheSpecifications) {
  for (const Wrap wrap : every_wrap)
    for (std::int64_t n = 1; n <= 5; ++n)
      for (std::int64_t from = -17; from <= 17; ++from) {
        const auto texel = spec::wrapped(specified(wrap), from, static_cast<std::uint32_t>(n));
        ASSERT_EQ(wrapped(wrap, from, n), texel ? std::int64_t{*texel} : -1);
        std::vector<bool> reached(static_cast<std::size_t>(n) + 1, false);
        for (std::int64_t to = from; to <= from + 25; ++to) {
          const auto last = spec::wrapped(specified(wrap), to, static_cast<std::uint32_t>(n));
          reached[last ? *last : static_cast<std::size_t>(n)] = true;
          const detail::Runs runs = detail::runs(wrap, from, to, n);
          std::vector<bool> seen(static_cast<std::size_t>(n) + 1, false);
          seen.back() = runs.border;
          for (int k = 0; k < runs.count; ++k)
            for (std::int64_t i = runs.from[k]; i <= runs.to[k]; ++i)
              seen.at(static_cast<std::size_t>(i)) = true;
          ASSERT_EQ(seen, reached) << int(wrap) << ' ' << n << ' ' << from << ' ' << to;
        }
      }
}

}  // namespace impl_bake_parts_test
