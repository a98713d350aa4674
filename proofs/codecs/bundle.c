/* Laws of arrays of one geometry, 2 triangles and 1 to 3 records, whose maps take a byte each.  SIZE: the records, 4
 * added for each type of index before.  A record's map may be of level 0 or 1, in either format, anywhere in the data
 * but in the last byte, which is no record's. */
#include "proofs/codecs/law.h"

enum {
  RECORDS = SIZE % 4,
  DATA = RECORDS + 1,
  TYPE = SIZE / 4,
  TRIANGLES = 2,
  HEAD = 12,
  GEOMETRY = 12,
  RECORD = 8,
  OF_NO_RECORD = 0xa5
};
enum {
  WIDTH = TYPE == MMVERIFY_INDEX_U8                                  ? 1
          : TYPE == MMVERIFY_INDEX_U16 || TYPE == MMVERIFY_INDEX_I16 ? 2
                                                                     : 4,
  ARRAY_BYTES = HEAD + GEOMETRY + RECORDS * RECORD + TRIANGLES * WIDTH + DATA,
  FILE_BYTES = 2 * ARRAY_BYTES + 64
};

static uint32_t number(const uint8_t* at, uint32_t bytes) {
  uint32_t value = 0;
  for (uint32_t k = 0; k < bytes; ++k) value |= (uint32_t)at[k] << 8 * k;
  return value;
}
static void put(uint8_t** at, uint32_t value, uint32_t bytes) {
  for (uint32_t k = 0; k < bytes; ++k) *(*at)++ = (uint8_t)(value >> 8 * k);
}

/* Any array of that form, of a byte for the base triangle, one for each triangle and two for each record. */
static void any_array(uint8_t* at) {
  const uint32_t base = RECORDS > 1 ? (uint32_t)any(8) & 1 : (uint32_t)any(8) & 0;
  uint8_t triangles[TRIANGLES], records[RECORDS], maps[RECORDS];
  any_bytes(triangles, TRIANGLES);
  any_bytes(records, RECORDS);
  any_bytes(maps, RECORDS);
  put(&at, RECORDS, 4), put(&at, DATA, 4), put(&at, 1, 4);
  put(&at, TYPE, 4), put(&at, base, 4), put(&at, TRIANGLES, 4);
  for (uint32_t r = 0; r < RECORDS; ++r) {
    const uint32_t place = records[r] & 3;
    put(&at, place < RECORDS ? place : 0, 4);
    put(&at, (records[r] >> 2 & 1) | (1u + (records[r] >> 3 & 1)) << 16, 4);
  }
  for (uint32_t t = 0; t < TRIANGLES; ++t) {
    const uint32_t low = triangles[t] & 3;
    put(&at, triangles[t] & 4 ? ~low : low + base < RECORDS ? low : 0, WIDTH);
  }
  for (uint32_t r = 0; r < RECORDS; ++r) put(&at, maps[r], 1);
  put(&at, OF_NO_RECORD, 1);
}

/* The map of a triangle of a geometry: its level, format and states; or a special index. */
typedef struct {
  uint32_t special, kind, states, record;
} Meaning;

static Meaning meaning(const uint8_t* array, uint32_t geometries, uint32_t geometry, uint32_t triangle) {
  Meaning is = {0, 0, 0, 0};
  const uint32_t records = number(array, 4), base = number(array + HEAD + GEOMETRY * geometry + 4, 4);
  const uint8_t* index = array + HEAD + GEOMETRY * geometries + RECORD * (size_t)records;
  const uint8_t* data = index + (size_t)geometries * TRIANGLES * WIDTH;
  const uint32_t code = number(index + (geometry * TRIANGLES + triangle) * WIDTH, WIDTH);
  const uint32_t below = (0xffffffffu >> (32 - 8 * WIDTH)) - code;
  if (below < 4) {
    is.special = 1 + below;
    return is;
  }
  is.record = code + base;
  check(is.record < records);
  const uint8_t* record = array + HEAD + GEOMETRY * geometries + RECORD * (size_t)is.record;
  is.kind = number(record + 4, 4);
  const uint32_t bits = (is.kind & 1 ? 4 : 1) * (is.kind >> 16), place = number(record, 4);
  check(place < number(array + 4, 4));
  is.states = data[place] & ((1u << bits) - 1);
  return is;
}

static int alike(Meaning a, Meaning b) {
  return a.special == b.special && a.kind == b.kind && a.states == b.states;
}

static size_t size_of(const uint8_t* array, uint32_t geometries) {
  return HEAD + GEOMETRY * geometries + RECORD * (size_t)number(array, 4) + number(array + 4, 4) +
         (size_t)geometries * TRIANGLES * WIDTH;
}

/* Each triangle of a changed array is as before, and the array has the size that was returned. */
static void unchanged(const uint8_t* array, const uint8_t* changed, size_t size) {
  check(size >= HEAD && size <= ARRAY_BYTES);
  check(number(changed, 4) <= RECORDS && number(changed + 4, 4) <= RECORDS && number(changed + 8, 4) == 1);
  check(number(changed + HEAD, 4) == TYPE && number(changed + HEAD + 8, 4) == TRIANGLES);
  check_is(size, size_of(changed, 1));
  for (uint32_t t = 0; t < TRIANGLES; ++t) check(alike(meaning(changed, 1, 0, t), meaning(array, 1, 0, t)));
}

/* array.compact: and each record that is left is used. */
void compact(void) {
  uint8_t array[ARRAY_BYTES], changed[ARRAY_BYTES];
  any_array(array);
  const size_t size = codec()->array_compact(array, ARRAY_BYTES, changed, ARRAY_BYTES);
  unchanged(array, changed, size);
  const Meaning first = meaning(changed, 1, 0, 0), second = meaning(changed, 1, 0, 1);
  for (uint32_t r = 0; r < RECORDS; ++r)
    check(r >= number(changed, 4) || (!first.special && first.record == r) ||
          (!second.special && second.record == r));
}

/* array.reorder: and all records are there, in the order of their first use. */
void reorder(void) {
  uint8_t array[ARRAY_BYTES], changed[ARRAY_BYTES];
  any_array(array);
  const size_t size = codec()->array_reorder(array, ARRAY_BYTES, changed, ARRAY_BYTES);
  unchanged(array, changed, size);
  check_is(number(changed, 4), RECORDS);
  const Meaning first = meaning(changed, 1, 0, 0), second = meaning(changed, 1, 0, 1);
  check(first.special || first.record == 0);
  check(second.special || second.record <= (first.special ? 0u : 1u));
}

/* array.concatenate: of two arrays. */
void concatenate(void) {
  uint8_t arrays[2 * ARRAY_BYTES], changed[2 * ARRAY_BYTES];
  any_array(arrays);
  any_array(arrays + ARRAY_BYTES);
  const size_t size = codec()->array_concatenate(arrays, 2 * ARRAY_BYTES, changed, 2 * ARRAY_BYTES);
  check(size >= HEAD && size <= 2 * ARRAY_BYTES);
  check(number(changed, 4) == 2 * RECORDS && number(changed + 4, 4) <= 2 * DATA);
  check_is(number(changed + 8, 4), 2);
  check_is(size, size_of(changed, 2));
  for (uint32_t g = 0; g < 2; ++g)
    for (uint32_t t = 0; t < TRIANGLES; ++t)
      check(alike(meaning(changed, 2, g, t), meaning(arrays + ARRAY_BYTES * g, 1, 0, t)));
}

/* array.files: what is saved is loaded; a file may have twice an array's bytes and 64 more. */
static void saved(uint32_t version, const uint8_t* array) {
  uint8_t file[FILE_BYTES], back[ARRAY_BYTES];
  const size_t size = codec()->array_save(version, array, ARRAY_BYTES, file, FILE_BYTES);
  check(size > 0 || version == 1);
  if (size == 0) return;
  room(size <= FILE_BYTES);
  check_is(codec()->array_load(file, size, back, ARRAY_BYTES), ARRAY_BYTES);
  check_bytes(back, array, ARRAY_BYTES);
}
void files(void) {
  uint8_t array[ARRAY_BYTES];
  any_array(array);
  saved(1, array);
  saved(2, array);
}
