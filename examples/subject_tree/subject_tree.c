/* A complete subject of topic tree: the codes of Succinct Opacity Micromaps, as the paper has them,
 * recursive. */
#include <string.h>

#include "mmverify_subject.h"

/* ---- bits: number k of `bits` bits each, packed from the least significant bit of each byte on ---- */

static unsigned get(const uint8_t* bytes, uint32_t bits, size_t k) {
  return bytes[k * bits / 8] >> k * bits % 8 & ((1u << bits) - 1);
}

static void put(uint8_t* bytes, uint32_t bits, size_t k, unsigned value) {
  bytes[k * bits / 8] = (uint8_t)(bytes[k * bits / 8] | value << k * bits % 8);
}

static size_t bytes_of(uint32_t bits, size_t count) { return (count * bits + 7) / 8; }

/* ---- encoding: the subtree of level `level` that begins at state `first` ---- */

static int uniform(const uint8_t* map, uint32_t bits, uint32_t level, size_t first) {
  for (size_t k = 1; k < (size_t)1 << 2 * level; ++k)
    if (get(map, bits, first + k) != get(map, bits, first)) return 0;
  return 1;
}

typedef struct {
  size_t nodes, leaves;
} Size;

static void measure(const uint8_t* map, uint32_t bits, uint32_t level, size_t first, Size* size) {
  ++size->nodes;
  if (uniform(map, bits, level, first)) {
    ++size->leaves;
    return;
  }
  for (size_t child = 0; child < 4; ++child)
    measure(map, bits, level - 1, first + (child << 2 * (level - 1)), size);
}

static void write(const uint8_t* map, uint32_t bits, uint32_t level, size_t first, uint8_t* tree,
                  uint8_t* data, Size* at) {
  const int leaf = uniform(map, bits, level, first);
  put(tree, 1, at->nodes++, !leaf);
  if (leaf) {
    put(data, bits, at->leaves++, get(map, bits, first));
    return;
  }
  for (size_t child = 0; child < 4; ++child)
    write(map, bits, level - 1, first + (child << 2 * (level - 1)), tree, data, at);
}

static size_t tree_encode(uint32_t level, uint32_t bits, const uint8_t* map, uint8_t* code, size_t capacity) {
  Size size = {0, 0}, at = {0, 0};
  measure(map, bits, level, 0, &size);
  const size_t tree_bytes = bytes_of(1, size.nodes), all = tree_bytes + bytes_of(bits, size.leaves);
  if (capacity < all) return all;
  memset(code, 0, all);
  write(map, bits, level, 0, code, code + tree_bytes, &at);
  return all;
}

/* ---- decoding ---- */

/* Nodes of a tree of at most `most` bits; 0 if it does not end there. */
static size_t tree_length(const uint8_t* tree, size_t most) {
  size_t owed = 1, t = 0;
  for (; owed > 0; ++t) {
    if (t == most) return 0;
    owed = get(tree, 1, t) ? owed + 3 : owed - 1;
  }
  return t;
}

static int read_subtree(const uint8_t* tree, const uint8_t* data, uint32_t bits, uint32_t level, size_t first,
                        Size* at, uint8_t* map) {
  if (get(tree, 1, at->nodes++)) {
    if (level == 0) return 0;
    for (size_t child = 0; child < 4; ++child)
      if (!read_subtree(tree, data, bits, level - 1, first + (child << 2 * (level - 1)), at, map)) return 0;
    return !uniform(map, bits, level, first); /* or it would have been a leaf */
  }
  const unsigned state = get(data, bits, at->leaves++);
  for (size_t k = 0; k < (size_t)1 << 2 * level; ++k) put(map, bits, first + k, state);
  return 1;
}

static int tree_decode(uint32_t level, uint32_t bits, const uint8_t* code, size_t code_size, uint8_t* map) {
  const size_t nodes = tree_length(code, 8 * code_size), leaves = nodes - nodes / 4;
  const size_t tree_bytes = bytes_of(1, nodes);
  if (nodes == 0 || code_size != tree_bytes + bytes_of(bits, leaves)) return 0;
  /* the bits after the last */
  for (size_t t = nodes; t < 8 * tree_bytes; ++t)
    if (get(code, 1, t)) return 0;
  for (size_t t = bits * leaves; t < 8 * (code_size - tree_bytes); ++t)
    if (get(code + tree_bytes, 1, t)) return 0;
  Size at = {0, 0};
  memset(map, 0, bytes_of(bits, (size_t)1 << 2 * level));
  return read_subtree(code, code + tree_bytes, bits, level, 0, &at, map);
}

/* ---- Algorithm 3 ---- */

/* Passes over `child` subtrees. */
static void bitscan(const uint8_t* tree, size_t child, Size* at) {
  for (; child > 0; --child, ++at->nodes) {
    if (get(tree, 1, at->nodes))
      child += 4;
    else
      ++at->leaves;
  }
}

static unsigned state_at(uint32_t level, uint32_t bits, const uint8_t* tree, const uint8_t* data,
                         size_t index) {
  Size at = {0, 0};
  while (get(tree, 1, at.nodes)) {
    ++at.nodes;
    bitscan(tree, index >> 2 * --level & 3, &at);
  }
  return get(data, bits, at.leaves);
}

static void tree_lookup(uint32_t level, uint32_t bits, const uint8_t* code, size_t code_size,
                        const uint32_t* index, uint8_t* state, size_t count) {
  const uint8_t* data = code + bytes_of(1, tree_length(code, 8 * code_size));
  for (size_t k = 0; k < count; ++k) state[k] = (uint8_t)state_at(level, bits, code, data, index[k]);
}

/* ---- points: the bit formula of VK_EXT_opacity_micromap. Algorithm 4 and the formula's own sum of
 * fractions would round; this compares, and is right for every pair of floats. ---- */

static float clamped(float x) { return x > 0 ? (x < 1 ? x : 1) : 0; }

static uint32_t spread(uint32_t x) {
  x = (x | x << 8) & 0x00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f;
  x = (x | x << 2) & 0x33333333;
  return (x | x << 1) & 0x55555555;
}

static size_t index_of(uint32_t level, float u, float v) {
  const uint32_t n = 1u << level;
  const float un = clamped(u) * (float)n, vn = clamped(v) * (float)n;
  uint32_t i = (uint32_t)un, j = (uint32_t)vn;
  const float uf = un - (float)i, vf = vn - (float)j;
  const int upper = uf > vf ? vf >= 1 - uf : uf >= 1 - vf;
  if (j > n - 1) j = n - 1;
  if (i > n - 1 - j) i = n - 1 - j;
  const uint32_t row = i + j + (upper && i + j < n - 1);
  const uint32_t b0 = i ^ row, t = (i ^ j) & b0;
  uint32_t f = t ^ t >> 1;
  f ^= f >> 2, f ^= f >> 4, f ^= f >> 8;
  return spread(b0) | spread(((f ^ i) & ~b0) | t) << 1;
}

static void tree_lookup_f32(uint32_t level, uint32_t bits, const uint8_t* code, size_t code_size,
                            const float* u, const float* v, uint8_t* state, size_t count) {
  const uint8_t* data = code + bytes_of(1, tree_length(code, 8 * code_size));
  for (size_t k = 0; k < count; ++k)
    state[k] = (uint8_t)state_at(level, bits, code, data, index_of(level, u[k], v[k]));
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example of a tree",
                                             .max_level = 12,
                                             .flags = MMVERIFY_TREE_STREAM,
                                             .tree_encode = tree_encode,
                                             .tree_decode = tree_decode,
                                             .tree_lookup = tree_lookup,
                                             .tree_lookup_f32 = tree_lookup_f32};
  return &subject;
}
