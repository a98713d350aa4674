/* A complete subject of topic dag in plain C: no graph, but an array in which maps that are the same lie once.
 *
 * A code: how many maps, 32 bits; for each its level and its place in the data, 32 bits each; the data.  Numbers
 * little-endian. */
#include <stdlib.h>
#include <string.h>

#include "mmverify_subject.h"

static uint32_t number(const uint8_t* at) {
  return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static void put(uint8_t* at, size_t x) {
  for (int k = 0; k < 4; ++k) at[k] = (uint8_t)(x >> 8 * k);
}

static size_t map_bytes(uint32_t level, uint32_t bits) { return (((size_t)bits << 2 * level) + 7) / 8; }

static size_t count_maps(uint32_t bits, const uint8_t* scene, size_t size) {
  size_t count = 0;
  for (size_t at = 0; at < size; at += 1 + map_bytes(scene[at], bits)) ++count;
  return count;
}

/* ---- encoding: where the first map lies that is the same, or behind all data ---- */

static size_t dag_encode(uint32_t bits, const uint8_t* scene, size_t size, uint8_t* code, size_t capacity) {
  const size_t maps = count_maps(bits, scene, size), data = 4 + 8 * maps;
  size_t end = 0, m = 0;
  uint8_t* out = malloc(data + size); /* never larger */
  if (!out) return 0;
  put(out, maps);
  for (size_t at = 0; at < size; ++m) {
    const uint32_t level = scene[at];
    const size_t bytes = map_bytes(level, bits);
    size_t place = end;
    for (size_t k = 0; k < m && place == end; ++k)
      if (number(out + 4 + 8 * k) == level &&
          memcmp(out + data + number(out + 8 + 8 * k), scene + at + 1, bytes) == 0)
        place = number(out + 8 + 8 * k);
    if (place == end) {
      memcpy(out + data + end, scene + at + 1, bytes);
      end += bytes;
    }
    put(out + 4 + 8 * m, level);
    put(out + 8 + 8 * m, place);
    at += 1 + bytes;
  }
  if (capacity >= data + end) memcpy(code, out, data + end);
  free(out);
  return data + end;
}

/* ---- decoding: what does not encode to the very bytes is no code ---- */

static size_t dag_decode(uint32_t bits, const uint8_t* code, size_t code_size, uint8_t* scene,
                         size_t capacity) {
  if (code_size < 4 || (code_size - 4) / 8 < number(code)) return 0;
  const size_t maps = number(code), data = 4 + 8 * maps;
  size_t size = 0;
  for (size_t m = 0; m < maps; ++m) {
    const uint32_t level = number(code + 4 + 8 * m), place = number(code + 8 + 8 * m);
    if (level > 12 || place > code_size - data || code_size - data - place < map_bytes(level, bits)) return 0;
    size += 1 + map_bytes(level, bits);
  }
  if (size == 0 || size > (size_t)1 << 26)
    return 0; /* a scene of no maps is none; and no code of this long a scene is taken */
  uint8_t* out = malloc(size);
  if (!out) return 0;
  size_t at = 0;
  for (size_t m = 0; m < maps; ++m) {
    const uint32_t level = number(code + 4 + 8 * m);
    out[at] = (uint8_t)level;
    memcpy(out + at + 1, code + data + number(code + 8 + 8 * m), map_bytes(level, bits));
    at += 1 + map_bytes(level, bits);
    const uint32_t used = (bits << 2 * level) % 8;
    if (used && out[at - 1] >> used) size = 0; /* a padding bit */
  }
  if (size) {
    uint8_t* again = malloc(code_size);
    if (!again || dag_encode(bits, out, size, again, code_size) != code_size ||
        memcmp(again, code, code_size) != 0)
      size = 0;
    free(again);
  }
  if (size && capacity >= size) memcpy(scene, out, size);
  free(out);
  return size;
}

/* ---- lookups ---- */

static void dag_lookup(uint32_t bits, const uint8_t* code, size_t code_size, const uint32_t* map,
                       const uint32_t* index, uint8_t* state, size_t count) {
  const uint8_t* data = code + 4 + 8 * (size_t)number(code);
  (void)code_size;
  for (size_t k = 0; k < count; ++k) {
    const size_t bit = (size_t)index[k] * bits;
    state[k] =
        (uint8_t)(data[number(code + 8 + 8 * (size_t)map[k]) + bit / 8] >> bit % 8 & ((1u << bits) - 1));
  }
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example of a scene's maps",
                                             .max_level = 12,
                                             .dag_encode = dag_encode,
                                             .dag_decode = dag_decode,
                                             .dag_lookup = dag_lookup};
  return &subject;
}
