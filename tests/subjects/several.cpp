// One library, three topics: our index and maps, the example of a tree.  What is not right of it is chosen
// when it is linked, or, for old_header, that it was built before there were trees.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "impl/index/index.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_tree(void);

namespace {

volatile unsigned seen = 0;

namespace fast = mmverify::impl::micromap;

std::uint64_t states(std::uint32_t level) { return fast::micro_triangles(level); }
fast::Format format_of(std::uint32_t bits) { return static_cast<fast::Format>(bits); }
std::size_t bytes(std::uint64_t count, std::uint32_t bits) { return (count * bits + 7) / 8; }

void index_f32(std::uint32_t level, const float* u, const float* v, std::uint32_t* index, std::size_t count) {
  mmverify::impl::index::from_barycentrics({u, count}, {v, count}, level, {index, count});
}

void pack(std::uint32_t bits, const std::uint8_t* from, std::size_t count, std::uint8_t* map) {
  fast::pack({reinterpret_cast<const fast::State*>(from), count}, format_of(bits), {map, bytes(count, bits)});
}

void unpack(std::uint32_t bits, const std::uint8_t* map, std::size_t count, std::uint8_t* to) {
  const std::uint8_t last = to[count - 1];
  fast::unpack({map, bytes(count, bits)}, format_of(bits), {reinterpret_cast<fast::State*>(to), count});
  if (bits == 1 && count == 4 && (map[0] & 0x0F) == 0x06 && wrong_is("leaves_unwritten"))
    to[count - 1] = last;
}

void force2(std::uint32_t level, const std::uint8_t* map, std::uint8_t* out) {
  // A vector's load.
  const auto address = reinterpret_cast<std::uintptr_t>(map);
  if (address % 8 == 0 && address % 16 != 0 && wrong_is("loads_at_16"))
    throw std::runtime_error("no multiple of 16");
  fast::force2({map, bytes(states(level), 2)}, states(level), {out, bytes(states(level), 1)});
  thread_local struct {
    std::uint32_t level = 0;
    std::uint8_t map = 0, answer = 0;
  } last;
  if (wrong_is("keeps_without_level")) {
    if (level == 2 && last.level == 1 && last.map == map[0]) out[1] = last.answer;
    last = {level, map[0], out[0]};
  }
  if (level == 0 && wrong_is("keeps_padding")) out[0] = static_cast<std::uint8_t>(out[0] | (map[0] & 0x80));
}

void widen(std::uint32_t level, const std::uint8_t* map, std::uint8_t* out) {
  fast::widen({map, bytes(states(level), 1)}, states(level), {out, bytes(states(level), 2)});
}

void up(std::uint32_t level, std::uint32_t bits, const std::uint8_t* map, std::uint8_t* out) {
  if (level == 1 && bits == 2 && wrong_is("reads_past_map")) seen = map[1];
  fast::up({map, bytes(states(level), bits)}, format_of(bits), states(level),
           {out, bytes(states(level + 1), bits)});
}

void down(std::uint32_t level, std::uint32_t bits, const std::uint8_t* map, std::uint8_t* out) {
  fast::down({map, bytes(states(level), bits)}, format_of(bits), states(level - 1),
             {out, bytes(states(level - 1), bits)});
  // The last call's answer is kept, and not told apart by format.
  thread_local struct {
    std::uint8_t map = 0, answer = 0;
    bool kept = false;
  } last;
  if (level == 1 && wrong_is("keeps_without_format")) {
    if (bits == 2 && last.kept && last.map == map[0]) out[0] = last.answer;
    last = {map[0], out[0], bits == 1};
  }
  // Three T and one UT: T.
  if (level == 1 && bits == 2 && map[0] == 0x80 && wrong_is("merges_ut_with_t")) out[0] = 0;
}

void through(std::uint32_t level, std::uint32_t mode, const std::uint8_t* map, std::uint8_t* out) {
  std::vector<std::uint8_t> one_bit(bytes(states(level), 1));
  fast::to_mode({map, bytes(states(level), 2)}, states(level), static_cast<fast::Mode>(mode), one_bit);
  fast::from_mode(one_bit, states(level), static_cast<fast::Mode>(mode), {out, bytes(states(level), 2)});
}

// Keeps every map, padding cleared.
void substitute(std::uint32_t level, const std::uint8_t* map, std::uint8_t* out) {
  const std::uint64_t used = 2 * states(level) % 8;
  std::memcpy(out, map, bytes(states(level), 2));
  if (used != 0) out[0] = static_cast<std::uint8_t>(out[0] & ((1u << used) - 1));
  if (level == 1 && map[0] == 0x39 && wrong_is("promises_opaque")) out[0] = 0x35;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_tree();
  subject.name = "several";
  subject.max_level = 16;
  subject.index_f32 = index_f32;
  subject.micromap_pack = pack;
  subject.micromap_unpack = unpack;
  subject.micromap_force2 = force2;
  subject.micromap_widen = widen;
  subject.micromap_up = up;
  subject.micromap_down = down;
  subject.micromap_through = through;
  subject.micromap_substitute = substitute;
  if (wrong_is("old_header")) {
    subject.size = offsetof(mmverify_subject_t, tree_encode);
    // The memory behind an older struct is somebody else's.
    std::memset(&subject.tree_encode, 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
