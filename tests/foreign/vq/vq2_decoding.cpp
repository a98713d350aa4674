// VQ2: the codebook, and the state of a region.
#include "tests/foreign/vq/decoding.hpp"
#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

/// The state that a word of figure 4 gives region r of four: bits 0 to 3 are set for C, bit 4 is the palette.
std::uint8_t state_of_word(unsigned word, int r) {
  if ((word >> r & 1u) != 0) return C;
  return (word >> 4 & 1u) != 0 ? O : T;
}

/// The number, in the codebook, of the entry that an index 3 to 7 names in a quadrant.
int vq2_entry(const std::uint8_t* block, unsigned index, int quadrant) {
  if (has(vq2_own_entries_of_tl) && index > 5) return 3 + static_cast<int>(index) - 6;
  if (has(vq2_own_entries_of_bl_are_br) && index > 5 && quadrant == BL)
    return 3 + 2 * BR + static_cast<int>(index) - 6;
  if (has(vq2_index_7_is_6_in_tr) && index == 7 && quadrant == TR) index = 6;
  if (has(vq2_shared_2_is_own_in_br) && index == 5 && quadrant == BR) return 3 + 2 * BR;
  if (has(vq2_shared_2_is_1_under_r270) && index == 5 && transform_of(vq2, block, BL) == 7) index = 4;
  if (has(vq2_own_shifts_if_shared_repeat) && index == 7 && bits(block, 201, 5) == bits(block, 206, 5))
    index = 6;
  return index < 6 ? static_cast<int>(index) - 3 : 3 + 2 * quadrant + static_cast<int>(index) - 6;
}

unsigned vq2_word(const std::uint8_t* block, int entry) {
  const unsigned word = bits(block, 201 + 5 * entry, 5);
  if (has(vq2_last_bit_not_read) && entry == 10) return word & 15u;
  if (has(vq2_uniform_entry_is_t) && word == 16) return 0;
  if (has(vq2_repeated_entry_is_check) && entry > 0 && word == bits(block, 201 + 5 * (entry - 1), 5))
    return 15;
  if (has(vq2_palette_of_shared_1) && entry == 1) return (word & 15u) | (bits(block, 201, 5) & 16u);
  if (has(vq2_word_22_in_entry_9) && entry == 9 && word == 22) return 25;
  if (has(vq2_own_palettes_of_first) && entry > 3 && entry % 2 == 0)
    return (word & 15u) | (bits(block, 201 + 5 * (entry - 1), 5) & 16u);
  if (has(vq2_check_bits_of_shared_2_by_tl_7) && entry == 2 && (bits(block, 201 + 20, 5) & 3u) == 2)
    return word ^ 1u;
  if (has(vq2_palette_by_majority) && entry >= 3) {
    unsigned opaque = 0;
    for (int e = 0; e < 11; ++e) opaque += bits(block, 201 + 5 * e + 4, 1);
    if (opaque >= 10) return word | 16u;
  }
  return word;
}

}  // namespace

std::uint8_t vq2_state(const std::uint8_t* block, int x, int y, Way way) {
  const int X = x / 2, Y = y / 2, quadrant = quadrant_of(X, Y);
  const unsigned index = read_index(vq2, block, X, Y, way);
  if (index < 3) {
    if (has(uniform_2_is_check_in_br) && index == 2 && quadrant == BR && x == 15 && y == 7) return C;
    return static_cast<std::uint8_t>(index);
  }
  const unsigned transform = read_transform(vq2, block, quadrant, index, way);
  const Region p = read_region(vq2, transform, quadrant, x, y);
  return state_of_word(vq2_word(block, vq2_entry(block, index, quadrant)), p.x + 2 * p.y);
}

}  // namespace mmverify::tests::foreign::vq
