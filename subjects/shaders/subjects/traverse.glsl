// The decision about a candidate hit, where every API decides alike; and hits that blend by a fixed function.
#include "shaders/traverse.glsl"

uint decide(uint api, uint candidate, uint instance_flags, uint ray_flags) {
  return mm_decide(candidate, instance_flags, ray_flags);
}

uint blend(uint operation, uint payload, uint value) { return mm_blend(operation, payload, value); }

// A hit is three words: its distance, whether it is accepted, its value.  The hits before the closest accepted one blend.
uint blend_hits(uint operation, uint payload, uint count) {
  float closest = uintBitsToFloat(0x7F800000u);
  for (uint k = 0u; k < count; ++k)
    if (mmverify_word(3u * k + 1u) != 0u) closest = min(closest, uintBitsToFloat(mmverify_word(3u * k)));
  for (uint k = 0u; k < count; ++k)
    if (mmverify_word(3u * k + 1u) == 0u && uintBitsToFloat(mmverify_word(3u * k)) < closest)
      payload = mm_blend(operation, payload, mmverify_word(3u * k + 2u));
  return payload;
}
