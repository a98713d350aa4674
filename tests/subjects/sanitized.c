/* The example, with a fault that no answer shows and a sanitizer sees; at level 6 alone. */
#define mmverify_subject_v1 example_v1
#include "examples/subject/subject.c"
#undef mmverify_subject_v1

#include <limits.h>
#include <stdlib.h>

static volatile int sink;

static void index_at_fault(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  example_v1()->index_f32(level, u, v, index, count);
  if (level != 6) return;
#ifdef READS_PAST_ITS_TABLE
  volatile char* table = (volatile char*)malloc(level);
  sink = table[level];
  free((void*)table);
#else
  volatile int most = INT_MAX;
  sink = most + (int)level;
#endif
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject = *example_v1();
  subject.index_f32 = index_at_fault;
  return &subject;
}
