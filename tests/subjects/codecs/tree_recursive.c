/* Succinct Opacity Micromaps, Algorithms 1 to 3, written from the paper alone: each step is a recursion over subtrees.
 * No table and no array of nodes is kept; what a subtree is, it says when it is asked. */
#include <string.h>

#include "subjects/sdk/mmverify_subject.h"

/* A packed map or a sequence of states in a code. */
typedef struct {
  const uint8_t* bytes;
  unsigned bits;
} States;

static unsigned state(States s, size_t k) {
  return (unsigned)s.bytes[k * s.bits / 8] >> k * s.bits % 8 & ((1u << s.bits) - 1);
}

static void append(uint8_t* bytes, unsigned bits, size_t k, unsigned value) {
  bytes[k * bits / 8] |= (uint8_t)(value << k * bits % 8);
}

static size_t bytes_of(size_t count, unsigned bits) { return (count * bits + 7) / 8; }

static size_t quarter(unsigned level) { return (size_t)1 << 2 * (level - 1); }

/* The state of a subtree; or one of these. */
enum { INNER = 4, WRONG = 5 };

/* Algorithm 1: what four children merge to. */
static unsigned merged(States map, unsigned level, size_t first) {
  if (level == 0) return state(map, first);
  const size_t step = quarter(level);
  const unsigned one = merged(map, level - 1, first), two = merged(map, level - 1, first + step),
                 three = merged(map, level - 1, first + 2 * step),
                 four = merged(map, level - 1, first + 3 * step);
  return one == two && two == three && three == four ? one : INNER;
}

static size_t inner_nodes(States map, unsigned level, size_t first) {
  size_t sum = 1;
  if (merged(map, level, first) != INNER) return 0;
  for (size_t child = 0; child < 4; ++child)
    sum += inner_nodes(map, level - 1, first + child * quarter(level));
  return sum;
}

/* The places of the next node and of the next leaf. */
typedef struct {
  size_t node, leaf;
} Place;

/* Algorithm 2. */
static Place emit(States map, unsigned level, size_t first, uint8_t* tree, uint8_t* data, Place at) {
  const unsigned value = merged(map, level, first);
  if (value != INNER) {
    append(data, map.bits, at.leaf, value);
    return (Place){at.node + 1, at.leaf + 1};
  }
  append(tree, 1, at.node++, 1);
  for (size_t child = 0; child < 4; ++child)
    at = emit(map, level - 1, first + child * quarter(level), tree, data, at);
  return at;
}

static size_t tree_encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code,
                          size_t capacity) {
  const States states = {map, format};
  const size_t inner = inner_nodes(states, level, 0);
  const size_t tree = bytes_of(4 * inner + 1, 1), size = tree + bytes_of(3 * inner + 1, format);
  if (size > capacity) return size;
  memset(code, 0, size);
  (void)emit(states, level, 0, code, code + tree, (Place){0, 0});
  return size;
}

/* The place behind the subtree at a place; node 0 is behind none, and stands for a tree that is none. */
static Place behind(States tree, size_t most, unsigned level, Place at) {
  if (at.node >= most) return (Place){0, 0};
  if (state(tree, at.node) == 0) return (Place){at.node + 1, at.leaf + 1};
  if (level == 0) return (Place){0, 0};
  ++at.node;
  for (unsigned child = 0; child < 4; ++child) {
    at = behind(tree, most, level - 1, at);
    if (at.node == 0) return at;
  }
  return at;
}

/* Writes the subtree at a place, which moves behind it.  Four leaves of one state are no code of Algorithm 1. */
static unsigned grow(States tree, States data, unsigned level, size_t first, Place* at, uint8_t* map) {
  unsigned is[4];
  if (state(tree, at->node++) == 0) {
    const unsigned value = state(data, at->leaf++);
    for (size_t k = 0; k < (size_t)1 << 2 * level; ++k) append(map, data.bits, first + k, value);
    return value;
  }
  for (size_t child = 0; child < 4; ++child) {
    is[child] = grow(tree, data, level - 1, first + child * quarter(level), at, map);
    if (is[child] == WRONG) return WRONG;
  }
  return is[0] < INNER && is[0] == is[1] && is[0] == is[2] && is[0] == is[3] ? WRONG : INNER;
}

/* Whether the bits after the last one of a sequence are zero. */
static int ends(const uint8_t* bytes, size_t bits) {
  return bits % 8 == 0 || bytes[bits / 8] >> bits % 8 == 0;
}

static int tree_decode(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size, uint8_t* map) {
  const States tree = {code, 1};
  const Place end = behind(tree, 8 * code_size, level, (Place){0, 0});
  Place at = {0, 0};
  if (end.node == 0) return 0;
  const size_t tree_bytes = bytes_of(end.node, 1);
  if (code_size != tree_bytes + bytes_of(end.leaf, format)) return 0;
  const States data = {code + tree_bytes, format};
  if (!ends(code, end.node) || !ends(data.bytes, format * end.leaf)) return 0;
  memset(map, 0, bytes_of((size_t)1 << 2 * level, format));
  return grow(tree, data, level, 0, &at, map) != WRONG;
}

/* Algorithm 3: into the child that holds the index, over the children before it. */
static size_t leaf_of(States tree, size_t most, unsigned level, size_t index, Place at) {
  if (state(tree, at.node) == 0) return at.leaf;
  ++at.node;
  for (size_t child = index / quarter(level); child > 0; --child) at = behind(tree, most, level - 1, at);
  return leaf_of(tree, most, level - 1, index % quarter(level), at);
}

static void tree_lookup(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                        const uint32_t* index, uint8_t* answer, size_t count) {
  const States tree = {code, 1};
  const size_t nodes = behind(tree, 8 * code_size, level, (Place){0, 0}).node;
  const States data = {code + bytes_of(nodes, 1), format};
  for (size_t k = 0; k < count; ++k)
    answer[k] = (uint8_t)state(data, leaf_of(tree, nodes, level, index[k], (Place){0, 0}));
}

static const mmverify_subject_t subject = {
    .abi = MMVERIFY_SUBJECT_ABI,
    .size = sizeof(mmverify_subject_t),
    .name = "recursive-tree",
    .max_level = 12,
    .flags = MMVERIFY_TREE_STREAM,
    .tree_encode = tree_encode,
    .tree_decode = tree_decode,
    .tree_lookup = tree_lookup,
};

const mmverify_subject_t* mmverify_subject_v1(void) { return &subject; }
