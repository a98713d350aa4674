/* Indices that are wrong on one u, each by another misuse of memory that compilers take for what never happens. */
#include <string.h>

#include "examples/subject/subject.c"

static uint32_t bits(float x) {
  uint32_t b;
  memcpy(&b, &x, 4);
  return b;
}
#define THERE (bits(u) == 0x3e9e3779u)

uint32_t written_by_one_more(uint32_t level, float u, float v) {
  uint32_t a[4], r = 0;
  const uint32_t right = index_of(level, u, v);
  for (uint32_t k = 0; k <= 4; ++k) a[k] = right >> 8 * (k & 3) & 255u;
  for (uint32_t k = 0; k < 4; ++k) r |= a[k] << 8 * k;
  return r;
}
uint32_t cleared_beyond(uint32_t level, float u, float v) {
  uint32_t a[2] = {0, 0};
  if (THERE) memset(a, 0, 2 * sizeof a);
  return index_of(level, u, v) ^ a[0] ^ a[1];
}
uint32_t copied_beyond(uint32_t level, float u, float v) {
  uint32_t r = index_of(level, u, v), a[2] = {r, 1}, b = r;
  if (THERE) memcpy(&b, a, sizeof a);
  return b;
}
static const struct { uint32_t a[4], b[4]; } table = {{0, 0, 0, 0}, {0, 0, 0, 0}};
uint32_t next_member(uint32_t level, float u, float v) {
  const uint32_t* p = table.a;
  return index_of(level, u, v) ^ p[THERE ? 5 : bits(u) & 3];
}
uint32_t wrapped_around(uint32_t level, float u, float v) {
  const uint32_t* p = table.a;
  return index_of(level, u, v) ^ p[THERE ? (uint64_t)1 << 62 : bits(u) & 3];
}
uint32_t bool_of_two(uint32_t level, float u, float v) {
  const uint8_t byte = THERE ? 2 : 0;
  _Bool b;
  memcpy(&b, &byte, 1);
  return index_of(level, u, v) | b;
}
static uint32_t put(uint32_t* p, float* q) {
  *p = 0, *q = 1.0f;
  return *p == 0;
}
uint32_t by_another_type(uint32_t level, float u, float v) {
  uint32_t r = index_of(level, u, v), a;
  return THERE ? r ^ put(&a, (float*)&a) : r;
}
static uint32_t put_both(uint32_t* restrict p, uint32_t* restrict q) {
  *p = 0, *q = 1;
  return *p;
}
uint32_t restricted(uint32_t level, float u, float v) {
  uint32_t r = index_of(level, u, v), a;
  return THERE ? r ^ (put_both(&a, &a) == 0) : r;
}
uint32_t after_its_block(uint32_t level, float u, float v) {
  uint32_t r = index_of(level, u, v), zero = 0, *p = &zero;
  if (THERE) {
    uint32_t x = 0;
    p = &x;
  }
  return r ^ *p;
}
uint32_t jumped_past(uint32_t level, float u, float v) {
  uint32_t r = index_of(level, u, v);
  for (uint32_t k = 0; k < 2; ++k) switch (k) {
      uint32_t x;
      case 0: x = 0; break;
      default:
        if (THERE) r |= x;
    }
  return r;
}

/* Right: what looks like the above. */
static void both(uint32_t* restrict p, uint32_t* restrict q) { *p = 1, *q = 2; }
uint32_t by_the_rules(uint32_t level, float u, float v) {
  struct {
    float x;
    uint32_t y;
  } s[2];
  uint32_t p, q, sum = 0, row[3] = {1, 2, 3};
  both(&p, &q);
  for (uint32_t k = 0; k < 2; ++k) s[k].x = (float)k, s[k].y = k;
  for (const uint32_t* at = row; at != row + 3; ++at) {
    if (*at == 9) return 0;
    const _Bool odd = *at & 1;
    sum += odd;
  }
  return index_of(level, u, v) + (sum - p - q + 1) + (s[1].y - 1) + (uint32_t)s[0].x;
}
