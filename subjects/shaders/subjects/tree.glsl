// Lookups in the paper's bit sequences.
#define MM_TREE_WORD(k) mmverify_word(k)
#include "shaders/index.glsl"
#include "shaders/tree.glsl"

uint tree_lookup(uint level, uint format, uint index) {
  return mm_tree_lookup(level, format, index, mm_tree_bits(8u * mmverify_byte_count()));
}

uint tree_lookup_at(uint level, uint format, float u, float v) {
  return tree_lookup(level, format, mm_index_exact(level, u, v));
}
