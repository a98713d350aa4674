// The example of a tree but for one thing, chosen when it is linked.  What happens at one place
// happens with the 2-state map 0110 of level 1, whose code is 01 06, and there at index 2 or at u = 1/2, v =
// 1/4.
#include <cfenv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_tree(void);

namespace {

volatile int* volatile nowhere = nullptr;
volatile unsigned seen = 0;

std::size_t encode(std::uint32_t level, std::uint32_t bits, const std::uint8_t* map, std::uint8_t* code,
                   std::size_t capacity) {
  std::vector<std::uint8_t> changed;
  if (bits == 2 && wrong_is("merges_ut")) {
    changed.assign(map, map + ((std::size_t{2} << 2 * level) + 7) / 8);
    // UT becomes T where the low bit of a state is clear.
    for (std::uint8_t& byte : changed) byte = static_cast<std::uint8_t>(byte & (byte << 1 | 0x55));
    map = changed.data();
  }
  // Asked between repetitions of a 2-state map, too.
  if (wrong_is("hangs_on_uo") && level == 0 && bits == MMVERIFY_4_STATE && map[0] == 3)
    std::this_thread::sleep_for(std::chrono::hours(1));
  const bool here = level == 1 && bits == MMVERIFY_2_STATE && map[0] == 0x06;
  if (here && wrong_is("has_no_code")) return 0;
  if (here && wrong_is("asks_too_much")) return std::size_t{1} << 30;
  if (here && wrong_is("writes_input")) const_cast<volatile std::uint8_t*>(map)[0] = 0;
  const std::uint8_t before = here && capacity > 1 ? code[1] : std::uint8_t{0};
  const std::size_t size = right_tree()->tree_encode(level, bits, map, code, capacity);
  if (!here) return size;
  static volatile int calls = 0, inside = 0;
  if (wrong_is("pads_with_ones") && capacity >= size) code[size - 1] |= 0x80;
  if (wrong_is("crash")) *nowhere = 1;
  if (wrong_is("hang")) std::this_thread::sleep_for(std::chrono::hours(1));
  if (wrong_is("overrun")) code[capacity] = 0;
  if (wrong_is("underrun")) code[-1] = 0;
  if (wrong_is("exits")) std::_Exit(0);
  if (wrong_is("throws")) throw std::runtime_error("no such map");
  if (wrong_is("rounds")) std::fesetround(FE_UPWARD);
  if (wrong_is("counts_calls")) {
    calls = calls + 1;
    if (capacity >= size && calls > 1) code[1] ^= 1;
  }
  if (wrong_is("sees_room")) return size + (capacity == size ? 1 : 0);
  if (wrong_is("sees_threads")) {
    inside = inside + 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (inside > 1) code[1] ^= 1;
    inside = inside - 1;
  }
  if (wrong_is("unwritten") && capacity >= size) code[1] = before;
  return size;
}

bool is_here(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size) {
  return level == 1 && bits == MMVERIFY_2_STATE && size == 2 && code[0] == 0x01 && code[1] == 0x06;
}

int decode(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  const bool here = is_here(level, bits, code, size);
  if (here && wrong_is("reads_past")) seen = code[size];
  if (here && wrong_is("writes_code")) const_cast<volatile std::uint8_t*>(code)[0] = 0;
  if (here && wrong_is("refuses_its_own")) return 0;
  const std::uint8_t before = map[0];
  const int taken = right_tree()->tree_decode(level, bits, code, size, map);
  if (here && wrong_is("unwritten_map")) map[0] = before;
  static int calls = 0;
  if (here && wrong_is("changes_its_mind")) return calls++ % 2;
  if (taken == 0 && wrong_is("takes_all")) {
    std::memset(map, 0, ((std::size_t{bits} << 2 * level) + 7) / 8);
    return 1;
  }
  return taken;
}

/// The code as it was when its address, size, first and last four bytes were last seen together: what another code left
/// there whose middle alone differs.
const std::uint8_t* kept_by_ends(const std::uint8_t* code, std::size_t size) {
  struct Kept {
    const std::uint8_t* at = nullptr;
    std::vector<std::uint8_t> bytes;
  };
  thread_local Kept kept;
  if (size < 8) return code;
  const bool known = kept.at == code && kept.bytes.size() == size &&
                     std::memcmp(kept.bytes.data(), code, 4) == 0 &&
                     std::memcmp(kept.bytes.data() + size - 4, code + size - 4, 4) == 0;
  if (!known) kept = {code, {code, code + size}};
  return kept.bytes.data();
}

void lookup(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
            const std::uint32_t* index, std::uint8_t* state, std::size_t count) {
  if (wrong_is("keeps_by_ends")) code = kept_by_ends(code, size);
  const bool here = is_here(level, bits, code, size);
  static const bool reversed = wrong_is("children_reversed");
  for (std::size_t k = 0; k < count; ++k) {
    // Child c's place is taken by child 3 - c.
    const std::uint32_t other = index[k] ^ ((1u << 2 * level) - 1);
    const std::uint32_t* asked = reversed ? &other : &index[k];
    if (here && index[k] == 2) {
      if (wrong_is("lookup_crashes")) *nowhere = 1;
      if (wrong_is("lookup_reads_past")) seen = code[size];
      if (wrong_is("lookup_unwritten")) continue;
    }
    right_tree()->tree_lookup(level, bits, code, size, asked, state + k, 1);
  }
}

void lookup_f32(std::uint32_t level, std::uint32_t bits, const std::uint8_t* code, std::size_t size,
                const float* u, const float* v, std::uint8_t* state, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k)
    if (u[k] == 0.5f && v[k] == 0.25f && is_here(level, bits, code, size) && wrong_is("point_throws"))
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
  const bool foreign_decoder = wrong_is("foreign_decoder"), foreign_encoder = wrong_is("foreign_encoder"),
             encodes_only = wrong_is("encodes_only"), decodes_only = wrong_is("decodes_only"),
             points_only = wrong_is("points_only");
  if (foreign_decoder || foreign_encoder || encodes_only || decodes_only || points_only) {
    if (!encodes_only && !foreign_encoder) subject.tree_encode = nullptr;
    if (!decodes_only && !foreign_decoder) subject.tree_decode = nullptr;
    if (!points_only) subject.tree_lookup_f32 = nullptr;
    subject.tree_lookup = nullptr;
    if (foreign_decoder || foreign_encoder) subject.flags = 0;
  }
  return &subject;
}
