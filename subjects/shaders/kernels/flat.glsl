// A lookup in a flat map: states along the curve, two bits each.
#include "shaders/index.glsl"

uint tree_lookup_at(uint level, uint format, float u, float v) {
  uint index = mm_index_exact(level, u, v);
  return mmverify_word(index >> 4) >> 2u * (index & 15u) & 3u;
}
