/* Laws of tree codecs by recursion, from level to level.  LEVEL: of the map.  `step` shows the contract of
 * mmverify_contract_t for the subtrees of level SIZE, given that of the level below; `whole` shows the law for the entry
 * points, given the contract of the map's own level.
 *
 * The contract of a subtree: measure and write move over the same lengths, and write changes nothing else; whatever its
 * place, as long as the bits that it wrote stay, skip moves over them, read gives its states back, and find each one. */
#include "proofs/codecs/contract.h"

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
  check(has_room(at, level));
  move_over(at, part_of(first));
}

static void write_part(uint32_t level, uint32_t format, const uint8_t* m, size_t first, uint8_t* nodes,
                       uint8_t* leaves, Place* at) {
  check(level == part_level && format == FORMAT && m == map && nodes == tree.bytes && leaves == data.bytes);
  Subtree* p = part_of(first);
  p->at = *at;
  const Place end = end_of(p);
  check(has_room(at, level));
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
  check(same_place(at, &p->at) && end_of(p).nodes <= most && is_small(most));
  require_unchanged(p);
  move_over(at, p);
  return 1;
}

static int read_part(uint32_t level, uint32_t format, const uint8_t* nodes, const uint8_t* leaves,
                     size_t first, Place* at, uint8_t* to) {
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
  check(same_place(at, &p->at) && end_of(p).nodes <= most && is_small(most) && is_small(number));
  require_unchanged(p);
  *at = any_place();
  const size_t inside = number % states_of_part();
  if (inside == asked_index % states_of_part()) return p->asked;
  return state_of(map, FORMAT, first_state + c * states_of_part() + inside);
}

/* The functions of which a law's steps show the contract; the others run as they are. */
enum { WRITES = 0, SKIPS = 1, READS_BACK = 2, FINDS = 4 };

static void by_contract(const mmverify_contract_t* c, int functions, uint32_t level, uint32_t count) {
  parts = count;
  part_level = level;
  for (uint32_t k = 0; k < count; ++k) part[k].length = any_length(level);
  stands_for((const void*)c->measure, (const void*)measure_part);
  stands_for((const void*)c->write, (const void*)write_part);
  if (functions & SKIPS) stands_for((const void*)c->skip, (const void*)skip_part);
  if (functions & READS_BACK) stands_for((const void*)c->read, (const void*)read_part);
  if (functions & FINDS) stands_for((const void*)c->find, (const void*)find_part);
}

/* ---- one level */

/* Any states for the subtree at first_state, all else as it is. */
static void any_subtree(uint8_t* to) {
  uint8_t states[INSIDE_BYTES];
  any_map(SIZE, FORMAT, states);
  const size_t at = first_state * FORMAT / 8;
  if (INSIDE * FORMAT >= 8) {
    for (size_t k = 0; k < INSIDE_BYTES; ++k) to[at + k] = states[k];
  } else {
    const unsigned shift = (unsigned)(first_state * FORMAT % 8), mask = ((1u << BYTE_BITS) - 1) << shift;
    to[at] = (uint8_t)((to[at] & ~mask) | (unsigned)states[0] << shift);
  }
}

/* Whether measure moves from a place over a leaf, 0, or over an internal node and four subtrees, 1. */
static int measured(const mmverify_contract_t* c, Place from, Place* to) {
  const Place leaf = {from.nodes + 1, from.leaves + 1};
  Place sum = {from.nodes + 1, from.leaves};
  for (uint32_t k = 0; k < parts; ++k) move_over(&sum, part + k);
  assume(has_room(&from, SIZE));
  *to = from;
  c->measure(SIZE, FORMAT, map, first_state, to);
  const int is_leaf = same_place(to, &leaf);
  check(is_leaf || (SIZE > 0 && same_place(to, &sum)));
  return !is_leaf;
}

/* Memory that ends with item `last`, with zeros from item `from` on. */
static void open_zeros_until(Sequence* s, uint32_t bits, size_t from, size_t last) {
  open_sequence(s, bits, from, bytes_for(last, bits));
  assume(s->watch[1] < s->size);
  become_zero(s, from, last);
}

/* The subtree is encoded, and nothing else has changed. Then all else changes, as its neighbours are encoded. */
static const mmverify_contract_t* written(int functions) {
  codec(); /* it may fill its entry points in */
  const mmverify_contract_t* c = mmverify_contract_v1();
  first_state = any_below((size_t)1 << (PLACE_BITS - 2 * SIZE)) << 2 * SIZE;
  const size_t other_byte_of_map = any(PLACE_BITS), first = first_state * FORMAT / 8;
  map = open_map(other_byte_of_map);
  any_subtree(map);
  uint8_t before[INSIDE_BYTES];
  for (size_t k = 0; k < INSIDE_BYTES; ++k) before[k] = map[first + k];
  const uint8_t beside = other_byte_of_map < first ? map[other_byte_of_map] : 0;
  by_contract(c, functions, SIZE == 0 ? 0 : SIZE - 1, SIZE == 0 ? 0 : 4);

  start = (Place){any(PLACE_BITS), any(PLACE_BITS)};
  Place elsewhere;
  const int there = measured(c, (Place){any(PLACE_BITS), any(PLACE_BITS)}, &elsewhere);
  check(measured(c, start, &end) == there);

  open_zeros_until(&tree, 1, start.nodes, end.nodes);
  open_zeros_until(&data, FORMAT, start.leaves, end.leaves);
  const unsigned node = item_of(&tree, tree.item), state = item_of(&data, data.item);
  Place at = start;
  c->write(SIZE, FORMAT, map, first_state, tree.bytes, data.bytes, &at);
  check(same_place(&at, &end));
  check(in(tree.item, start.nodes, end.nodes) || item_of(&tree, tree.item) == node);
  check(in(data.item, start.leaves, end.leaves) || item_of(&data, data.item) == state);
  for (size_t k = 0; k < INSIDE_BYTES; ++k) check(map[first + k] == before[k]);
  check(other_byte_of_map >= first || map[other_byte_of_map] == beside);
  others_become_any(&tree, start.nodes, end.nodes);
  others_become_any(&data, start.leaves, end.leaves);
  note_code();
  return c;
}

void step_of_skip(void) {
  const mmverify_contract_t* c = written(SKIPS);
  Place at = start;
  const size_t most = any(PLACE_BITS);
  assume(most >= end.nodes);
  check(c->skip(SIZE, tree.bytes, most, &at) == 1);
  check(same_place(&at, &end));
  require_code_unchanged();
}

void step_of_read(void) {
  const mmverify_contract_t* c = written(SKIPS | READS_BACK);
  open_zeros();
  Place at = start;
  check(c->read(SIZE, FORMAT, tree.bytes, data.bytes, first_state, &at, out) == 1);
  check(same_place(&at, &end));
  for (size_t k = first_state; k < first_state + INSIDE; ++k)
    check(state_of(out, FORMAT, k) == state_of(map, FORMAT, k));
  require_others_unchanged();
  require_code_unchanged();
}

void step_of_find(void) {
  const mmverify_contract_t* c = written(SKIPS | FINDS);
  Place at = start;
  const size_t most = any(PLACE_BITS);
  assume(most >= end.nodes);
  asked_index = any(PLACE_BITS);
  for (uint32_t k = 0; k < parts; ++k)
    part[k].asked =
        state_of(map, FORMAT, first_state + k * states_of_part() + asked_index % states_of_part());
  const unsigned due =
      parts == 0 ? state_of(map, FORMAT, first_state) : part[asked_index / states_of_part() % 4].asked;
  check(c->find(SIZE, FORMAT, tree.bytes, data.bytes, most, asked_index, &at) == due);
  require_code_unchanged();
}

/* Algorithm 2: a node's bit, then its leaf or its four subtrees. */
void step_of_spec(void) {
  written(WRITES);
  int same = 1;
  for (size_t k = 1; k < INSIDE; ++k)
    same &= state_of(map, FORMAT, first_state + k) == state_of(map, FORMAT, first_state);
  check(item_of(&tree, start.nodes) == !same);
  if (same) {
    check(end.nodes == start.nodes + 1 && end.leaves == start.leaves + 1);
    check(item_of(&data, start.leaves) == state_of(map, FORMAT, first_state));
    return;
  }
  Place at = {start.nodes + 1, start.leaves};
  for (uint32_t k = 0; k < parts; ++k) {
    check(same_place(&part[k].at, &at));
    require_unchanged(part + k);
    move_over(&at, part + k);
  }
  check(same_place(&at, &end));
}

/* ---- the entry points, on maps of LEVEL */

static void any_map_and_length(uint8_t* states, int functions) {
  map = states;
  any_map(LEVEL, FORMAT, map);
  only_read(map);
  codec();
  by_contract(mmverify_contract_v1(), functions, LEVEL, 1);
  any_length_of_map();
}

/* The code is the two sequences, each from a whole byte on, and zeros behind them. */
static void require_sequences(void) {
  const Place none = {0, 0}, length = part[0].length;
  check(same_place(&part[0].at, &none));
  require_unchanged(part);
  for (size_t k = length.nodes; k < 8 * tree_bytes; ++k) check(item_of(&tree, k) == 0);
  for (size_t k = length.leaves; k * FORMAT < 8 * (code_size - tree_bytes); ++k)
    check(item_of(&data, k) == 0);
}

/* The size is the code's for any capacity, and so is the code; no byte behind the code or the capacity changes. */
void encode_by_contract(void) {
  uint8_t states[MAP_BYTES];
  any_map_and_length(states, WRITES);
  const size_t capacity = any(PLACE_BITS);
  other = any(PLACE_BITS);
  uint8_t* code = open_code(capacity, other);
  const uint8_t before = other < capacity ? code[other] : 0;
  check(codec()->tree_encode(LEVEL, FORMAT, map, code, capacity) == code_size);
  if (other < capacity && (capacity < code_size || other >= code_size)) check(code[other] == before);
  if (capacity >= code_size) require_sequences();
}

/* The code of exactly its size. */
static void encoded(uint8_t* states, int functions) {
  any_map_and_length(states, functions);
  other = any(PLACE_BITS);
  open_code(code_size, other);
  check(codec()->tree_encode(LEVEL, FORMAT, map, tree.bytes, code_size) == code_size);
  other_byte = other < code_size ? tree.bytes[other] : 0;
}

static void require_same_code(void) { check(other >= code_size || tree.bytes[other] == other_byte); }

void spec_by_contract(void) {
  uint8_t states[MAP_BYTES];
  encoded(states, WRITES);
  require_sequences();
}

void decode_by_contract(void) {
  uint8_t states[MAP_BYTES], back[MAP_BYTES];
  encoded(states, SKIPS | READS_BACK);
  out = back;
  check(codec()->tree_decode(LEVEL, FORMAT, tree.bytes, code_size, back));
  check(equal(states, back, MAP_BYTES));
  require_same_code();
}

/* Any index, at each place of a batch of three, and alone. */
void lookup_by_contract(void) {
  uint8_t states[MAP_BYTES];
  encoded(states, SKIPS | FINDS);
  asked_index = any_below(STATES);
  part[0].asked = state_of(map, FORMAT, asked_index);
  for (size_t place = 0; place < 3; ++place) {
    uint32_t batch[3] = {STATES - 1, 0, STATES / 2};
    uint8_t state[3];
    batch[place] = (uint32_t)asked_index;
    codec()->tree_lookup(LEVEL, FORMAT, tree.bytes, code_size, batch, state, 3);
    for (size_t k = 0; k < 3; ++k)
      check(state[k] == (k == place ? part[0].asked : state_of(map, FORMAT, batch[k])));
    check(batch[0] == (place == 0 ? asked_index : STATES - 1) && batch[1] == (place == 1 ? asked_index : 0) &&
          batch[2] == (place == 2 ? asked_index : STATES / 2));
  }
  const uint32_t alone = (uint32_t)asked_index;
  uint8_t state;
  codec()->tree_lookup(LEVEL, FORMAT, tree.bytes, code_size, &alone, &state, 1);
  check(state == part[0].asked && alone == asked_index);
  require_same_code();
}
