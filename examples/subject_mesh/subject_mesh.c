/* A baker of whole meshes from a baker of one triangle: each triangle's map is baked by itself. A uniform map becomes a
 * special index, equal maps share a record. */
#include <stdlib.h>
#include <string.h>

#include "mmverify_subject.h"

/* The subject that bakes one triangle. */
extern const mmverify_subject_t* baker(void);

typedef struct {
  uint32_t level;
  uint32_t state;  /* of all micro-triangles, or 4 */
  uint32_t record; /* if the state is 4 */
  int is_first;    /* of those that have the record */
  uint8_t* map;
} baked;

static size_t bytes_of(uint32_t level, uint32_t format) {
  return (((size_t)1 << 2 * level) * format + 7) / 8;
}

static uint32_t uniform(const uint8_t* map, uint32_t level, uint32_t format) {
  const size_t states = (size_t)1 << 2 * level;
  const uint32_t mask = format == MMVERIFY_2_STATE ? 1 : 3, first = map[0] & mask;
  for (size_t i = 1; i < states; ++i)
    if ((map[i * format / 8] >> i * format % 8 & mask) != first) return 4;
  return first;
}

/* Bakes all triangles; returns the number of records, or -1 for an unsupported case. */
static long bake_all(const mmverify_mesh_case_t* what, baked* all, uint8_t* maps) {
  long records = 0;
  for (uint32_t t = 0; t < what->triangles; ++t) {
    mmverify_bake_case_t one = *what->surface;
    baked* b = &all[t];
    one.level = what->levels != NULL ? what->levels[t] : one.level;
    for (uint32_t k = 0; k < 3; ++k)
      memcpy(&one.uv[2 * k], &what->uvs[2 * what->indices[3 * t + k]], 2 * sizeof(float));
    b->level = one.level;
    b->map = maps;
    if (!baker()->bake(&one, b->map)) return -1;
    maps += bytes_of(one.level, one.format);
    b->state = uniform(b->map, one.level, one.format);
    b->is_first = b->state == 4;
    for (uint32_t j = 0; j < t && b->is_first; ++j)
      if (all[j].state == 4 && all[j].level == b->level &&
          memcmp(all[j].map, b->map, bytes_of(b->level, one.format)) == 0)
        b->record = all[j].record, b->is_first = 0;
    if (b->is_first) b->record = (uint32_t)records++;
  }
  return records;
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

/* Usage counts of records, or of triangles that have one; returns how many there are. */
static uint32_t put_counts(writer* w, const mmverify_mesh_case_t* what, const baked* all, int references) {
  uint32_t entries = 0;
  for (uint32_t level = 0; level <= 12; ++level) {
    uint32_t count = 0;
    for (uint32_t t = 0; t < what->triangles; ++t)
      if (all[t].level == level && (references ? all[t].state == 4 : all[t].is_first)) ++count;
    if (count == 0) continue;
    ++entries;
    if (w == NULL) continue;
    put_word(w, count);
    put_word(w, level);
    put_word(w, what->surface->format);
  }
  return entries;
}

static size_t put_all(writer* w, const mmverify_mesh_case_t* what, const baked* all, uint32_t records) {
  const uint32_t format = what->surface->format, type = what->index_type;
  const size_t width = type == MMVERIFY_INDEX_U8                                  ? 1
                       : type == MMVERIFY_INDEX_U16 || type == MMVERIFY_INDEX_I16 ? 2
                                                                                  : 4;
  const uint64_t limit =
      type >= MMVERIFY_INDEX_I16 ? (uint64_t)1 << (8 * width - 1) : ((uint64_t)1 << 8 * width) - 4;
  const int counts_geometry = what->api == MMVERIFY_ARRAY_EXT || what->api == MMVERIFY_ARRAY_OPTIX ||
                              what->api == MMVERIFY_ARRAY_NVAPI;
  mmverify_array_answer_t head = {records, put_counts(NULL, what, all, 0), 0, 0, 0};
  uint32_t offset = 0;
  if (records > limit) return 0;
  if (counts_geometry) head.geometry_counts = put_counts(NULL, what, all, 1);
  head.index_bytes = (uint32_t)(what->triangles * width);
  for (uint32_t t = 0; t < what->triangles; ++t)
    if (all[t].is_first) head.data_bytes += (uint32_t)bytes_of(all[t].level, format);
  put(w, &head, sizeof head);
  for (uint32_t t = 0; t < what->triangles; ++t) {
    if (!all[t].is_first) continue;
    put_word(w, offset);
    put_word(w, all[t].level | format << 16);
    offset += (uint32_t)bytes_of(all[t].level, format);
  }
  put_counts(w, what, all, 0);
  if (counts_geometry) put_counts(w, what, all, 1);
  for (uint32_t t = 0; t < what->triangles; ++t) {
    const uint32_t code = all[t].state == 4 ? all[t].record : ~all[t].state; /* -1 T, -2 O, -3 UT, -4 UO */
    put(w, &code, width);
  }
  for (uint32_t t = 0; t < what->triangles; ++t)
    if (all[t].is_first) put(w, all[t].map, bytes_of(all[t].level, format));
  return w->size;
}

static size_t bake_mesh(const mmverify_mesh_case_t* what, uint8_t* answer, size_t capacity) {
  writer w = {answer, capacity, 0};
  size_t bytes = 0;
  for (uint32_t t = 0; t < what->triangles; ++t)
    bytes += bytes_of(what->levels != NULL ? what->levels[t] : what->surface->level, what->surface->format);
  baked* const all = calloc(what->triangles, sizeof *all);
  uint8_t* const maps = calloc(bytes, 1);
  if (all != NULL && maps != NULL) {
    const long records = bake_all(what, all, maps);
    if (records >= 0) put_all(&w, what, all, (uint32_t)records);
  }
  free(maps);
  free(all);
  return w.size;
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  if (subject.abi == 0) {
    memcpy(&subject, baker(), baker()->size);
    subject.size = sizeof subject;
    subject.name = "the example of a baker of meshes";
    subject.bake_mesh = bake_mesh;
  }
  return &subject;
}
