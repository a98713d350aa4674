// impl::bake::TriangleBaker under every SIMD target of every processor: the same maps, which laws compare with the
// specification, under the targets that x86 has.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::impl::bake;

/// Rough and flat texels side by side, so that parents decide some micro-triangles and leaves the others.
template <class Texel>
std::vector<Texel> texels_of(std::mt19937& random, std::uint32_t side) {
  const double most = std::is_same_v<Texel, float> ? 1 : std::numeric_limits<Texel>::max();
  std::vector<Texel> texels;
  for (std::uint32_t k = 0; k < side * side; ++k) {
    const bool rough = k % side < side / 2 && k / side > side / 3;
    const double alpha = rough ? static_cast<double>(random() % 256) / 255 : k / side % 40 < 20 ? 0 : 1;
    texels.push_back(static_cast<Texel>(alpha * most));
  }
  return texels;
}

template <class Texel>
std::vector<std::vector<std::uint8_t>> maps() {
  std::mt19937 random(8);
  const auto anywhere = [&] { return static_cast<float>(random() % 3001) / 1000 - 1; };
  std::vector<std::vector<std::uint8_t>> all;
  for (int round = 0; round < (sanitized ? 5 : 40); ++round) {
    const auto side = static_cast<std::uint32_t>(8 + random() % 90),
               level = static_cast<std::uint32_t>(random() % 7);
    const std::vector<Texel> texels = texels_of<Texel>(random, side);
    Sampling sampling{.u = static_cast<Wrap>(random() % 5), .v = static_cast<Wrap>(random() % 5)};
    if (round % 4 == 0) sampling.factors[0] = 0.75f;
    if (round % 5 == 0) sampling.filter = Filter::nearest;
    if (round % 6 == 0) sampling.margin = 0.75f;
    if (round % 7 == 0) sampling.border = 1;
    const AlphaMode mode = round % 3 == 0 ? AlphaMode(Blend{}) : Mask{0.5f};
    const TexelView<Texel> mip{texels.data(), side, side, side};
    const BaseTriangle uv{{{anywhere(), anywhere()}, {anywhere(), anywhere()}, {anywhere(), anywhere()}}};
    all.emplace_back(level == 0 ? 1 : std::size_t{1} << (2 * level - 2));
    TriangleBaker(std::array<Texels, 1>{mip}, mode, sampling).bake(uv, level, all.back());
  }
  return all;
}

/// FNV-1a.
std::uint64_t digest(const std::vector<std::vector<std::uint8_t>>& maps) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto& map : maps)
    for (const std::uint8_t byte : map) hash = (hash ^ byte) * 0x100000001b3;
  return hash;
}

template <class Texel>
class ImplBakeTargets : public testing::Test {};
using Kinds = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ImplBakeTargets, Kinds);

TYPED_TEST(ImplBakeTargets, EachMakesTheMapsOfTheOneThatAProgramGets) {
  const auto expected = maps<TypeParam>();
  // Whole numbers of 16 bits are those of 8 times 257.
  constexpr std::uint64_t known =
      std::is_same_v<TypeParam, float> ? 18391419362777114525u : 6093660456945757822u;
  if (!sanitized) {
    EXPECT_EQ(digest(expected), known);
  }
  mmverify::tests::on_every_target([&] { EXPECT_EQ(maps<TypeParam>(), expected); });
}

}  // namespace
