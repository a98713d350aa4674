// Lookups in the form with counts, which mmverify encodes.
#define MM_TREE_WORD(k) mmverify_word(k)
#include "shaders/tree.glsl"

uint ranked_lookup(uint level, uint format, uint index) { return mm_ranked_lookup(index); }
