// The example of a baker but for one thing, chosen when it is linked.  What happens at one place
// happens with the 2x2 texture that is transparent but for its last texel, at level 1 or above.
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_bake(void);

namespace {

volatile unsigned seen = 0;

std::size_t bytes_of(const mmverify_bake_case_t& c) {
  return ((std::size_t{c.format} << 2 * c.level) + 7) / 8;
}

bool is_here(const mmverify_bake_case_t& c) {
  static const std::uint8_t texels[] = {0, 0, 0, 255};
  return c.level >= 1 && c.width == 2 && c.height == 2 && std::memcmp(c.texels, texels, 4) == 0;
}

/// The texels of the last texture with this address, these sides and this first row; what the right one supports has one
/// byte a texel.
const void* kept_by_first_row(const mmverify_bake_case_t& c) {
  struct Kept {
    const void* at = nullptr;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> texels;
  };
  thread_local Kept kept;
  const auto* const now = static_cast<const std::uint8_t*>(c.texels);
  const bool known = kept.at == now && kept.width == c.width && kept.height == c.height &&
                     std::memcmp(kept.texels.data(), now, c.width) == 0;
  if (!known) kept = {now, c.width, c.height, {now, now + std::size_t{c.width} * c.height}};
  return kept.texels.data();
}

int bake(const mmverify_bake_case_t* what, std::uint8_t* map) {
  static volatile int calls = 0;
  mmverify_bake_case_t c = *what;
  const std::size_t bytes = bytes_of(c);
  const std::uint8_t last = map[bytes - 1];
  if (wrong_is("declines_all")) return 0;
  if (wrong_is("declines_borders") &&
      (c.wrap_u == MMVERIFY_CLAMP_TO_BORDER || c.wrap_v == MMVERIFY_CLAMP_TO_BORDER))
    return 0;
  if (wrong_is("keeps_by_first_row") && c.texel == MMVERIFY_UNORM8 && c.mips == 1)
    c.texels = kept_by_first_row(c);
  if (wrong_is("rows_from_below"))
    for (int k = 1; k < 6; k += 2) c.uv[k] = 1 - c.uv[k];
  const int done = right_bake()->bake(&c, map);
  if (wrong_is("settles_all"))
    for (std::size_t k = 0; k < bytes; ++k) map[k] = static_cast<std::uint8_t>(map[k] & 0x55);
  if (wrong_is("all_unknown"))
    for (std::size_t k = 0; k < bytes; ++k) map[k] = c.level == 0 ? 2 : 0xaa;
  if (wrong_is("pads_with_ones") && c.level == 0) map[0] = static_cast<std::uint8_t>(map[0] | 0xf0);
  if (wrong_is("crashes_on_some") && is_here(c) && c.wrap_u == c.wrap_v) std::abort();
  if (wrong_is("crashes_and_is_wrong") && is_here(c)) {
    if (c.wrap_u == c.wrap_v) std::abort();
    for (std::size_t k = 0; k < bytes; ++k) map[k] = static_cast<std::uint8_t>(map[k] & 0x55);
  }
  if (!is_here(c)) return done;
  if (wrong_is("reads_past")) seen = static_cast<const std::uint8_t*>(c.texels)[4];
  if (wrong_is("overrun")) map[bytes] = 0;
  if (wrong_is("unwritten")) map[bytes - 1] = last;
  if (wrong_is("throws")) throw std::runtime_error("no such texture");
  if (!wrong_is("counts_calls") && !wrong_is("changes_its_mind")) return done;
  calls = calls + 1;
  if (wrong_is("changes_its_mind")) return calls % 2;
  if (calls > 1) map[0] ^= 1;
  return done;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_bake();
  subject.name = "a wrong baker";
  subject.bake = bake;
  if (wrong_is("promises_the_centroid")) subject.flags = MMVERIFY_BAKE_CENTROID;
  if (wrong_is("old_header")) {
    subject.size = offsetof(mmverify_subject_t, bake);
    // The memory behind an older struct is somebody else's.
    std::memset(static_cast<void*>(&subject.bake), 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
