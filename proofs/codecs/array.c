/* Laws of arrays whose buffers are small: any index code, and maps emulated at a lower level. */
#include "proofs/codecs/law.h"

/* The target of a code by the header's rule for array_resolve. */
static void target(unsigned type, int cluster, uint32_t code, uint32_t base, uint32_t records, uint32_t* kind,
                   uint32_t* value) {
  const uint32_t last = type == MMVERIFY_INDEX_U8                                  ? 0xff
                        : type == MMVERIFY_INDEX_U16 || type == MMVERIFY_INDEX_I16 ? 0xffff
                                                                                   : 0xffffffff;
  const int negative = type >= MMVERIFY_INDEX_I16 && code > last / 2;
  const uint64_t record = (uint64_t)code + base;
  *value = 0;
  if (last - code < 4) {
    *kind = MMVERIFY_TARGET_SPECIAL;
    *value = last - code;
  } else if (cluster && last - code == 4) {
    *kind = MMVERIFY_TARGET_NONE;
  } else if (negative || record >= records) {
    *kind = MMVERIFY_TARGET_OUTSIDE;
  } else {
    *kind = MMVERIFY_TARGET_RECORD;
    *value = (uint32_t)record;
  }
}

/* array.codes: SIZE is the type of the index, 8 added in a cluster; two codes, each with its base and records. */
void codes(void) {
  const unsigned type = SIZE & 7;
  const uint32_t bits = type == MMVERIFY_INDEX_U8                                  ? 8
                        : type == MMVERIFY_INDEX_U16 || type == MMVERIFY_INDEX_I16 ? 16
                                                                                   : 32;
  uint32_t code[2], base[2], records[2], is[4];
  for (int k = 0; k < 2; ++k) {
    code[k] = (uint32_t)any(bits);
    base[k] = (uint32_t)any(32);
    records[k] = (uint32_t)any(32);
  }
  codec()->array_resolve(SIZE, code, base, records, is, 2);
  for (int k = 0; k < 2; ++k) {
    uint32_t kind, value;
    target(type, (SIZE & MMVERIFY_INDEX_IN_CLUSTER) != 0, code[k], base[k], records[k], &kind, &value);
    check_is(is[2 * k], kind);
    check_is(is[2 * k + 1], value);
  }
}

/* array.emulates: of any 4-state map, at each level below. */
void emulates(void) {
  uint8_t map[MAP_BYTES];
  any_map(LEVEL, FORMAT, map);
  for (uint32_t most = 0; most < LEVEL; ++most) {
    uint8_t out[MAP_BYTES];
    const size_t blocks = (size_t)1 << 2 * most, each = STATES / blocks, size = bytes_for(blocks, FORMAT);
    READS(map, MAP_BYTES, check_is(codec()->array_emulate(LEVEL, most, map, out, size), size));
    for (size_t b = 0; b < blocks; ++b) {
      const unsigned first = state_of(map, FORMAT, b * each), is = state_of(out, FORMAT, b);
      int same = first < 2;
      for (size_t k = 1; k < each; ++k) same &= state_of(map, FORMAT, b * each + k) == first;
      check(same ? is == first : is >= 2);
    }
    check(padded(out, FORMAT, blocks));
  }
}
