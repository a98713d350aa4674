#version 450
#extension GL_GOOGLE_include_directive : require
// Colours at a frame's hits, four words each: `second` 0 faces, in the first word, 1 vertices.  Binding 4 has the records,
// and behind them the values.
#include "shaders/attribute_api.glsl"
MM_TRIANGLE_MICROMAP_PLAIN(0, 4, 4, uint, face_colour)
MM_VERTEX_MICROMAP(0, 4, 4, vec4, vertex_colour)
layout(std430, set = 0, binding = 0) readonly buffer Us { float us[]; };
layout(std430, set = 0, binding = 1) readonly buffer Vs { float vs[]; };
layout(std430, set = 0, binding = 2) readonly buffer Triangles { uint triangles[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uvec4 answers[]; };
layout(push_constant) uniform Asked { uint count, level, first, second, bytes; };
layout(local_size_x = 64) in;
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  vec2 uv = vec2(us[k], vs[k]);
  if (second == 0u)
    answers[k] = uvec4(face_colour(triangles[k], uv), 0u, 0u, 0u);
  else
    answers[k] = floatBitsToUint(vertex_colour(triangles[k], uv));
}
