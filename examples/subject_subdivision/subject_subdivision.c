/* A complete subject of topic subdivision in plain C: each cell's children one by one, down to the one with the point.
 *
 * It takes levels up to 6, so that all numbers fit 128 bits. */
#include <string.h>

#include "mmverify_subject.h"

__extension__ typedef __int128 wide;
typedef struct cell {
  wide at[4][3];
  unsigned entry, exit; /* of a tetrahedron */
} cell;

static const struct shape {
  unsigned corners, dimension, children, parts;
  int base[4][3], inward[4][3];
  const char* means[9]; /* a child's corners, each the mean of the parent's that are named */
} shapes[] = {{3,
               2,
               4,
               2,
               {{0}, {1}, {0, 1}},
               {{2, 1}, {-2, 1}, {1, -2}},
               {"00 01 02", "02 12 01", "01 11 12", "12 02 22"}},
              {3,
               2,
               9,
               3,
               {{0}, {1}, {0, 1}},
               {{2, 1}, {-2, 1}, {1, -2}},
               {"000 002 001", "001 012 002", "002 022 012", "012 001 011", "011 111 112", "112 011 012",
                "012 112 122", "122 012 022", "022 122 222"}},
              {4,
               2,
               4,
               2,
               {{0}, {0, 1}, {1, 1}, {1}},
               {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}},
               {"00 03 02 01", "01 11 12 02", "02 12 22 23", "23 02 03 33"}},
              {4,
               2,
               4,
               2,
               {{0}, {0, 1}, {1, 1}, {1}},
               {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}},
               {"00 01 02 03", "03 02 23 33", "01 11 12 02", "02 12 22 23"}},
              {4,
               3,
               8,
               2,
               {{0}, {1}, {0, 1}, {0, 0, 1}},
               {{1, 1, 1}, {-4, 1, 1}, {1, -4, 1}, {1, 1, -4}},
               {"00 01 02 03", "01 11 12 13", "02 12 22 23", "03 13 23 33", "01 02 03 13", "01 02 12 13",
                "02 03 13 23", "02 12 13 23"}},
              {3, 2, 2, 2, {{1}, {0}, {0, 1}}, {{2, 1}, {-2, 1}, {1, -2}}, {"00 02 11", "11 02 22"}}};

/* ---- the children ---- */

/* A tetrahedron's, by its entry and its exit: child, entry and exit of each. */
static const char* const paths[4][4] = {
    {0, "001 401 601 302 230 701 520 101", "001 401 510 103 310 610 701 212",
     "001 401 510 102 210 702 621 303"},
    {0, 0, "110 501 410 013 301 620 701 212", "110 501 410 012 201 710 601 303"},
    {0, 0, 0, "220 701 523 130 012 412 612 313"}};

static cell child_of(uint32_t scheme, const cell* parent, unsigned digit) {
  const struct shape* s = &shapes[scheme];
  unsigned child = digit, i = 0, j = 0;
  if (scheme == MMVERIFY_TETRAHEDRON) {
    const unsigned backwards = parent->entry > parent->exit;
    const char* step = backwards ? paths[parent->exit][parent->entry] + 4 * (7 - digit)
                                 : paths[parent->entry][parent->exit] + 4 * digit;
    child = (unsigned)(step[0] - '0');
    i = (unsigned)(step[1 + backwards] - '0');
    j = (unsigned)(step[2 - backwards] - '0');
  }
  cell c = {.entry = i, .exit = j};
  for (unsigned k = 0; k < s->corners; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      for (unsigned part = 0; part < s->parts; ++part)
        c.at[k][axis] += parent->at[s->means[child][k * (s->parts + 1) + part] - '0'][axis];
      c.at[k][axis] /= s->parts;
    }
  return c;
}

static cell whole(uint32_t scheme, wide unit) {
  cell c = {.entry = 0, .exit = 3};
  for (unsigned k = 0; k < shapes[scheme].corners; ++k)
    for (int axis = 0; axis < 3; ++axis) c.at[k][axis] = unit * shapes[scheme].base[k][axis];
  return c;
}

static uint32_t side_of(uint32_t scheme, uint32_t level) {
  uint32_t side = 1;
  if (scheme == MMVERIFY_BISECTION) level = (level + 1) / 2;
  while (level-- > 0) side *= shapes[scheme].parts;
  return side;
}

/* ---- the cell of a point ---- */

static wide determinant(const struct shape* s, const wide a[3], const wide b[3], const wide c[3]) {
  const wide plane = a[0] * b[1] - a[1] * b[0];
  return s->dimension == 2
             ? plane
             : plane * c[2] + (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1];
}

/* A vector's part across the facet of three corners, a triangle's edge of two; negative outwards. */
static int across(const struct shape* s, const cell* c, unsigned f, const wide v[3]) {
  const wide(*at)[3] = c->at;
  const unsigned o = (f + 1) % s->corners, p = (f + 2) % s->corners, q = (f + 3) % s->corners;
  wide a[3], b[3], in[3];
  for (int axis = 0; axis < 3; ++axis) {
    a[axis] = at[p][axis] - at[o][axis];
    b[axis] = at[q][axis] - at[o][axis];
    in[axis] = at[f][axis] - at[o][axis];
  }
  const wide inside = s->dimension == 2 ? determinant(s, a, in, in) : determinant(s, a, b, in),
             part = s->dimension == 2 ? determinant(s, a, v, v) : determinant(s, a, b, v);
  return part == 0 ? 0 : (part > 0) == (inside > 0) ? 1 : -1;
}

/* Inside each facet, or on it with a direction that leads inside. */
static int holds(const struct shape* s, const cell* c, const wide p[3], const wide direction[3]) {
  for (unsigned f = 0; f < s->corners; ++f) {
    wide from[3];
    for (int axis = 0; axis < 3; ++axis) from[axis] = p[axis] - c->at[(f + 1) % s->corners][axis];
    const int place = across(s, c, f, from);
    if (place < 0 || (place == 0 && across(s, c, f, direction) < 0)) return 0;
  }
  return 1;
}

static void subdivision_index(uint32_t scheme, uint32_t level, const uint32_t* x, const uint32_t* y,
                              const uint32_t* z, const uint32_t* denominator, uint32_t* index, size_t count) {
  const struct shape* s = &shapes[scheme];
  const wide side = side_of(scheme, level);
  for (size_t k = 0; k < count; ++k) {
    const wide p[3] = {x[k] * side, y[k] * side, z[k] * side};
    cell c = whole(scheme, denominator[k] * side);
    wide direction[3] = {0};
    for (unsigned d = s->corners; d-- > 0;) {
      const wide inward[3] = {s->inward[d][0], s->inward[d][1], s->inward[d][2]};
      if (holds(s, &c, p, inward)) memcpy(direction, inward, sizeof direction);
    }
    index[k] = 0;
    for (uint32_t depth = 0; depth < level; ++depth) {
      unsigned digit = 0;
      cell child = child_of(scheme, &c, digit);
      while (!holds(s, &child, p, direction) && digit + 1 < s->children)
        child = child_of(scheme, &c, ++digit);
      c = child;
      index[k] = index[k] * s->children + digit;
    }
  }
}

static void subdivision_corners(uint32_t scheme, uint32_t level, const uint32_t* index, uint32_t* corners,
                                size_t count) {
  for (size_t k = 0; k < count; ++k) {
    uint64_t below = 1, rest = index[k];
    for (uint32_t depth = 0; depth < level; ++depth) below *= shapes[scheme].children;
    cell c = whole(scheme, side_of(scheme, level));
    for (uint32_t depth = 0; depth < level; ++depth, rest %= below) {
      below /= shapes[scheme].children;
      c = child_of(scheme, &c, (unsigned)(rest / below));
    }
    for (int word = 0; word < 12; ++word) corners[12 * k + (size_t)word] = (uint32_t)c.at[word / 3][word % 3];
  }
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example of shapes",
                                             .max_level = 6,
                                             .subdivision_index = subdivision_index,
                                             .subdivision_corners = subdivision_corners};
  return &subject;
}
