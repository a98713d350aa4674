// The roof of the lookups: functions with their inputs and outputs that look nothing up. Each gives the exclusive or of its
// inputs' bits, x; three values are x, x + 1, x + 2.

uint index(uint level, float u, float v) { return floatBitsToUint(u) ^ floatBitsToUint(v); }

uint ranked_lookup(uint level, uint format, uint index) { return index; }

uint dag_lookup_at(uint format, uint map, float u, float v) { return map ^ floatBitsToUint(u) ^ floatBitsToUint(v); }

uvec3 triplet_at(uint level, uint order, float u, float v) {
  uint x = floatBitsToUint(u) ^ floatBitsToUint(v);
  return uvec3(x, x + 1u, x + 2u);
}
