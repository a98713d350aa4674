// The example of a tree but for one thing, chosen by WRONG when it is compiled.  What happens at one place
// happens with the 2-state map 0110 of level 1, whose code is 01 06, and there at index 2 or at u = 1/2, v =
// 1/4.
#include <cfenv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "sdk/mmverify_subject.h"

extern "C" const mmverify_subject_t* right_tree(void);

namespace {

enum Wrong {
  // answers
  merges_ut,
  children_reversed,
  takes_all,
  refuses_its_own,
  has_no_code,
  pads_with_ones,
  // what is no answer: of the encoder,
  crash,
  hang,
  overrun,
  underrun,
  exits,
  throws,
  rounds,
  counts_calls,
  sees_room,
  sees_threads,
  writes_input,
  unwritten,
  asks_too_much,
  // of the decoder
  reads_past,
  writes_code,
  unwritten_map,
  changes_its_mind,
  // and of lookups
  lookup_crashes,
  lookup_unwritten,
  lookup_reads_past,
  point_throws,
  // entry points that are missing
  encodes_only,
  decodes_only,
  points_only,
  foreign_decoder,
  foreign_encoder
};

volatile int* volatile nowhere = nullptr;
volatile unsigned seen = 0;

std::size_t encode(std::uint32_t level, std::uint32_t bits, const std::uint8_t* map, std::uint8_t* code,
                   std::size_t capacity) {
  std::vector<std::uint8_t> changed;
  if (WRONG == merges_ut && bits == 2) {
    changed.assign(map, map + ((std::size_t{2} << 2 * level) + 7) / 8);
    // UT becomes T where the low bit of a state is clear.
    for (std::uint8_t& byte : changed) byte = static_cast<std::uint8_t>(byte & (byte << 1 | 0x55));
    map = changed.data();
  }
  const bool here = level == 1 && bits == MMVERIFY_2_STATE && map[0] == 0x06;
  if (here && WRONG == has_no_code) return 0;
  if (here && WRONG == asks_too_much) return std::size_t{1} << 30;
  if (here && WRONG == writes_input) const_cast<volatile std::uint8_t*>(map)[0] = 0;
  const std::uint8_t before = here && capacity > 1 ? code[1] : std::uint8_t{0};
  const std::size_t size = right_tree()->tree_encode(level, bits, map, code, capacity);
  if (!here) return size;
  static volatile int calls = 0, inside = 0;
  switch (WRONG) {
    case pads_with_ones:
      if (capacity >= size) code[size - 1] |= 0x80;
      break;
    case crash:
      *nowhere = 1;
      break;
    case hang:
      std::this_thread::sleep_for(std::chrono::hours(1));
      break;
    case overrun:
      code[capacity] = 0;
      break;
    case underrun:
      code[-1] = 0;
      break;
    case exits:
      std::_Exit(0);
    case throws:
      throw std::runtime_error("no such map");
    case rounds:
      std::fesetround(FE_UPWARD);
      break;
    case counts_calls:
      calls = calls + 1;
      if (capacity >= size && calls > 1) code[1] ^= 1;
      break;
    case sees_room:
      return size + (capacity == size ? 1 : 0);
    case sees_threads:
      inside = inside + 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (inside > 1) code[1] ^= 1;
      inside = inside - 1;
      break;
    case unwritten:
      if (capacity >= size) code[1] = before;
      break;
    default:
      break;
  }
  return size;
}

bool is_here(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size) {
  return level == 1 && bits == MMVERIFY_2_STATE && size == 2 && code[0] == 0x01 && code[1] == 0x06;
}

int decode(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  const bool here = is_here(level, bits, code, size);
  if (here && WRONG == reads_past) seen = code[size];
  if (here && WRONG == writes_code) const_cast<volatile std::uint8_t*>(code)[0] = 0;
  if (here && WRONG == refuses_its_own) return 0;
  const std::uint8_t before = map[0];
  const int taken = right_tree()->tree_decode(level, bits, code, size, map);
  if (here && WRONG == unwritten_map) map[0] = before;
  static int calls = 0;
  if (here && WRONG == changes_its_mind) return calls++ % 2;
  if (taken == 0 && WRONG == takes_all) {
    std::memset(map, 0, ((std::size_t{bits} << 2 * level) + 7) / 8);
    return 1;
  }
  return taken;
}

void lookup(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
            const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  const bool here = is_here(level, bits, code, size);
  for (std::size_t k = 0; k < count; ++k) {
    // Child c's place is taken by child 3 - c.
    const std::uint32_t other = index[k] ^ ((1u << 2 * level) - 1);
    const std::uint32_t* asked = WRONG == children_reversed ? &other : &index[k];
    if (here && index[k] == 2) {
      if (WRONG == lookup_crashes) *nowhere = 1;
      if (WRONG == lookup_reads_past) seen = code[size];
      if (WRONG == lookup_unwritten) continue;
    }
    right_tree()->tree_lookup(level, bits, code, size, asked, state + k, 1);
  }
}

void lookup_f32(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
                const float* u, const float* v, std::uint8_t* state, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k)
    if (WRONG == point_throws && is_here(level, bits, code, size) && u[k] == 0.5f && v[k] == 0.25f)
      throw std::runtime_error("no such point");
  right_tree()->tree_lookup_f32(level, bits, code, size, u, v, state, count);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_tree();
  subject.name = "a wrong tree";
  subject.tree_encode = encode;
  subject.tree_decode = decode;
  subject.tree_lookup = lookup;
  subject.tree_lookup_f32 = lookup_f32;
  if (WRONG >= encodes_only) {
    if (WRONG != encodes_only && WRONG != foreign_encoder) subject.tree_encode = nullptr;
    if (WRONG != decodes_only && WRONG != foreign_decoder) subject.tree_decode = nullptr;
    if (WRONG != points_only) subject.tree_lookup_f32 = nullptr;
    subject.tree_lookup = nullptr;
    if (WRONG >= foreign_decoder) subject.flags = 0;
  }
  return &subject;
}
