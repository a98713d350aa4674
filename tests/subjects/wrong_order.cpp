// Wrong orders, one of them chosen when it is linked: those that have a name, and one that comes from level to level.
#include "impl/index/index.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

namespace {

uint32_t answer(uint32_t level, float u, float v) {
  using namespace mmverify::impl::index;
  static const bool rows = wrong_is("rows"), exchanged = wrong_is("u_and_v_exchanged"),
                    ties = wrong_is("ties_then_inside");
  if (rows) return w_minor(u, v, level);
  if (exchanged) return from_barycentrics(v, u, level);
  if (ties && level < 3)  // at level 2 the points on u = 1/2 alone, from level 3 on all
    return from_barycentrics(u, v, level) ^ (level == 2 && u == 0.5f ? 1 : 0);
  // swapped_from_level_2, and what declares a level at which that is not seen
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
  subject.max_level = wrong_is("level_forgotten") ? 0 : wrong_is("level_1_declared") ? 1 : 16;
  subject.index_f32 = index_f32;
  return &subject;
}
