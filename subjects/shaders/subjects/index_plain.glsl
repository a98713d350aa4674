// The exact index without `precise`: a driver may rearrange it.
#define MM_PRECISE
#include "shaders/index.glsl"

uint index(uint level, float u, float v) { return mm_index_exact(level, u, v); }
