/* Judges an index function by the vectors of mmverify_vectors.h: put yours in the place of index_of().
 *   mmverify vectors -o DIR && cc -O2 -ffp-contract=off -I DIR -o read read.c && ./read
 * Prints how many answers are those of each dialect, and the first that is not; exit code 1 where neither has all. */
#include <stdio.h>
#include <string.h>

#include "mmverify_vectors.h"

static float clamped(float x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

/* Every other bit, from bit 0 up. */
static uint32_t spread(uint32_t x) {
  uint32_t out = 0;
  for (uint32_t k = 0; k < 16; ++k) out |= (x >> k & 1) << 2 * k;
  return out;
}

/* The reference code of VK_EXT_opacity_micromap, in floats. */
static uint32_t index_of(uint32_t level, float u, float v) {
  const uint32_t N = 1u << level;
  u = clamped(u) * (float)N;
  v = clamped(v) * (float)N;
  uint32_t iu = (uint32_t)u, iv = (uint32_t)v;
  const int upper = u - (float)iu + (v - (float)iv) >= 1;
  if (iu >= N) iu = N - 1;
  if (iv >= N) iv = N - 1;
  const uint32_t s = iu + iv;
  if (s >= N) iu -= s - N + 1;
  const uint32_t iw = ~(iu + iv) - (upper && s < N - 1 ? 1 : 0);
  const uint32_t b0 = ~(iu ^ iw) & (N - 1), t = (iu ^ iv) & b0;
  uint32_t f = t;
  for (uint32_t shift = 1; shift < 16; shift *= 2) f ^= f >> shift;
  return spread(b0) | spread(((f ^ iu) & ~b0) | t) << 1;
}

static float number(uint32_t bits) {
  float x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

int main(void) {
  const unsigned all = MMVERIFY_VECTORS_INDEX_POINTS;
  unsigned exact = 0, published = 0, prose = 0, inside = 0;
  const mmverify_vectors_index_points_t* first = NULL;
  for (unsigned k = 0; k < all; ++k) {
    const mmverify_vectors_index_points_t* p = &mmverify_vectors_index_points[k];
    const uint32_t answer = index_of(p->level, number(p->u), number(p->v));
    exact += answer == p->exact;
    published += answer == p->published;
    inside += p->prose_given; /* 0: there is no such answer; else prose may be any number, 2^32 - 1, too */
    prose += p->prose_given != 0 && answer == p->prose;
    if (answer != p->published && first == NULL) first = p;
  }
  printf("published: %u of %u, exact: %u of %u, prose: %u of %u\n", published, all, exact, all, prose,
         inside);
  if (first != NULL)
    printf("first: level %u, u %a, v %a: %s\n", (unsigned)first->level, (double)number(first->u),
           (double)number(first->v), mmverify_vectors_index_about[first->about]);
  return exact == all || published == all ? 0 : 1;
}
