// The library's own packing, levels and modes as a subject: its sources, word for word, in one file.
#include <vector>

#include "impl/micromap/level.cpp"
#include "impl/micromap/micromap.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::micromap;
using Bytes = std::span<std::uint8_t>;
using ConstBytes = std::span<const std::uint8_t>;

Format format_of(uint32_t format) { return static_cast<Format>(format); }
ConstBytes map_of(const uint8_t* map, uint32_t format, std::uint64_t count) {
  return {map, packed_bytes(count, format_of(format))};
}
Bytes map_of(uint8_t* map, uint32_t format, std::uint64_t count) {
  return {map, packed_bytes(count, format_of(format))};
}

void pack(uint32_t format, const uint8_t* states, size_t count, uint8_t* map) {
  mmverify::impl::micromap::pack({reinterpret_cast<const State*>(states), count}, format_of(format),
                                 map_of(map, format, count));
}
void unpack(uint32_t format, const uint8_t* map, size_t count, uint8_t* states) {
  mmverify::impl::micromap::unpack(map_of(map, format, count), format_of(format),
                                   {reinterpret_cast<State*>(states), count});
}
void force2(uint32_t level, const uint8_t* four_state, uint8_t* two_state) {
  const std::uint64_t count = micro_triangles(level);
  mmverify::impl::micromap::force2(map_of(four_state, 2, count), count, map_of(two_state, 1, count));
}
void widen(uint32_t level, const uint8_t* two_state, uint8_t* four_state) {
  const std::uint64_t count = micro_triangles(level);
  mmverify::impl::micromap::widen(map_of(two_state, 1, count), count, map_of(four_state, 2, count));
}
void up(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* above) {
  const std::uint64_t count = micro_triangles(level);
  mmverify::impl::micromap::up(map_of(map, format, count), format_of(format), count,
                               map_of(above, format, 4 * count));
}
void down(uint32_t level, uint32_t format, const uint8_t* map, uint8_t* below) {
  const std::uint64_t count = micro_triangles(level) / 4;
  mmverify::impl::micromap::down(map_of(map, format, 4 * count), format_of(format), count,
                                 map_of(below, format, count));
}
void through(uint32_t level, uint32_t mode, const uint8_t* four_state, uint8_t* out) {
  const std::uint64_t count = micro_triangles(level);
  std::vector<std::uint8_t> one_bit(packed_bytes(count, Format::two_state));
  to_mode(map_of(four_state, 2, count), count, static_cast<Mode>(mode), one_bit);
  from_mode(one_bit, count, static_cast<Mode>(mode), map_of(out, 2, count));
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own packing";
  subject.max_level = 12;
  subject.micromap_pack = pack;
  subject.micromap_unpack = unpack;
  subject.micromap_force2 = force2;
  subject.micromap_widen = widen;
  subject.micromap_up = up;
  subject.micromap_down = down;
  subject.micromap_through = through;
  return &subject;
}
