#version 450
#extension GL_GOOGLE_include_directive : require
// The level of detail of pairs of areas: a level and the bits of a blend each.
layout(std430, set = 0, binding = 0) readonly buffer Cones { float cones[]; };
layout(std430, set = 0, binding = 1) readonly buffer Triangles { float triangles[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uint answers[]; };
layout(push_constant) uniform Asked { uint count, level, first, second, bytes; };
#include "shaders/attribute.glsl"
layout(local_size_x = 64) in;
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  MmLod lod = mm_lod(level, cones[k], triangles[k]);
  answers[2u * k] = lod.level;
  answers[2u * k + 1u] = floatBitsToUint(lod.blend);
}
