// The library's own lossy forms of a map as a subject, word for word in one file: by MODE a level below and back, as KHR's
// lossy micromaps have it, or one bit a state, T or O apart from the rest.
#include <vector>

#include "impl/micromap/level.cpp"
#include "impl/micromap/micromap.cpp"
#include "subjects/sdk/mmverify_subject.h"

#ifndef MODE
#define MODE 0
#endif

namespace {

using namespace mmverify::impl::micromap;

void substitute(uint32_t level, const uint8_t* map, uint8_t* out) {
  const std::uint64_t count = micro_triangles(level);
  const std::size_t bytes = packed_bytes(count, Format::four_state);
  const std::span<const std::uint8_t> from(map, bytes);
  const std::span<std::uint8_t> to(out, bytes);
  if (MODE != 0) {
    std::vector<std::uint8_t> one_bit(packed_bytes(count, Format::two_state));
    to_mode(from, count, static_cast<Mode>(MODE), one_bit);
    from_mode(one_bit, count, static_cast<Mode>(MODE), to);
  } else if (level == 0) {
    out[0] = map[0] & 3;
  } else {
    std::vector<std::uint8_t> below(packed_bytes(count / 4, Format::four_state));
    down(from, Format::four_state, count / 4, below);
    up(below, Format::four_state, count / 4, to);
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own lossy forms";
  subject.max_level = 12;
  subject.micromap_substitute = substitute;
  return &subject;
}
