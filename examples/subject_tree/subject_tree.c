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

static void measure(uint32_t level, uint32_t bits, const uint8_t* map, size_t first, mmverify_place_t* at) {
  ++at->nodes;
  if (uniform(map, bits, level, first)) {
    ++at->leaves;
    return;
  }
  for (size_t child = 0; child < 4; ++child)
    measure(level - 1, bits, map, first + (child << 2 * (level - 1)), at);
}

static void write(uint32_t level, uint32_t bits, const uint8_t* map, size_t first, uint8_t* tree,
                  uint8_t* data, mmverify_place_t* at) {
  const int leaf = uniform(map, bits, level, first);
  put(tree, 1, at->nodes++, !leaf);
  if (leaf) {
    put(data, bits, at->leaves++, get(map, bits, first));
    return;
  }
  for (size_t child = 0; child < 4; ++child)
    write(level - 1, bits, map, first + (child << 2 * (level - 1)), tree, data, at);
}

static size_t tree_encode(uint32_t level, uint32_t bits, const uint8_t* map, uint8_t* code, size_t capacity) {
  mmverify_place_t size = {0, 0}, at = {0, 0};
  measure(level, bits, map, 0, &size);
  const size_t tree_bytes = bytes_of(1, size.nodes), all = tree_bytes + bytes_of(bits, size.leaves);
  if (capacity < all) return all;
  memset(code, 0, all);
  write(level, bits, map, 0, code, code + tree_bytes, &at);
  return all;
}

/* ---- decoding ---- */

/* Passes over a subtree; 0 if it does not end within `most` bits or has nodes below the last level. */
static int skip(uint32_t level, const uint8_t* tree, size_t most, mmverify_place_t* at) {
  if (at->nodes >= most) return 0;
  if (!get(tree, 1, at->nodes++)) {
    ++at->leaves;
    return 1;
  }
  if (level == 0) return 0;
  for (size_t child = 0; child < 4; ++child)
    if (!skip(level - 1, tree, most, at)) return 0;
  return 1;
}

static int read(uint32_t level, uint32_t bits, const uint8_t* tree, const uint8_t* data, size_t first,
                mmverify_place_t* at, uint8_t* map) {
  if (get(tree, 1, at->nodes++)) {
    for (size_t child = 0; child < 4; ++child)
      if (!read(level - 1, bits, tree, data, first + (child << 2 * (level - 1)), at, map)) return 0;
    return !uniform(map, bits, level, first); /* or it would have been a leaf */
  }
  const unsigned state = get(data, bits, at->leaves++);
  for (size_t k = 0; k < (size_t)1 << 2 * level; ++k) put(map, bits, first + k, state);
  return 1;
}

static int tree_decode(uint32_t level, uint32_t bits, const uint8_t* code, size_t code_size, uint8_t* map) {
  mmverify_place_t end = {0, 0}, at = {0, 0};
  if (!skip(level, code, 8 * code_size, &end)) return 0;
  const size_t tree_bytes = bytes_of(1, end.nodes);
  if (code_size != tree_bytes + bytes_of(bits, end.leaves)) return 0;
  /* the bits after the last */
  for (size_t t = end.nodes; t < 8 * tree_bytes; ++t)
    if (get(code, 1, t)) return 0;
  for (size_t t = bits * end.leaves; t < 8 * (code_size - tree_bytes); ++t)
    if (get(code + tree_bytes, 1, t)) return 0;
  memset(map, 0, bytes_of(bits, (size_t)1 << 2 * level));
  return read(level, bits, code, code + tree_bytes, 0, &at, map);
}

/* ---- Algorithm 3 ---- */

static unsigned find(uint32_t level, uint32_t bits, const uint8_t* tree, const uint8_t* data, size_t most,
                     size_t index, mmverify_place_t* at) {
  if (!get(tree, 1, at->nodes++)) return get(data, bits, at->leaves);
  for (size_t child = index >> 2 * (level - 1) & 3; child > 0; --child) skip(level - 1, tree, most, at);
  return find(level - 1, bits, tree, data, most, index, at);
}

static unsigned state_at(uint32_t level, uint32_t bits, const uint8_t* tree, size_t nodes, size_t index) {
  mmverify_place_t at = {0, 0};
  return find(level, bits, tree, tree + bytes_of(1, nodes), nodes, index, &at);
}

static size_t nodes_of(uint32_t level, const uint8_t* code, size_t code_size) {
  mmverify_place_t end = {0, 0};
  skip(level, code, 8 * code_size, &end);
  return end.nodes;
}

static void tree_lookup(uint32_t level, uint32_t bits, const uint8_t* code, size_t code_size,
                        const uint32_t* index, uint8_t* state, size_t count) {
  const size_t nodes = nodes_of(level, code, code_size);
  for (size_t k = 0; k < count; ++k) state[k] = (uint8_t)state_at(level, bits, code, nodes, index[k]);
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
  const size_t nodes = nodes_of(level, code, code_size);
  for (size_t k = 0; k < count; ++k)
    state[k] = (uint8_t)state_at(level, bits, code, nodes, index_of(level, u[k], v[k]));
}

/* Not needed by a subject: the recursion, for a proof at each level. */
const mmverify_contract_t* mmverify_contract_v1(void) {
  static const mmverify_contract_t contract = {sizeof contract, measure, write, skip, read, find};
  return &contract;
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
