/* An array of many triangles' maps, built the obvious way, and what an index means. Nothing is merged, which the contract
 * allows. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "mmverify_subject.h"

static size_t states_of(uint32_t level) { return (size_t)1 << (2 * level); }
static size_t bytes_of(const mmverify_array_triangle_t* t) {
  return (states_of(t->level) * t->format + 7) / 8;
}

static uint32_t state_at(const uint8_t* map, uint32_t format, size_t i) {
  const size_t bit = i * format;
  return map[bit / 8] >> bit % 8 & (format == MMVERIFY_2_STATE ? 1u : 3u);
}

/* The one state of all, or 4. */
static uint32_t uniform(const mmverify_array_case_t* what, uint32_t k) {
  const mmverify_array_triangle_t* t = &what->triangles[k];
  const uint8_t* map = what->maps + t->map;
  const uint32_t first = state_at(map, t->format, 0);
  for (size_t i = 1; i < states_of(t->level); ++i)
    if (state_at(map, t->format, i) != first) return 4;
  return first;
}

static int equal(const mmverify_array_case_t* what, uint32_t a, uint32_t b) {
  const mmverify_array_triangle_t *x = &what->triangles[a], *y = &what->triangles[b];
  return x->level == y->level && x->format == y->format &&
         memcmp(what->maps + x->map, what->maps + y->map, bytes_of(x)) == 0;
}

static int is_special(const mmverify_array_case_t* what, uint32_t k) {
  return k >= what->before && (what->flags & MMVERIFY_ARRAY_SPECIAL) && uniform(what, k) < 4;
}

/* The triangle whose record k has: itself, or an earlier one that it shares with. */
static uint32_t owner(const mmverify_array_case_t* what, uint32_t k) {
  if (k >= what->before && (what->flags & MMVERIFY_ARRAY_SHARE))
    for (uint32_t j = what->base_triangle; j < k; ++j)
      if (!is_special(what, j) && equal(what, j, k)) return j;
  return k;
}

static int has_record(const mmverify_array_case_t* what, uint32_t k) {
  return !is_special(what, k) && owner(what, k) == k;
}

/* The number of the record that k owns. */
static uint32_t record_of(const mmverify_array_case_t* what, uint32_t k) {
  uint32_t record = 0;
  for (uint32_t j = 0; j < k; ++j)
    if (has_record(what, j)) ++record;
  return record;
}

static uint32_t width_of(uint32_t index_type) {
  switch (index_type) {
    case MMVERIFY_INDEX_U8: return 8;
    case MMVERIFY_INDEX_U16:
    case MMVERIFY_INDEX_I16: return 16;
    default: return 32;
  }
}
static int is_signed(uint32_t index_type) { return index_type >= MMVERIFY_INDEX_I16; }

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

/* How many triangles have a map of this level and format: of records, or of references. */
static uint32_t count_of(const mmverify_array_case_t* what, uint32_t level, uint32_t format, int references) {
  uint32_t count = 0;
  for (uint32_t k = references ? what->before : 0; k < what->count; ++k) {
    const mmverify_array_triangle_t* t = &what->triangles[k];
    const int counts = references ? !is_special(what, k) : has_record(what, k);
    if (counts && t->level == level && t->format == format) ++count;
  }
  return count;
}

static uint32_t put_counts(writer* w, const mmverify_array_case_t* what, int references) {
  uint32_t entries = 0;
  for (uint32_t level = 0; level <= 12; ++level)
    for (uint32_t format = MMVERIFY_2_STATE; format <= MMVERIFY_4_STATE; ++format) {
      const uint32_t count = count_of(what, level, format, references);
      if (count == 0) continue;
      ++entries;
      if (w == NULL) continue;
      put_word(w, count);
      put_word(w, level);
      put_word(w, format);
    }
  return entries;
}

static size_t array_build(const mmverify_array_case_t* what, uint8_t* answer, size_t capacity) {
  const uint32_t width = width_of(what->index_type);
  const uint64_t limit =
      is_signed(what->index_type) ? (uint64_t)1 << (width - 1) : ((uint64_t)1 << width) - 4;
  const int counts_geometry = what->api == MMVERIFY_ARRAY_EXT || what->api == MMVERIFY_ARRAY_OPTIX ||
                              what->api == MMVERIFY_ARRAY_NVAPI;
  mmverify_array_answer_t head = {0, 0, 0, 0, 0};
  writer w = {answer, capacity, 0};
  for (uint32_t k = 0; k < what->count; ++k)
    if (has_record(what, k)) {
      ++head.records;
      head.data_bytes += (uint32_t)bytes_of(&what->triangles[k]);
    }
  head.array_counts = put_counts(NULL, what, 0);
  if (counts_geometry) head.geometry_counts = put_counts(NULL, what, 1);
  head.index_bytes = (what->count - what->before) * (width / 8);
  put(&w, &head, sizeof head);

  uint32_t offset = 0;
  for (uint32_t k = 0; k < what->count; ++k) {
    const mmverify_array_triangle_t* t = &what->triangles[k];
    if (!has_record(what, k)) continue;
    put_word(&w, offset);
    put_word(&w, t->level | t->format << 16);
    offset += (uint32_t)bytes_of(t);
  }
  put_counts(&w, what, 0);
  if (counts_geometry) put_counts(&w, what, 1);
  for (uint32_t k = what->before; k < what->count; ++k) {
    uint32_t code = ~uniform(what, k); /* -1 T, -2 O, -3 UT, -4 UO; the base triangle is no part of it */
    if (!is_special(what, k)) {
      code = record_of(what, owner(what, k)) - what->base_triangle;
      if (code >= limit) return 0;
    }
    put(&w, &code, width / 8);
  }
  for (uint32_t k = 0; k < what->count; ++k)
    if (has_record(what, k)) put(&w, what->maps + what->triangles[k].map, bytes_of(&what->triangles[k]));
  return w.size;
}

static void array_resolve(uint32_t index_type, const uint32_t* code, const uint32_t* base_triangle,
                          const uint32_t* records, uint32_t* target, size_t count) {
  const uint32_t type = index_type & ~MMVERIFY_INDEX_IN_CLUSTER, width = width_of(type);
  const uint32_t all_ones = 0xffffffffu >> (32 - width);
  for (size_t k = 0; k < count; ++k) {
    const uint32_t from_the_end = all_ones - code[k]; /* 0 for -1 */
    const int below_zero = is_signed(type) && code[k] >> (width - 1) != 0;
    const uint64_t record = (uint64_t)code[k] + base_triangle[k];
    target[2 * k + 1] = 0;
    if (from_the_end < 4) {
      target[2 * k] = MMVERIFY_TARGET_SPECIAL;
      target[2 * k + 1] = from_the_end;
    } else if (from_the_end == 4 && (index_type & MMVERIFY_INDEX_IN_CLUSTER)) {
      target[2 * k] = MMVERIFY_TARGET_NONE;
    } else if (below_zero || record >= records[k]) { /* less than, not "less than or equal" */
      target[2 * k] = MMVERIFY_TARGET_OUTSIDE;
    } else {
      target[2 * k] = MMVERIFY_TARGET_RECORD;
      target[2 * k + 1] = (uint32_t)record;
    }
  }
}

static const mmverify_subject_t subject = {
    .abi = MMVERIFY_SUBJECT_ABI,
    .size = sizeof(mmverify_subject_t),
    .name = "arrays in C",
    .max_level = 12,
    .array_build = array_build,
    .array_resolve = array_resolve,
};

const mmverify_subject_t* mmverify_subject_v1(void) { return &subject; }
