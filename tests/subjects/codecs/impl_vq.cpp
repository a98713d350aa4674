// The library's own VQ2 and VQ4 as a subject: the sources of their decoders, word for word, in one file, as they are for
// processors without vectors.  REGIONS_ALONE leaves the whole map of VQ4 out.
#define HWY_COMPILE_ONLY_SCALAR
#include "impl/vq/four/decode.cpp"
#include "impl/vq/two/decode.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::vq;

template <class Block>
Block block_of(const uint8_t* bytes) {
  Block block;
  std::memcpy(block.data(), bytes, block.size());
  return block;
}

template <class Block>
void decode(const uint8_t* block, uint8_t* map) {
  const auto states = mmverify::impl::vq::decode(block_of<Block>(block));
  std::memcpy(map, states.data(), states.size());
}
template <class Block>
void region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state, size_t count) {
  const Block of = block_of<Block>(block);
  for (size_t k = 0; k < count; ++k)
    state[k] = static_cast<uint8_t>(mmverify::impl::vq::region(of, x[k], y[k]));
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own VQ2 and VQ4";
  subject.vq2_decode = decode<Block2>;
  subject.vq2_region = region<Block2>;
#ifndef REGIONS_ALONE
  subject.vq4_decode = decode<Block4>;
#endif
  subject.vq4_region = region<Block4>;
  return &subject;
}
