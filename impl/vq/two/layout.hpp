// Places and codes in a block of VQ2.  Internal to impl/vq.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "impl/vq/transform.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::vq::detail {

static_assert(std::endian::native == std::endian::little, "words are loaded as they lie");

/// The last word has the rest.
inline constexpr std::uint32_t indices_bits = 192;  // check-magic: 192 == 64 * 3

/// The places in the last word, in bits from the lowest on.
inline constexpr std::uint32_t transform_bits = 9, shared_at = 9;  // check-magic: 9 == 3 * 3
inline constexpr std::uint32_t own_at = 24;                        // check-magic: 24 == 9 + 3 * 5

constexpr std::uint32_t quadrant(std::uint32_t x, std::uint32_t y) noexcept {
  return (x < 8 ? 0 : 1) + (y < 8 ? 2 : 0);  // the quadrant of a region: TL, TR, BL, BR
}

/// The first bit of an entry's code.  Domain: index in 3..7.
constexpr std::uint32_t code_at(std::uint32_t quadrant, std::uint32_t index) noexcept {
  return index < 6 ? shared_at + 5 * (index - 3) : own_at + 10 * quadrant + 5 * (index - 6);
}

/// The bits of the last word for one region of an entry: whether it is C, and its palette.
struct Place2 {
  std::uint8_t checked, palette;
};
/// The places by quadrant, index and region; meaningless for the indices 0 to 2, which have no code.
inline constexpr auto places2 = [] {
  std::array<std::array<std::array<Place2, 4>, 8>, 4> table{};
  for (std::uint32_t q = 0; q < 4; ++q)
    for (std::uint32_t index = 3; index < 8; ++index)
      for (std::uint32_t k = 0; k < 4; ++k)
        table[q][index][k] = {static_cast<std::uint8_t>(code_at(q, index) + k),
                              static_cast<std::uint8_t>(code_at(q, index) + 4)};
  return table;
}();

inline std::uint64_t last_word(const Block2& block) noexcept {
  std::uint64_t word;
  std::memcpy(&word, block.data() + indices_bits / 8, sizeof word);
  return word;
}

/// The index of vector k = X + 8Y.
inline std::uint32_t index_of(const Block2& block, std::uint32_t k) noexcept {
  std::uint16_t two;
  std::memcpy(&two, block.data() + 3 * k / 8, sizeof two);
  return two >> (3 * k % 8) & 7u;
}

constexpr State picked(std::uint64_t code, std::uint32_t k) noexcept {
  const std::uint64_t checked = code >> k & 1, opaque = code >> 4 & 1;
  return static_cast<State>(checked | (opaque & ~checked) << 1);
}

/// The transform of a quadrant.  TL has none stored: the zeros shifted in are the identity.
constexpr std::uint32_t transform(std::uint64_t word, std::uint32_t quadrant) noexcept {
  return static_cast<std::uint32_t>(word << 3 >> (3 * quadrant)) & 7;
}

}  // namespace mmverify::impl::vq::detail
