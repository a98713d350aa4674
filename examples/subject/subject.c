/* A complete subject: the index of a hit, as a shader would have it, handed to mmverify for judgement. */
#include "mmverify_subject.h"
static float clamped(float x) { return x > 0 ? (x < 1 ? x : 1) : 0; }
static uint32_t spread(uint32_t x) {
  x = (x | x << 8) & 0x00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f;
  x = (x | x << 2) & 0x33333333;
  return (x | x << 1) & 0x55555555;
}

static uint32_t index_of(uint32_t level, float u, float v) {
  const uint32_t n = 1u << level;
  const float un = clamped(u) * (float)n, vn = clamped(v) * (float)n;
  uint32_t i = (uint32_t)un, j = (uint32_t)vn;
  const float uf = un - (float)i, vf = vn - (float)j;
  /* the sum uf + vf could round up to 1 */
  const int upper = uf > vf ? vf >= 1 - uf : uf >= 1 - vf;
  if (j > n - 1) j = n - 1;
  if (i > n - 1 - j) i = n - 1 - j;
  const uint32_t row = i + j + (upper && i + j < n - 1);
  const uint32_t b0 = i ^ row, t = (i ^ j) & b0;
  uint32_t f = t ^ t >> 1;
  f ^= f >> 2, f ^= f >> 4, f ^= f >> 8;
  return spread(b0) | spread(((f ^ i) & ~b0) | t) << 1;
}

static void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) index[k] = index_of(level, u[k], v[k]);
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example",
                                             .max_level = 16,
                                             .index_f32 = index_f32};
  return &subject;
}
