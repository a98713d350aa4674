/* What traversal does with a candidate hit, in the order of Vulkan's chapter Ray Traversal. */
#include <stddef.h>
#include <stdint.h>

#include "mmverify_subject.h"

enum { T, O, UT, UO };
enum { FORCE_OPAQUE = 4, FORCE_NO_OPAQUE = 8, INSTANCE_2_STATE = 16, DISABLE_MICROMAPS = 32 };
enum { RAY_OPAQUE = 1, RAY_NO_OPAQUE = 2, CULL_OPAQUE = 64, CULL_NO_OPAQUE = 128, RAY_2_STATE = 1024 };

static uint8_t decide_one(uint32_t candidate, uint32_t instance, uint32_t ray) {
  uint8_t outcome;
  if ((candidate & MMVERIFY_CANDIDATE_HAS_MICROMAP) && !(instance & DISABLE_MICROMAPS)) {
    const uint32_t state = candidate & MMVERIFY_CANDIDATE_STATE;
    const int two_state = (instance & INSTANCE_2_STATE) || (ray & RAY_2_STATE);
    if (state == T || (state == UT && two_state)) return MMVERIFY_IGNORED; /* no flag brings it back */
    outcome = state == O || two_state ? MMVERIFY_OPAQUE : MMVERIFY_NON_OPAQUE;
  } else {
    outcome = candidate & MMVERIFY_CANDIDATE_GEOMETRY_OPAQUE ? MMVERIFY_OPAQUE : MMVERIFY_NON_OPAQUE;
  }
  if (instance & FORCE_OPAQUE) outcome = MMVERIFY_OPAQUE;
  if (instance & FORCE_NO_OPAQUE) outcome = MMVERIFY_NON_OPAQUE;
  if (ray & RAY_OPAQUE) outcome = MMVERIFY_OPAQUE;
  if (ray & RAY_NO_OPAQUE) outcome = MMVERIFY_NON_OPAQUE;
  if ((ray & CULL_OPAQUE) && outcome == MMVERIFY_OPAQUE) return MMVERIFY_IGNORED;
  if ((ray & CULL_NO_OPAQUE) && outcome == MMVERIFY_NON_OPAQUE) return MMVERIFY_IGNORED;
  return outcome;
}

/* Every API decides alike. */
static void decide(uint32_t api, const uint32_t* candidate, const uint32_t* instance_flags,
                   const uint32_t* ray_flags, uint8_t* outcome, size_t count) {
  (void)api;
  for (size_t k = 0; k < count; ++k) outcome[k] = decide_one(candidate[k], instance_flags[k], ray_flags[k]);
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the decision in C",
                                             .traverse_decide = decide};
  return &subject;
}
