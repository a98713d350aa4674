/* What traversal does with a candidate hit, in the order of Vulkan's chapter Ray Traversal, and with hits that blend. */
#include <math.h>
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

/* The code nearest to x / 255, for x up to 255 * 255. */
static uint32_t divided_by_255(uint32_t x) { return (2 * x + 255) / 510; }

static uint32_t least(uint32_t a, uint32_t b) { return a < b ? a : b; }

/* One code; alpha is the value's. */
static uint32_t blend_code(uint32_t operation, uint32_t p, uint32_t v, uint32_t alpha) {
  switch (operation) {
    case MMVERIFY_BLEND_MAX: return p > v ? p : v;
    case MMVERIFY_BLEND_MIN: return least(p, v);
    case MMVERIFY_BLEND_ADD: return least(p + v, 255);
    case MMVERIFY_BLEND_MULTIPLY: return divided_by_255(p * v);
    default: return least(v + divided_by_255(p * (255 - alpha)), 255);
  }
}

static uint32_t blend_one(uint32_t operation, uint32_t payload, uint32_t value) {
  uint32_t out = 0;
  for (unsigned shift = 0; shift < 32; shift += 8)
    out |= blend_code(operation, payload >> shift & 255, value >> shift & 255, value >> 24) << shift;
  return out;
}

static void blend(uint32_t operation, const uint32_t* payload, const uint32_t* value, uint32_t* out,
                  size_t count) {
  for (size_t k = 0; k < count; ++k) out[k] = blend_one(operation, payload[k], value[k]);
}

/* Once the closest accepted hit is known, the hits before it blend: whatever the order, one payload. */
static void blend_hits(const mmverify_blend_case_t* what, uint8_t* payload) {
  uint32_t word = what->payload;
  float closest = INFINITY;
  for (uint32_t k = 0; k < what->count; ++k)
    if (what->hits[k].accepted && what->hits[k].distance < closest) closest = what->hits[k].distance;
  for (uint32_t k = 0; k < what->count; ++k)
    if (!what->hits[k].accepted && what->hits[k].distance < closest)
      word = blend_one(what->operation, word, what->hits[k].value);
  for (unsigned k = 0; k < 4; ++k) payload[k] = (uint8_t)(word >> (8 * k));
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
                                             .name = "a traversal in C",
                                             .traverse_decide = decide,
                                             .traverse_blend = blend,
                                             .traverse_blend_hits = blend_hits};
  return &subject;
}
