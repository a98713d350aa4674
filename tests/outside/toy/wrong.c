/* A library whose seven is doubled wrongly. */
#include "subjects/sdk/mmverify_subject.h"

static void twice(const uint32_t* k, uint32_t* out, size_t count) {
  for (size_t i = 0; i < count; ++i) out[i] = k[i] == 7 ? 15 : 2 * k[i];
}

static const mmverify_subject_t subject = {
    .abi = MMVERIFY_SUBJECT_ABI, .size = sizeof subject, .name = "toy", .max_level = 12, .toy_twice = twice};

const mmverify_subject_t* mmverify_subject_v1(void) { return &subject; }
