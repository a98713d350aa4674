#include "impl/bake/blocks/bc.hpp"

namespace mmverify::impl::bake::blocks {

std::array<std::uint8_t, 16> alpha_of_bc1(std::span<const unsigned char> block) {
  constexpr int transparent = 3;
  const auto colour = [&](std::size_t at) { return block[at] | block[at + 1] << 8; };
  const bool punches = colour(0) <= colour(2);
  std::array<std::uint8_t, 16> alpha;
  for (std::size_t k = 0; k < 16; ++k)
    alpha[k] = punches && (block[4 + k / 4] >> (2 * (k % 4)) & 3) == transparent ? 0 : 255;
  return alpha;
}

std::array<std::uint8_t, 16> alpha_of_bc2(std::span<const unsigned char> block) {
  std::array<std::uint8_t, 16> alpha;
  for (std::size_t k = 0; k < 16; ++k)
    alpha[k] = static_cast<std::uint8_t>((block[k / 2] >> (4 * (k % 2)) & 15) * 17);
  return alpha;
}

std::array<std::uint16_t, 16> alpha_of_bc3(std::span<const unsigned char> block) {
  const std::uint32_t a0 = block[0], a1 = block[1], steps = a0 > a1 ? 7 : 5;
  std::array<std::uint16_t, 8> values{};
  for (std::uint32_t code = 0; code < 8; ++code) {
    // The last two codes of a block of fifths are 0 and 1.
    const bool between = steps == 7 || code < 6;
    const std::uint32_t i = code == 0 ? 0 : code == 1 ? steps : code - 1;
    // 65535 = 257 * 255, so that the ends are exact.
    if (between)
      values[code] =
          static_cast<std::uint16_t>((2 * 257 * ((steps - i) * a0 + i * a1) + steps) / (2 * steps));
  }
  if (steps == 5) values[7] = 65535;
  std::array<std::uint16_t, 16> alpha;
  for (std::size_t k = 0; k < 16; ++k) {
    std::size_t code = 0;
    for (std::size_t bit = 0; bit < 3; ++bit) {
      const std::size_t at = 16 + 3 * k + bit;
      code |= (block[at / 8] >> (at % 8) & std::size_t{1}) << bit;
    }
    alpha[k] = values[code];
  }
  return alpha;
}

}  // namespace mmverify::impl::bake::blocks
