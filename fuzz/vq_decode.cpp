// Any block: impl's decoders against the specification, hits in the middles of regions, and its map encoded
// again without a substitution.
//
// Input: a byte that chooses an encoder, then the block: VQ4 if more than 32 bytes follow, else VQ2; missing
// bytes are 0.  The encoder encodes the decoded map again: for VQ4, by the byte's remainder by 4, fast,
// balanced, thorough, none; for VQ2 none if the byte is odd.  Balanced and thorough take 1/8 of the inputs that ask for
// them, fast the others.
//
// Covers: impl/vq/*/decode.cpp impl/vq/*/layout.hpp impl/vq/hit.cpp impl/vq/transform.hpp
#include <algorithm>
#include <cstddef>

#include "fuzz/share.hpp"
#include "fuzz/vq_both.hpp"

namespace {

using namespace mmverify::fuzz;

template <class Format>
States<Format> decoded(const slow::BlockBytes<Format>& block) {
  constexpr auto size = static_cast<std::uint32_t>(8 * Format::side);
  const States<Format> expected = meant<Format>(block), map = fast::decode(block);
  require_same<Format>(expected, map, "decode", "is not the specification's");
  // A region's middle is a binary32 number, and so is its distance from 1.
  const auto middle = [](std::uint32_t at) {
    return (static_cast<float>(at) + 0.5f) / static_cast<float>(size);
  };
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    const std::uint32_t x = k % size, y = k / size;
    require(fast::region(block, x, y) == expected[k], "region()", "is not decode()", Format::side, k);
    require(fast::state_at(block, fast::Half::lower, middle(x), middle(y)) == expected[k] &&
                fast::state_at(block, fast::Half::upper, 1 - middle(x), 1 - middle(y)) == expected[k],
            "a hit's state", "is not the region's", Format::side, k);
  }
  return map;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const bool slow = Share(data, size).of(8);
  const std::uint8_t how = *data++;
  --size;
  if (size <= 32) {
    fast::Block2 block{};
    std::copy(data, data + size, block.begin());
    const fast::Map2 map = decoded<slow::Vq2>(block);
    if (how % 2 != 0) return 0;
    const fast::Encoded2 again = fast::encode_optimal(map);
    require(again.substitutions == 0, "encoded again, it", "loses", 2);
    require_same<slow::Vq2>(map, meant<slow::Vq2>(again.block), "encoded again, it", "is another map");
    return 0;
  }
  fast::Block4 block{};
  std::copy(data, data + std::min<std::size_t>(size, 64), block.begin());
  const fast::Map4 map = decoded<slow::Vq4>(block);
  if (how % 4 == 3) return 0;
  const fast::Encoded4 again =
      fast::encode(map, slow ? static_cast<fast::Effort>(how % 4) : fast::Effort::fast);
  require(again.substitutions == 0, "encoded again, it", "loses", 4);
  require_same<slow::Vq4>(map, meant<slow::Vq4>(again.block), "encoded again, it", "is another map");
  return 0;
}
