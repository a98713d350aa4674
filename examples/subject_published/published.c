/* The index function that the appendix "Reference Code" of VK_KHR_opacity_micromap describes, in binary32: what a shader
 * that follows it does. Beside it the same in GLSL, HLSL and Slang. */
#include "mmverify_subject.h"

/* Where a compiler may contract a product and a sum, tell it not to: -ffp-contract=off. */
static float unit(float x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

/* Bit k of x to bit 2k. */
static uint32_t apart(uint32_t x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

static uint32_t index_of(uint32_t level, float u, float v) {
  const uint32_t side = 1u << level, mask = side - 1;
  const float x = unit(u) * (float)side, y = unit(v) * (float)side;
  uint32_t iu = (uint32_t)x, iv = (uint32_t)y;
  const float fu = x - (float)iu, fv = y - (float)iv;
  uint32_t sum, iw, b0, t, f, b1;
  if (iu > mask) iu = mask;
  if (iv > mask) iv = mask;
  sum = iu + iv;
  if (sum >= side) iu -= sum - mask;
  iw = ~(iu + iv);
  if (fu + fv >= 1.0f && sum < mask) iw -= 1;
  b0 = ~(iu ^ iw) & mask;
  t = (iu ^ iv) & b0;
  f = t ^ t >> 1;
  f ^= f >> 2;
  f ^= f >> 4;
  f ^= f >> 8;
  b1 = ((f ^ iu) & ~b0 & mask) | t;
  return apart(b0) | apart(b1) << 1;
}

static void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) index[k] = index_of(level, u[k], v[k]);
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the published index function in binary32",
                                             .max_level = 16,
                                             .index_f32 = index_f32};
  return &subject;
}
