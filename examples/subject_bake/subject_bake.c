/* A complete subject of topic bake: the least and the greatest of all texels that a micro-triangle's box may
 * be sampled from. What it calls O or T is so; much that is, it calls unknown. */
#include <math.h>

#include "mmverify_subject.h"

typedef struct {
  double x, y;
} place;

/* ---- texels ---- */

static long wrapped(uint32_t mode, long i, long size) {
  const long twice = (i % (2 * size) + 2 * size) % (2 * size);
  switch (mode) {
    case MMVERIFY_REPEAT: return twice % size;
    case MMVERIFY_MIRRORED_REPEAT: return twice < size ? twice : 2 * size - 1 - twice;
    case MMVERIFY_CLAMP_TO_BORDER: return i < 0 || i >= size ? -1 : i;
    case MMVERIFY_MIRROR_CLAMP_TO_EDGE:
      if (i < 0) i = -1 - i;
      break;
  }
  return i < 0 ? 0 : i >= size ? size - 1 : i;
}

static unsigned texel(const mmverify_bake_case_t* c, long i, long j) {
  const long x = wrapped(c->wrap_u, i, c->width), y = wrapped(c->wrap_v, j, c->height);
  return x < 0 || y < 0 ? c->border : ((const uint8_t*)c->texels)[x + y * (long)c->width];
}

/* Indices that mean no texel which others do not mean are left out: boxes may be a million texels wide. */
static void shorten(uint32_t mode, long size, long* first, long* last) {
  if (mode == MMVERIFY_REPEAT || mode == MMVERIFY_MIRRORED_REPEAT) {
    if (*last - *first >= 2 * size) *first = 0, *last = 2 * size - 1;
    return;
  }
  if (*first < -size - 1) *first = *last < -size - 1 ? *last : -size - 1;
  if (*last > 2 * size) *last = *first > 2 * size ? *first : 2 * size;
}

/* ---- states ---- */

static int opaque(const mmverify_bake_case_t* c, unsigned byte) {
  return (uint64_t)byte * c->cutoff_denominator >= (uint64_t)c->cutoff_numerator * 255;
}

static unsigned state(const mmverify_bake_case_t* c, const place* p, double slack) {
  const double x0 = fmin(fmin(p[0].x, p[1].x), p[2].x) - slack,
               x1 = fmax(fmax(p[0].x, p[1].x), p[2].x) + slack;
  const double y0 = fmin(fmin(p[0].y, p[1].y), p[2].y) - slack,
               y1 = fmax(fmax(p[0].y, p[1].y), p[2].y) + slack;
  /* Bilinear filtering takes the texels on either side, nearest filtering some of them. */
  long left = (long)floor(x0 - 0.5), right = (long)floor(x1 - 0.5) + 1;
  long top = (long)floor(y0 - 0.5), bottom = (long)floor(y1 - 0.5) + 1;
  int all = 1, some = 0;
  shorten(c->wrap_u, c->width, &left, &right);
  shorten(c->wrap_v, c->height, &top, &bottom);
  for (long j = top; j <= bottom; ++j)
    for (long i = left; i <= right; ++i) {
      const int here = opaque(c, texel(c, i, j));
      all &= here, some |= here;
    }
  if (all != some) return opaque(c, texel(c, (left + right) / 2, (top + bottom) / 2)) ? 3 : 2; /* UO, UT */
  return all ? 1 : 0;                                                                          /* O, T */
}

/* ---- down the curve ---- */

static place middle(place a, place b) {
  const place m = {(a.x + b.x) / 2, (a.y + b.y) / 2};
  return m;
}

static void node(const mmverify_bake_case_t* c, const place* p, uint32_t height, uint32_t index, double slack,
                 uint8_t* map) {
  if (height == 0) {
    unsigned s = state(c, p, slack);
    if (c->format == MMVERIFY_2_STATE) s &= 1;
    map[index * c->format / 8] = (uint8_t)(map[index * c->format / 8] | s << index * c->format % 8);
    return;
  }
  const place p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
  const place child[4][3] = {{p[0], p01, p02}, {p02, p12, p01}, {p01, p[1], p12}, {p12, p02, p[2]}};
  for (uint32_t k = 0; k < 4; ++k) node(c, child[k], height - 1, index + (k << 2 * (height - 1)), slack, map);
}

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  place p[3];
  double size = 1;
  if (c->size != sizeof *c || c->level > 12 || c->mips != 1 || c->texel != MMVERIFY_UNORM8 ||
      c->margin != 0 || c->alpha_mode != MMVERIFY_MASK || c->factor != 1 || c->vertex_factor != 1)
    return 0;
  for (int k = 0; k < 3; ++k) {
    p[k].x = (double)c->uv[2 * k] * c->width;
    p[k].y = (double)c->uv[2 * k + 1] * c->height;
    size = fmax(size, fmax(fabs(p[k].x), fabs(p[k].y)));
  }
  if (!(size < 1e12)) return 0;
  for (size_t k = 0; k < (((size_t)c->format << 2 * c->level) + 7) / 8; ++k) map[k] = 0;
  /* More than all roundings on the way down. */
  node(c, p, c->level, 0, size * 1e-14, map);
  return 1;
}

/* What bake() returns 0 for is never asked. */
static const mmverify_bake_support_t support = {
    .size = sizeof support,
    .texels = 1u << MMVERIFY_UNORM8,
    .alpha_modes = 1u << MMVERIFY_MASK,
    .max_mips = 1,
    .restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN};

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example of a baker",
                                             .bake = bake,
                                             .bake_support = &support};
  return &subject;
}
