// The index as Vulkan's reference code has it, in binary32 without contraction.
#include "shaders/index.glsl"

uint index(uint level, float u, float v) { return mm_index_published(level, u, v); }
