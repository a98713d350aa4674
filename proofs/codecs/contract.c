/* Laws of tree codecs by recursion, from level to level.  LEVEL: of the map.  `step` shows the contract of
 * mmverify_contract_t for the subtrees of level SIZE, given that of the level below; `whole` shows the law for the entry
 * points, given the contract of the map's own level.
 *
 * The contract of a subtree: measure and write move over the same lengths, and write changes nothing else; whatever its
 * place, as long as the bits that it wrote stay, skip moves over them, read gives its states back, and find each one. */
#include "proofs/codecs/law.h"

/* A function of the law runs wherever the codec calls its own. */
void stands_for(const void* own, const void* other);
/* Memory of `size` bytes of any content. What a read gives is any, except at `count` places, which keep what is written. */
uint8_t* watched_memory(size_t size, const size_t* places, size_t count);

typedef mmverify_place_t Place;

/* States, and places in codes, are below 2^PLACE_BITS, as those of level 12 are. */
enum { PLACE_BITS = 25, WATCHES = 6 };
/* States and bytes of the subtree at hand. */
enum { INSIDE = 1 << 2 * SIZE, INSIDE_BYTES = (INSIDE * FORMAT + 7) / 8, BYTE_BITS = INSIDE * FORMAT < 8 ? INSIDE * FORMAT : 8 };

/* Bytes of a sequence whose content is followed; all others may be anything. */
typedef struct {
  uint8_t* bytes;
  uint32_t bits; /* of an item: 1 in a tree, FORMAT in data */
  size_t watch[WATCHES], watches;
  size_t item; /* one item, any */
} Sequence;

/* A subtree whose functions are taken by contract. */
typedef struct {
  Place length, at;
  int written;
  unsigned node, state; /* at the items of the sequences */
  unsigned asked;       /* the state at `asked_index` of the subtree */
} Subtree;

/* The map, and what is read. */
static uint8_t *map, *out;
static Sequence tree, data;
/* The subtrees at hand: how many, their level, the first one's first state, and whether they follow in one range. */
static Subtree part[4];
static uint32_t parts, part_level;
static size_t first_state;
/* A state that is asked for: its number in a subtree is the lowest bits. */
static size_t asked_index;

static size_t any_below(size_t limit) { /* limit: a power of two */
  return limit <= 1 ? 0 : (size_t)any((uint32_t)__builtin_ctzll(limit));
}

static unsigned item_of(const Sequence* s, size_t k) {
  return s->bytes[k * s->bits / 8] >> k * s->bits % 8 & ((1u << s->bits) - 1);
}

static int in(size_t k, size_t from, size_t to) { return k >= from && k < to; }

/* The bits of byte `at` that belong to the items `from` to `to`. */
static unsigned mask_of(const Sequence* s, size_t at, size_t from, size_t to) {
  unsigned mask = 0;
  for (size_t k = 0; k < 8; ++k)
    if (in((8 * at + k) / s->bits, from, to)) mask |= 1u << k;
  return mask;
}

/* Any bits for the items. */
static void become_any(Sequence* s, size_t from, size_t to) {
  for (size_t w = 0; w < s->watches; ++w) {
    const unsigned mask = mask_of(s, s->watch[w], from, to);
    uint8_t* byte = s->bytes + s->watch[w];
    *byte = (uint8_t)((*byte & ~mask) | ((unsigned)any(8) & mask));
  }
}

static void become_zero(Sequence* s, size_t from, size_t to) {
  for (size_t w = 0; w < s->watches; ++w)
    s->bytes[s->watch[w]] = (uint8_t)(s->bytes[s->watch[w]] & ~mask_of(s, s->watch[w], from, to));
}

static Place end_of(const Subtree* p) {
  return (Place){p->at.nodes + p->length.nodes, p->at.leaves + p->length.leaves};
}

static int same_place(const Place* a, const Place* b) { return a->nodes == b->nodes && a->leaves == b->leaves; }

static void move_over(Place* at, const Subtree* p) {
  at->nodes += p->length.nodes;
  at->leaves += p->length.leaves;
}

/* Any length of a subtree of the level, and some more: that nodes and leaves are 4 j + 1 and 3 j + 1 follows from what
 * written() checks, and no step needs it. */
static Place any_length(uint32_t level) {
  const Place length = {any(2 * level + 1), any(2 * level + 1)};
  assume(length.nodes >= 1 && length.leaves >= 1);
  return length;
}

static size_t states_of_part(void) { return (size_t)1 << 2 * part_level; }

/* The part whose first state that is. */
static Subtree* part_of(size_t first) {
  for (uint32_t c = 0; c < parts; ++c)
    if (first == first_state + c * states_of_part()) return part + c;
  check(0);
  return part;
}

/* The number of the part whose code begins there. */
static uint32_t part_at(const Place* at) {
  for (uint32_t c = 0; c < parts; ++c)
    if (part[c].written && at->nodes == part[c].at.nodes) return c;
  check(0);
  return 0;
}

/* Its bits are as they were written. */
static void require_unchanged(const Subtree* p) {
  const Place end = end_of(p);
  check(p->written);
  check(!in(tree.item, p->at.nodes, end.nodes) || item_of(&tree, tree.item) == p->node);
  check(!in(data.item, p->at.leaves, end.leaves) || item_of(&data, data.item) == p->state);
}

/* ---- the contract, in place of the codec's functions */

static void measure_part(uint32_t level, uint32_t format, const uint8_t* m, size_t first, Place* at) {
  check(level == part_level && format == FORMAT && m == map);
  move_over(at, part_of(first));
}

static void write_part(uint32_t level, uint32_t format, const uint8_t* m, size_t first, uint8_t* nodes,
                       uint8_t* leaves, Place* at) {
  check(level == part_level && format == FORMAT && m == map && nodes == tree.bytes && leaves == data.bytes);
  Subtree* p = part_of(first);
  p->at = *at;
  const Place end = end_of(p);
  check(end.nodes >> PLACE_BITS == 0 && end.leaves >> PLACE_BITS == 0);
  check(!in(tree.item, at->nodes, end.nodes) || item_of(&tree, tree.item) == 0);
  check(!in(data.item, at->leaves, end.leaves) || item_of(&data, data.item) == 0);
  become_any(&tree, at->nodes, end.nodes);
  become_any(&data, at->leaves, end.leaves);
  p->node = item_of(&tree, tree.item);
  p->state = item_of(&data, data.item);
  p->written = 1;
  *at = end;
}

static int skip_part(uint32_t level, const uint8_t* nodes, size_t most, Place* at) {
  check(level == part_level && nodes == tree.bytes);
  const Subtree* p = part + part_at(at);
  check(end_of(p).nodes <= most);
  require_unchanged(p);
  move_over(at, p);
  return 1;
}

static int read_part(uint32_t level, uint32_t format, const uint8_t* nodes, const uint8_t* leaves, size_t first,
                     Place* at, uint8_t* to) {
  check(level == part_level && format == FORMAT && nodes == tree.bytes && leaves == data.bytes);
  const Subtree* p = part_of(first);
  check(same_place(at, &p->at) && to == out);
  require_unchanged(p);
  for (size_t k = first; k < first + states_of_part(); ++k) {
    check(state_of(to, FORMAT, k) == 0);
    put_state(to, FORMAT, k, state_of(map, FORMAT, k));
  }
  move_over(at, p);
  return 1;
}

static unsigned find_part(uint32_t level, uint32_t format, const uint8_t* nodes, const uint8_t* leaves,
                          size_t most, size_t number, Place* at) {
  check(level == part_level && format == FORMAT && nodes == tree.bytes && leaves == data.bytes);
  const uint32_t c = part_at(at);
  const Subtree* p = part + c;
  check(same_place(at, &p->at) && end_of(p).nodes <= most);
  require_unchanged(p);
  const size_t inside = number % states_of_part();
  if (inside == asked_index % states_of_part()) return p->asked;
  return state_of(map, FORMAT, first_state + c * states_of_part() + inside);
}

static void by_contract(const mmverify_contract_t* c, uint32_t level, uint32_t count) {
  parts = count;
  part_level = level;
  for (uint32_t k = 0; k < count; ++k) part[k].length = any_length(level);
  stands_for((const void*)c->measure, (const void*)measure_part);
  stands_for((const void*)c->write, (const void*)write_part);
  stands_for((const void*)c->skip, (const void*)skip_part);
  stands_for((const void*)c->read, (const void*)read_part);
  stands_for((const void*)c->find, (const void*)find_part);
}

/* ---- one level */

/* The step: the subtree's place, and its end. */
static Place start, end;

/* Memory for the items up to `last`, of which one, any, and those of the byte at `from` are watched. */
static void open_sequence(Sequence* s, uint32_t bits, size_t from, size_t last) {
  s->bits = bits;
  s->item = any(PLACE_BITS);
  assume(s->item < last);
  s->watch[0] = from * bits / 8;
  s->watch[1] = s->item * bits / 8;
  s->watches = 2;
  s->bytes = watched_memory(bytes_for(last, bits), s->watch, s->watches);
  become_zero(s, from, last);
}

/* A map of any level. The bytes of the subtree at first_state, and byte `other`, are watched. */
static uint8_t* open_map(size_t other) {
  size_t watch[INSIDE_BYTES + 1];
  for (size_t k = 0; k < INSIDE_BYTES; ++k) watch[k] = first_state * FORMAT / 8 + k;
  watch[INSIDE_BYTES] = other;
  return watched_memory((size_t)1 << PLACE_BITS, watch, INSIDE_BYTES + 1);
}

/* Any states for the subtree at first_state, all else as it is. */
static void any_subtree(uint8_t* to) {
  uint8_t states[INSIDE_BYTES];
  any_map(SIZE, FORMAT, states);
  const size_t at = first_state * FORMAT / 8;
  if (INSIDE * FORMAT >= 8) {
    for (size_t k = 0; k < INSIDE_BYTES; ++k) to[at + k] = states[k];
  } else {
    const unsigned shift = (unsigned)(first_state * FORMAT % 8),
                   mask = ((1u << BYTE_BITS) - 1) << shift;
    to[at] = (uint8_t)((to[at] & ~mask) | (unsigned)states[0] << shift);
  }
}

/* The subtree is encoded, and nothing else has changed. */
static const mmverify_contract_t* written(void) {
  const mmverify_contract_t* c = mmverify_contract_v1();
  first_state = any_below((size_t)1 << (PLACE_BITS - 2 * SIZE)) << 2 * SIZE;
  map = open_map(0);
  any_subtree(map);
  by_contract(c, SIZE == 0 ? 0 : SIZE - 1, SIZE == 0 ? 0 : 4);

  start = end = (Place){any(PLACE_BITS), any(PLACE_BITS)};
  c->measure(SIZE, FORMAT, map, first_state, &end);
  /* A leaf, or an internal node and four subtrees. */
  const Place leaf = {start.nodes + 1, start.leaves + 1};
  Place sum = {start.nodes + 1, start.leaves};
  for (uint32_t k = 0; k < parts; ++k) move_over(&sum, part + k);
  check(same_place(&end, &leaf) || (SIZE > 0 && same_place(&end, &sum)));
  assume(end.nodes >> PLACE_BITS == 0 && end.leaves >> PLACE_BITS == 0);

  open_sequence(&tree, 1, start.nodes, end.nodes);
  open_sequence(&data, FORMAT, start.leaves, end.leaves);
  const unsigned node = item_of(&tree, tree.item), state = item_of(&data, data.item);
  Place at = start;
  c->write(SIZE, FORMAT, map, first_state, tree.bytes, data.bytes, &at);
  check(same_place(&at, &end));
  check(tree.item >= start.nodes || item_of(&tree, tree.item) == node);
  check(data.item >= start.leaves || item_of(&data, data.item) == state);
  return c;
}

void step_of_write(void) { written(); }

void step_of_skip(void) {
  const mmverify_contract_t* c = written();
  Place at = start;
  const size_t most = any(PLACE_BITS);
  assume(most >= end.nodes);
  check(c->skip(SIZE, tree.bytes, most, &at) == 1);
  check(same_place(&at, &end));
}

void step_of_read(void) {
  const mmverify_contract_t* c = written();
  const size_t other = any(PLACE_BITS - 1), first_byte = first_state * FORMAT / 8;
  out = open_map(other);
  for (size_t k = 0; k < INSIDE_BYTES; ++k) {
    const unsigned mask = ((1u << BYTE_BITS) - 1) << first_state * FORMAT % 8;
    out[first_byte + k] = (uint8_t)(out[first_byte + k] & ~mask);
  }
  const uint8_t others = out[other], beside = out[first_byte];
  Place at = start;
  check(c->read(SIZE, FORMAT, tree.bytes, data.bytes, first_state, &at, out) == 1);
  check(same_place(&at, &end));
  for (size_t k = first_state; k < first_state + INSIDE; ++k)
    check(state_of(out, FORMAT, k) == state_of(map, FORMAT, k));
  check(in(other, first_byte, first_byte + INSIDE_BYTES) || out[other] == others);
  if (INSIDE * FORMAT < 8) {
    const unsigned mask = ((1u << BYTE_BITS) - 1) << first_state * FORMAT % 8;
    check(((out[first_byte] ^ beside) & ~mask) == 0);
  }
}

void step_of_find(void) {
  const mmverify_contract_t* c = written();
  Place at = start;
  const size_t most = any(PLACE_BITS);
  assume(most >= end.nodes);
  asked_index = any(PLACE_BITS);
  for (uint32_t k = 0; k < parts; ++k)
    part[k].asked = state_of(map, FORMAT, first_state + k * states_of_part() + asked_index % states_of_part());
  const unsigned due =
      parts == 0 ? state_of(map, FORMAT, first_state) : part[asked_index / states_of_part() % 4].asked;
  check(c->find(SIZE, FORMAT, tree.bytes, data.bytes, most, asked_index, &at) == due);
}

/* ---- the entry points, on maps of LEVEL */

static size_t tree_bytes, code_size;

/* Any map; its code has any length that one of its level may have. */
static void any_map_and_length(uint8_t* states) {
  map = states;
  any_map(LEVEL, FORMAT, map);
  by_contract(mmverify_contract_v1(), LEVEL, 1);
  const size_t internal = any_below((size_t)1 << 2 * LEVEL);
  assume(internal <= (STATES - 1) / 3);
  part[0].length = (Place){4 * internal + 1, 3 * internal + 1};
  tree_bytes = bytes_for(part[0].length.nodes, 1);
  code_size = tree_bytes + bytes_for(part[0].length.leaves, FORMAT);
}

/* Memory for a code. Watched: an item of each sequence, the last byte of each, and byte `other`. */
static uint8_t* open_code(size_t capacity, size_t other) {
  const Place length = part[0].length;
  tree.bits = 1, data.bits = FORMAT;
  tree.item = any_below(2 * STATES), data.item = any_below(2 * STATES);
  assume(tree.item < length.nodes && data.item < length.leaves);
  tree.watches = data.watches = 2;
  tree.watch[0] = tree.item / 8, tree.watch[1] = (length.nodes - 1) / 8;
  data.watch[0] = data.item * FORMAT / 8, data.watch[1] = (length.leaves - 1) * FORMAT / 8;
  const size_t watch[5] = {tree.watch[0], tree.watch[1], tree_bytes + data.watch[0],
                           tree_bytes + data.watch[1], other};
  tree.bytes = watched_memory(capacity, watch, 5);
  data.bytes = tree.bytes + (capacity < code_size ? 0 : tree_bytes);
  return tree.bytes;
}

/* The size is the code's for any capacity; no byte behind the code or the capacity changes. */
void encode_by_contract(void) {
  uint8_t states[MAP_BYTES], same[MAP_BYTES];
  any_map_and_length(states);
  memcpy(same, states, MAP_BYTES);
  const size_t capacity = any(PLACE_BITS), other = any(PLACE_BITS);
  assume(other < capacity);
  uint8_t* code = open_code(capacity, other);
  const uint8_t before = code[other];
  check(codec()->tree_encode(LEVEL, FORMAT, map, code, capacity) == code_size);
  check((capacity >= code_size && other < code_size) || code[other] == before);
  check((capacity >= code_size) == part[0].written);
  check(equal(states, same, MAP_BYTES));
}

/* The code of exactly its size. */
static void encoded(uint8_t* states) {
  any_map_and_length(states);
  open_code(code_size, 0);
  check(codec()->tree_encode(LEVEL, FORMAT, map, tree.bytes, code_size) == code_size);
}

void decode_by_contract(void) {
  uint8_t states[MAP_BYTES], back[MAP_BYTES];
  encoded(states);
  out = back;
  check(codec()->tree_decode(LEVEL, FORMAT, tree.bytes, code_size, back));
  check(equal(states, back, MAP_BYTES));
}

/* Any index, at each place of a batch of three. */
void lookup_by_contract(void) {
  uint8_t states[MAP_BYTES];
  encoded(states);
  asked_index = any_below(STATES);
  part[0].asked = state_of(map, FORMAT, asked_index);
  for (size_t place = 0; place < 3; ++place) {
    uint32_t batch[3] = {STATES - 1, 0, STATES / 2};
    uint8_t state[3];
    batch[place] = (uint32_t)asked_index;
    codec()->tree_lookup(LEVEL, FORMAT, tree.bytes, code_size, batch, state, 3);
    for (size_t k = 0; k < 3; ++k)
      check(state[k] == (k == place ? part[0].asked : state_of(map, FORMAT, batch[k])));
    check(batch[place] == asked_index);
  }
}
