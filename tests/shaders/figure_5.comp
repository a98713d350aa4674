#version 450
#extension GL_GOOGLE_include_directive : require
// Values of the attribute API at points: the triangle is the push constant `first`; `second` 0 reads vertices, 1 faces, at the
// level of detail `level`.
#include "shaders/attribute_api.glsl"
MM_VERTEX_MICROMAP(0, 4, 2, float, at_vertices)
MM_TRIANGLE_MICROMAP(0, 4, 2, float, at_faces)
layout(std430, set = 0, binding = 0) readonly buffer Us { float us[]; };
layout(std430, set = 0, binding = 1) readonly buffer Vs { float vs[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uint answers[]; };
layout(push_constant) uniform Asked { uint count, level, first, second, bytes; };
layout(local_size_x = 64) in;
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  vec2 uv = vec2(us[k], vs[k]);
  MmLod lod = MmLod(level, 0.0);
  answers[k] = floatBitsToUint(second == 0u ? at_vertices_lod(first, uv, lod) : at_faces_lod(first, uv, lod));
}
