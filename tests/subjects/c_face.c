/* The library's C face as a subject: what an engine in another language would call, put in the dock. */
#include <stdlib.h>
#include <string.h>

#include "impl/mmverify.h"
#include "subjects/sdk/mmverify_subject.h"

static void must(int done) {
  if (!done) abort();
}

static void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  must(mmverify_index(level, u, v, index, count));
}
static void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  must(mmverify_corners(level, index, out, count));
}
static void row_index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  must(mmverify_row_index(level, u, v, index, count));
}
static void row_corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  must(mmverify_row_corners(level, index, out, count));
}

static size_t tree_encode(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* code,
                          size_t capacity) {
  return mmverify_tree_encode(level, format, map, code, capacity);
}

static void pack(uint32_t format, const uint8_t* states, size_t count, uint8_t* map) {
  must(mmverify_pack(format, states, count, map));
}
static void unpack(uint32_t format, const uint8_t* map, size_t count, uint8_t* states) {
  must(mmverify_unpack(format, map, count, states));
}
static void force2(uint32_t level, const uint8_t* map, uint8_t* out) {
  must(mmverify_force2(level, map, out));
}
static void widen(uint32_t level, const uint8_t* map, uint8_t* out) { must(mmverify_widen(level, map, out)); }
static void up(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* out) {
  must(mmverify_map_up(level, format, map, out));
}
static void down(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* out) {
  must(mmverify_map_down(level, format, map, out));
}

static void vq2_decode(const uint8_t* block, uint8_t* map) { must(mmverify_vq2_decode(block, map)); }
static void vq4_decode(const uint8_t* block, uint8_t* map) { must(mmverify_vq4_decode(block, map)); }
static void vq2_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                       size_t count) {
  must(mmverify_vq2_region(block, x, y, state, count));
}
static void vq4_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                       size_t count) {
  must(mmverify_vq4_region(block, x, y, state, count));
}
static void vq2_encode(const uint8_t* map, uint8_t* block) { must(mmverify_vq2_encode(map, block)); }
static void vq4_encode(const uint8_t* map, uint8_t* block) { must(mmverify_vq4_encode(map, block)); }

static int bake(const mmverify_bake_case_t* what, uint8_t* map) {
  const size_t texel = what->texel == MMVERIFY_UNORM8 ? 1 : what->texel == MMVERIFY_UNORM16 ? 2 : 4;
  const char* texels = what->texels;
  mmverify_texture mips[32];
  mmverify_sampling how;
  uint32_t k;
  uint8_t* four_state;
  int ok;
  if (what->size != sizeof *what || what->mips > 32) return 0;
  for (k = 0; k < what->mips; ++k) {
    mips[k].width = what->width >> k == 0 ? 1 : what->width >> k;
    mips[k].height = what->height >> k == 0 ? 1 : what->height >> k;
    mips[k].texels = texels;
    texels += texel * mips[k].width * mips[k].height;
  }
  memset(&how, 0, sizeof how);
  how.texel = what->texel;
  how.filter = what->filter;
  how.wrap_u = what->wrap_u;
  how.wrap_v = what->wrap_v;
  if (what->texel == MMVERIFY_FLOAT32)
    memcpy(&how.border, &what->border, sizeof how.border);
  else
    how.border = (float)what->border;
  how.factor = what->factor;
  how.vertex_factor = what->vertex_factor;
  how.blend = what->alpha_mode == MMVERIFY_BLEND;
  how.cutoff_numerator = what->cutoff_numerator;
  how.cutoff_denominator = what->cutoff_denominator;
  how.margin = what->margin;
  {
    mmverify_baker* baker = mmverify_baker_new(mips, what->mips, &how);
    if (baker == NULL) return 0;
    four_state = malloc((((size_t)1 << 2 * what->level) + 3) / 4);
    ok = four_state != NULL && mmverify_bake(baker, what->uv, what->level, four_state);
    if (ok && what->format == MMVERIFY_2_STATE)
      ok = mmverify_force2(what->level, four_state, map);
    else if (ok)
      memcpy(map, four_state, (((size_t)1 << 2 * what->level) + 3) / 4);
    free(four_state);
    mmverify_baker_free(baker);
  }
  return ok;
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t s;
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "the library's C face";
  s.max_level = 16;
  s.flags =
      MMVERIFY_TREE_STREAM | MMVERIFY_BAKE_CENTROID | MMVERIFY_BAKE_TIGHT | MMVERIFY_CORNERS_OF_CHILDREN;
  s.index_f32 = index_f32;
  s.corners = corners;
  s.row_index_f32 = row_index_f32;
  s.row_corners = row_corners;
  s.tree_encode = tree_encode;
  s.micromap_pack = pack;
  s.micromap_unpack = unpack;
  s.micromap_force2 = force2;
  s.micromap_widen = widen;
  s.micromap_up = up;
  s.micromap_down = down;
  s.vq2_decode = vq2_decode;
  s.vq2_region = vq2_region;
  s.vq2_encode = vq2_encode;
  s.vq4_decode = vq4_decode;
  s.vq4_region = vq4_region;
  s.vq4_encode = vq4_encode;
  s.bake = bake;
  return &s;
}
