/* Maps of attributes from a texture of colours, in binary64: a value is a code off at most, where the exact number is near
 * the middle between two codes.  Directions, and triangles without an area, are declined. */
#include <math.h>
#include <string.h>

#include "mmverify_subject.h"

typedef struct {
  double x, y;
} place;

/* A triangle cut by four lines has seven corners at most; one is room. */
typedef struct {
  place at[8];
  int corners;
} polygon;

/* ---- the texture ---- */

/* The texel that stands at index i of a side, or -1 outside with a border. */
static int64_t wrapped(int64_t i, uint32_t side, uint32_t wrap) {
  const int64_t n = side;
  int64_t m;
  switch (wrap) {
    case MMVERIFY_REPEAT: return (i % n + n) % n;
    case MMVERIFY_MIRRORED_REPEAT: m = (i % (2 * n) + 2 * n) % (2 * n); return m < n ? m : 2 * n - 1 - m;
    case MMVERIFY_CLAMP_TO_BORDER: return i < 0 || i >= n ? -1 : i;
    case MMVERIFY_MIRROR_CLAMP_TO_EDGE:
      if (i < 0) i = -1 - i;
      return i < n ? i : n - 1;
    default: return i < 0 ? 0 : i < n ? i : n - 1;
  }
}

static double light_of(double code) {
  const double c = code / 255;
  return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

static double code_of_light(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055);
}

static int is_curved(const mmverify_attribute_case_t* what, int channel) {
  return what->meaning == MMVERIFY_SRGB && channel < 3;
}

/* Adds a texel's numbers, which are averaged, by its weight. */
static void add(const mmverify_attribute_case_t* what, int64_t i, int64_t j, double weight, double sum[4]) {
  const int64_t x = wrapped(i, what->width, what->wrap_u), y = wrapped(j, what->height, what->wrap_v);
  const uint8_t* texel = (const uint8_t*)what->texels + 4 * (x + (int64_t)what->width * y);
  for (int c = 0; c < 4; ++c) {
    const double code = x < 0 || y < 0 ? what->border[c] : texel[c];
    sum[c] += weight * (is_curved(what, c) ? light_of(code) : code);
  }
}

static void put(const mmverify_attribute_case_t* what, const double mean[4], uint8_t* out) {
  for (int c = 0; c < 4; ++c) {
    const double code = is_curved(what, c) ? code_of_light(mean[c]) : mean[c];
    /* What lies in the middle between two codes goes up; a sum may come out a little below it. */
    out[c] = (uint8_t)fmin(255, floor(code + 0.5 + 1e-9));
  }
}

/* ---- vertices ---- */

static place vertex(const mmverify_attribute_case_t* what, double u, double v) {
  const float* t = what->uv;
  const double w = 1 - u - v;
  const place p = {(t[0] * w + t[2] * u + t[4] * v) * what->width,
                   (t[1] * w + t[3] * u + t[5] * v) * what->height};
  return p;
}

static void sample(const mmverify_attribute_case_t* what, place p, uint8_t* out) {
  double sum[4] = {0, 0, 0, 0};
  if (what->filter == MMVERIFY_NEAREST) {
    add(what, (int64_t)floor(p.x), (int64_t)floor(p.y), 1, sum);
  } else {
    const double x = floor(p.x - 0.5), y = floor(p.y - 0.5), fx = p.x - 0.5 - x, fy = p.y - 0.5 - y;
    for (int k = 0; k < 4; ++k)
      add(what, (int64_t)x + k % 2, (int64_t)y + k / 2, (k % 2 ? fx : 1 - fx) * (k / 2 ? fy : 1 - fy), sum);
  }
  put(what, sum, out);
}

static int bake_vertices(const mmverify_attribute_case_t* what, uint8_t* map) {
  if (what->texel != MMVERIFY_UNORM8 || what->meaning > MMVERIFY_SRGB) return 0;
  const uint32_t N = 1u << what->level;
  for (uint32_t row = 0; row <= N; ++row)
    for (uint32_t j = 0; j <= row; ++j, map += 4)
      sample(what, vertex(what, (double)(row - j) / N, (double)j / N), map);
  return 1;
}

/* ---- faces ---- */

/* What of a polygon has sign (x - at) >= 0, or of y. */
static polygon cut(polygon p, int along_y, double at, double sign) {
  polygon out = {.corners = 0};
  for (int k = 0; k < p.corners; ++k) {
    const place a = p.at[k], b = p.at[(k + 1) % p.corners];
    const double ha = sign * ((along_y ? a.y : a.x) - at), hb = sign * ((along_y ? b.y : b.x) - at);
    if (ha >= 0) out.at[out.corners++] = a;
    if ((ha < 0) != (hb < 0)) {
      const double t = ha / (ha - hb);
      const place crossing = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      out.at[out.corners++] = crossing;
    }
  }
  return out;
}

static double area(const polygon* p) {
  double twice = 0;
  for (int k = 2; k < p->corners; ++k) {
    const place a = p->at[0], b = p->at[k - 1], c = p->at[k];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return fabs(twice) / 2;
}

static void average(const mmverify_attribute_case_t* what, const polygon* face, uint8_t* out) {
  double sum[4] = {0, 0, 0, 0}, weights = 0;
  place low = face->at[0], high = face->at[0];
  for (int k = 1; k < 3; ++k) {
    low.x = fmin(low.x, face->at[k].x), low.y = fmin(low.y, face->at[k].y);
    high.x = fmax(high.x, face->at[k].x), high.y = fmax(high.y, face->at[k].y);
  }
  for (double y = floor(low.y); y < high.y; ++y) {
    const polygon row = cut(cut(*face, 1, y, 1), 1, y + 1, -1);
    for (double x = floor(low.x); x < high.x; ++x) {
      const polygon under = cut(cut(row, 0, x, 1), 0, x + 1, -1);
      const double weight = area(&under);
      weights += weight;
      if (weight > 0) add(what, (int64_t)x, (int64_t)y, weight, sum);
    }
  }
  for (int c = 0; c < 4; ++c) sum[c] /= weights;
  put(what, sum, out);
}

/* The micro-triangles below one in the order of the curve, by their corners in barycentrics: children 1 and 3 are turned
 * over, as docs/INDEX.md has it. */
static uint8_t* visit(const mmverify_attribute_case_t* what, const double w[2], const double u[2],
                      const double v[2], uint32_t levels, uint8_t* out) {
  if (levels == 0) {
    polygon face = {.corners = 3};
    face.at[0] = vertex(what, w[0], w[1]);
    face.at[1] = vertex(what, u[0], u[1]);
    face.at[2] = vertex(what, v[0], v[1]);
    average(what, &face, out);
    return out + 4;
  }
  const double wu[2] = {(w[0] + u[0]) / 2, (w[1] + u[1]) / 2}, uv[2] = {(u[0] + v[0]) / 2, (u[1] + v[1]) / 2},
               vw[2] = {(v[0] + w[0]) / 2, (v[1] + w[1]) / 2};
  out = visit(what, w, wu, vw, levels - 1, out);
  out = visit(what, vw, uv, wu, levels - 1, out);
  out = visit(what, wu, u, uv, levels - 1, out);
  return visit(what, uv, vw, v, levels - 1, out);
}

static int bake_faces(const mmverify_attribute_case_t* what, uint8_t* map) {
  polygon whole = {.corners = 3};
  const double w[2] = {0, 0}, u[2] = {1, 0}, v[2] = {0, 1};
  whole.at[0] = vertex(what, 0, 0), whole.at[1] = vertex(what, 1, 0), whole.at[2] = vertex(what, 0, 1);
  if (what->texel != MMVERIFY_UNORM8 || what->meaning > MMVERIFY_SRGB || area(&whole) < 1e-6) return 0;
  visit(what, w, u, v, what->level, map);
  return 1;
}

static const mmverify_attribute_support_t support = {
    .size = sizeof support,
    .max_level = 8,
    .meanings = 1u << MMVERIFY_LINEAR | 1u << MMVERIFY_SRGB,
    .tolerance = 1,
};

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {
      .abi = MMVERIFY_SUBJECT_ABI,
      .size = sizeof subject,
      .name = "a baker of attribute maps in C",
      .max_level = 16,
      .attribute_bake_faces = bake_faces,
      .attribute_bake_vertices = bake_vertices,
      .attribute_support = &support,
  };
  return &subject;
}
