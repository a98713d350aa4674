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
