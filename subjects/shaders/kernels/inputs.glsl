#version 450
#extension GL_GOOGLE_include_directive : require
// Makes the hits of a bench in the device's memory. Hit k of 2^n is the centre of micro-triangle
// place(k) 2^(32-n) of level 16 on the curve, place(k) = k where hits are coherent, a permutation where they are
// shuffled. So both orders have the same hits.
#include "shaders/index.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer In0 { uint in0[]; };
layout(std430, set = 0, binding = 1) buffer In1 { uint in1[]; };
layout(std430, set = 0, binding = 2) buffer In2 { uint in2[]; };
layout(std430, set = 0, binding = 3) buffer Out { uint answer[]; };
layout(std430, set = 0, binding = 4) buffer Bytes { uint words[]; };
layout(push_constant) uniform Asked { uint count, level, kind, shuffled, log_hits; };

const uint POINTS = 0u, POINTS_OF_MAP = 1u, INDICES = 2u, SQUARE = 3u, STATES = 4u;

/// A bijection of 0..2^log_hits - 1: products with odd numbers, and shifts, modulo 2^log_hits.
uint place(uint k) {
  if (shuffled == 0u) return k;
  uint mask = (1u << log_hits) - 1u, shift = (log_hits + 1u) / 2u;
  k = k * 0x9e3779b1u & mask;
  k ^= k >> shift;
  k = k * 0x85ebca6bu & mask;
  return k ^ k >> shift;
}

/// Word k of a map of random states.
uint hashed(uint k) {
  k = (k ^ k >> 16) * 0x7feb352du;
  k = (k ^ k >> 15) * 0x846ca68bu;
  return k ^ k >> 16;
}

void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= count) return;
  if (kind == STATES) {
    words[k] = hashed(k);
    return;
  }
  uint number = place(k) << (32u - log_hits);
  uint cell = level == 0u ? 0u : number >> 2u * (16u - level);
  if (kind == INDICES) {
    in0[k] = cell;
    return;
  }
  if (kind == SQUARE) {
    // Along the Z curve of the square.
    in0[k] = mm_together(cell);
    in1[k] = mm_together(cell >> 1);
    return;
  }
  MmFace f = mm_curve_face(number);
  // A centre lies a third of a step above its square's corner, or two thirds.
  const float thirds = float(196608);  // check-magic: 196608 == 3 * 2**16
  uint u = floatBitsToUint(float(3u * f.iu + 1u + f.upper) / thirds);
  uint v = floatBitsToUint(float(3u * f.iv + 1u + f.upper) / thirds);
  if (kind == POINTS) {
    in0[k] = u;
    in1[k] = v;
  } else {
    in0[k] = 0u;
    in1[k] = u;
    in2[k] = v;
  }
  if (log_hits > 32u) answer[0] = 0u;  // never; a shader that uses no binding of answers would be refused
}
