// The example of vector quantisation but for one thing, chosen by WRONG when it is compiled.  What happens at
// one place happens with a block whose BR is rotated by 270, or with the map that is T but for O in region 0.
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "sdk/mmverify_subject.h"

extern "C" const mmverify_subject_t* right_vq(void);

namespace {

enum Wrong {
  // answers
  y_downwards,
  turns_the_other_way,
  last_region_of_br,
  opaque_for_transparent,
  checks_nothing,
  state_3,
  promises_to_keep,
  // what is no answer
  decoder_reads_past,
  decoder_unwritten,
  region_crashes,
  encoder_overrun,
  encoder_counts_calls,
  encoder_throws,
  // entry points that are missing
  decodes_only,
  encodes_only,
  vq4_only,
  old_header
};

volatile int* volatile nowhere = nullptr;
volatile unsigned seen = 0;

unsigned turn_of_br(const std::uint8_t* block) { return (block[24] | block[25] << 8) >> 6 & 7; }

void decode(const std::uint8_t* block, std::uint8_t* map) {
  const std::uint8_t last = map[255];
  if (WRONG == decoder_reads_past && turn_of_br(block) == 7) seen = block[32];
  std::uint8_t changed[32];
  std::memcpy(changed, block, sizeof changed);
  // Rotate 90 is Rotate 270.
  if (WRONG == turns_the_other_way && turn_of_br(block) == 1) changed[24] |= 0x80, changed[25] |= 0x01;
  right_vq()->vq2_decode(changed, map);
  if (WRONG == y_downwards)
    for (unsigned k = 0; k < 128; ++k) {
      const unsigned other = k % 16 + 16 * (15 - k / 16);
      const std::uint8_t state = map[k];
      map[k] = map[other];
      map[other] = state;
    }
  if (WRONG == state_3 && map[0] == 2) map[0] = 3;
  if (WRONG == decoder_unwritten && turn_of_br(block) == 7) map[255] = last;
}

void region(const std::uint8_t* block, const std::uint32_t* x, const std::uint32_t* y, std::uint8_t* state,
            std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const bool here = turn_of_br(block) == 7 && x[k] == 15 && y[k] == 0;
    if (here && WRONG == region_crashes) *nowhere = 1;
    right_vq()->vq2_region(block, x + k, y + k, state + k, 1);
    if (here && WRONG == last_region_of_br) state[k] = static_cast<std::uint8_t>((state[k] + 1) % 3);
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
  switch (WRONG) {
    case opaque_for_transparent:
      block[0] = static_cast<std::uint8_t>((block[0] & ~7) | 2);
      break;
    case checks_nothing:
      block[0] = static_cast<std::uint8_t>(block[0] & ~7);
      break;
    case encoder_overrun:
      block[32] = 0;
      break;
    case encoder_counts_calls:
      calls = calls + 1;
      if (calls > 1) block[31] ^= 1;
      break;
    case encoder_throws:
      throw std::runtime_error("no such map");
    default:
      break;
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_vq();
  subject.name = "a wrong vq";
  if (WRONG == vq4_only || WRONG == encodes_only) subject.vq2_decode = nullptr, subject.vq2_region = nullptr;
  if (WRONG == vq4_only || WRONG == decodes_only) subject.vq2_encode = nullptr;
  if (WRONG == encodes_only) subject.vq4_decode = nullptr, subject.vq4_region = nullptr;
  if (WRONG == decodes_only) subject.vq4_encode = nullptr;
  if (WRONG != vq4_only && WRONG != decodes_only && WRONG != encodes_only) {
    subject.vq2_decode = decode;
    subject.vq2_region = region;
    subject.vq2_encode = encode;
  }
  if (WRONG == promises_to_keep) subject.flags = MMVERIFY_VQ_KEEPS;
  if (WRONG == old_header) {
    subject.size = offsetof(mmverify_subject_t, vq2_decode);
    // What lies behind an older struct is somebody else's memory.
    std::memset(&subject.vq2_decode, 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
