// The decision about a candidate hit: every API decides alike.
#include "shaders/traverse.glsl"

uint decide(uint api, uint candidate, uint instance_flags, uint ray_flags) {
  return mm_decide(candidate, instance_flags, ray_flags);
}
