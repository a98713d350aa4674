/* Laws of any bytes that a decoder is given, from level to level; see contract.c.
 *
 * The contract of a subtree of any bits: skip passes over no more than `most` bits, or says 0; where it passed, read says
 * 0 or gives states, and write makes the same bits of them. */
#include "proofs/codecs/contract.h"

/* The subtrees that skip has passed so far, and the code that write makes. */
static uint32_t passed;
static Sequence again_tree, again_data;
/* Bits of the tree that there are, and where a code that may be read ends. */
static size_t most_nodes;
static Place limit;

static int skip_any(uint32_t level, const uint8_t* nodes, size_t most, Place* at) {
  check(level == part_level && nodes == tree.bytes && passed < parts);
  check(at->leaves <= at->nodes && at->nodes <= most && most <= most_nodes);
  Subtree* p = part + passed;
  ++passed;
  p->at = *at;
  if (!any(1)) {
    *at = any_place();
    return 0;
  }
  assume(end_of(p).nodes <= most);
  p->written = 1;
  *at = end_of(p);
  return 1;
}

/* A state of the subtree, any, by which its states are known again. */
static size_t asked_state(size_t first) { return first + asked_index % states_of_part(); }

static int read_any(uint32_t level, uint32_t format, const uint8_t* nodes, const uint8_t* leaves,
                    size_t first, Place* at, uint8_t* to) {
  check(level == part_level && format == FORMAT && nodes == tree.bytes && leaves == data.bytes && to == out);
  Subtree* p = part_of(first);
  check(p->written && same_place(at, &p->at));
  check(end_of(p).nodes <= limit.nodes && end_of(p).leaves <= limit.leaves);
  for (size_t k = first; k < first + states_of_part(); ++k) {
    check(state_of(to, FORMAT, k) == 0);
    put_state(to, FORMAT, k, (unsigned)any_state(FORMAT));
  }
  p->asked = state_of(to, FORMAT, asked_state(first));
  p->given = (int)any(1);
  *at = p->given ? end_of(p) : any_place();
  return p->given;
}

static void measure_again(uint32_t level, uint32_t format, const uint8_t* m, size_t first, Place* at) {
  check(level == part_level && format == FORMAT && m == out);
  const Subtree* p = part_of(first);
  check(p->given && same_place(at, &p->at) && state_of(m, FORMAT, asked_state(first)) == p->asked);
  move_over(at, p);
}

/* Any bits but at the watched item, which becomes that of the code. */
static void become_same(Sequence* s, const Sequence* given, size_t from, size_t to) {
  check(!in(s->item, from, to) || item_of(s, s->item) == 0);
  become_any(s, from, to);
  assume(!in(s->item, from, to) || item_of(s, s->item) == item_of(given, s->item));
}

static void write_again(uint32_t level, uint32_t format, const uint8_t* m, size_t first, uint8_t* nodes,
                        uint8_t* leaves, Place* at) {
  check(level == part_level && format == FORMAT && m == out && nodes == again_tree.bytes &&
        leaves == again_data.bytes);
  const Subtree* p = part_of(first);
  check(p->given && same_place(at, &p->at) && state_of(m, FORMAT, asked_state(first)) == p->asked);
  const Place last = end_of(p);
  become_same(&again_tree, &tree, at->nodes, last.nodes);
  become_same(&again_data, &data, at->leaves, last.leaves);
  *at = last;
}

static void any_bits(const mmverify_contract_t* c, uint32_t level, uint32_t count) {
  asked_index = any(PLACE_BITS);
  parts = count;
  part_level = level;
  passed = 0;
  stands_for((const void*)c->skip, (const void*)skip_any);
  stands_for((const void*)c->read, (const void*)read_any);
  stands_for((const void*)c->measure, (const void*)measure_again);
  stands_for((const void*)c->write, (const void*)write_again);
}

/* Memory that ends with the byte of item `last`, with the watched bytes of `from`. */
static void end_sequence(Sequence* s, const Sequence* from, size_t last) {
  *s = *from;
  s->size = bytes_for(last, s->bits);
  s->bytes = watched_memory(s->size, s->watch, WATCHES);
  for (size_t w = 0; w < WATCHES; ++w)
    if (s->watch[w] < s->size) s->bytes[s->watch[w]] = from->bytes[s->watch[w]];
}

static void require_same_items(void) {
  if (in(tree.item, start.nodes, end.nodes))
    check(item_of(&again_tree, tree.item) == item_of(&tree, tree.item));
  if (in(data.item, start.leaves, end.leaves))
    check(item_of(&again_data, data.item) == item_of(&data, data.item));
}

/* Whether skip passes over a subtree, from `start` to `end`. */
static int passes(const mmverify_contract_t* c) {
  const size_t most = any(PLACE_BITS);
  start = end = (Place){any(PLACE_BITS), any(PLACE_BITS)};
  assume(start.leaves <= start.nodes && start.nodes <= most);
  open_sequence(&tree, 1, start.nodes, bytes_for(most, 1));
  most_nodes = most;
  const int whole = tree.item / 8 < tree.size;
  const unsigned node = whole ? item_of(&tree, tree.item) : 0;
  const int passed_over = c->skip(SIZE, tree.bytes, most, &end);
  check(passed_over == 0 || passed_over == 1);
  check(!whole || item_of(&tree, tree.item) == node);
  if (!passed_over) return 0;
  check(end.nodes <= most);
  const Place leaf = {start.nodes + 1, start.leaves + 1};
  Place sum = {start.nodes + 1, start.leaves};
  for (uint32_t k = 0; k < parts; ++k) move_over(&sum, part + k);
  check(same_place(&end, &leaf) || (SIZE > 0 && same_place(&end, &sum)));
  return end.leaves >> PLACE_BITS == 0;
}

/* The map that is written again, which no function may change: its subtree, a byte before it, and what is beside. */
static uint8_t noted[INSIDE_BYTES];

static void note_states(void) {
  const size_t first = first_state * FORMAT / 8;
  for (size_t k = 0; k < INSIDE_BYTES; ++k) noted[k] = out[first + k];
  other_byte = other < first ? out[other] : 0;
}

static void require_same_states(void) {
  const size_t first = first_state * FORMAT / 8;
  for (size_t k = 0; k < INSIDE_BYTES; ++k) check(out[first + k] == noted[k]);
  check(other >= first || out[other] == other_byte);
}

void step_of_any_bits(void) {
  codec(); /* it may fill its entry points in */
  const mmverify_contract_t* c = mmverify_contract_v1();
  first_state = any_below((size_t)1 << (PLACE_BITS - 2 * SIZE)) << 2 * SIZE;
  any_bits(c, SIZE == 0 ? 0 : SIZE - 1, SIZE == 0 ? 0 : 4);
  for (uint32_t k = 0; k < parts; ++k) {
    part[k].length = any_length(part_level);
    assume(part[k].length.leaves <= part[k].length.nodes);
  }
  if (!passes(c)) return;

  const Sequence given = tree;
  end_sequence(&tree, &given, end.nodes);
  open_sequence(&data, FORMAT, start.leaves, bytes_for(end.leaves, FORMAT));
  open_zeros();
  limit = end;
  note_code();
  Place at = start;
  const int taken = c->read(SIZE, FORMAT, tree.bytes, data.bytes, first_state, &at, out);
  require_others_unchanged();
  require_code_unchanged();
  check(taken == 0 || taken == 1);
  if (!taken) return;
  check(same_place(&at, &end));

  others_become_any_states();
  note_states();
  at = start;
  c->measure(SIZE, FORMAT, out, first_state, &at);
  check(same_place(&at, &end));
  end_sequence(&again_tree, &tree, end.nodes);
  end_sequence(&again_data, &data, end.leaves);
  others_become_any(&again_tree, start.nodes, end.nodes);
  others_become_any(&again_data, start.leaves, end.leaves);
  become_zero(&again_tree, start.nodes, end.nodes);
  become_zero(&again_data, start.leaves, end.leaves);
  const int has_node = again_tree.watch[1] < again_tree.size,
            has_state = again_data.watch[1] < again_data.size;
  const unsigned node = has_node ? item_of(&again_tree, tree.item) : 0;
  const unsigned state = has_state ? item_of(&again_data, data.item) : 0;
  at = start;
  c->write(SIZE, FORMAT, out, first_state, again_tree.bytes, again_data.bytes, &at);
  check(same_place(&at, &end));
  require_same_items();
  check(!has_node || in(tree.item, start.nodes, end.nodes) || item_of(&again_tree, tree.item) == node);
  check(!has_state || in(data.item, start.leaves, end.leaves) || item_of(&again_data, data.item) == state);
  require_same_states();
}

/* Any bytes are refused, or are the code of a map with zeros after its last state. */
void decode_any_bytes(void) {
  const mmverify_contract_t* c = mmverify_contract_v1();
  uint8_t back[MAP_BYTES];
  any_bits(c, LEVEL, 1);
  any_length_of_map();
  const size_t size = any(PLACE_BITS - 3);
  other = any(PLACE_BITS);
  open_code(size, other);
  out = back;
  most_nodes = 8 * size;
  /* All of it may be read if it fits. */
  if (size >= code_size) limit = part[0].length;
  other_byte = other < size ? tree.bytes[other] : 0;
  start = (Place){0, 0};
  end = part[0].length;
  const int taken = codec()->tree_decode(LEVEL, FORMAT, tree.bytes, size, back);
  check(other >= size || tree.bytes[other] == other_byte);
  if (!taken) return;
  check(padded(back, FORMAT, STATES));
  require_whole(back);
  if (!(codec()->flags & MMVERIFY_TREE_STREAM)) return;
  check(size == code_size);
  again_tree = tree;
  again_data = data;
  const size_t watched[4] = {tree.watch[0], tree.watch[1], tree_bytes + data.watch[0],
                             tree_bytes + data.watch[1]};
  again_tree.bytes = watched_memory(size, watched, 4);
  again_data.bytes = again_tree.bytes + tree_bytes;
  check(codec()->tree_encode(LEVEL, FORMAT, back, again_tree.bytes, size) == size);
  require_same_items();
  for (size_t k = end.nodes; k < 8 * tree_bytes; ++k)
    check(item_of(&tree, k) == 0 && item_of(&again_tree, k) == 0);
  for (size_t k = end.leaves; k * FORMAT < 8 * (code_size - tree_bytes); ++k)
    check(item_of(&data, k) == 0 && item_of(&again_data, k) == 0);
}
