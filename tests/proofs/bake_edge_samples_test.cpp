// [release] proofs/bake/domains/samples.hpp: what each sample is said to turn on, it turns on.
#include <gtest/gtest.h>

#include <cmath>

#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {
namespace bake_edge_samples_test {

constexpr std::size_t draws = 200;
constexpr Level level = 2;

/// How many of the drawn cases have another state, by the specification, when `change` was made to them.
template <class Draw, class Change>
std::size_t changed(Draw draw, Change change) {
  std::size_t count = 0;
  for (std::uint64_t k = 0; k < draws; ++k) {
    Random random(1, 0x65646765, k);
    Case one;
    draw(random, one);
    one.filter = k % 2 != 0 ? Filter::nearest : Filter::bilinear;
    Case other = one;
    change(other);
    count += true_states(one, level).lower != true_states(other, level).lower ? 1 : 0;
  }
  return count;
}

TEST(BakeEdgeSamples, ACornerOverALineIsNotOneOnIt) {
  const std::size_t count = changed(cross_a_line_by_a_step, [](Case& one) {
    const std::size_t axis = one.width > 1 ? 0 : 1;
    const float size = static_cast<float>(axis == 0 ? one.width : one.height);
    one.uv[axis] = std::round(one.uv[axis] * size) / size;
  });
  EXPECT_GT(count, draws / 5);
}

TEST(BakeEdgeSamples, AMarginIsNotOneIn256thsOfATexel) {
  const std::size_t count =
      changed(reach_a_line_by_the_margin, [](Case& one) { one.margin = std::floor(one.margin * 256) / 256; });
  EXPECT_GT(count, draws / 5);
}

TEST(BakeEdgeSamples, ACutoffIsCrossedWithinAnEdge) {
  std::size_t crests = 0;
  for (std::uint64_t k = 0; k < draws; ++k) {
    Random random(1, 0x65646765, k);
    Case one;
    cross_the_cutoff_within_an_edge(random, one);
    const bool crest = one.alpha[0] < one.alpha[1];
    crests += crest ? 1 : 0;
    // The middle between four texels is their mean: two steps of the cutoff further on nothing crosses it.
    Case beyond = one;
    beyond.cutoff.numerator += crest ? 2 : static_cast<std::uint32_t>(-2);
    EXPECT_NE(true_states(one, level).lower, true_states(beyond, level).lower) << text_of(one);
  }
  EXPECT_GT(crests, draws / 4);
  EXPECT_LT(crests, 3 * draws / 4);
}

}  // namespace bake_edge_samples_test
}  // namespace mmverify::proofs::bake
