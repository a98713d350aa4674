// VQ4: the codebook, and the state of a region.
#include <bit>

#include "tests/foreign/vq/decoding.hpp"
#include "tests/foreign/vq/faults.hpp"
#include "tests/foreign/vq/vq4_code.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

unsigned vq4_word(const std::uint8_t* block, unsigned index) {
  const Code code = vq4_code(index);
  const unsigned word = bits(block, code.first, code.count);
  if (has(vq4_20_bits_read_as_19) && index > 7) return word & 0x7ffffu;
  if (has(vq4_top_bit_lost_in_15) && index == 15) return word & 0x7ffffu;
  if (has(vq4_top_bit_lost_beside_full_half) && index == 12 && (word & 0x3ffu) == 0x1efu)
    return word & 0x7ffffu;
  if (has(vq4_17_bits_of_entry_7) && index == 7) return word & 0x1ffffu;
  if (has(vq4_palette_of_4_is_that_of_3) && index == 4)
    return (word & 0xffffu) | (bits(block, 265, 17) & 0x10000u);
  if (has(vq4_one_word_of_11) && index == 11 && word == 0x5a2d3u) return word ^ 0x400u;
  if (has(vq4_one_word_of_9_turned) && index == 9 && word == 0xb3c96u && transform_of(vq4, block, BL) == 3)
    return word ^ 1u;
  if (has(vq4_one_word_of_5) && index == 5 && word == 0x1c35au) return word ^ 0x10000u;
  if (has(vq4_four_bits_set_are_five) && index == 13 && std::popcount(word) == 10) return word | 0x80u;
  if (has(vq4_entry_repeated_is_next) && index > 8 && word == bits(block, vq4_code(index - 1).first, 20))
    return bits(block, vq4_code(index == 15 ? 8 : index + 1).first, 20);
  if (has(vq4_mini_2_of_10_from_9) && index == 10)
    return (word & ~0x7c00u) | (bits(block, vq4_code(9).first, 20) & 0x7c00u);
  if (has(vq4_words_of_8_bits_ahead) && index == 8 && word == 0x3ffu << 10)
    return bits(block, code.first + 1, 19);
  return word;
}

std::uint8_t state_of_palette(unsigned word, int bit, int palette) {
  if ((word >> bit & 1u) != 0) return C;
  return (word >> palette & 1u) != 0 ? O : T;
}

std::uint8_t vq4_entry_state(unsigned index, unsigned word, Region p, Region shown) {
  const int r = p.x + 4 * p.y;
  if (index < 6) {
    if (has(vq4_simple_5_has_two_palettes) && index == 5 && p.y == 3 && p.x == 3 && word == 0x10000u)
      return C;
    return state_of_palette(word, r, 16);
  }
  if (index < 8) {
    bool second = index == 6 ? p.x >= 2 : p.y >= 2;
    if (has(vq4_partition_of_6_is_7) && index == 6) second = p.y >= 2;
    if (has(vq4_partition_not_turned)) second = index == 6 ? shown.x >= 2 : shown.y >= 2;
    if (has(vq4_partition_not_turned_for_6) && index == 6) second = shown.x >= 2;
    if (has(vq4_palettes_of_7_exchanged) && index == 7) second = !second;
    if (has(vq4_partition_by_columns_where_both_opaque) && index == 7 && (word >> 16 & 3u) == 1 &&
        (word & 0xffu) == 0x33u)
      second = p.x >= 2;
    return state_of_palette(word, r, second ? 17 : 16);
  }
  int mini = p.x / 2 + 2 * (p.y / 2);
  if (has(vq4_minis_column_by_column)) mini = p.y / 2 + 2 * (p.x / 2);
  const int bit = 5 * mini + p.x % 2 + 2 * (p.y % 2);
  int palette = 5 * mini + 4;
  if (has(vq4_mini_3_with_palette_of_2) && mini == 3) palette = 14;
  if (has(vq4_mini_3_with_palette_of_2_in_14) && mini == 3 && index == 14) palette = 14;
  if (has(vq4_mini_1_with_palette_of_0_if_mini_2_is_check) && mini == 1 && (word >> 10 & 15u) == 15 &&
      (word & 15u) == 9 && (word >> 15 & 15u) == 6)
    palette = 4;
  if (has(vq4_check_minis_lend_their_palette) && mini == 0 && (word >> 5 & 15u) == 15 &&
      (word >> 15 & 15u) == 15)
    palette = 14;
  return state_of_palette(word, bit, palette);
}

}  // namespace

std::uint8_t vq4_state(const std::uint8_t* block, int x, int y, Way way) {
  const int X = x / 4, Y = y / 4, quadrant = quadrant_of(X, Y);
  unsigned index = read_index(vq4, block, X, Y, way);
  if (index < 3) return static_cast<std::uint8_t>(index);
  const unsigned transform = read_transform(vq4, block, quadrant, index, way);
  const Region p = read_region(vq4, transform, quadrant, x, y);
  if (has(vq4_index_of_three_bits_in_bl) && quadrant == BL && index > 7) index &= 7u;
  if (index < 3) return static_cast<std::uint8_t>(index);
  if (has(vq4_index_13_is_12_in_tr) && index == 13 && quadrant == TR) index = 12;
  if (has(vq4_index_8_is_9_at_one_place) && index == 8 && X == 5 && Y == 2 && transform == 6) index = 9;
  return vq4_entry_state(index, vq4_word(block, index), p, {x % 4, y % 4});
}

}  // namespace mmverify::tests::foreign::vq
