/* A complete subject of topic vq: both decoders of both formats, region by region, and an encoder that keeps
 * uniform vectors, the first few others, and makes C of the rest. */
#include <string.h>

#include "mmverify_subject.h"

/* ---- bits, from the least significant of byte 0 on ---- */

static unsigned get(const uint8_t* block, unsigned at, unsigned count) {
  unsigned value = 0;
  for (unsigned k = 0; k < count; ++k, ++at) value |= (block[at / 8] >> at % 8 & 1u) << k;
  return value;
}

static void put(uint8_t* block, unsigned at, unsigned count, unsigned value) {
  for (unsigned k = 0; k < count; ++k, ++at)
    block[at / 8] = (uint8_t)(block[at / 8] | (value >> k & 1u) << at % 8);
}

/* ---- decoding; a vector is side x side regions, a map 8 x 8 vectors ---- */

enum { T = 0, C = 1, O = 2 };

static unsigned index_bits(unsigned side) { return side == 2 ? 3 : 4; }

/* The state that a code has where bit `check` says C and bit `palette` O or T. */
static uint8_t picked(const uint8_t* block, unsigned code, unsigned check, unsigned palette) {
  if (get(block, code + check, 1)) return C;
  return get(block, code + palette, 1) ? O : T;
}

static uint8_t state_at(const uint8_t* block, unsigned side, unsigned x, unsigned y) {
  const unsigned last = side - 1, vx = x / side, vy = y / side;
  const unsigned index = get(block, index_bits(side) * (vx + 8 * vy), index_bits(side));
  if (index < 3) return (uint8_t)index;
  /* TL, TR, BL, BR; TL is never transformed. */
  const unsigned quadrant = (vx < 4 ? 0u : 1u) + (vy < 4 ? 2u : 0u), turns = 64 * index_bits(side);
  const unsigned t = quadrant == 0 ? 0 : get(block, turns + 3 * (quadrant - 1), 3);
  /* Where the transform took the region from: Reflect LR, TB and Rotate 90 undone. */
  x %= side, y %= side;
  if (t & 4) x = last - x;
  if (t & 2) y = last - y;
  if (t & 1) {
    const unsigned turned = x;
    x = y;
    y = last - turned;
  }
  const unsigned k = x + side * y, codebook = turns + 9;
  if (side == 2)
    return picked(block, codebook + 5 * (index < 6 ? index - 3 : 2 * quadrant + index - 3), k, 4);
  if (index < 6) return picked(block, codebook + 17 * (index - 3), k, 16);
  if (index == 6) return picked(block, codebook + 51, k, 16 + x / 2);
  if (index == 7) return picked(block, codebook + 69, k, 16 + y / 2);
  const unsigned mini = 5 * (x / 2 + 2 * (y / 2));
  return picked(block, codebook + 87 + 20 * (index - 8), mini + x % 2 + 2 * (y % 2), mini + 4);
}

static void decode(const uint8_t* block, unsigned side, uint8_t* map) {
  for (unsigned y = 0; y < 8 * side; ++y)
    for (unsigned x = 0; x < 8 * side; ++x) map[x + 8 * side * y] = state_at(block, side, x, y);
}

static void regions(const uint8_t* block, unsigned side, const uint32_t* x, const uint32_t* y, uint8_t* state,
                    size_t count) {
  for (size_t k = 0; k < count; ++k) state[k] = state_at(block, side, x[k], y[k]);
}

/* ---- encoding: no transforms, the entries first come, first served ---- */

/* Five bits for four regions; -1 for O beside T, which no code has. */
static int mini_code(const uint8_t* map, unsigned side, unsigned x, unsigned y) {
  int code = 0, t = 0, o = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const uint8_t s = map[x + k % 2 + 8 * side * (y + k / 2)];
    code |= s == C ? 1 << k : 0;
    t |= s == T, o |= s == O;
  }
  return t && o ? -1 : code | o << 4;
}

static void encode(const uint8_t* map, unsigned side, uint8_t* block) {
  const unsigned minis = side * side / 4, bits = 5 * minis, all = side == 2 ? 3 : 8;
  const unsigned first_index = side == 2 ? 3 : 8,
                 first_bit = 64 * index_bits(side) + 9 + (side == 2 ? 0 : 87);
  unsigned entries[8], used = 0;
  memset(block, 0, side == 2 ? 32 : 64);
  for (unsigned v = 0; v < 64; ++v) {
    const unsigned x = side * (v % 8), y = side * (v / 8);
    unsigned code = 0, index = C, same = 1;
    int none = 0;
    for (unsigned m = 0; m < minis; ++m) {
      const int mini = mini_code(map, side, x + 2 * (m % 2), y + 2 * (m / 2));
      none |= mini < 0;
      code |= (unsigned)mini << 5 * m;
    }
    for (unsigned k = 0; k < side * side; ++k)
      same &= map[x + k % side + 8 * side * (y + k / side)] == map[x + 8 * side * y];
    if (same) {
      index = map[x + 8 * side * y];
    } else if (!none) {
      unsigned e = 0;
      while (e < used && entries[e] != code) ++e;
      if (e == used && used < all) {
        put(block, first_bit + bits * used, bits, code);
        entries[used++] = code;
      }
      if (e < used) index = first_index + e;
    }
    put(block, index_bits(side) * v, index_bits(side), index);
  }
}

/* ---- the entry points ---- */

static void vq2_decode(const uint8_t* block, uint8_t* map) { decode(block, 2, map); }
static void vq4_decode(const uint8_t* block, uint8_t* map) { decode(block, 4, map); }
static void vq2_encode(const uint8_t* map, uint8_t* block) { encode(map, 2, block); }
static void vq4_encode(const uint8_t* map, uint8_t* block) { encode(map, 4, block); }
static void vq2_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                       size_t count) {
  regions(block, 2, x, y, state, count);
}
static void vq4_region(const uint8_t* block, const uint32_t* x, const uint32_t* y, uint8_t* state,
                       size_t count) {
  regions(block, 4, x, y, state, count);
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "the example of vector quantisation",
                                             .vq2_decode = vq2_decode,
                                             .vq2_region = vq2_region,
                                             .vq2_encode = vq2_encode,
                                             .vq4_decode = vq4_decode,
                                             .vq4_region = vq4_region,
                                             .vq4_encode = vq4_encode};
  return &subject;
}
