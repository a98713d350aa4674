/* The library's C face for lookups in a map, as a subject: its code of a map is the map, bits after the last state 0. */
#include <stdlib.h>
#include <string.h>

#include "impl/mmverify.h"
#include "subjects/sdk/mmverify_subject.h"

static size_t bits_of(uint32_t level, uint32_t format) { return ((size_t)1 << 2 * level) * format; }
static size_t size_of(uint32_t level, uint32_t format) { return (bits_of(level, format) + 7) / 8; }
static uint8_t mask_of_last(uint32_t level, uint32_t format) {
  const size_t used = bits_of(level, format) % 8;
  return used == 0 ? 0xff : (uint8_t)((1u << used) - 1);
}

static size_t encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code, size_t capacity) {
  const size_t size = size_of(level, format);
  if (size <= capacity) {
    memcpy(code, map, size);
    code[size - 1] &= mask_of_last(level, format);
  }
  return size;
}

static mmverify_tree* tree_of(uint32_t level, uint32_t format, const uint8_t* code) {
  mmverify_tree* tree = mmverify_tree_new(level, format, code);
  if (!tree) abort();
  return tree;
}

static int decode(uint32_t level, uint32_t format, const uint8_t* code, size_t size, uint8_t* map) {
  if (size != size_of(level, format) || (code[size - 1] & ~mask_of_last(level, format)) != 0) return 0;
  mmverify_tree* tree = tree_of(level, format, code);
  if (!mmverify_tree_decode(tree, map)) abort();
  mmverify_tree_free(tree);
  return 1;
}

static void lookup(uint32_t level, uint32_t format, const uint8_t* code, size_t size, const uint32_t* index,
                   uint8_t* state, size_t count) {
  (void)size;
  mmverify_tree* tree = tree_of(level, format, code);
  if (!mmverify_tree_lookup(tree, index, state, count)) abort();
  mmverify_tree_free(tree);
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t s;
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "the library's C face, lookups";
  s.max_level = 12;
  s.tree_encode = encode;
  s.tree_decode = decode;
  s.tree_lookup = lookup;
  return &s;
}
