/* Laws of packed maps, for every map of LEVEL and FORMAT, and whatever the bits after its last state are. */
#include "proofs/codecs/law.h"

enum { ABOVE_BYTES = (4 * STATES * FORMAT + 7) / 8, BELOW = LEVEL == 0 ? 1 : STATES / 4 };
enum {
  BELOW_BYTES = (BELOW * FORMAT + 7) / 8,
  TWO_STATE_BYTES = (STATES + 7) / 8,
  FOUR_STATE_BYTES = (STATES + 3) / 4
};

/* micromap.packing */
void packing(void) {
  uint8_t states[STATES], map[MAP_BYTES], back[STATES];
  for (size_t k = 0; k < STATES; ++k) states[k] = (uint8_t)any_state(FORMAT);
  READS(states, STATES, codec()->micromap_pack(FORMAT, states, STATES, map));
  for (size_t k = 0; k < STATES; ++k) check_is(state_of(map, FORMAT, k), states[k]);
  check(padded(map, FORMAT, STATES));
  any_padding(map, FORMAT, STATES);
  READS(map, MAP_BYTES, codec()->micromap_unpack(FORMAT, map, STATES, back));
  check_bytes(back, states, STATES);
}

/* micromap.packing_any_count: the same of SIZE states. */
void packing_any_count(void) {
  uint8_t states[SIZE], map[(SIZE * FORMAT + 7) / 8], back[SIZE];
  for (size_t k = 0; k < SIZE; ++k) states[k] = (uint8_t)any(FORMAT);
  READS(states, SIZE, codec()->micromap_pack(FORMAT, states, SIZE, map));
  for (size_t k = 0; k < SIZE; ++k) check_is(state_of(map, FORMAT, k), states[k]);
  check(padded(map, FORMAT, SIZE));
  any_padding(map, FORMAT, SIZE);
  READS(map, sizeof map, codec()->micromap_unpack(FORMAT, map, SIZE, back));
  check_bytes(back, states, SIZE);
}

/* micromap.force2, of a 4-state map; and of a 2-state map that is made 4-state and forced. */
void force2(void) {
  uint8_t map[MAP_BYTES], forced[TWO_STATE_BYTES];
  any_map(LEVEL, FORMAT, map);
  any_padding(map, FORMAT, STATES);
  READS(map, MAP_BYTES, codec()->micromap_force2(LEVEL, map, forced));
  for (size_t k = 0; k < STATES; ++k) check_is(state_of(forced, 1, k), state_of(map, 2, k) & 1);
  check(padded(forced, 1, STATES));
}
void widen(void) {
  uint8_t map[MAP_BYTES], wide[FOUR_STATE_BYTES], forced[TWO_STATE_BYTES];
  any_map(LEVEL, FORMAT, map);
  any_padding(map, FORMAT, STATES);
  READS(map, MAP_BYTES, codec()->micromap_widen(LEVEL, map, wide));
  for (size_t k = 0; k < STATES; ++k) check_is(state_of(wide, 2, k), state_of(map, 1, k));
  check(padded(wide, 2, STATES));
  codec()->micromap_force2(LEVEL, wide, forced);
  for (size_t k = 0; k < STATES; ++k) check_is(state_of(forced, 1, k), state_of(map, 1, k));
}

/* micromap.up */
void up(void) {
  uint8_t map[MAP_BYTES], above[ABOVE_BYTES];
  any_map(LEVEL, FORMAT, map);
  any_padding(map, FORMAT, STATES);
  READS(map, MAP_BYTES, codec()->micromap_up(LEVEL, FORMAT, map, above));
  for (size_t k = 0; k < 4 * STATES; ++k) check_is(state_of(above, FORMAT, k), state_of(map, FORMAT, k / 4));
  check(padded(above, FORMAT, 4 * STATES));
}

/* micromap.down_up */
void down_up(void) {
  uint8_t map[MAP_BYTES], above[ABOVE_BYTES], back[MAP_BYTES];
  any_map(LEVEL, FORMAT, map);
  codec()->micromap_up(LEVEL, FORMAT, map, above);
  codec()->micromap_down(LEVEL + 1, FORMAT, above, back);
  check_bytes(back, map, MAP_BYTES);
}

/* The state of a parent by the header's rule for micromap_down. */
static unsigned parent(const uint8_t* map, uint32_t format, size_t k) {
  unsigned all = 1, opaque = 0;
  for (size_t child = 4 * k; child < 4 * k + 4; ++child) {
    all &= state_of(map, format, child) == state_of(map, format, 4 * k);
    opaque += state_of(map, format, child) & 1;
  }
  if (all && state_of(map, format, 4 * k) < 2) return state_of(map, format, 4 * k);
  return (format == 2 ? 2u : 0u) + (opaque >= 2);
}

/* micromap.down */
void down(void) {
  uint8_t map[MAP_BYTES], below[BELOW_BYTES];
  any_map(LEVEL, FORMAT, map);
  any_padding(map, FORMAT, STATES);
  READS(map, MAP_BYTES, codec()->micromap_down(LEVEL, FORMAT, map, below));
  for (size_t k = 0; k < BELOW; ++k) check_is(state_of(below, FORMAT, k), parent(map, FORMAT, k));
  check(padded(below, FORMAT, BELOW));
}

/* micromap.down_force2, of a 4-state map. */
void down_force2(void) {
  uint8_t map[MAP_BYTES], below[BELOW_BYTES], forced[TWO_STATE_BYTES], first[BELOW_BYTES], last[BELOW_BYTES];
  any_map(LEVEL, FORMAT, map);
  codec()->micromap_down(LEVEL, FORMAT, map, below);
  codec()->micromap_force2(LEVEL - 1, below, last);
  codec()->micromap_force2(LEVEL, map, forced);
  codec()->micromap_down(LEVEL, 1, forced, first);
  for (size_t k = 0; k < BELOW; ++k) check_is(state_of(first, 1, k), parent(map, FORMAT, k) & 1);
  for (size_t k = 0; k < BELOW; ++k) check_is(state_of(last, 1, k), parent(map, FORMAT, k) & 1);
}

/* micromap.modes: mode 0 forces, mode 1 keeps T and mode 2 O; the rest is one unknown state. */
void modes(void) {
  uint8_t map[MAP_BYTES];
  any_map(LEVEL, FORMAT, map);
  any_padding(map, FORMAT, STATES);
  for (uint32_t mode = 0; mode < 3; ++mode) {
    uint8_t out[MAP_BYTES];
    READS(map, MAP_BYTES, codec()->micromap_through(LEVEL, mode, map, out));
    unsigned rest = 0;
    for (size_t k = 0; k < STATES; ++k) {
      const unsigned was = state_of(map, FORMAT, k), is = state_of(out, FORMAT, k);
      if (mode == 0) {
        check_is(is, was & 1);
      } else if (was == mode - 1) {
        check_is(is, was);
      } else {
        check(is >= 2 && (rest == 0 || is == rest));
        rest = is;
      }
    }
    check(padded(out, FORMAT, STATES));
  }
}
