#version 450
// The roof of the lookups: a kernel that reads as many words a hit as they do, and writes as many.
//   answer j of hit k = the exclusive or of the hit's words, plus j
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer In0 { uint in0[]; };
layout(std430, set = 0, binding = 1) readonly buffer In1 { uint in1[]; };
layout(std430, set = 0, binding = 2) readonly buffer In2 { uint in2[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Out { uint answer[]; };
layout(push_constant) uniform Asked { uint count, level, words_in, words_out, bytes; };

void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  uint x = in0[k];
  if (words_in > 1u) x ^= in1[k];
  if (words_in > 2u) x ^= in2[k];
  for (uint j = 0u; j < words_out; ++j) answer[words_out * k + j] = x + j;
}
