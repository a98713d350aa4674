// Micromaps written from the header and docs/MICROMAP.md alone: packing, force-2-state, levels, 1-bit modes and
// a lossy codec, one state at a time.  Each fault of the table is one slip inside this code.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/fault.hpp"

namespace {

using mmverify::tests::foreign::chosen_fault;
using mmverify::tests::foreign::threading;

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/micromap_faults.def"
#undef MMVERIFY_FAULT
};

constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/micromap_faults.def"
#undef MMVERIFY_FAULT
};

const std::optional<int> fault = chosen_fault(fault_names);
bool has(Fault f) { return fault == f; }

enum State : unsigned { T = 0, O = 1, UT = 2, UO = 3 };

using Bytes = std::uint8_t*;
using Map = const std::uint8_t*;

std::size_t states_of(unsigned level) { return std::size_t{1} << (2 * level); }
std::size_t bytes_of(std::size_t states, unsigned bits) { return (states * bits + 7) / 8; }

/// The i-th state.
unsigned get(Map map, unsigned bits, std::size_t i) {
  const std::size_t bit = i * bits;
  return static_cast<unsigned>(map[bit / 8] >> (bit % 8)) & ((1u << bits) - 1);
}

/// Writes the i-th state into bytes that are zero there.
void put(Bytes map, unsigned bits, std::size_t i, unsigned state) {
  const std::size_t bit = i * bits;
  map[bit / 8] = static_cast<std::uint8_t>(map[bit / 8] | (state << (bit % 8)));
}

bool opaque(unsigned state) { return (state & 1) != 0; }
bool unknown(unsigned state) { return state >= UT; }

/// Whether the first `count` states are all `state`.
bool all_are(Map map, unsigned bits, std::size_t count, unsigned state) {
  for (std::size_t i = 0; i < count; ++i)
    if (get(map, bits, i) != state) return false;
  return true;
}

void clear(Bytes map, std::size_t states, unsigned bits) { std::memset(map, 0, bytes_of(states, bits)); }

// ---- packing

void pack(std::uint32_t bits, const std::uint8_t* states, std::size_t count, Bytes map) {
  std::size_t end = count;
  if (has(pack_counts_in_16_bits)) end = static_cast<std::uint16_t>(count);
  if (has(pack_drops_an_odd_rest) && count > 4) end = count - count % 4;
  if (!has(pack_leaves_old_bits)) clear(map, count, bits);
  for (std::size_t i = 0; i < end; ++i) {
    unsigned state = states[i];
    if (has(pack_unknown_as_unknown_transparent) && state == UO) state = UT;
    if (has(pack_keeps_one_bit_of_the_last) && bits == 2 && count >= 64 && i == count - 1) state &= 1;
    if (has(pack_65th_word_shift) && bits == 2 && i >= 64 && i % 32 == 31) state &= 1;
    if (has(pack_wrong_from_256th) && i >= 256 && i % 256 == 0) state = states[i - 256];
    if (has(pack_wrong_above_level_7) && i >= std::size_t{1} << 14 && i % 4096 == 4095) state ^= 1;
    if (has(pack_merges_uo_run) && i >= 3 && state == UO && states[i - 1] == UO && states[i - 2] == UO &&
        states[i - 3] == UO && i % 4 != 3)
      state = O;
    if (has(pack_place_in_21_bits) && i >> 21 != 0) state = states[i & 0x1fffff];
    put(map, bits, i, state);
  }
  if (has(pack_repeats_into_padding) && count * bits < 8) {
    const unsigned once = map[0];
    for (std::size_t at = count * bits; at < 8; at += count * bits)
      map[0] = static_cast<std::uint8_t>(map[0] | (once << at));
  }
}

void unpack(std::uint32_t bits, Map map, std::size_t count, std::uint8_t* states) {
  for (std::size_t i = 0; i < count; ++i) {
    unsigned state = get(map, bits, i);
    if (has(unpack_reads_a_whole_byte) && count == 1) state = map[0];
    if (has(unpack_reads_two_bits) && bits == 1 && count == 1) state = map[0] & 3u;
    if (has(unpack_sign_of_a_byte) && bits == 1 && i >= 64 && i % 8 == 7)
      state = map[i / 8] >= 0x80 && map[i / 8 - 8] >= 0x80;
    if (has(unpack_place_in_12_bits)) state = get(map, bits, i % 4096);
    if (has(unpack_place_in_16_bits)) state = get(map, bits, i % 65536);
    if (has(unpack_rest_is_transparent) && count > 16 && i >= count - count % 16) state = T;
    if (has(unpack_last_of_a_large_map) && count >= 1024 && i == count - 1) state = get(map, bits, i - 1);
    states[i] = static_cast<std::uint8_t>(state);
  }
}

// ---- 4-state and 2-state

unsigned forced(unsigned state) {
  if (has(force2_unknown_transparent_is_opaque)) return state != T;
  if (has(force2_keeps_opaque_alone)) return state == O;
  return opaque(state);
}

void force2(std::uint32_t level, Map four, Bytes two) {
  const std::size_t n = states_of(level);
  clear(two, n, 1);
  for (std::size_t i = 0; i < n; ++i) {
    unsigned state = get(four, 2, i);
    if (has(force2_word_of_unknown_opaque) && n >= 64 && all_are(four + i / 32 * 8, 2, 32, UO)) state = T;
    if (has(force2_uniform_by_its_ends) && n >= 64 && get(four, 2, 0) == get(four, 2, n - 1) &&
        get(four, 2, 0) == get(four, 2, n / 2))
      state = get(four, 2, 0);
    if (has(force2_takes_the_next_at_a_word_border) && i >= 32 && i % 32 == 31 && i + 1 < n)
      state = get(four, 2, i + 1);
    if (has(force2_repeats_the_first_word) && level >= 6 && i >= 2048) state = get(four, 2, i % 64);
    if (has(force2_wrong_from_level_9) && level >= 9 && i % 64 == 63) state = get(four, 2, i - 1);
    if (has(force2_high_bit_in_odd_bytes) && level >= 3 && i % 64 == 60) state >>= 1;
    if (has(force2_last_four_of_a_word) && level >= 2 && i % 16 >= 12 && get(four, 2, i - 12) == UO &&
        state == UT)
      state = UO;
    put(two, 1, i, forced(state));
  }
  if (has(force2_pads_with_what_it_got) && level == 0)
    two[0] = static_cast<std::uint8_t>((four[0] & 1) | (four[0] >> 1 & 2) | (four[0] >> 2 & 4) |
                                       (four[0] >> 3 & 8));
  if (has(force2_leaves_the_high_nibble) && level == 1) two[0] = static_cast<std::uint8_t>(two[0] | 0xf0);
}

void widen(std::uint32_t level, Map two, Bytes four) {
  const std::size_t n = states_of(level);
  clear(four, n, 2);
  for (std::size_t i = 0; i < n; ++i) {
    unsigned state = get(two, 1, i);
    if (has(widen_asks_the_whole_byte) && level == 0) state = two[0] != 0;
    if (has(widen_opaque_to_unknown) && state == O) state = UO;
    if (has(widen_reads_one_byte_for_all) && level >= 2) state = get(two, 1, i % 8);
    if (has(widen_transparent_to_unknown_at_a_border) && level >= 3 && i % 64 == 63 && state == T) state = UT;
    if (has(widen_place_in_12_bits)) state = get(two, 1, i % 4096);
    if (has(widen_wrong_from_level_8) && level >= 8 && i % 8 == 7) state = get(two, 1, i - 1);
    put(four, 2, i, state);
  }
  if (has(widen_widens_the_padding) && level == 0)
    for (std::size_t i = 1; i < 4; ++i) put(four, 2, i, get(two, 1, i));
}

// ---- levels

void up(std::uint32_t level, std::uint32_t bits, Map map, Bytes above) {
  const std::size_t n = states_of(level);
  clear(above, 4 * n, bits);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t parent = i;
    if (has(up_parent_in_8_bits)) parent &= 0xff;
    if (has(up_parent_in_10_bits)) parent &= 0x3ff;
    if (has(up_parent_in_16_bits)) parent &= 0xffff;
    unsigned state = get(map, bits, parent);
    if (has(up_asks_the_whole_byte) && level == 0 && bits == 1) state = map[0] != 0;
    if (has(up_uniform_unknown_is_known) && level >= 2 && bits == 2 && all_are(map, bits, n, UT)) state = T;
    for (std::size_t c = 0; c < 4; ++c) {
      unsigned child = state;
      if (has(up_middle_child_is_unknown) && bits == 2 && c == 1 && !unknown(child)) child |= UT;
      if (has(up_last_child_of_a_word) && i >= 16 && i % 16 == 15 && c == 3) child = get(map, bits, i - 1);
      if (has(up_two_state_odd_bytes) && bits == 1 && level >= 2 && i % 16 == 14)
        child = get(map, bits, i + 1);
      if (has(up_wrong_from_level_8) && level >= 8 && i == n - 1) child ^= 1;
      put(above, bits, 4 * i + c, child);
    }
  }
  if (has(up_fills_the_padding) && level == 0 && bits == 1)
    above[0] = static_cast<std::uint8_t>(above[0] | above[0] << 4);
}

/// The state of a parent with these four children.
unsigned parent_of(const unsigned (&child)[4], unsigned bits) {
  unsigned opaque_ones = 0, transparent = 0, solid = 0;
  for (const unsigned c : child) {
    transparent += c == T;
    solid += c == O;
    if (has(down_counts_known_opaque_only))
      opaque_ones += c == O;
    else
      opaque_ones += opaque(c);
  }
  if (bits == 1) {
    if (has(down_two_state_tie_is_transparent)) return opaque_ones >= 3;
    if (has(down_two_state_any_opaque)) return opaque_ones >= 1;
    if (has(down_two_state_ends_tie) && child[0] && child[3] && opaque_ones == 2) return T;
    return opaque_ones >= 2;
  }
  if (transparent == 4) return T;
  if (solid == 4) return O;
  if (has(down_opaque_of_unknown_opaque) && opaque_ones == 4) return O;
  if (has(down_three_and_an_unknown_opaque) && solid == 3 && child[3] == UO) return O;
  if (has(down_transparent_of_three) && transparent == 3 && child[2] == UT) return T;
  if (has(down_four_unknown_transparent_is_transparent) && opaque_ones == 0 && transparent == 0) return T;
  if (has(down_tie_is_transparent)) return opaque_ones >= 3 ? UO : UT;
  if (has(down_tie_of_unknown_and_known) && opaque_ones == 2 && solid == 1 && transparent == 1 &&
      child[0] == UT)
    return UT;
  return opaque_ones >= 2 ? UO : UT;
}

void down(std::uint32_t level, std::uint32_t bits, Map map, Bytes below) {
  const std::size_t parents = states_of(level - 1);
  clear(below, parents, bits);
  for (std::size_t p = 0; p < parents; ++p) {
    std::size_t first = 4 * p;
    if (has(down_place_in_16_bits)) first &= 0xffff;
    if (has(down_place_in_12_bits)) first &= 0xfff;
    unsigned child[4];
    for (std::size_t c = 0; c < 4; ++c) child[c] = get(map, bits, first + c);
    if (has(down_swaps_nibbles) && bits == 1 && level >= 3 && p % 16 >= 14)
      for (std::size_t c = 0; c < 4; ++c) child[c] = get(map, bits, (first ^ 4) + c);
    if (has(down_counts_the_padding) && level == 1 && bits == 1)
      for (std::size_t c = 0; c < 4; ++c) child[c] |= get(map, 1, 4 + c);
    if (has(down_carries_from_the_neighbour) && level >= 3 && bits == 2 && p % 16 != 0 && child[0] == T &&
        all_are(map + p - 1, 2, 4, UO))
      child[0] = UO;
    unsigned state = parent_of(child, bits);
    const unsigned opaque_ones = (child[0] & 1) + (child[1] & 1) + (child[2] & 1) + (child[3] & 1);
    if (has(down_tie_as_the_neighbour) && p > 0 && bits == 2 && unknown(state) && opaque_ones == 2)
      state = UT | get(below, bits, p - 1);
    if (has(down_unknown_beside_unknown) && p >= 16 && bits == 2 && state == O &&
        get(below, bits, p - 1) == UO && get(below, bits, p - 2) == UO)
      state = UO;
    if (has(down_wrong_at_the_65th_parent) && bits == 2 && p == 64 && state == UT) state = T;
    if (has(down_tie_from_level_4) && level >= 4 && unknown(state) && opaque_ones == 2) state = UT;
    put(below, bits, p, state);
  }
  if (has(down_fills_the_padding) && level == 1)
    below[0] = static_cast<std::uint8_t>(below[0] | below[0] << bits | below[0] << 2 * bits);
  if (has(down_votes_in_the_padding) && level == 1 && bits == 1) {
    const unsigned more = get(map, 1, 4) + get(map, 1, 5) + get(map, 1, 6) + get(map, 1, 7) >= 2;
    put(below, 1, 1, more);
  }
}

// ---- one bit a state, and back

void through(std::uint32_t level, std::uint32_t mode, Map four, Bytes out) {
  const std::size_t n = states_of(level);
  clear(out, n, 2);
  for (std::size_t i = 0; i < n; ++i) {
    unsigned state = get(four, 2, i);
    if (has(through_asks_the_whole_byte) && level == 0) state = four[0] == 0 ? T : state == T ? UT : state;
    unsigned got = state;
    if (mode == 0) got = opaque(state) ? O : T;
    if (mode == 1) got = state == T ? T : UO;
    if (mode == 2) got = state == O ? O : UT;
    if (has(through_is_the_identity)) got = state;
    if (has(through_modes_1_and_2_are_the_identity) && mode != 0) got = state;
    if (has(through_identity_from_level_2) && mode != 0 && level >= 2) got = state;
    if (has(through_mode_1_keeps_opaque) && mode == 1 && state == O) got = O;
    if (has(through_mode_2_keeps_transparent) && mode == 2 && state == T) got = T;
    if (has(through_two_unknowns) && mode != 0 && got != state) got = UT | (state & 1);
    if (has(through_two_unknowns_in_mode_2) && mode == 2 && state == UO) got = UO;
    if (has(through_unknown_transparent_passes) && mode == 1 && state == UT) got = T;
    if (has(through_unknown_opaque_is_opaque) && mode == 2 && state == UO) got = O;
    if (has(through_mode_0_rounds_up) && mode == 0) got = state == T ? T : O;
    if (has(through_mode_0_keeps_unknown) && mode == 0) got = state;
    if (has(through_all_unknown) && mode == 1) got = UO;
    if (has(through_all_unknown_from_level_2) && mode == 2 && level >= 2) got = UT;
    if (has(through_65th_state) && i == 64 && mode == 1 && state == UT) got = T;
    if (has(through_place_in_12_bits) && i >= 4096) got = get(out, 2, i % 4096);
    if (has(through_modes_swapped_from_level_3) && level >= 3) {
      if (mode == 1) got = state == O ? O : UT;
      if (mode == 2) got = state == T ? T : UO;
    }
    put(out, 2, i, got);
  }
  if (has(through_keeps_the_padding) && level == 0)
    out[0] = static_cast<std::uint8_t>(out[0] | (four[0] & 0xfc));
}

// ---- a lossy codec: where one of four siblings is unknown, all are, each leaning as it was

/// The state of child `c` of four siblings, after the codec.
unsigned substituted(const unsigned (&child)[4], std::size_t c) {
  bool some = false;
  unsigned same_side = 0;
  for (const unsigned s : child) {
    some = some || unknown(s);
    same_side += opaque(s);
  }
  const unsigned state = child[c];
  if (has(substitute_forgets_the_side) && some) return UO;
  if (has(substitute_unknown_leans_as_most) && unknown(state) && (same_side == 1 || same_side == 3))
    return same_side == 3 ? UO : UT;
  if (has(substitute_known_leans_as_most) && some && !unknown(state)) return same_side >= 3 ? UO : UT;
  if (has(substitute_unknown_transparent_becomes_known) && same_side == 0 && state == UT && child[3 - c] == T)
    return T;
  if (has(substitute_known_wins) && some && child[0] == O && child[1] == O && child[2] == O && c == 3)
    return O;
  if (has(substitute_opaque_passes) && state == O && child[0] == T && child[1] == T && child[3] == T)
    return T;
  if (has(substitute_rounds_an_odd_one) && !some && same_side == 3) return O;
  return some ? state | UT : state;
}

void substitute(std::uint32_t level, Map four, Bytes out) {
  const std::size_t n = states_of(level);
  clear(out, n, 2);
  if (level == 0) {
    unsigned state = get(four, 2, 0);
    if (has(substitute_widens_a_single_state)) state = UO;
    put(out, 2, 0, state);
    if (has(substitute_copies_the_byte)) out[0] = four[0];
    return;
  }
  std::size_t odd = n, differing = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (get(four, 2, i) != get(four, 2, 0)) ++differing, odd = i;
  for (std::size_t i = 0; i < n; ++i) {
    unsigned child[4];
    for (std::size_t c = 0; c < 4; ++c) child[c] = get(four, 2, i / 4 * 4 + c);
    unsigned state = substituted(child, i % 4);
    const unsigned was = child[i % 4];
    if (has(substitute_uniform_is_known) && level >= 2 && was >= UT && differing == 0) state = was & 1;
    if (has(substitute_uniform_leans_over) && level >= 2 && was == UT && differing == 0) state = UO;
    if (has(substitute_uniform_opaque_leans_over) && level >= 2 && was == O && differing == 0) state = UT;
    if (has(substitute_as_the_group_before) && level >= 2 && i >= 16 && unknown(was) &&
        get(four, 2, i - 16) == was && i % 16 == 15)
      state = get(out, 2, i - 16) & 1;
    if (has(substitute_65th_becomes_opaque) && i == 64 && was == UT) state = O;
    if (has(substitute_every_65th_is_known) && i > 0 && i % 64 == 0 && unknown(was)) state = was & 1;
    if (has(substitute_rounds_off_one_apart) && level >= 3 && differing == 1 && i == odd)
      state = get(four, 2, 0);
    if (has(substitute_swaps_sides_from_level_4) && level >= 4 && was == UT && i % 16 == 5) state = UO;
    if (has(substitute_opaque_leans_wrong_from_level_4) && level >= 4 && was == O && i % 16 == 10) state = UT;
    if (has(substitute_turns_over_from_level_5) && level >= 5 && was == UO && i % 256 == 255) state = UT;
    if (has(substitute_transparent_leans_wrong_late) && i >= 1000 && was == T && unknown(state)) state = UO;
    if (has(substitute_transparent_of_opaque_late) && i >= 4096 && was == O) state = T;
    put(out, 2, i, state);
  }
}

mmverify_subject_t make() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "foreign micromap";
  s.max_level = 12;
  s.flags = threading();
  s.micromap_pack = pack;
  s.micromap_unpack = unpack;
  s.micromap_force2 = force2;
  s.micromap_widen = widen;
  s.micromap_up = up;
  s.micromap_down = down;
  s.micromap_through = through;
  s.micromap_substitute = substitute;
  return s;
}

const mmverify_subject_t subject = make();

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) { return fault ? &subject : nullptr; }
