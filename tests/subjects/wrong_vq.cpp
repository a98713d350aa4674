// The example of vector quantisation but for one thing, chosen when it is linked.  What happens at
// one place happens with a block whose BR is rotated by 270, or with the map that is T but for O in region 0.
#include <cstring>
#include <stdexcept>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_vq(void);

namespace {

volatile int* volatile nowhere = nullptr;
volatile unsigned seen = 0;

unsigned turn_of_br(const std::uint8_t* block) { return (block[24] | block[25] << 8) >> 6 & 7; }

void decode(const std::uint8_t* block, std::uint8_t* map) {
  const std::uint8_t last = map[255];
  if (wrong_is("decoder_reads_past") && turn_of_br(block) == 7) seen = block[32];
  std::uint8_t changed[32];
  std::memcpy(changed, block, sizeof changed);
  // Rotate 90 is Rotate 270.
  if (wrong_is("turns_the_other_way") && turn_of_br(block) == 1) changed[24] |= 0x80, changed[25] |= 0x01;
  right_vq()->vq2_decode(changed, map);
  if (wrong_is("y_downwards"))
    for (unsigned k = 0; k < 128; ++k) {
      const unsigned other = k % 16 + 16 * (15 - k / 16);
      const std::uint8_t state = map[k];
      map[k] = map[other];
      map[other] = state;
    }
  if (wrong_is("state_3") && map[0] == 2) map[0] = 3;
  if (wrong_is("decoder_unwritten") && turn_of_br(block) == 7) map[255] = last;
}

void region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y, std::uint8_t* state,
            std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const bool here = turn_of_br(block) == 7 && x[k] == 15 && y[k] == 0;
    if (here && wrong_is("region_crashes")) *nowhere = 1;
    if (count % 4 == 0 && reinterpret_cast<std::uintptr_t>(x) % 16 != 0 && wrong_is("region_loads_at_16"))
      throw std::runtime_error("no multiple of 16");
    right_vq()->vq2_region(block, x + k, y + k, state + k, 1);
    if (here && wrong_is("last_region_of_br")) state[k] = static_cast<std::uint8_t>((state[k] + 1) % 3);
  }
}

bool is_here(const std::uint8_t* map) {
  unsigned sum = 0;
  for (unsigned k = 0; k < 256; ++k) sum += map[k];
  return sum == 2 && map[0] == 2;
}

void encode(const std::uint8_t* map, std::uint8_t* block) {
  right_vq()->vq2_encode(map, block);
  if (!is_here(map)) return;
  static volatile int calls = 0;
  if (wrong_is("opaque_for_transparent")) block[0] = static_cast<std::uint8_t>((block[0] & ~7) | 2);
  if (wrong_is("checks_nothing")) block[0] = static_cast<std::uint8_t>(block[0] & ~7);
  if (wrong_is("encoder_overrun")) block[32] = 0;
  if (wrong_is("encoder_counts_calls")) {
    calls = calls + 1;
    if (calls > 1) block[31] ^= 1;
  }
  if (wrong_is("encoder_throws")) throw std::runtime_error("no such map");
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_vq();
  subject.name = "a wrong vq";
  const bool encodes_only = wrong_is("encodes_only"), decodes_only = wrong_is("decodes_only"),
             vq4_only = wrong_is("vq4_only");
  if (vq4_only || encodes_only) subject.vq2_decode = nullptr, subject.vq2_region = nullptr;
  if (vq4_only || decodes_only) subject.vq2_encode = nullptr;
  if (encodes_only) subject.vq4_decode = nullptr, subject.vq4_region = nullptr;
  if (decodes_only) subject.vq4_encode = nullptr;
  if (!vq4_only && !decodes_only && !encodes_only) {
    subject.vq2_decode = decode;
    subject.vq2_region = region;
    subject.vq2_encode = encode;
  }
  if (wrong_is("promises_to_keep")) subject.flags = MMVERIFY_VQ_KEEPS;
  if (wrong_is("old_header")) {
    subject.size = offsetof(mmverify_subject_t, vq2_decode);
    // The memory behind an older struct is somebody else's.
    std::memset(&subject.vq2_decode, 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
