// Places and codes in a block of VQ4.  Internal to impl/vq.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "impl/vq/transform.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq::detail {

static_assert(std::endian::native == std::endian::little, "words are loaded as they lie");

/// The transform of a quadrant TL, TR, BL or BR.  TL has none stored: the zeros shifted in are the identity.
inline std::uint32_t transform4(const std::uint8_t* block, std::uint32_t quadrant) noexcept {
  std::uint16_t three;
  std::memcpy(&three, block + 32, sizeof three);
  return (std::uint32_t{three} << 3 >> (3 * quadrant)) & 7;
}

/// The first bit of the code of each index from 3 on; table 2.
inline constexpr auto code_at4 = [] {
  std::array<std::uint16_t, 17> at{};
  std::uint16_t next = 265;  // check-magic: 265 == 64 * 4 + 3 * 3
  for (std::uint32_t index = 3; index < 17; ++index) {
    at[index] = next;
    next = static_cast<std::uint16_t>(next + (index < 6 ? 17 : index < 8 ? 18 : 20));
  }
  return at;
}();
static_assert(code_at4[16] == 512);

/// The 20 bits from the code of an index on; the code may be shorter.
inline std::uint32_t code4(const std::uint8_t* block, std::uint32_t index) noexcept {
  const std::uint32_t byte = std::min(code_at4[index] / 8u, 56u);
  std::uint64_t word;
  std::memcpy(&word, block + byte, sizeof word);
  return static_cast<std::uint32_t>(word >> (code_at4[index] - 8 * byte)) & 0xfffff;
}

/// The kind of each index's code: 0 simple, 1 vertical, 2 horizontal, 3 generic.
inline constexpr std::array<std::uint8_t, 16> kind4{0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 3};

/// The bits of the block for one region of an entry: whether it is C, and its palette.
struct Place4 {
  std::uint16_t checked, palette;
};
/// The places by index and region; meaningless for the indices 0 to 2, which have no code.
inline constexpr auto places4 = [] {
  std::array<std::array<Place4, 16>, 16> table{};
  for (std::uint32_t index = 3; index < 16; ++index)
    for (std::uint32_t k = 0; k < 16; ++k) {
      const std::uint32_t x = k % 4, y = k / 4, mini = 5 * (x / 2 + 2 * (y / 2));
      const std::uint32_t kind = kind4[index];
      const std::uint32_t checked = kind == 3 ? mini + x % 2 + 2 * (y % 2) : k;
      const std::uint32_t palette = kind == 3 ? mini + 4 : 16 + (kind == 1 ? x / 2 : kind == 2 ? y / 2 : 0);
      table[index][k] = {static_cast<std::uint16_t>(code_at4[index] + checked),
                         static_cast<std::uint16_t>(code_at4[index] + palette)};
    }
  return table;
}();

/// The states of every index, 16 bytes each.
using Codebook = std::array<std::array<std::uint8_t, 16>, 16>;

/// Spreads eight bits to eight bytes of 0 or 1.
constexpr std::uint64_t bytes_of_bits(std::uint64_t bits) noexcept {
  const std::uint64_t apart = (bits & 0xff) * 0x0101010101010101 & 0x8040201008040201;
  return (apart + 0x7f7f7f7f7f7f7f7f) >> 7 & 0x0101010101010101;
}

inline Codebook codebook(const std::uint8_t* block) noexcept {
  Codebook vectors;
  for (std::uint32_t index = 0; index < 3; ++index) vectors[index].fill(static_cast<std::uint8_t>(index));
  for (std::uint32_t index = 3; index < 16; ++index) {
    const std::uint32_t code = code4(block, index), kind = kind4[index];
    // `checked` has a bit a region in order; `opaque` has a byte of ones for each region with the palette {O, C}.
    // Columns 0 and 1 of two rows are bytes 0, 1, 4 and 5.
    constexpr std::uint64_t left = 0x0000ffff0000ffff, right = ~left;
    const auto ones = [code](std::uint32_t bit) { return 0 - std::uint64_t{code >> bit & 1}; };
    std::uint32_t checked = code & 0xffff;
    std::uint64_t opaque[2];
    if (kind == 0) {
      opaque[0] = opaque[1] = ones(16);
    } else if (kind == 1) {
      opaque[0] = opaque[1] = (ones(16) & left) | (ones(17) & right);
    } else if (kind == 2) {
      opaque[0] = ones(16);
      opaque[1] = ones(17);
    } else {
      checked = 0;
      for (std::uint32_t mini = 0; mini < 4; ++mini) {
        const std::uint32_t bits = code >> (5 * mini), corner = 2 * (mini % 2) + 8 * (mini / 2);
        checked |= (bits & 3) << corner | (bits >> 2 & 3) << (corner + 4);
      }
      opaque[0] = (ones(4) & left) | (ones(9) & right);
      opaque[1] = (ones(14) & left) | (ones(19) & right);
    }
    for (std::uint32_t half = 0; half < 2; ++half) {
      const std::uint64_t c = bytes_of_bits(checked >> (8 * half));
      const std::uint64_t states = c | (opaque[half] & ((c ^ 0x0101010101010101) << 1));
      std::memcpy(vectors[index].data() + 8 * half, &states, sizeof states);
    }
  }
  return vectors;
}

}  // namespace mmverify::impl::vq::detail
