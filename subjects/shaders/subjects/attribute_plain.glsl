// Attribute maps without `precise`: a driver may rearrange the weights.
#define MM_PRECISE
#include "shaders/attribute.glsl"

uvec3 triplet_at(uint level, uint order, float u, float v) { return mm_triplet(level, order, mm_hit(level, u, v).face); }
vec3 weights(uint level, float u, float v) { return mm_hit(level, u, v).weights; }

