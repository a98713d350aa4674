// impl/vq/vq.hpp, VQ2: Algorithm 1 by hand.  Laws vq2.lossless_when_it_fits and vq2.optimum judge the other encoders.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"

namespace impl_vq2_test {

namespace spec = mmverify::spec::vq;
using namespace mmverify::impl::vq;

/// A map of C with some vectors, each 2x2, region 0 lowest.
Map2 with_vectors(const std::vector<std::pair<std::uint32_t, std::array<State, 4>>>& vectors) {
  Map2 map;
  map.fill(State::C);
  for (const auto& [vector, states] : vectors)
    for (std::uint32_t k = 0; k < 4; ++k)
      map[2 * (vector % 8) + k % 2 + 16 * (2 * (vector / 8) + k / 2)] = states[k];
  return map;
}

// Worked by hand. Nothing is lost, so Algorithm 1 ends at the first transforms, all identity. TL (X < 4, Y >= 4) has
// three vectors of its own: the two with one C each score lowest and get its two entries; the third, with three, gets a
// shared one.
TEST(ImplVq2, AlgorithmOneByHand) {
  using enum State;
  const Map2 map = with_vectors({{32, {O, O, O, C}}, {33, {T, C, T, T}}, {34, {C, C, C, O}}});
  const Encoded2 encoded = encode_paper(map);
  EXPECT_EQ(encoded.substitutions, 0u);
  const auto fields = spec::from_bytes<spec::Vq2>(encoded.block);
  for (const auto& t : fields.transforms) EXPECT_EQ(t.number(), 0u);
  EXPECT_EQ(fields.indices[32], 6);  // the last of equal scores is taken first: O, whose number is higher
  EXPECT_EQ(fields.indices[33], 7);
  EXPECT_EQ(fields.indices[34], 3);
  EXPECT_EQ(fields.own[0][0], 16 + 8);  // 1000b: region 3 is C, of {O, C}
  EXPECT_EQ(fields.own[0][1], 2);
  EXPECT_EQ(fields.shared[0], 16 + 7);
}

}  // namespace impl_vq2_test
