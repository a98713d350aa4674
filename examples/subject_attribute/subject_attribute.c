/* A complete subject of topic attribute: where values lie in a map, in three orders of vertices and three of faces, what is
 * interpolated at a point, what is read across a decimated edge, and mips. */
#include "mmverify_subject.h"

typedef struct {
  uint32_t i, j;
} vertex;
typedef struct {
  uint32_t iu, iv, upper;
} face;

/* ---- numbers ---- */

static uint32_t side_of(uint32_t level) { return 1u << level; }
static uint64_t triangular(uint64_t r) { return r * (r + 1) / 2; }
static uint64_t vertices_of(uint32_t level) { return triangular((uint64_t)side_of(level) + 1); }

/* The greatest r with f(r) <= x, f growing, r below 2^17. */
static uint32_t greatest(uint64_t x, uint64_t (*f)(uint64_t)) {
  uint32_t r = 0;
  for (uint32_t bit = 1u << 16; bit != 0; bit /= 2)
    if (f(r + bit) <= x) r += bit;
  return r;
}
static uint64_t square(uint64_t r) { return r * r; }

/* Bit k of what comes is the sum of the bits of x from k on, modulo 2. */
static uint32_t xor_from_above(uint32_t x) {
  x ^= x >> 1, x ^= x >> 2, x ^= x >> 4;
  return x ^ x >> 8;
}

/* ---- the curve ---- */

static uint32_t curve_index(face t) {
  const uint32_t row = t.iu + t.iv + t.upper, b0 = t.iu ^ row, turn = (t.iu ^ t.iv) & b0;
  const uint32_t b1 = ((xor_from_above(turn) ^ t.iu) & ~b0) | turn;
  uint32_t index = 0;
  for (unsigned k = 0; k < 16; ++k) index |= (b0 >> k & 1u) << 2 * k | (b1 >> k & 1u) << (2 * k + 1);
  return index;
}

static face curve_face(uint32_t index) {
  uint32_t b0 = 0, b1 = 0;
  for (unsigned k = 0; k < 16; ++k) b0 |= (index >> 2 * k & 1u) << k, b1 |= (index >> (2 * k + 1) & 1u) << k;
  const uint32_t t = b0 & b1, f = xor_from_above(t), m = xor_from_above(b0 & ~b1), inverted = m >> 1;
  const face found = {(b0 & inverted) | (~b0 & (b1 ^ f) & 0xffffu), inverted ^ t, m & 1u};
  return found;
}

/* ---- vertices ---- */

/* How many micro-triangles before number x of the curve of a level stand upright: under each digit 1, the middle child, up and
 * down change places. */
static uint64_t upright_before(uint64_t x, uint32_t level) {
  int64_t excess = 0, sign = 1;
  for (uint32_t l = level; l-- > 0;) {
    const uint64_t digit = x >> 2 * l & 3u;
    if (digit % 2 != 0) excess += sign * (int64_t)side_of(l);
    if (digit == 1) sign = -sign;
  }
  return (uint64_t)((int64_t)x + excess) / 2;
}

/* And the number of upright micro-triangle k. */
static uint32_t upright_number(uint64_t k, uint32_t level) {
  uint32_t x = 0, upright = 1;
  for (uint32_t l = level; l-- > 0;) {
    const uint64_t S = side_of(l);
    uint32_t digit = 0;
    for (;; ++digit) {
      const uint64_t held = (digit == 1 ? !upright : upright) ? S * (S + 1) / 2 : S * (S - 1) / 2;
      if (k < held) break;
      k -= held;
    }
    if (digit == 1) upright = !upright;
    x = 4 * x + digit;
  }
  return x;
}

static uint64_t bird_index(vertex at, uint32_t level) {
  const uint32_t N = side_of(level);
  if ((at.i == 0 || at.i == N) && (at.j == 0 || at.j == N)) return at.i != 0 ? 1 : at.j != 0 ? 2 : 0;
  uint32_t m = level;
  for (; at.i % 2 == 0 && at.j % 2 == 0; --m) at.i /= 2, at.j /= 2;
  const uint32_t edge = at.i % 2 == 0 ? 0 : at.j % 2 != 0 ? 1 : 2;
  const face parent = {at.i / 2, at.j / 2, 0};
  return vertices_of(m - 1) + 3 * upright_before(curve_index(parent), m - 1) + edge;
}

static vertex bird_vertex(uint32_t index, uint32_t level) {
  const uint32_t N = side_of(level);
  vertex at = {index == 1 ? N : 0, index == 2 ? N : 0};
  if (index < 3) return at;
  uint32_t m = level;
  while (vertices_of(m - 1) > index) --m;
  const uint64_t from = index - vertices_of(m - 1);
  const face parent = curve_face(upright_number(from / 3, m - 1));
  at.i = (2 * parent.iu + (from % 3 != 0)) << (level - m);
  at.j = (2 * parent.iv + (from % 3 != 2)) << (level - m);
  return at;
}

static uint32_t index_of_vertex(vertex at, uint32_t order, uint32_t level) {
  if (order == MMVERIFY_VERTICES_W_MINOR) return (uint32_t)(triangular(at.i + at.j) + at.j);
  if (order == MMVERIFY_VERTICES_BIRD) return (uint32_t)bird_index(at, level);
  return (uint32_t)(at.i * ((uint64_t)side_of(level) + 2) - triangular(at.i) + at.j);
}

static vertex vertex_at(uint32_t index, uint32_t order, uint32_t level) {
  if (order == MMVERIFY_VERTICES_BIRD) return bird_vertex(index, level);
  /* U-major are rows counted from the u-corner, backwards. */
  const int back = order == MMVERIFY_VERTICES_U_MAJOR;
  const uint64_t x = back ? vertices_of(level) - 1 - index : index;
  const uint32_t r = greatest(x, triangular), c = (uint32_t)(x - triangular(r));
  const vertex at = {back ? side_of(level) - r : r - c, back ? r - c : c};
  return at;
}

/* ---- faces ---- */

static uint32_t index_of_face(face t, uint32_t order, uint32_t level) {
  const uint64_t row = (uint64_t)t.iu + t.iv + t.upper, left = side_of(level) - t.iu;
  if (order == MMVERIFY_FACES_CURVE) return curve_index(t);
  if (order == MMVERIFY_FACES_ROWS) return (uint32_t)(row * row + 2 * t.iv + t.upper);
  return (uint32_t)(square(side_of(level)) - left * left + 2 * t.iv + t.upper);
}

static face face_at(uint32_t index, uint32_t order, uint32_t level) {
  if (order == MMVERIFY_FACES_CURVE) return curve_face(index);
  face t;
  uint32_t c;
  if (order == MMVERIFY_FACES_ROWS) {
    const uint32_t row = greatest(index, square);
    c = (uint32_t)(index - square(row));
    t.iu = row - (c + 1) / 2;
  } else {
    const uint64_t all = square(side_of(level));
    const uint32_t left = greatest(all - 1 - index, square) + 1;
    c = (uint32_t)(index - (all - square(left)));
    t.iu = side_of(level) - left;
  }
  t.iv = c / 2, t.upper = c % 2;
  return t;
}

/* The base, one step along u, one along v. */
static void put_triplet(face t, uint32_t order, uint32_t level, uint32_t* out) {
  const vertex base = {t.iu + t.upper, t.iv + t.upper};
  const uint32_t step = t.upper ? ~0u : 1u; /* -1 wraps around, and back */
  const vertex along_u = {base.i + step, base.j}, along_v = {base.i, base.j + step};
  out[0] = index_of_vertex(base, order, level);
  out[1] = index_of_vertex(along_u, order, level);
  out[2] = index_of_vertex(along_v, order, level);
}

/* ---- points; binary64 holds u N and v N, and which side of 1 uf + vf is 1 - vf tells ---- */

typedef struct {
  face at;
  double w[3];
} place;

static place located(double u, double v, uint32_t level) {
  const uint32_t N = side_of(level), last = N - 1;
  const double x = u * N, y = v * N;
  uint32_t iu = (uint32_t)x, iv = (uint32_t)y;
  const double uf = x - iu, vf = y - iv, most = uf > vf ? uf : vf, least = uf > vf ? vf : uf;
  uint32_t row = iu + iv + (least >= 1 - most ? 1u : 0u);
  place p;
  if (row > last) row = last;
  if (iv > last) iv = last;
  if (iu > last - iv) iu = last - iv;
  p.at.iu = iu, p.at.iv = iv, p.at.upper = row - (iu + iv);
  const double fu = x - iu, fv = y - iv, rest = 1 - fu - fv;
  if (p.at.upper)
    p.w[0] = -rest, p.w[1] = 1 - fu, p.w[2] = 1 - fv;
  else
    p.w[0] = rest, p.w[1] = fu, p.w[2] = fv;
  return p;
}

/* ---- entry points ---- */

static void vertex_index(uint32_t level, uint32_t order, const uint32_t* i, const uint32_t* j,
                         uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const vertex at = {i[k], j[k]};
    index[k] = index_of_vertex(at, order, level);
  }
}

static void vertex_place(uint32_t level, uint32_t order, const uint32_t* index, uint32_t* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const vertex at = vertex_at(index[k], order, level);
    out[2 * k] = at.i, out[2 * k + 1] = at.j;
  }
}

static void face_index(uint32_t level, uint32_t order, const uint32_t* iu, const uint32_t* iv,
                       const uint32_t* upper, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const face t = {iu[k], iv[k], upper[k]};
    index[k] = index_of_face(t, order, level);
  }
}

static void face_place(uint32_t level, uint32_t order, const uint32_t* index, uint32_t* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const face t = face_at(index[k], order, level);
    out[3 * k] = t.iu, out[3 * k + 1] = t.iv, out[3 * k + 2] = t.upper;
  }
}

static void triplet(uint32_t level, uint32_t vertices, uint32_t faces, const uint32_t* index, uint32_t* out,
                    size_t count) {
  for (size_t k = 0; k < count; ++k)
    put_triplet(face_at(index[k], faces, level), vertices, level, out + 3 * k);
}

static void face_of(uint32_t level, uint32_t vertices, uint32_t faces, const uint32_t* first,
                    const uint32_t* second, const uint32_t* third, uint32_t* index, size_t count) {
  (void)third; /* the first two say it */
  for (size_t k = 0; k < count; ++k) {
    const vertex a = vertex_at(first[k], vertices, level), b = vertex_at(second[k], vertices, level);
    const uint32_t upper = b.i < a.i;
    const face t = {upper ? b.i : a.i, a.j - upper, upper};
    index[k] = index_of_face(t, faces, level);
  }
}

static void triplet_f32(uint32_t level, uint32_t order, const float* u, const float* v, uint32_t* out,
                        size_t count) {
  for (size_t k = 0; k < count; ++k)
    put_triplet(located((double)u[k], (double)v[k], level).at, order, level, out + 3 * k);
}

static void weights_f32(uint32_t level, const float* u, const float* v, float* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const place p = located((double)u[k], (double)v[k], level);
    for (size_t c = 0; c < 3; ++c) out[3 * k + c] = (float)p.w[c];
  }
}

/* Away from the middle of the edge; the middle of level 1 to w, u, v. */
static void decimate(uint32_t level, uint32_t flags, const uint32_t* i, const uint32_t* j, uint32_t* out,
                     size_t count) {
  const uint32_t N = side_of(level), middle = N / 2;
  for (size_t n = 0; n < count; ++n) {
    vertex at = {i[n], j[n]};
    const uint32_t k = N - at.i - at.j, odd_i = N > 1 && at.i % 2 != 0, odd_j = N > 1 && at.j % 2 != 0;
    if ((flags & MMVERIFY_EDGE_W_U) != 0 && at.j == 0 && odd_i) {
      at.i += k < middle ? 1u : ~0u;
    } else if ((flags & MMVERIFY_EDGE_U_V) != 0 && k == 0 && odd_j) {
      const uint32_t step = at.i < middle ? ~0u : 1u;
      at.i += step, at.j -= step;
    } else if ((flags & MMVERIFY_EDGE_V_W) != 0 && at.i == 0 && odd_j) {
      at.j += at.j < middle ? ~0u : 1u;
    }
    out[2 * n] = at.i, out[2 * n + 1] = at.j;
  }
}

static uint32_t mean(uint32_t rounding, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  const uint32_t sum = a + b + c + d;
  switch (rounding) {
    case MMVERIFY_ROUND_HALF_UP: return (sum + 2) / 4;
    case MMVERIFY_ROUND_HALF_TO_EVEN: return (sum + 1 + sum / 4 % 2) / 4;
    case MMVERIFY_ROUND_TRUNCATE: return sum / 4;
    default: return ((a + b + 1) / 2 + (c + d + 1) / 2 + 1) / 2;
  }
}

static void face_mip(uint32_t rounding, const uint8_t* children, size_t parents, uint8_t* out) {
  for (size_t k = 0; k < parents; ++k)
    for (size_t c = 0; c < 4; ++c) {
      const uint8_t* of = children + 16 * k + c;
      out[4 * k + c] = (uint8_t)mean(rounding, of[0], of[4], of[8], of[12]);
    }
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {
      .abi = MMVERIFY_SUBJECT_ABI,
      .size = sizeof subject,
      .name = "attribute maps in C",
      .max_level = 16,
      .attribute_vertex_index = vertex_index,
      .attribute_vertex_place = vertex_place,
      .attribute_face_index = face_index,
      .attribute_face_place = face_place,
      .attribute_triplet = triplet,
      .attribute_face_of = face_of,
      .attribute_triplet_f32 = triplet_f32,
      .attribute_weights_f32 = weights_f32,
      .attribute_decimate = decimate,
      .attribute_face_mip = face_mip,
  };
  return &subject;
}
