/* Arrays that are there: compacted, reordered, put behind each other, kept in files, and maps of levels that a device lacks.
 * Each the obvious way. */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "mmverify_subject.h"

enum { record_bytes = 8, geometry_bytes = 12, head_bytes = 12, state_bits = 2 };
static const uint32_t nowhere = 0xffffffffu;

static size_t map_bytes(uint32_t level, uint32_t format) {
  return (((size_t)1 << (2 * level)) * format + 7) / 8;
}

static uint32_t width_of(uint32_t index_type) { /* in bytes */
  switch (index_type) {
    case MMVERIFY_INDEX_U8: return 1;
    case MMVERIFY_INDEX_U16:
    case MMVERIFY_INDEX_I16: return 2;
    default: return 4;
  }
}

static uint32_t word_at(const uint8_t* at) {
  uint32_t word;
  memcpy(&word, at, sizeof word);
  return word;
}

/* Writes behind each other, and counts what there is no room for. */
typedef struct {
  uint8_t* to;
  size_t capacity, size;
} writer;
static void put(writer* w, const void* from, size_t bytes) {
  if (w->size + bytes <= w->capacity) memcpy(w->to + w->size, from, bytes);
  w->size += bytes;
}
static void put_word(writer* w, uint32_t word) { put(w, &word, sizeof word); }

/* The parts of an array's bytes. */
typedef struct {
  mmverify_array_parts_t head;
  const uint8_t *geometries, *records, *indices, *data;
  size_t size; /* of all */
} view;

static mmverify_array_geometry_t geometry_of(const view* v, uint32_t g) {
  mmverify_array_geometry_t geometry;
  memcpy(&geometry, v->geometries + geometry_bytes * g, sizeof geometry);
  return geometry;
}

static size_t index_bytes(const view* v) {
  size_t bytes = 0;
  for (uint32_t g = 0; g < v->head.geometries; ++g) {
    const mmverify_array_geometry_t geometry = geometry_of(v, g);
    bytes += (size_t)geometry.triangles * width_of(geometry.index_type);
  }
  return bytes;
}

static view view_of(const uint8_t* bytes) {
  view v;
  memcpy(&v.head, bytes, sizeof v.head);
  v.geometries = bytes + head_bytes;
  v.records = v.geometries + (size_t)geometry_bytes * v.head.geometries;
  v.indices = v.records + (size_t)record_bytes * v.head.records;
  v.data = v.indices + index_bytes(&v);
  v.size = (size_t)(v.data - bytes) + v.head.data_bytes;
  return v;
}

static size_t bytes_of_record(const view* v, uint32_t record) {
  const uint32_t kind = word_at(v->records + record_bytes * record + 4);
  return map_bytes(kind & 0xffff, kind >> 16);
}

/* An index as it is stored, and the record that it means, or `nowhere`. */
static uint32_t code_at(const uint8_t* index, uint32_t width) {
  uint32_t code = 0;
  memcpy(&code, index, width);
  return code;
}
static uint32_t record_of(uint32_t code, uint32_t width, uint32_t base) {
  const uint32_t all_ones = 0xffffffffu >> (32 - 8 * width);
  return all_ones - code < 4 ? nowhere : code + base;
}
static uint64_t limit_of(uint32_t index_type) {
  const uint32_t bits = 8 * width_of(index_type);
  return index_type >= MMVERIFY_INDEX_I16 ? (uint64_t)1 << (bits - 1) : ((uint64_t)1 << bits) - 4;
}

/* The array with the records `order`, `count` of them: place[r] says where record r has gone. */
static size_t arranged(const view* v, const uint32_t* order, const uint32_t* place, uint32_t count,
                       uint8_t* changed, size_t capacity) {
  writer w = {changed, capacity, 0};
  mmverify_array_parts_t head = v->head;
  head.records = count;
  head.data_bytes = 0;
  for (uint32_t k = 0; k < count; ++k) head.data_bytes += (uint32_t)bytes_of_record(v, order[k]);
  put(&w, &head, sizeof head);
  for (uint32_t g = 0; g < v->head.geometries; ++g) {
    mmverify_array_geometry_t geometry = geometry_of(v, g);
    geometry.base_triangle = 0;
    put(&w, &geometry, sizeof geometry);
  }
  uint32_t offset = 0;
  for (uint32_t k = 0; k < count; ++k) {
    put_word(&w, offset);
    put(&w, v->records + record_bytes * order[k] + 4, 4);
    offset += (uint32_t)bytes_of_record(v, order[k]);
  }
  const uint8_t* index = v->indices;
  for (uint32_t g = 0; g < v->head.geometries; ++g) {
    const mmverify_array_geometry_t geometry = geometry_of(v, g);
    const uint32_t width = width_of(geometry.index_type);
    for (uint32_t t = 0; t < geometry.triangles; ++t, index += width) {
      uint32_t code = code_at(index, width);
      const uint32_t record = record_of(code, width, geometry.base_triangle);
      if (record != nowhere) code = place[record];
      if (record != nowhere && code >= limit_of(geometry.index_type)) return 0;
      put(&w, &code, width);
    }
  }
  for (uint32_t k = 0; k < count; ++k)
    put(&w, v->data + word_at(v->records + record_bytes * order[k]), bytes_of_record(v, order[k]));
  return w.size;
}

/* Records in the order of their first use, then, if asked for, the others. */
static size_t by_use(const uint8_t* array, int by_first_use, int others, uint8_t* changed, size_t capacity) {
  const view v = view_of(array);
  uint32_t* const order = malloc(sizeof(uint32_t) * (2 * (size_t)v.head.records + 1));
  uint32_t* const place = order + v.head.records;
  uint32_t count = 0;
  for (uint32_t r = 0; r < v.head.records; ++r) place[r] = nowhere;
  const uint8_t* index = v.indices;
  for (uint32_t g = 0; g < v.head.geometries; ++g) {
    const mmverify_array_geometry_t geometry = geometry_of(&v, g);
    const uint32_t width = width_of(geometry.index_type);
    for (uint32_t t = 0; t < geometry.triangles; ++t, index += width) {
      const uint32_t record = record_of(code_at(index, width), width, geometry.base_triangle);
      if (record == nowhere || place[record] != nowhere) continue;
      place[record] = count;
      order[count++] = record;
    }
  }
  if (!by_first_use) { /* those in use, in the order that they had */
    count = 0;
    for (uint32_t r = 0; r < v.head.records; ++r)
      if (place[r] != nowhere) {
        place[r] = count;
        order[count++] = r;
      }
  }
  for (uint32_t r = 0; others && r < v.head.records; ++r)
    if (place[r] == nowhere) {
      place[r] = count;
      order[count++] = r;
    }
  const size_t size = arranged(&v, order, place, count, changed, capacity);
  free(order);
  return size;
}

static size_t array_compact(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity) {
  (void)array_size;
  return by_use(array, 0, 0, changed, capacity);
}

static size_t array_reorder(const uint8_t* array, size_t array_size, uint8_t* changed, size_t capacity) {
  (void)array_size;
  return by_use(array, 1, 1, changed, capacity);
}

static size_t array_concatenate(const uint8_t* arrays, size_t arrays_size, uint8_t* changed,
                                size_t capacity) {
  (void)arrays_size;
  const view a = view_of(arrays), b = view_of(arrays + a.size);
  const mmverify_array_parts_t head = {a.head.records + b.head.records, a.head.data_bytes + b.head.data_bytes,
                                       a.head.geometries + b.head.geometries};
  writer w = {changed, capacity, 0};
  put(&w, &head, sizeof head);
  put(&w, a.geometries, (size_t)geometry_bytes * a.head.geometries);
  for (uint32_t g = 0; g < b.head.geometries; ++g) {
    mmverify_array_geometry_t geometry = geometry_of(&b, g);
    geometry.base_triangle += a.head.records;
    put(&w, &geometry, sizeof geometry);
  }
  put(&w, a.records, (size_t)record_bytes * a.head.records);
  for (uint32_t r = 0; r < b.head.records; ++r) {
    put_word(&w, word_at(b.records + record_bytes * r) + a.head.data_bytes);
    put(&w, b.records + record_bytes * r + 4, 4);
  }
  put(&w, a.indices, index_bytes(&a));
  put(&w, b.indices, index_bytes(&b));
  put(&w, a.data, a.head.data_bytes);
  put(&w, b.data, b.head.data_bytes);
  return w.size;
}

/* FNV-1a. */
static uint32_t sum_of(const uint8_t* bytes, size_t count) {
  uint32_t sum = 0x811c9dc5u;
  for (size_t k = 0; k < count; ++k) sum = (sum ^ bytes[k]) * 0x01000193u;
  return sum;
}

static const char magic[8] = {'M', 'M', 'A', 'R', 'R', 'A', 'Y', 'S'};
enum { magic_bytes = 8, version_1_head = 28, version_2_least = 28 };

/* The files of docs/ARRAYS.md. */
static size_t array_save(uint32_t version, const uint8_t* array, size_t array_size, uint8_t* file,
                         size_t capacity) {
  const view v = view_of(array);
  writer w = {file, capacity, 0};
  put(&w, magic, magic_bytes);
  put_word(&w, version);
  if (version == 2) {
    put(&w, array, array_size);
    const size_t before = w.size;
    put_word(&w, before <= capacity ? sum_of(file, before) : 0);
    return w.size;
  }
  if (version != 1 || v.head.geometries != 1) return 0;
  const mmverify_array_geometry_t geometry = geometry_of(&v, 0);
  if (geometry.index_type != MMVERIFY_INDEX_U32) return 0;
  put_word(&w, v.head.records);
  put_word(&w, v.head.data_bytes);
  put_word(&w, geometry.triangles);
  put_word(&w, geometry.base_triangle);
  put(&w, v.records, array_size - (size_t)(v.records - array));
  return w.size;
}

static size_t load_version_1(const uint8_t* file, size_t file_size, uint8_t* array, size_t capacity) {
  if (file_size < version_1_head) return 0;
  const uint32_t records = word_at(file + 12), data_bytes = word_at(file + 16),
                 triangles = word_at(file + 20), base = word_at(file + 24);
  const uint64_t all =
      version_1_head + (uint64_t)record_bytes * records + (uint64_t)4 * triangles + data_bytes;
  if (all != file_size) return 0;
  const mmverify_array_parts_t head = {records, data_bytes, 1};
  const mmverify_array_geometry_t geometry = {MMVERIFY_INDEX_U32, base, triangles};
  writer w = {array, capacity, 0};
  put(&w, &head, sizeof head);
  put(&w, &geometry, sizeof geometry);
  put(&w, file + version_1_head, file_size - version_1_head);
  return w.size;
}

static size_t array_load(const uint8_t* file, size_t file_size, uint8_t* array, size_t capacity) {
  if (file_size < magic_bytes + 4 || memcmp(file, magic, magic_bytes) != 0) return 0;
  const uint32_t version = word_at(file + magic_bytes);
  if (version == 1) return load_version_1(file, file_size, array, capacity);
  if (version != 2 || file_size < version_2_least) return 0;
  const uint8_t* const parts = file + magic_bytes + 4;
  const size_t size = file_size - magic_bytes - 4 - 4;
  if (word_at(file + file_size - 4) != sum_of(file, file_size - 4)) return 0;
  /* What is announced, before any of it is believed. */
  const uint32_t geometries = word_at(parts + 8);
  uint64_t all = head_bytes + (uint64_t)geometry_bytes * geometries;
  if (all > size) return 0;
  all += (uint64_t)record_bytes * word_at(parts) + word_at(parts + 4);
  for (uint32_t g = 0; g < geometries; ++g) {
    const uint8_t* geometry = parts + head_bytes + (size_t)geometry_bytes * g;
    if (word_at(geometry) > MMVERIFY_INDEX_I32) return 0;
    all += (uint64_t)word_at(geometry + 8) * width_of(word_at(geometry));
  }
  if (all != size) return 0;
  writer w = {array, capacity, 0};
  put(&w, parts, size);
  return w.size;
}

/* T and O for blocks of T and O alone; UO where there is an O or UO, else UT. */
static size_t array_emulate(uint32_t level, uint32_t most, const uint8_t* map, uint8_t* emulated,
                            size_t capacity) {
  const size_t size = map_bytes(most, MMVERIFY_4_STATE), blocks = (size_t)1 << (2 * most),
               each = (size_t)1 << (2 * (level - most));
  if (size > capacity) return size;
  memset(emulated, 0, size);
  for (size_t b = 0; b < blocks; ++b) {
    unsigned seen = 0; /* bit s: state s */
    for (size_t i = b * each; i < (b + 1) * each; ++i)
      seen |= 1u << (map[i * state_bits / 8] >> i * state_bits % 8 & 3);
    const unsigned state = seen == 1 ? 0 : seen == 2 ? 1 : (seen & 10u) != 0 ? 3 : 2;
    emulated[b * state_bits / 8] |= (uint8_t)(state << b * state_bits % 8);
  }
  return size;
}

static const mmverify_subject_t subject = {
    .abi = MMVERIFY_SUBJECT_ABI,
    .size = sizeof(mmverify_subject_t),
    .name = "changes of arrays in C",
    .max_level = 12,
    .flags = MMVERIFY_ARRAY_FILES,
    .array_compact = array_compact,
    .array_reorder = array_reorder,
    .array_concatenate = array_concatenate,
    .array_save = array_save,
    .array_load = array_load,
    .array_emulate = array_emulate,
};

const mmverify_subject_t* mmverify_subject_v1(void) { return &subject; }
