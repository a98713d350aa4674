/* Succinct Opacity Micromaps, Algorithms 1 to 3, written from the paper alone and as it says them: the perfect tree lies
 * in memory level by level, the nodes wait on a stack, and a lookup scans the sequence bit by bit.  No function calls
 * itself. */
#include <stdlib.h>
#include <string.h>

#include "subjects/sdk/mmverify_subject.h"

enum { LEVELS = 12, INTERNAL = 255 };

static unsigned read_bits(const uint8_t* from, unsigned width, size_t k) {
  unsigned value = 0;
  for (unsigned b = 0; b < width; b++) {
    const size_t bit = k * width + b;
    value |= (from[bit / 8] >> (bit & 7) & 1u) << b;
  }
  return value;
}

static void write_bits(uint8_t* to, unsigned width, size_t k, unsigned value) {
  for (unsigned b = 0; b < width; b++) {
    const size_t bit = k * width + b;
    const uint8_t mask = (uint8_t)(1u << (bit & 7));
    to[bit / 8] = (uint8_t)((to[bit / 8] & ~mask) | (value >> b & 1u ? mask : 0));
  }
}

/* The first node of a level in the perfect tree, whose root is node 0. */
static size_t level_start(uint32_t level) { return (((size_t)1 << 2 * level) - 1) / 3; }

/* Algorithm 1, bottom up.  Returns the number of internal nodes that the root leads to. */
static size_t build(uint8_t* node, uint32_t level, uint32_t format, const uint8_t* map) {
  size_t internal = 0;
  for (size_t k = 0; k < (size_t)1 << 2 * level; k++)
    node[level_start(level) + k] = (uint8_t)read_bits(map, format, k);
  for (uint32_t n = level; n-- > 0;)
    for (size_t k = 0; k < (size_t)1 << 2 * n; k++) {
      const uint8_t* child = node + level_start(n + 1) + 4 * k;
      const int same = child[0] == child[1] && child[0] == child[2] && child[0] == child[3];
      node[level_start(n) + k] = same ? child[0] : INTERNAL;
      internal += node[level_start(n) + k] == INTERNAL;
    }
  return internal;
}

/* Algorithm 2.  A node is its place in the perfect tree: the children of node p are 4p + 1 to 4p + 4. */
static void flatten(const uint8_t* node, uint32_t format, uint8_t* tree, uint8_t* data) {
  size_t stack[3 * LEVELS + 1], depth = 0, nodes = 0, leaves = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const size_t p = stack[--depth];
    if (node[p] == INTERNAL) {
      write_bits(tree, 1, nodes++, 1);
      for (size_t child = 4; child > 0; child--) stack[depth++] = 4 * p + child;
    } else {
      write_bits(tree, 1, nodes++, 0);
      write_bits(data, format, leaves++, node[p]);
    }
  }
}

static size_t tree_encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code,
                          size_t capacity) {
  uint8_t* node = malloc(level_start(level + 1));
  if (node == NULL) return 0;
  const size_t internal = build(node, level, format, map);
  const size_t tree_bytes = (4 * internal + 1 + 7) / 8;
  const size_t size = tree_bytes + ((3 * internal + 1) * format + 7) / 8;
  if (capacity >= size) {
    memset(code, 0, size);
    flatten(node, format, code, code + tree_bytes);
  }
  free(node);
  return size;
}

/* The nodes of the tree at the start of a code: each pays for itself, an internal one owes four more.  0 if the code ends
 * before the tree does. */
static size_t count_nodes(const uint8_t* code, size_t code_size) {
  size_t owed = 1, t = 0;
  while (owed > 0) {
    if (t == 8 * code_size) return 0;
    owed += read_bits(code, 1, t) ? 4 : 0;
    owed--;
    t++;
  }
  return t;
}

static int zeros(const uint8_t* bytes, size_t from, size_t to) {
  int all = 1;
  for (size_t k = from; k < to; k++) all &= read_bits(bytes, 1, k) == 0;
  return all;
}

/* The open nodes above the one at hand: children that are still to come, and what those before them are. */
typedef struct {
  int left[LEVELS + 2], seen[LEVELS + 2];
} Path;

enum { NOTHING = -1, MIXED = -2 };

/* Notes a child, and closes each node whose last child it is.  Returns the depth, or -1 for four leaves alike. */
static int close_nodes(Path* path, int depth, int value) {
  while (depth > 0) {
    int* seen = &path->seen[depth];
    *seen = *seen == NOTHING || *seen == value ? value : MIXED;
    if (--path->left[depth] > 0) return depth;
    if (*seen != MIXED) return -1;
    value = MIXED;
    depth--;
  }
  return depth;
}

static int unfold(uint32_t level, uint32_t format, const uint8_t* code, size_t nodes, uint8_t* map) {
  const uint8_t* data = code + (nodes + 7) / 8;
  Path path;
  int depth = 0;
  size_t leaves = 0, place = 0;
  for (size_t t = 0; t < nodes; t++) {
    if (read_bits(code, 1, t)) {
      if (depth == (int)level) return 0;
      depth++;
      path.left[depth] = 4;
      path.seen[depth] = NOTHING;
    } else {
      const unsigned value = read_bits(data, format, leaves++);
      const size_t end = place + ((size_t)1 << 2 * ((int)level - depth));
      for (; place < end; place++) write_bits(map, format, place, value);
      depth = close_nodes(&path, depth, (int)value);
      if (depth < 0) return 0;
    }
  }
  return 1;
}

static int tree_decode(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size, uint8_t* map) {
  const size_t nodes = count_nodes(code, code_size);
  if (nodes == 0) return 0;
  const size_t leaves = (3 * nodes + 1) / 4, tree_bytes = (nodes + 7) / 8;
  if (code_size != tree_bytes + (leaves * format + 7) / 8) return 0;
  if (!zeros(code, nodes, 8 * tree_bytes)) return 0;
  if (!zeros(code + tree_bytes, leaves * format, 8 * (code_size - tree_bytes))) return 0;
  memset(map, 0, ((((size_t)1 << 2 * level) * format) + 7) / 8);
  return unfold(level, format, code, nodes, map);
}

/* Algorithm 3 and its bitscan. */
static unsigned look_up(uint32_t level, uint32_t format, const uint8_t* tree, size_t length,
                        const uint8_t* data, uint32_t index) {
  size_t t = 0, d = 0;
  while (read_bits(tree, 1, t)) {
    uint32_t child = index >> 2 * --level & 3u;
    for (t++; t < length && child > 0; child--, t++) {
      if (read_bits(tree, 1, t))
        child += 4;
      else
        d++;
    }
  }
  return read_bits(data, format, d);
}

static void tree_lookup(uint32_t level, uint32_t format, const uint8_t* code, size_t code_size,
                        const uint32_t* index, uint8_t* state, size_t count) {
  const size_t nodes = count_nodes(code, code_size);
  for (size_t k = 0; k < count; k++)
    state[k] = (uint8_t)look_up(level, format, code, nodes, code + (nodes + 7) / 8, index[k]);
}

static const mmverify_subject_t subject = {
    .abi = MMVERIFY_SUBJECT_ABI,
    .size = sizeof(mmverify_subject_t),
    .name = "stacked-tree",
    .max_level = LEVELS,
    .flags = MMVERIFY_TREE_STREAM,
    .tree_encode = tree_encode,
    .tree_decode = tree_decode,
    .tree_lookup = tree_lookup,
};

const mmverify_subject_t* mmverify_subject_v1(void) { return &subject; }
