/* Laws of lossy codecs of 4-state maps, for every map of LEVEL, each with one rule for each state. */
#include "proofs/codecs/law.h"

/* A map and what stands for it: the same whatever the bits after the last state are, and zeros there. */
static void substituted(uint8_t* map, uint8_t* out) {
  uint8_t other[MAP_BYTES];
  any_map(LEVEL, FORMAT, map);
  READS(map, MAP_BYTES, codec()->micromap_substitute(LEVEL, map, out));
  check(padded(out, FORMAT, STATES));
  if (STATES * FORMAT % 8 == 0) return;
  any_padding(map, FORMAT, STATES);
  codec()->micromap_substitute(LEVEL, map, other);
  check_bytes(out, other, MAP_BYTES);
}

/* lossy.allowed: a state stays or becomes unknown. */
void allowed(void) {
  uint8_t map[MAP_BYTES], out[MAP_BYTES];
  substituted(map, out);
  for (size_t k = 0; k < STATES; ++k)
    check(state_of(out, FORMAT, k) == state_of(map, FORMAT, k) || state_of(out, FORMAT, k) >= 2);
}

/* lossy.conservative: T and O stay or become unknown, and an unknown state stays. */
void conservative(void) {
  uint8_t map[MAP_BYTES], out[MAP_BYTES];
  substituted(map, out);
  for (size_t k = 0; k < STATES; ++k)
    check(state_of(out, FORMAT, k) == state_of(map, FORMAT, k) ||
          (state_of(map, FORMAT, k) < 2 && state_of(out, FORMAT, k) >= 2));
}

/* lossy.force2_stable: T may become UT and O may become UO; nothing else changes. */
void force2_stable(void) {
  uint8_t map[MAP_BYTES], out[MAP_BYTES];
  substituted(map, out);
  for (size_t k = 0; k < STATES; ++k)
    check(state_of(out, FORMAT, k) == state_of(map, FORMAT, k) ||
          state_of(out, FORMAT, k) == state_of(map, FORMAT, k) + 2);
}
