// A subject of large batches that says where it runs; KIND: what is wrong with it.
#include <cstdlib>

#include "impl/index/index.hpp"
#include "subjects/sdk/mmverify_subject.h"

#define RIGHT 0
#define SEES_BATCH 1
#define CRASHES 2
#define NOT_HERE 3
#define UNWRITTEN 4
#define WRITES_BEHIND 5

namespace {

void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const uint32_t right = mmverify::impl::index::from_barycentrics(u[k], v[k], level);
#if KIND == CRASHES
    if (level == 8 && u[k] == 0.5f && v[k] == 0.25f) std::abort();
#elif KIND == UNWRITTEN
    if (level == 8 && k == 65'535) continue;
#endif
    index[k] = KIND == SEES_BATCH && level == 8 && count > 4096 && k > 60'000 ? right ^ 1u : right;
  }
  if (KIND == WRITES_BEHIND && reinterpret_cast<uintptr_t>(index + count) % 4096 != 0) index[count] = 0;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "large batches";
  subject.max_level = 16;
  subject.flags = MMVERIFY_LARGE_BATCHES;
  subject.index_f32 = index_f32;
  subject.runs_on = "machine: a test's\nno colon here\n";
  return KIND == NOT_HERE ? nullptr : &subject;
}

#if KIND == NOT_HERE
extern "C" const char* mmverify_subject_v1_not_here(void) { return "the moon is not up"; }
#endif
