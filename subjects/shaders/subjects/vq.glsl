// Regions of square maps.
#define MM_VQ_WORD(k) mmverify_word(k)
#include "shaders/vq.glsl"

uint vq2_region(uint x, uint y) { return mm_vq2_region(x, y); }
uint vq4_region(uint x, uint y) { return mm_vq4_region(x, y); }
