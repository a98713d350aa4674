/* Laws of tree codecs, for every map of LEVEL and FORMAT.  SIZE: bytes that a code may have, or of a hostile code. */
#include "proofs/codecs/law.h"

/* Nodes of the largest tree, and bytes of its code in the paper's form. */
enum { NODES = (4 * STATES - 1) / 3, LONGEST = (NODES + 7) / 8 + MAP_BYTES };
/* Bits of a number up to SIZE. */
enum { CAPACITY_BITS = SIZE == 0 ? 1 : 32 - __builtin_clz(SIZE + (SIZE == 0)) };

/* tree.round_trip */
void round_trip(void) {
  uint8_t map[MAP_BYTES], code[SIZE], back[MAP_BYTES];
  size_t size;
  any_map(LEVEL, FORMAT, map);
  READS(map, MAP_BYTES, size = codec()->tree_encode(LEVEL, FORMAT, map, code, SIZE));
  check(size > 0);
  room(size <= SIZE);
  READS_SOME(code, SIZE, size, check(codec()->tree_decode(LEVEL, FORMAT, code, size, back)));
  check_bytes(back, map, MAP_BYTES);
}

/* tree.round_trip, of the encoder alone, for any capacity: the size is the same, no byte behind the capacity changes, and
 * the code is the same wherever it fits. */
void exact_size(void) {
  uint8_t map[MAP_BYTES], code[SIZE], whole[SIZE];
  any_map(LEVEL, FORMAT, map);
  const uint8_t before = (uint8_t)any(8);
  const size_t capacity = any(CAPACITY_BITS);
  assume(capacity <= SIZE);
  for (size_t k = 0; k < SIZE; ++k) code[k] = before;
  const size_t size = codec()->tree_encode(LEVEL, FORMAT, map, whole, SIZE);
  check_is(codec()->tree_encode(LEVEL, FORMAT, map, code, capacity), size);
  room(size <= SIZE);
  for (size_t k = 0; k < SIZE; ++k) check(k < capacity || code[k] == before);
  for (size_t k = 0; k < SIZE; ++k) check(capacity < size || k >= size || code[k] == whole[k]);
}

/* tree.lookup_is_decode: any index, at each place of a batch of three, and alone. */
void lookup(void) {
  uint8_t map[MAP_BYTES], code[SIZE];
  any_map(LEVEL, FORMAT, map);
  const uint32_t index = LEVEL == 0 ? 0 : (uint32_t)any(LEVEL == 0 ? 1 : 2 * LEVEL);
  const size_t size = codec()->tree_encode(LEVEL, FORMAT, map, code, SIZE);
  room(size <= SIZE);
  for (size_t place = 0; place < 3; ++place) {
    uint32_t batch[3] = {STATES - 1, 0, STATES / 2};
    uint8_t state[3];
    batch[place] = index;
    codec()->tree_lookup(LEVEL, FORMAT, code, size, batch, state, 3);
    for (size_t k = 0; k < 3; ++k) check_is(state[k], state_of(map, FORMAT, batch[k]));
    check(batch[0] == (place == 0 ? index : STATES - 1) && batch[1] == (place == 1 ? index : 0) &&
          batch[2] == (place == 2 ? index : STATES / 2));
  }
  uint8_t alone;
  READS_SOME(code, SIZE, size, codec()->tree_lookup(LEVEL, FORMAT, code, size, &index, &alone, 1));
  check_is(alone, state_of(map, FORMAT, index));
}

/* tree.lookup_is_decode, at level 1: any four indices in one batch. */
void lookups(void) {
  uint8_t map[MAP_BYTES], code[SIZE], state[4];
  uint32_t index[4];
  any_map(LEVEL, FORMAT, map);
  for (size_t k = 0; k < 4; ++k) index[k] = (uint32_t)any(LEVEL == 0 ? 1 : 2 * LEVEL);
  const size_t size = codec()->tree_encode(LEVEL, FORMAT, map, code, SIZE);
  room(size <= SIZE);
  codec()->tree_lookup(LEVEL, FORMAT, code, size, index, state, 4);
  for (size_t k = 0; k < 4; ++k) check_is(state[k], state_of(map, FORMAT, index[k]));
}

/* tree.malformed: any SIZE bytes are refused, or are a map with zeros after its last state. */
void malformed(void) {
  uint8_t code[SIZE + (SIZE == 0)], map[MAP_BYTES];
  any_bytes(code, SIZE);
  int taken;
  READS(code, SIZE, taken = codec()->tree_decode(LEVEL, FORMAT, code + (SIZE == 0), SIZE, map));
  if (!taken) return;
  check(padded(map, FORMAT, STATES));
  require_whole(map);
}

/* tree.canonical: any SIZE bytes that are decoded are what the encoder makes of their map. */
void canonical(void) {
  uint8_t code[SIZE + (SIZE == 0)], map[MAP_BYTES], again[LONGEST];
  any_bytes(code, SIZE);
  if (codec()->tree_decode(LEVEL, FORMAT, code + (SIZE == 0), SIZE, map)) {
    check_is(codec()->tree_encode(LEVEL, FORMAT, map, again, LONGEST), SIZE);
    check_bytes(code, again, SIZE < LONGEST ? SIZE : LONGEST);
  }
}

/* The paper's two sequences, Algorithms 1 and 2, bit by bit. */
typedef struct {
  uint8_t tree[(NODES + 7) / 8], data[MAP_BYTES];
  size_t nodes, leaves;
} Sequences;

static void subtree(const uint8_t* map, uint32_t level, size_t first, Sequences* to) {
  int same = 1;
  for (size_t k = 1; k < (size_t)1 << 2 * level; ++k)
    same &= state_of(map, FORMAT, first + k) == state_of(map, FORMAT, first);
  put_state(to->tree, 1, to->nodes++, !same);
  if (same)
    put_state(to->data, FORMAT, to->leaves++, state_of(map, FORMAT, first));
  else
    for (size_t child = 0; child < 4; ++child)
      subtree(map, level - 1, first + (child << 2 * (level - 1)), to);
}

/* tree.equals_spec: the code is those two sequences, the second from a whole byte on. */
void equals_spec(void) {
  uint8_t map[MAP_BYTES], code[LONGEST];
  any_map(LEVEL, FORMAT, map);
  Sequences due;
  memset(&due, 0, sizeof due);
  subtree(map, LEVEL, 0, &due);
  const size_t tree_bytes = bytes_for(due.nodes, 1), size = tree_bytes + bytes_for(due.leaves, FORMAT);
  READS(map, MAP_BYTES, check_is(codec()->tree_encode(LEVEL, FORMAT, map, code, LONGEST), size));
  for (size_t k = 0; k < LONGEST; ++k)
    check(k >= size || code[k] == (k < tree_bytes ? due.tree[k] : due.data[k - tree_bytes]));
}
