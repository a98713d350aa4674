// [memory] impl/traverse/ where no law goes: spans of other sizes, bits that mean nothing.
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "impl/traverse/blend.hpp"
#include "impl/traverse/decision.hpp"

namespace impl_traverse_test {

using namespace mmverify::impl::traverse;

TEST(ImplTraverse, RefusesSpansOfOtherSizes) {
  const std::vector<std::uint32_t> two(2), three(3);
  std::vector<Outcome> out(2, Outcome::opaque);
  EXPECT_THROW(decide(three, two, two, out), std::invalid_argument);
  EXPECT_THROW(decide(two, three, two, out), std::invalid_argument);
  EXPECT_THROW(decide(two, two, three, out), std::invalid_argument);
  EXPECT_EQ(out, std::vector<Outcome>(2, Outcome::opaque));
  EXPECT_NO_THROW(decide({}, {}, {}, {}));
  std::vector<std::uint32_t> words(2, 7);
  EXPECT_THROW(blend(Operation::add, three, two, words), std::invalid_argument);
  EXPECT_THROW(blend(Operation::add, two, three, words), std::invalid_argument);
  EXPECT_EQ(words, (std::vector<std::uint32_t>{7, 7}));
  EXPECT_NO_THROW(blend(Operation::over, {}, {}, {}));
}

TEST(ImplTraverse, NoHitsLeaveThePayload) {
  EXPECT_EQ(blended(Operation::over, 0x12345678, {}), 0x12345678u);
  const Hit wall{1, true, 5};
  EXPECT_EQ(blended(Operation::over, 0x12345678, {&wall, 1}), 0x12345678u);
}

// Such as those of culling by facing.
TEST(ImplTraverse, IgnoresOtherBits) {
  for (std::uint32_t candidate = 0; candidate < 16; ++candidate)
    for (std::uint32_t instance = 0; instance < 64; instance += 4)
      for (const std::uint32_t ray : {ray_opaque, ray_no_opaque, ray_cull_opaque, ray_cull_no_opaque,
                                      ray_force_two_state, ray_force_two_state | ray_cull_opaque, 0u}) {
        const std::uint32_t more[] = {candidate | ~0xFu, instance | ~0x3Cu, ray | ~0x4C3u};
        EXPECT_EQ(decide(more[0], more[1], more[2]), decide(candidate, instance, ray));
        for (const bool enabled : {true, false})
          EXPECT_EQ(undefined(enabled, more[0], more[1], more[2]),
                    undefined(enabled, candidate, instance, ray));
      }
}

}  // namespace impl_traverse_test
