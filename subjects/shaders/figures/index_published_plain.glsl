// The published index without `precise`.
#define MM_PRECISE
#include "shaders/index.glsl"
uint index(uint level, float u, float v) { return mm_index_published(level, u, v); }
