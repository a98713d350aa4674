// Wrong orders that have a name, one of them chosen when it is linked.
#include "impl/index/index.hpp"
#include "sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

namespace {

uint32_t answer(uint32_t level, float u, float v) {
  using namespace mmverify::impl::index;
  static const bool rows = wrong_is("rows"), exchanged = wrong_is("u_and_v_exchanged");
  if (rows) return w_minor(u, v, level);
  if (exchanged) return from_barycentrics(v, u, level);
  // swapped_from_level_2
  const uint32_t index = from_barycentrics(u, v, level);
  if (level < 2) return index;
  // Even digits are children 0 and 2: their high bit flips, but for the first digit's.
  const uint32_t even = ~index & 0x55555555u & ((1u << (2 * level - 2)) - 1);
  return index ^ even << 1;
}

void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) index[k] = answer(level, u[k], v[k]);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.max_level = 16;
  subject.index_f32 = index_f32;
  return &subject;
}
