// The library's own VQ2 as a subject: the sources of its decoder, word for word, in one file.
#include <algorithm>

#include "impl/vq/two/decode.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::vq;

Block2 block_of(const uint8_t* bytes) {
  Block2 block;
  std::memcpy(block.data(), bytes, block.size());
  return block;
}

void decode(const uint8_t* block, uint8_t* map) {
  const Map2 states = mmverify::impl::vq::decode(block_of(block));
  std::memcpy(map, states.data(), states.size());
}
void region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state, size_t count) {
  const Block2 of = block_of(block);
  for (size_t k = 0; k < count; ++k)
    state[k] = static_cast<uint8_t>(mmverify::impl::vq::region(of, x[k], y[k]));
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own VQ2";
  subject.vq2_decode = decode;
  subject.vq2_region = region;
  return &subject;
}
