// [memory] impl/vq/vq.hpp, VQ4: the decoders against the specification.
#include <gtest/gtest.h>

#include <random>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"
#include "tests/impl/every_target.hpp"

namespace impl_vq4_test {

namespace spec = mmverify::spec::vq;
using namespace mmverify::impl::vq;
using mmverify::tests::on_every_target;

void expect_specified(const Block4& block) {
  const spec::Map<spec::Vq4> expected = spec::decode(spec::from_bytes<spec::Vq4>(block));
  const Map4 map = decode(block);
  for (std::uint32_t k = 0; k < 1024; ++k) {
    ASSERT_EQ(static_cast<int>(map[k]), static_cast<int>(expected[k])) << k;
    ASSERT_EQ(region(block, k % 32, k / 32), map[k]) << k;
    ASSERT_EQ(region(block, k % 32 + 32, k / 32 + 0xffffffe0), map[k]) << k;
  }
}

TEST(ImplVq4, DecodesAsSpecifiedOnEveryTarget) {
  on_every_target([] {
    std::mt19937 random(1);
    for (int round = 0; round < 40; ++round) {
      Block4 block;
      for (auto& byte : block) byte = static_cast<std::uint8_t>(random());
      expect_specified(block);
      if (HasFatalFailure()) return;
    }
  });
}

// Each bit of each entry alone, under every transform, in every quadrant.
TEST(ImplVq4, DecodesEveryBitOfEveryEntry) {
  for (std::uint8_t index = 0; index < 16; ++index)
    for (std::uint32_t t = 0; t < 8; ++t)
      for (std::uint32_t bit = 0; bit <= (index < 3 ? 0 : spec::bits_of(spec::Vq4::code_of(index))); ++bit) {
        spec::Vq4 fields;
        fields.indices.fill(index);
        for (std::size_t q = 1; q < 4; ++q) fields.transforms[q] = spec::Transform::of(t);
        if (index >= 3)
          fields.codebook[index - 3u] = (1u << bit) & ((1u << spec::bits_of(spec::Vq4::code_of(index))) - 1);
        expect_specified(spec::bytes(fields));
        if (HasFatalFailure()) FAIL() << int{index} << ' ' << t << ' ' << bit;
      }
}

}  // namespace impl_vq4_test
