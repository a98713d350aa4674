/* What proofs from level to level share: memory of which few bytes are followed, and subtrees whose functions are taken
 * by contract. */
#ifndef MMVERIFY_CODEC_CONTRACT_H
#define MMVERIFY_CODEC_CONTRACT_H

#include "proofs/codecs/law.h"

/* A function of the law runs wherever the codec calls its own. */
void stands_for(const void* own, const void* other);
/* Memory of `size` bytes of any content. What a read gives is any, except at `count` places, which keep what is written. */
uint8_t* watched_memory(size_t size, const size_t* places, size_t count);
/* No function may write into that memory from now on. */
void only_read(const void* memory);

typedef mmverify_place_t Place;

/* States, and places in codes, are below 2^PLACE_BITS, as those of level 12 are. */
enum { PLACE_BITS = 26 };
#ifndef WATCHES
#define WATCHES 2
#endif
/* States and bytes of the subtree at hand. */
enum {
  INSIDE = 1 << 2 * SIZE,
  INSIDE_BYTES = (INSIDE * FORMAT + 7) / 8,
  BYTE_BITS = INSIDE * FORMAT < 8 ? INSIDE * FORMAT : 8
};

/* Bytes of a sequence whose content is followed; all others may be anything. */
typedef struct {
  uint8_t* bytes;
  size_t size;
  uint32_t bits; /* of an item: 1 in a tree, FORMAT in data */
  size_t item;   /* one item, any */
  size_t watch[WATCHES];
} Sequence;

/* A subtree whose functions are taken by contract. */
typedef struct {
  Place length, at;
  int written, given;   /* by write, or passed by skip; by read */
  unsigned node, state; /* at the items of the sequences */
  unsigned asked;       /* the state at `asked_index` of the subtree */
} Subtree;

/* The map, and what is read. */
static uint8_t *map, *out;
static Sequence tree, data;
/* The subtrees at hand: how many, their level, and the first one's first state. */
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

/* The bits of byte `at` that belong to item `from` or later ones. Without branches: paths would be told apart. */
static unsigned mask_from(const Sequence* s, size_t at, size_t from) {
  const size_t bit = from * s->bits;
  return ((0u - (at > bit / 8)) | ((0u - (at == bit / 8)) & 0xffu << bit % 8)) & 0xff;
}

/* The bits of byte `at` that belong to the items `from` to `to`. */
static unsigned mask_of(const Sequence* s, size_t at, size_t from, size_t to) {
  return mask_from(s, at, from) & ~mask_from(s, at, to);
}

/* Any bits for the items, or, if `others`, for all others. */
static void become_any_if(Sequence* s, size_t from, size_t to, int others) {
  for (size_t w = 0; w < WATCHES; ++w) {
    if (s->watch[w] >= s->size) continue;
    const unsigned inside = mask_of(s, s->watch[w], from, to), mask = others ? ~inside : inside;
    uint8_t* byte = s->bytes + s->watch[w];
    *byte = (uint8_t)((*byte & ~mask) | ((unsigned)any(8) & mask));
  }
}
static void become_any(Sequence* s, size_t from, size_t to) { become_any_if(s, from, to, 0); }
static void others_become_any(Sequence* s, size_t from, size_t to) { become_any_if(s, from, to, 1); }

static void become_zero(Sequence* s, size_t from, size_t to) {
  for (size_t w = 0; w < WATCHES; ++w)
    if (s->watch[w] < s->size)
      s->bytes[s->watch[w]] = (uint8_t)(s->bytes[s->watch[w]] & ~mask_of(s, s->watch[w], from, to));
}

static Place end_of(const Subtree* p) {
  return (Place){p->at.nodes + p->length.nodes, p->at.leaves + p->length.leaves};
}

static int same_place(const Place* a, const Place* b) {
  return a->nodes == b->nodes && a->leaves == b->leaves;
}

/* Functions are proved for numbers below 2^PLACE_BITS, and for places that leave room for a whole tree. */
static int is_small(size_t number) { return number >> PLACE_BITS == 0; }
static int has_room(const Place* at, uint32_t level) {
  const size_t states = (size_t)1 << 2 * level, limit = ((size_t)1 << PLACE_BITS) - 1;
  return at->nodes <= limit - (4 * states - 1) / 3 && at->leaves <= limit - states;
}

static Place any_place(void) { return (Place){any(64), any(64)}; }

static void move_over(Place* at, const Subtree* p) {
  at->nodes += p->length.nodes;
  at->leaves += p->length.leaves;
}

/* Any length of a subtree of the level, and some more: that nodes and leaves are 4 j + 1 and 3 j + 1, and j at most
 * (4^level - 1) / 3, follows from what the steps check, and no step needs more than this. */
static Place any_length(uint32_t level) {
  const size_t states = (size_t)1 << 2 * level;
  const Place length = {any(2 * level + 1), any(2 * level + 1)};
  assume(length.nodes >= 1 && length.nodes <= (4 * states - 1) / 3);
  assume(length.leaves >= 1 && length.leaves <= states);
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

/* The step: the subtree's place, and its end. */
static Place start, end;

/* Memory for a sequence. An item, any, and those of the byte of item `from` are watched. */
static void open_sequence(Sequence* s, uint32_t bits, size_t from, size_t size) {
  s->bits = bits;
  s->item = any(PLACE_BITS);
  s->watch[0] = from * bits / 8;
  s->watch[1] = s->item * bits / 8;
  s->size = size;
  s->bytes = watched_memory(size, s->watch, WATCHES);
}

/* A map that ends with the subtree at first_state. The subtree's bytes, and byte `other`, are watched. */
static uint8_t* open_map(size_t other) {
  size_t watch[INSIDE_BYTES + 1];
  for (size_t k = 0; k < INSIDE_BYTES; ++k) watch[k] = first_state * FORMAT / 8 + k;
  watch[INSIDE_BYTES] = other;
  return watched_memory(watch[0] + INSIDE_BYTES, watch, INSIDE_BYTES + 1);
}

/* The watched items of the code, which no reader may change. */
static unsigned noted_node, noted_state;

static void note_code(void) {
  noted_node = tree.item * tree.bits / 8 < tree.size ? item_of(&tree, tree.item) : 0;
  noted_state = data.item * data.bits / 8 < data.size ? item_of(&data, data.item) : 0;
}

static void require_code_unchanged(void) {
  check(tree.item * tree.bits / 8 >= tree.size || item_of(&tree, tree.item) == noted_node);
  check(data.item * data.bits / 8 >= data.size || item_of(&data, data.item) == noted_state);
}

static size_t other;
static uint8_t other_byte, first_byte;

static unsigned inside_mask(void) { return ((1u << BYTE_BITS) - 1) << first_state * FORMAT % 8; }

/* Zeros to read into, among any states. */
static void open_zeros(void) {
  other = any(PLACE_BITS);
  out = open_map(other);
  const size_t first = first_state * FORMAT / 8;
  for (size_t k = 0; k < INSIDE_BYTES; ++k) out[first + k] = (uint8_t)(out[first + k] & ~inside_mask());
  other_byte = other < first ? out[other] : 0;
  first_byte = out[first];
}

/* States beside the subtree are as they were. */
static void require_others_unchanged(void) {
  const size_t first = first_state * FORMAT / 8;
  check(other >= first || out[other] == other_byte);
  check(((out[first] ^ first_byte) & ~inside_mask()) == 0);
}

/* Any states beside the subtree: its siblings come and go. */
static void others_become_any_states(void) {
  const size_t first = first_state * FORMAT / 8;
  if (other < first) out[other] = (uint8_t)any(8);
  out[first] = (uint8_t)((out[first] & inside_mask()) | ((unsigned)any(8) & ~inside_mask()));
}

/* ---- a code of a map of LEVEL */

static size_t tree_bytes, code_size;

/* Any length that the code of a map may have. */
static void any_length_of_map(void) {
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
  tree.watch[0] = tree.item / 8, tree.watch[1] = (length.nodes - 1) / 8;
  data.watch[0] = data.item * FORMAT / 8, data.watch[1] = (length.leaves - 1) * FORMAT / 8;
  const size_t watch[5] = {tree.watch[0], tree.watch[1], tree_bytes + data.watch[0],
                           tree_bytes + data.watch[1], other};
  tree.bytes = watched_memory(capacity, watch, 5);
  data.bytes = tree.bytes + (capacity < code_size ? 0 : tree_bytes);
  tree.size = tree_bytes;
  data.size = code_size - tree_bytes;
  return tree.bytes;
}

#endif
