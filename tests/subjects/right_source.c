/* Right functions whose bitcode is put together of parts, some of them never set and never looked at.  Nothing about them is to
 * be said undefined: tests/outside/source_test.sh. */
#include <string.h>

#include "examples/subject/subject.c"

/* A struct of two words, by value. */
struct two {
  uint32_t x, y;
};
static struct two halves_of(uint32_t index) {
  struct two r;
  r.x = index & 0xffffu;
  r.y = index >> 16;
  return r;
}
static uint32_t joined(struct two r) { return r.x | r.y << 16; }
uint32_t by_value(uint32_t level, float u, float v) { return joined(halves_of(index_of(level, u, v))); }

/* A struct with holes, of which one member is never set. */
struct holed {
  uint8_t tag;
  uint32_t x;
  uint16_t y;
};
static struct holed with_x(uint32_t x) {
  struct holed r;
  r.x = x;
  return r;
}
uint32_t with_holes(uint32_t level, float u, float v) {
  const struct holed r = with_x(index_of(level, u, v)), s = r;
  return s.x;
}

/* Bit-fields, of which the first is never set. */
struct fields {
  uint32_t unused : 5, low : 16, high : 11;
};
uint32_t bit_fields(uint32_t level, float u, float v) {
  const uint32_t index = index_of(level, u, v);
  struct fields f;
  f.low = index & 0xffffu;
  f.high = 0;
  return f.low | (uint32_t)f.high << 16 | (index & 0xffff0000u);
}

/* A union of two sizes, half of it set. */
uint32_t of_union(uint32_t level, float u, float v) {
  union {
    uint64_t all;
    float x;
  } r;
  r.x = u;
  const uint32_t bits = (uint32_t)r.all;
  memcpy(&u, &bits, sizeof u);
  return index_of(level, u, v);
}

/* Bytes in a buffer of which a half is set, put together as one word. */
uint32_t of_bytes(uint32_t level, float u, float v) {
  const uint32_t index = index_of(level, u, v);
  uint8_t bytes[8];
  uint64_t all;
  for (int k = 0; k < 4; ++k) bytes[k] = (uint8_t)(index >> 8 * k);
  memcpy(&all, bytes, sizeof all);
  return (uint32_t)all;
}

/* Set where it is used, and not elsewhere. */
uint32_t set_late(uint32_t level, float u, float v) {
  uint32_t x;
  if (u > v) x = index_of(level, u, v);
  return u > v ? x : index_of(level, u, v);
}

/* Pointers that stay within what they point into: an end, bytes of a struct. */
uint32_t of_pointers(uint32_t level, float u, float v) {
  const uint32_t zeros[4] = {0, 0, 0, 0};
  uint32_t sum = index_of(level, u, v);
  for (const uint32_t *p = zeros, *end = zeros + 4; p != end; ++p) sum += *p;
  struct two s = {1, 0};
  const char* y = (const char*)&s + 4;
  return sum + *(const uint32_t*)y;
}
/* A character that was never set, handed on. */
static unsigned char no_character(unsigned char c) {
  (void)c;
  return 0;
}
uint32_t unset_character(uint32_t level, float u, float v) {
  unsigned char c[2];
  c[0] = 0;
  return index_of(level, u, v) ^ no_character(c[1]) ^ c[0];
}
