/* The words that the law of a codec is written in: choices, obligations and plain readings of packed maps.
 *
 * A harness is a function of no argument.  It calls the codec's entry points on choices and checks the answers.  It is
 * proved by mmverify-codec, which follows it for all choices at once, and it is compiled with replay.c, which runs it on
 * the choices of one case.  Macros: LEVEL and FORMAT of the maps; SIZE, bytes of a code or what the harness says. */
#ifndef MMVERIFY_CODEC_LAW_H
#define MMVERIFY_CODEC_LAW_H

#include <string.h>

#include "subjects/sdk/mmverify_subject.h"

/* Any number of so many bits, 1 to 64; and any state of a map, in the order of the index.  Each call is a choice. */
uint64_t any(uint32_t bits);
uint64_t any_state(uint32_t format);
/* Leaves out all choices for which the condition does not hold. */
void assume(int holds);
#ifdef MMVERIFY_REPLAY
void mmverify_check_fails(int line, const char* condition);
void mmverify_check_differs(int line, const char* name, uint64_t got, uint64_t expected);
void mmverify_check_bytes(int line, const char* name, const uint8_t* got, const uint8_t* expected,
                          size_t count);
void mmverify_no_room(int line);
#define check(holds) ((holds) ? (void)0 : mmverify_check_fails(__LINE__, #holds))
#define check_is(got, expected)                                                                         \
  do {                                                                                                  \
    const __typeof__(got) got_ = (got);                                                                 \
    const __typeof__(expected) expected_ = (expected);                                                  \
    if (got_ != expected_) mmverify_check_differs(__LINE__, #got, (uint64_t)got_, (uint64_t)expected_); \
  } while (0)
#define check_bytes(got, expected, count) mmverify_check_bytes(__LINE__, #got, got, expected, count)
#define room(holds) ((holds) ? (void)0 : mmverify_no_room(__LINE__))
#else
/* An obligation: it holds for all choices. */
void check(int holds);
/* Two numbers, or so many bytes, are the same: the codec's first, then what the law wants. */
#define check_is(got, expected) check((got) == (expected))
#define check_bytes(got, expected, count) check(equal(got, expected, count))
/* A limit of the harness, not of the codec: a codec that exceeds it is not judged. */
#define room(holds) check(holds)
#endif

enum { STATES = 1 << 2 * LEVEL, MAP_BYTES = (STATES * FORMAT + 7) / 8 };

static inline const mmverify_subject_t* codec(void) { return mmverify_subject_v1(); }

static inline size_t bytes_for(size_t states, uint32_t format) { return (states * format + 7) / 8; }

/* State k of a packed map; a state appended to a map of zeros. */
static inline unsigned state_of(const uint8_t* map, uint32_t format, size_t k) {
  return map[k * format / 8] >> k * format % 8 & ((1u << format) - 1);
}
static inline void put_state(uint8_t* map, uint32_t format, size_t k, unsigned state) {
  map[k * format / 8] = (uint8_t)(map[k * format / 8] | state << k * format % 8);
}

/* Whether the bits after the last state are zero. */
static inline int padded(const uint8_t* map, uint32_t format, size_t states) {
  const size_t used = states * format % 8;
  return used == 0 || map[states * format / 8] >> used == 0;
}

/* Each byte of the map was set. */
static inline void require_whole(const uint8_t* map) {
  unsigned sum = 0;
  for (size_t k = 0; k < MAP_BYTES; ++k) sum += map[k];
  check(sum <= 255u * MAP_BYTES);
}

static inline int equal(const uint8_t* a, const uint8_t* b, size_t count) {
  int same = 1;
  for (size_t k = 0; k < count; ++k) same &= a[k] == b[k];
  return same;
}

/* A call that gets the first `count` of `most` bytes to read; they are the same after it. */
#define READS_SOME(input, most, count, ...)                                                    \
  do {                                                                                         \
    uint8_t before_[(most) + 1];                                                               \
    memcpy(before_, input, most);                                                              \
    __VA_ARGS__;                                                                               \
    for (size_t k_ = 0; k_ < (most); ++k_) check(k_ >= (count) || (input)[k_] == before_[k_]); \
  } while (0)
#define READS(input, count, ...) READS_SOME(input, count, count, __VA_ARGS__)

/* Any map, packed; the bits after the last state are zero. */
static inline void any_map(uint32_t level, uint32_t format, uint8_t* map) {
  const size_t states = (size_t)1 << 2 * level, each = 8 / format;
  for (size_t at = 0; at < bytes_for(states, format); ++at) {
    unsigned byte = 0;
    for (size_t k = 0; k < each && at * each + k < states; ++k)
      byte |= (unsigned)any_state(format) << k * format;
    map[at] = (uint8_t)byte;
  }
}

/* Any bits after the last state, which maps to maps must not heed. */
static inline void any_padding(uint8_t* map, uint32_t format, size_t states) {
  const size_t used = states * format % 8;
  if (used != 0)
    map[states * format / 8] = (uint8_t)(map[states * format / 8] | any((uint32_t)(8 - used)) << used);
}

static inline void any_bytes(uint8_t* bytes, size_t count) {
  for (size_t k = 0; k < count; ++k) bytes[k] = (uint8_t)any(8);
}

#endif
