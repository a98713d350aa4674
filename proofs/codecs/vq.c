/* Laws of VQ2 (LEVEL 4) and VQ4 (LEVEL 5), for every block or every map.  docs/VQ.md has the order of a block's bits. */
#include "proofs/codecs/law.h"

#if LEVEL == 4
#define SIDE 2 /* regions to a side of a vector; a map has 8 x 8 vectors */
#define DECODE vq2_decode
#define REGION vq2_region
#define ENCODE vq2_encode
#else
#define SIDE 4
#define DECODE vq4_decode
#define REGION vq4_region
#define ENCODE vq4_encode
#endif
enum { WIDTH = 8 * SIDE, BLOCK_BYTES = 16 * SIDE, INDEX_BITS = SIDE == 2 ? 3 : 4 };
enum { T, C, O };

static unsigned number(const uint8_t* block, unsigned first, unsigned bits) {
  unsigned value = 0;
  for (unsigned k = 0; k < bits; ++k) value |= (block[(first + k) / 8] >> (first + k) % 8 & 1u) << k;
  return value;
}

/* A code's region whose C bit and palette bit are at these bits of the block. */
static unsigned coded(const uint8_t* block, unsigned c, unsigned palette) {
  const unsigned known = number(block, palette, 1) ? O : T;
  return number(block, c, 1) ? C : known;
}

/* Region (x, y) of the entry of an index in a quadrant, before the transform. */
static unsigned entry(const uint8_t* block, unsigned quadrant, unsigned index, unsigned x, unsigned y) {
  const unsigned book = 64 * INDEX_BITS + 9, k = x + SIDE * y;
  if (index < 3) return index;
  if (SIDE == 2) {
    const unsigned code = book + 5 * (index < 6 ? index - 3 : 3 + 2 * quadrant + (index - 6));
    return coded(block, code + k, code + 4);
  }
  if (index < 6) return coded(block, book + 17 * (index - 3) + k, book + 17 * (index - 3) + 16);
  if (index == 6) return coded(block, book + 51 + k, book + 51 + 16 + x / 2);
  if (index == 7) return coded(block, book + 69 + k, book + 69 + 16 + y / 2);
  const unsigned mini = book + 87 + 20 * (index - 8) + 5 * (x / 2 + 2 * (y / 2));
  return coded(block, mini + x % 2 + 2 * (y % 2), mini + 4);
}

/* Region (x, y) of a block's map: turned by 90 degrees, reflected from top to bottom, then from left to right. */
static unsigned region(const uint8_t* block, unsigned x, unsigned y) {
  const unsigned quadrant = (x >= WIDTH / 2 ? 1u : 0u) + (y < WIDTH / 2 ? 2u : 0u),
                 vector = x / SIDE + 8 * (y / SIDE);
  const unsigned stored = number(block, 64 * INDEX_BITS + 3 * (quadrant == 0 ? 0 : quadrant - 1), 3);
  const unsigned transform = quadrant == 0 ? 0 : stored;
  const unsigned right = transform & 4 ? SIDE - 1 - x % SIDE : x % SIDE;
  const unsigned above = transform & 2 ? SIDE - 1 - y % SIDE : y % SIDE;
  const unsigned from_x = transform & 1 ? above : right, from_y = transform & 1 ? SIDE - 1 - right : above;
  return entry(block, quadrant, number(block, INDEX_BITS * vector, INDEX_BITS), from_x, from_y);
}

#if LEVEL == 4
#define REGION_OF_MAP region
#else
#define REGION_OF_MAP region_by_cases
/* The same as region(), one index and one transform after another, each at known places of the block: a prover that
 * has 1024 regions of VQ4 before it shares what the cases of different regions have in common. */
static unsigned region_by_cases(const uint8_t* block, unsigned x, unsigned y) {
  const unsigned quadrant = (x >= WIDTH / 2 ? 1u : 0u) + (y < WIDTH / 2 ? 2u : 0u),
                 vector = x / SIDE + 8 * (y / SIDE);
  const unsigned stored = number(block, 64 * INDEX_BITS + 3 * (quadrant == 0 ? 0 : quadrant - 1), 3);
  const unsigned index = number(block, INDEX_BITS * vector, INDEX_BITS);
  unsigned state = 0;
  for (unsigned t = 0; t < (quadrant == 0 ? 1u : 8u); ++t) {
    const unsigned right = t & 4 ? SIDE - 1 - x % SIDE : x % SIDE;
    const unsigned above = t & 2 ? SIDE - 1 - y % SIDE : y % SIDE;
    const unsigned from_x = t & 1 ? above : right, from_y = t & 1 ? SIDE - 1 - right : above;
    unsigned of_t = 0;
    for (unsigned i = 0; i < 1u << INDEX_BITS; ++i) {
      const unsigned is = entry(block, quadrant, i, from_x, from_y);
      of_t = index == i ? is : of_t;
    }
    state = quadrant == 0 || stored == t ? of_t : state;
  }
  return state;
}
#endif

/* vq2.region_is_map, vq4.region_is_map: the whole map; and any region, first and second of two. */
void whole_map(void) {
  uint8_t block[BLOCK_BYTES], map[STATES];
  any_bytes(block, BLOCK_BYTES);
  READS(block, BLOCK_BYTES, codec()->DECODE(block, map));
  for (unsigned y = 0; y < WIDTH; ++y)
    for (unsigned x = 0; x < WIDTH; ++x) check_is(map[x + WIDTH * y], REGION_OF_MAP(block, x, y));
}
void any_region(void) {
  uint8_t block[BLOCK_BYTES], state[2];
  any_bytes(block, BLOCK_BYTES);
  const uint32_t a = (uint32_t)any(LEVEL), b = (uint32_t)any(LEVEL);
  const uint32_t x[2] = {a, 0}, y[2] = {b, WIDTH - 1}, last_x[2] = {0, a}, last_y[2] = {WIDTH - 1, b};
  READS(block, BLOCK_BYTES, codec()->REGION(block, x, y, state, 2));
  check_is(state[0], region(block, a, b));
  check_is(state[1], region(block, 0, WIDTH - 1));
  codec()->REGION(block, last_x, last_y, state, 2);
  check_is(state[0], region(block, 0, WIDTH - 1));
  check_is(state[1], region(block, a, b));
}

/* The same of any four regions in one batch. */
void any_four_regions(void) {
  uint8_t block[BLOCK_BYTES], state[4];
  any_bytes(block, BLOCK_BYTES);
  uint32_t x[4], y[4];
  for (unsigned k = 0; k < 4; ++k) x[k] = (uint32_t)any(LEVEL), y[k] = (uint32_t)any(LEVEL);
  codec()->REGION(block, x, y, state, 4);
  for (unsigned k = 0; k < 4; ++k) check_is(state[k], region(block, x[k], y[k]));
}

/* Where region (x, y) lies in any_map(): squares of 2 x 2, 4 x 4, ... regions follow each other, so that the maps that
 * the prover tries first have uniform vectors. */
static unsigned place(unsigned x, unsigned y) {
  unsigned at = 0;
  for (unsigned k = 0; k < LEVEL; ++k) at |= (x >> k & 1) << 2 * k | (y >> k & 1) << (2 * k + 1);
  return at;
}

/* Any map; the choice 3 is C, too. */
static void any_regions(uint8_t* map) {
  uint8_t chosen[MAP_BYTES];
  any_map(LEVEL, FORMAT, chosen);
  for (unsigned k = 0; k < STATES; ++k) {
    const unsigned state = state_of(chosen, FORMAT, place(k % WIDTH, k / WIDTH));
    map[k] = (uint8_t)(state == 3 ? C : state);
  }
}

/* vq2.conservative, vq4.conservative: in the block of any map T and O stay or become C, and C stays. */
void conservative(void) {
  uint8_t map[STATES], block[BLOCK_BYTES];
  any_regions(map);
  READS(map, STATES, codec()->ENCODE(map, block));
  for (unsigned k = 0; k < STATES; ++k) {
    const unsigned is = region(block, k % WIDTH, k / WIDTH);
    check(is == map[k] || is == C);
  }
}

/* vq2.lossless_when_it_fits, vq4.lossless_when_it_fits: the map of any block is encoded whole. */
void lossless(void) {
  uint8_t of[BLOCK_BYTES], map[STATES], block[BLOCK_BYTES];
  any_bytes(of, BLOCK_BYTES);
  for (unsigned k = 0; k < STATES; ++k) map[k] = (uint8_t)region(of, k % WIDTH, k / WIDTH);
  codec()->ENCODE(map, block);
  for (unsigned k = 0; k < STATES; ++k) check_is(region(block, k % WIDTH, k / WIDTH), map[k]);
}
