// Functions that are wrong, or that cannot be judged: for tests/outside/source_test.sh.
#include "shaders/index.glsl"

/// One pair of 2^60 has the index of its neighbour.
uint one_pair(uint level, float u, float v) {
  uint index = mm_index_exact(level, u, v);
  return floatBitsToUint(u) == 0x3ea2f983u && floatBitsToUint(v) == 0x3d4ccccdu ? index ^ 1u : index;
}

/// The sum in binary32, as the specification's appendix has it.
uint plain_sum(uint level, float u, float v) { return mm_index_published(level, u, v); }

/// Beyond 32 bits, and so undefined.
uint far(uint level, float u, float v) { return uint(u * 5.0e9f) + level; }

uint third(uint level, float u, float v) { return uint(u / 3.0f) + level; }
uint of_buffer(uint level, float u, float v) { return mmverify_word(level) + uint(u); }
mediump float twice(mediump float x) { return x * 2.0f; }
uint in_16_bits(uint level, float u, float v) { return uint(twice(u)); }
uint rounds(uint level, float u, float v) { return uint(round(u)); }
uint endless(uint level, float u, float v) {
  uint k = 0u;
  while (u > 0.5f) {
    u *= v;
    ++k;
  }
  return k;
}

/// What the specification of SPIR-V leaves open, on one u each.
bool one(float u) { return floatBitsToUint(u) == 0x3e9e3779u; }
uint of_nan(uint level, float u, float v) {
  float infinite = uintBitsToFloat(0x7f800000u);
  float x = one(u) ? infinite - infinite : 0.25f;
  return mm_index_exact(level, u, v) ^ uint(min(x, 0.5f));
}
uint turned_clamp(uint level, float u, float v) {
  return mm_index_exact(level, u, v) ^ clamp(0u, one(u) ? 1u : 0u, 0u);
}
uint negative_rest(uint level, float u, float v) {
  int x = one(u) ? -3 : 3;
  return mm_index_exact(level, u, v) ^ uint(x % 3);
}
uint field_beyond(uint level, float u, float v) {
  return mm_index_exact(level, u, v) ^ bitfieldExtract(0u, one(u) ? 20 : 4, 20);
}
uint never_set(uint level, float u, float v) {
  uint z;
  if (!one(u)) z = 0u;
  return mm_index_exact(level, u, v) ^ z;
}
uint set_late(uint level, float u, float v) {
  uint t[2];
  if (!one(u)) t = uint[2](0u, 0u);
  return mm_index_exact(level, u, v) ^ t[u > v ? 1 : 0];
}
uint two_of_a_name(uint level, float u, float v) { return mm_index_exact(level, u, v); }
uint two_of_a_name(float u, float v, uint level) { return 0u; }
/// A variable that is never set, less itself: refuted before spirv-opt makes OpUndef of it, and after.
uint less_itself(uint level, float u, float v) {
  uint z;
  return mm_index_exact(level, u, v) ^ (one(u) ? z - z : 0u);
}
/// A read beyond an array of which no bit comes into the index.
uint of_no_bits(uint level, float u, float v) {
  uint zeros[2] = uint[2](0u, 0u);
  return mm_index_exact(level, u, v) ^ (zeros[one(u) ? 2 : 1] & 0u);
}
layout(constant_id = 0) const uint zero = 0u;
uint specialized(uint level, float u, float v) { return mm_index_exact(level, u, v) ^ zero; }
