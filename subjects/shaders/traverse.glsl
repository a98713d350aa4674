// The decision of traversal on a candidate hit before any shader runs, and fixed functions on payloads.
#ifndef MMVERIFY_SHADERS_TRAVERSE
#define MMVERIFY_SHADERS_TRAVERSE

const uint MM_IGNORED = 0u, MM_OPAQUE = 1u, MM_NON_OPAQUE = 2u;

/// Domain: candidate is the state, T 0, O 1, UT 2, UO 3, with 4 where a micromap gave it and 8 where the geometry is opaque;
/// flags of the instance and of the ray with Vulkan's and SPIR-V's numbers, force-2-state 16 and 1024.
/// Source: Vulkan, chapter Ray Traversal; docs/TRAVERSE.md.
uint mm_decide(uint candidate, uint instance_flags, uint ray_flags) {
  uint state = candidate & 3u;
  bool two_state = (instance_flags & 16u) != 0u || (ray_flags & 1024u) != 0u;
  uint outcome = (candidate & 8u) != 0u ? MM_OPAQUE : MM_NON_OPAQUE;
  if ((candidate & 4u) != 0u && (instance_flags & 32u) == 0u) {
    if (state == 0u || (state == 2u && two_state)) return MM_IGNORED;  // no flag brings it back
    outcome = state == 1u || two_state ? MM_OPAQUE : MM_NON_OPAQUE;
  }
  if ((instance_flags & 4u) != 0u) outcome = MM_OPAQUE;
  if ((instance_flags & 8u) != 0u) outcome = MM_NON_OPAQUE;
  if ((ray_flags & 1u) != 0u) outcome = MM_OPAQUE;
  if ((ray_flags & 2u) != 0u) outcome = MM_NON_OPAQUE;
  if ((ray_flags & 64u) != 0u && outcome == MM_OPAQUE) return MM_IGNORED;
  if ((ray_flags & 128u) != 0u && outcome == MM_NON_OPAQUE) return MM_IGNORED;
  return outcome;
}

const uint MM_BLEND_MAX = 0u, MM_BLEND_MIN = 1u, MM_BLEND_ADD = 2u, MM_BLEND_MULTIPLY = 3u, MM_BLEND_OVER = 4u;

/// The code nearest to x / 255, exactly.  Domain: x up to 255 * 255.
uint mm_divided_by_255(uint x) { return (x + 128u + ((x + 128u) >> 8)) >> 8; }

/// A payload after a hit with this value, by a fixed function: four codes x / 255 to a word, R in the lowest byte.
///   max(p, v) | min(p, v) | min(255, p + v) | p v / 255 | min(255, v + p (255 - alpha) / 255), alpha the value's own
/// Source: Color and Attribute Micromaps, 4.3; docs/TRAVERSE.md.
uint mm_blend(uint operation, uint payload, uint value) {
  uint result = 0u, kept = 255u - (value >> 24);
  for (uint shift = 0u; shift < 32u; shift += 8u) {
    uint p = (payload >> shift) & 255u, v = (value >> shift) & 255u, code;
    if (operation == MM_BLEND_MAX) code = max(p, v);
    else if (operation == MM_BLEND_MIN) code = min(p, v);
    else if (operation == MM_BLEND_ADD) code = min(p + v, 255u);
    else if (operation == MM_BLEND_MULTIPLY) code = mm_divided_by_255(p * v);
    else code = min(v + mm_divided_by_255(p * kept), 255u);
    result |= code << shift;
  }
  return result;
}

#endif
