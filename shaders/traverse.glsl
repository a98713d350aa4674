// What traversal does with a candidate hit before any shader runs.
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

#endif
