#include "scene/read/ktx2/uastc.hpp"

#include <algorithm>
#include <optional>

#include "scene/read/low_bits.hpp"

namespace mmverify::scene {
namespace {

struct UastcMode {
  unsigned code, code_bits;  ///< the bits that begin a block of the mode
  unsigned weight_bits;
  unsigned radix, end_bits;  ///< an end is digit * 2^end_bits + bits; the radix 1 has no digits
  unsigned components;       ///< of an end: luminance and alpha, RGB, RGBA
  unsigned subsets, planes;
};

constexpr UastcMode uastc_modes[] = {
    {0x01, 4, 4, 3, 6, 3, 1, 1}, {0x35, 6, 2, 1, 8, 3, 1, 1}, {0x1D, 5, 3, 1, 4, 3, 2, 1},
    {0x03, 5, 2, 3, 2, 3, 3, 1}, {0x13, 5, 2, 5, 3, 3, 2, 1}, {0x0B, 5, 3, 1, 8, 3, 1, 1},
    {0x1B, 5, 2, 5, 5, 3, 1, 2}, {0x07, 5, 2, 5, 3, 3, 2, 1}, {0x17, 5, 0, 0, 0, 4, 1, 1},
    {0x0F, 5, 2, 1, 4, 4, 2, 1}, {0x02, 3, 4, 3, 4, 4, 1, 1}, {0x00, 2, 2, 3, 4, 4, 1, 2},
    {0x06, 3, 3, 3, 6, 4, 1, 1}, {0x1F, 5, 1, 1, 8, 4, 1, 2}, {0x0D, 5, 2, 1, 8, 4, 1, 1},
    {0x05, 7, 4, 1, 8, 2, 1, 1}, {0x15, 6, 2, 1, 8, 2, 2, 1}, {0x25, 6, 2, 1, 8, 2, 1, 2},
    {0x09, 4, 5, 1, 5, 3, 1, 1}};

/// Bit t: the subset of texel t.
constexpr std::uint16_t patterns_of_two[] = {0xCCCC, 0x8888, 0x1111, 0xECC8, 0x377F, 0xFEEC, 0x0137, 0x137F,
                                             0xC800, 0x0013, 0xFE80, 0x17FF, 0x0017, 0x00FF, 0xFFF0, 0x0FFF,
                                             0xFF71, 0x8EFF, 0x08CE, 0x008C, 0x7310, 0xCEFF, 0x7331, 0x088C,
                                             0xCEEF, 0x6666, 0xF00F, 0x5555, 0x0F0F, 0x36C9};
constexpr std::uint16_t patterns_of_mode_7[] = {0x00F0, 0x4444, 0x0133, 0xCC80, 0xF0FF, 0x2222, 0xFFC8,
                                                0xCCCE, 0x3C03, 0x00EE, 0x7700, 0x3003, 0x00CE, 0xFF80,
                                                0x6FFF, 0x1333, 0x11FF, 0x136C, 0x00EF};
/// Bits 2t and 2t + 1: the subset of texel t.
constexpr std::uint32_t patterns_of_three[] = {0xA5A50000, 0xAA005555, 0xAA000055, 0x0000AA55,
                                               0x25252525, 0x94949494, 0x58585858, 0x56560202,
                                               0x92929292, 0x55AA0055, 0xA05050A0};

using Subsets = std::array<unsigned, 16>;

/// None for a pattern beyond the table.
std::optional<Subsets> subsets_of(unsigned mode, unsigned pattern) {
  Subsets subsets{};
  if (mode == 3) {
    if (pattern >= std::size(patterns_of_three)) return std::nullopt;
    for (unsigned t = 0; t < 16; ++t) subsets[t] = patterns_of_three[pattern] >> (2 * t) & 3;
    return subsets;
  }
  const std::span<const std::uint16_t> table =
      mode == 7 ? std::span<const std::uint16_t>(patterns_of_mode_7) : patterns_of_two;
  if (pattern >= table.size()) return std::nullopt;
  for (unsigned t = 0; t < 16; ++t) subsets[t] = table[pattern] >> t & 1u;
  return subsets;
}

/// An end of 8 bits by its digit and its bits: ASTC's unquantization of colours, in the letters of its table.
unsigned uastc_end(unsigned radix, unsigned end_bits, unsigned digit, unsigned bits) {
  if (radix == 1) {
    // The high bits are repeated below; 4, 5 and 8 bits occur.
    return end_bits == 8 ? bits : (bits << (8 - end_bits) | bits >> (2 * end_bits - 8)) & 0xff;
  }
  const unsigned a = (bits & 1) * 0x1ff, high = bits >> 1;
  unsigned b = 0, c = 0;
  if (radix == 3 && end_bits == 2) {
    b = high * 0x116, c = 93;
  } else if (radix == 3 && end_bits == 4) {
    b = high << 6 | high, c = 22;
  } else if (radix == 3) {
    b = high << 4 | high >> 4, c = 5;
  } else if (end_bits == 3) {
    b = high << 7 | high << 1 | high >> 1, c = 26;
  } else {
    b = high << 5 | high >> 3, c = 6;
  }
  const unsigned t = (digit * c + b) ^ a;
  return (a & 0x80) | t >> 2;
}

/// The digits of `count` ends: five of radix 3 in 8 bits, three of radix 5 in 7, the last group in fewer.
std::array<unsigned, 18> take_digits(LowBits& bits, unsigned radix, unsigned count) {
  constexpr unsigned bits_of_trits[] = {0, 2, 4, 5, 7, 8}, bits_of_quints[] = {0, 3, 5, 7};
  std::array<unsigned, 18> digits{};
  if (radix == 1) return digits;
  const unsigned most = radix == 3 ? 5 : 3;
  for (unsigned first = 0; first < count; first += most) {
    const unsigned held = std::min(most, count - first);
    unsigned packed = bits.take(radix == 3 ? bits_of_trits[held] : bits_of_quints[held]);
    for (unsigned k = first; k < first + held; ++k, packed /= radix) digits[k] = packed % radix;
  }
  return digits;
}

/// Ends of 8 bits: of subset s and channel c, low at [s][c][0] and high at [s][c][1].
using UastcEnds = std::array<std::array<std::array<unsigned, 2>, 4>, 3>;

UastcEnds take_ends(LowBits& bits, const UastcMode& mode) {
  const unsigned count = 2 * mode.components * mode.subsets;
  const std::array<unsigned, 18> digits = take_digits(bits, mode.radix, count);
  UastcEnds ends{};
  for (unsigned k = 0; k < count; ++k) {
    const unsigned end = uastc_end(mode.radix, mode.end_bits, digits[k], bits.take(mode.end_bits));
    const unsigned subset = k / (2 * mode.components), component = k / 2 % mode.components;
    auto& of_subset = ends[subset];
    if (mode.components > 2)
      of_subset[component][k % 2] = end;
    else if (component == 1)
      of_subset[3][k % 2] = end;
    else
      for (unsigned channel = 0; channel < 3; ++channel) of_subset[channel][k % 2] = end;
  }
  if (mode.components == 3)
    for (auto& of_subset : ends) of_subset[3] = {255, 255};
  return ends;
}

/// A weight of 64 by its bits: they are repeated to 6, and the upper half moves up by one.
unsigned uastc_weight(unsigned bits, unsigned weight) {
  unsigned of_63 = 0;
  for (unsigned filled = 0; filled < 6; filled += bits)
    of_63 |= filled + bits <= 6 ? weight << (6 - bits - filled) : weight >> (filled + bits - 6);
  return of_63 > 32 ? of_63 + 1 : of_63;
}

/// The weights of both planes, [texel][plane]; each subset's first texel lacks its highest bit.
std::array<std::array<unsigned, 2>, 16> take_weights(LowBits& bits, const UastcMode& mode,
                                                     const Subsets& subsets) {
  std::array<std::array<unsigned, 2>, 16> weights{};
  std::array<bool, 3> begun{};
  for (unsigned t = 0; t < 16; ++t) {
    const unsigned lacks = begun[subsets[t]] ? 0 : 1;
    begun[subsets[t]] = true;
    for (unsigned plane = 0; plane < mode.planes; ++plane)
      weights[t][plane] = uastc_weight(mode.weight_bits, bits.take(mode.weight_bits - lacks));
  }
  return weights;
}

std::uint8_t uastc_between(unsigned low, unsigned high, unsigned weight, bool srgb) {
  const auto wide = [srgb](unsigned end) { return end << 8 | (srgb ? 0x80 : end); };
  return static_cast<std::uint8_t>(((64 - weight) * wide(low) + weight * wide(high) + 32) >> 6 >> 8);
}

RgbaTexels one_colour(std::array<std::uint8_t, 4> colour) {
  RgbaTexels texels;
  texels.fill(colour);
  return texels;
}

std::optional<unsigned> uastc_mode(LowBits& bits, unsigned char first) {
  for (unsigned k = 0; k < std::size(uastc_modes); ++k)
    if ((first & ((1u << uastc_modes[k].code_bits) - 1)) == uastc_modes[k].code) {
      bits.take(uastc_modes[k].code_bits);
      return k;
    }
  return std::nullopt;
}

}  // namespace

RgbaTexels texels_of_uastc(std::span<const unsigned char> block, bool srgb) {
  constexpr std::array<std::uint8_t, 4> error{255, 0, 255, 255};
  constexpr unsigned solid = 8;
  LowBits bits(block);
  const std::optional<unsigned> number = uastc_mode(bits, block[0]);
  if (!number) return one_colour(error);
  if (*number == solid) {
    std::array<std::uint8_t, 4> colour;
    for (std::uint8_t& channel : colour) channel = static_cast<std::uint8_t>(bits.take(8));
    return one_colour(colour);
  }
  const UastcMode& mode = uastc_modes[*number];
  // Hints for BC1 and ETC1, which do not change the texels.
  const bool few_hints = *number >= 10 && *number <= 12, has_alpha = mode.components != 3;
  bits.take(few_hints ? 9 : 15);
  if (has_alpha && bits.take(8) >> 4 == 0) return one_colour(error);
  Subsets subsets{};
  if (mode.subsets > 1) {
    const auto of_pattern = subsets_of(*number, bits.take(mode.subsets == 3 ? 4 : 5));
    if (!of_pattern) return one_colour(error);
    subsets = *of_pattern;
  }
  // The channel that has the second plane.
  unsigned alone = 3;
  if (mode.planes == 2 && mode.components > 2) alone = bits.take(2);
  const UastcEnds ends = take_ends(bits, mode);
  const auto weights = take_weights(bits, mode, subsets);
  RgbaTexels texels;
  for (unsigned t = 0; t < 16; ++t)
    for (unsigned channel = 0; channel < 4; ++channel) {
      const auto& [low, high] = ends[subsets[t]][channel];
      const unsigned plane = mode.planes == 2 && channel == alone ? 1 : 0;
      texels[t][channel] = uastc_between(low, high, weights[t][plane], srgb);
    }
  return texels;
}

}  // namespace mmverify::scene
