/* Packed maps, a lossy codec, and index codes, as plain C: what the laws of proofs/codecs/ prove, and what
 * tests/outside/codec_test.sh plants faults in. */
#include <string.h>

#include "subjects/sdk/mmverify_subject.h"

static unsigned get(const uint8_t* map, uint32_t bits, size_t k) {
  return map[k * bits / 8] >> k * bits % 8 & ((1u << bits) - 1);
}
static void put(uint8_t* map, uint32_t bits, size_t k, unsigned state) {
  map[k * bits / 8] = (uint8_t)(map[k * bits / 8] | state << k * bits % 8);
}
static size_t states_of(uint32_t level) { return (size_t)1 << 2 * level; }
static void clear(uint8_t* map, uint32_t bits, size_t states) { memset(map, 0, (states * bits + 7) / 8); }

static void pack(uint32_t format, const uint8_t* states, size_t count, uint8_t* map) {
  clear(map, format, count);
  for (size_t k = 0; k < count; ++k) put(map, format, k, states[k]);
}
static void unpack(uint32_t format, const uint8_t* map, size_t count, uint8_t* states) {
  for (size_t k = 0; k < count; ++k) states[k] = (uint8_t)get(map, format, k);
}

/* A byte of eight 2-state states from two bytes of four: the even bits move together. */
static void force2(uint32_t level, const uint8_t* four_state, uint8_t* two_state) {
  const size_t bytes = (2 * states_of(level) + 7) / 8;
  for (size_t k = 0; k < bytes; k += 2) {
    uint32_t x = four_state[k] | (k + 1 < bytes ? (uint32_t)four_state[k + 1] << 8 : 0);
    x &= 0x5555;
    x = (x | x >> 1) & 0x3333;
    x = (x | x >> 2) & 0x0f0f;
    x = (x | x >> 4) & 0x00ff;
    two_state[k / 2] = (uint8_t)(level == 0 ? x & 1 : x);
  }
}
static void widen(uint32_t level, const uint8_t* two_state, uint8_t* four_state) {
  clear(four_state, 2, states_of(level));
  for (size_t k = 0; k < states_of(level); ++k) put(four_state, 2, k, get(two_state, 1, k));
}

static void up(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above) {
  clear(above, format, states_of(level + 1));
  for (size_t k = 0; k < states_of(level + 1); ++k) put(above, format, k, get(map, format, k / 4));
}
static void down(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below) {
  clear(below, format, states_of(level - 1));
  for (size_t k = 0; k < states_of(level - 1); ++k) {
    unsigned count[4] = {0, 0, 0, 0};
    for (size_t child = 0; child < 4; ++child) ++count[get(map, format, 4 * k + child)];
    const unsigned opaque = count[1] + count[3] >= 2;
    unsigned state = format == 1 ? opaque : 2 + opaque;
    if (count[0] == 4) state = 0;
    if (count[1] == 4) state = 1;
    put(below, format, k, state);
  }
}

static void through(uint32_t level, uint32_t mode, const uint8_t* four_state, uint8_t* out) {
  clear(out, 2, states_of(level));
  for (size_t k = 0; k < states_of(level); ++k) {
    const unsigned state = get(four_state, 2, k);
    const unsigned kept = mode == 0 ? state & 1 : state == mode - 1 ? state : 3;
    put(out, 2, k, kept);
  }
}

/* Four children that differ become unknown, each on its own side. */
static void substitute(uint32_t level, const uint8_t* four_state, uint8_t* out) {
  clear(out, 2, states_of(level));
  for (size_t k = 0; k < states_of(level); ++k) {
    unsigned same = 1;
    for (size_t child = k & ~(size_t)3; child < states_of(level) && child < (k | 3); ++child)
      same &= get(four_state, 2, child) == get(four_state, 2, k | (level == 0 ? 0 : 3));
    put(out, 2, k, get(four_state, 2, k) | (same ? 0 : 2));
  }
}

static void resolve(uint32_t index_type, const uint32_t* code, const uint32_t* base_triangle,
                    const uint32_t* records, uint32_t* target, size_t count) {
  static const uint32_t highest[5] = {0xff, 0xffff, 0xffffffff, 0xffff, 0xffffffff};
  const uint32_t type = index_type & 7, limit = highest[type];
  for (size_t k = 0; k < count; ++k) {
    const uint32_t below = limit - code[k];
    const uint64_t record = (uint64_t)code[k] + base_triangle[k];
    const int none = (index_type & MMVERIFY_INDEX_IN_CLUSTER) && below == 4;
    const int outside = record >= records[k] || (type >= 3 && below <= limit / 2);
    target[2 * k] = below < 4 ? MMVERIFY_TARGET_SPECIAL
                    : none    ? MMVERIFY_TARGET_NONE
                    : outside ? MMVERIFY_TARGET_OUTSIDE
                              : MMVERIFY_TARGET_RECORD;
    target[2 * k + 1] = below < 4 ? below : none || outside ? 0 : (uint32_t)record;
  }
}

static size_t emulate(uint32_t level, uint32_t most, const uint8_t* map, uint8_t* emulated, size_t capacity) {
  const size_t blocks = states_of(most), each = states_of(level - most), size = (2 * blocks + 7) / 8;
  if (capacity < size) return size;
  clear(emulated, 2, blocks);
  for (size_t b = 0; b < blocks; ++b) {
    unsigned any = 0, all = 3;
    for (size_t k = b * each; k < (b + 1) * each; ++k) {
      any |= get(map, 2, k);
      all &= get(map, 2, k);
    }
    put(emulated, 2, b, any == all ? (any < 2 ? any : 2) : 3);
  }
  return size;
}

const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {.abi = MMVERIFY_SUBJECT_ABI,
                                             .size = sizeof subject,
                                             .name = "maps, in C",
                                             .max_level = 12,
                                             .micromap_pack = pack,
                                             .micromap_unpack = unpack,
                                             .micromap_force2 = force2,
                                             .micromap_widen = widen,
                                             .micromap_up = up,
                                             .micromap_down = down,
                                             .micromap_through = through,
                                             .micromap_substitute = substitute,
                                             .array_resolve = resolve,
                                             .array_emulate = emulate};
  return &subject;
}
