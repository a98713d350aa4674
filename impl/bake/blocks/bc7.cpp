#include "impl/bake/blocks/bc7.hpp"

namespace mmverify::impl::bake::blocks {
namespace {

constexpr std::size_t texels = 16;

/// The bits of a block, one after another, each byte from its lowest bit on.  No mode has more than the block's 128.
class Bits {
 public:
  explicit Bits(std::span<const unsigned char> block) : block_(block) {}

  /// The next `count` bits, the first one lowest.
  unsigned take(unsigned count) {
    unsigned value = 0;
    for (unsigned k = 0; k < count; ++k, ++at_) value |= (block_[at_ / 8] >> (at_ % 8) & 1u) << k;
    return value;
  }

 private:
  std::span<const unsigned char> block_;
  std::size_t at_ = 0;
};

/// Bit t: the subset of texel t, of partitions of two subsets.
constexpr std::uint16_t partitions[64] = {
    0xCCCC, 0x8888, 0xEEEE, 0xECC8, 0xC880, 0xFEEC, 0xFEC8, 0xEC80, 0xC800, 0xFFEC, 0xFE80, 0xE800, 0xFFE8,
    0xFF00, 0xFFF0, 0xF000, 0xF710, 0x008E, 0x7100, 0x08CE, 0x008C, 0x7310, 0x3100, 0x8CCE, 0x088C, 0x3110,
    0x6666, 0x366C, 0x17E8, 0x0FF0, 0x718E, 0x399C, 0xAAAA, 0xF0F0, 0x5A5A, 0x33CC, 0x3C3C, 0x55AA, 0x9696,
    0xA55A, 0x73CE, 0x13C8, 0x324C, 0x3BDC, 0x6996, 0xC33C, 0x9966, 0x0660, 0x0272, 0x04E4, 0x4E40, 0x2720,
    0xC936, 0x936C, 0x39C6, 0x639C, 0x9336, 0x9CC6, 0x817E, 0xE718, 0xCCF0, 0x0FCC, 0x7744, 0xEE22};

/// The texel of the second subset whose index lacks its highest bit.
constexpr std::uint8_t second_anchors[64] = {15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15,
                                             15, 2,  8,  2,  2,  8,  8,  15, 2,  8,  2,  2,  8,  8,  2,  2,
                                             15, 15, 6,  8,  2,  8,  15, 15, 2,  8,  2,  2,  2,  15, 15, 6,
                                             6,  2,  6,  8,  15, 15, 2,  2,  15, 15, 15, 15, 15, 2,  2,  15};

constexpr std::uint8_t weights_2[] = {0, 21, 43, 64}, weights_3[] = {0, 9, 18, 27, 37, 46, 55, 64},
                       weights_4[] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};

unsigned weight(unsigned bits, unsigned index) {
  return bits == 2 ? weights_2[index] : bits == 3 ? weights_3[index] : weights_4[index];
}

/// A value of 4 to 8 bits as one of 8, its high bits repeated below.
unsigned of_8_bits(unsigned value, unsigned bits) { return value << (8 - bits) | value >> (2 * bits - 8); }

std::uint8_t between(unsigned e0, unsigned e1, unsigned w) {
  return static_cast<std::uint8_t>(((64 - w) * e0 + w * e1 + 32) >> 6);
}

using Indices = std::array<unsigned, texels>;

/// The indices of all texels; those of the anchors lack their highest bit.
Indices indices_of(Bits& bits, unsigned count, std::size_t second_anchor = 0) {
  Indices indices;
  for (std::size_t t = 0; t < texels; ++t)
    indices[t] = bits.take(count - (t == 0 || t == second_anchor ? 1 : 0));
  return indices;
}

/// Modes 4 and 5: alpha has ends and indices of its own, and may be exchanged with a colour.
std::array<std::uint8_t, texels> with_own_alpha(Bits& bits, bool is_mode_4) {
  const unsigned rotation = bits.take(2), exchanged = is_mode_4 ? bits.take(1) : 0;
  const unsigned colour_bits = is_mode_4 ? 5 : 7, alpha_bits = is_mode_4 ? 6 : 8;
  unsigned ends[4][2];
  for (unsigned channel = 0; channel < 4; ++channel)
    for (unsigned& end : ends[channel]) {
      const unsigned width = channel < 3 ? colour_bits : alpha_bits;
      end = of_8_bits(bits.take(width), width);
    }
  const unsigned second_bits = is_mode_4 ? 3 : 2;
  const Indices first = indices_of(bits, 2), second = indices_of(bits, second_bits);
  const unsigned channel = rotation == 0 ? 3 : rotation - 1;
  const bool by_first = (channel == 3) == (exchanged == 1);
  std::array<std::uint8_t, texels> alpha;
  for (std::size_t t = 0; t < texels; ++t)
    alpha[t] = between(ends[channel][0], ends[channel][1],
                       by_first ? weight(2, first[t]) : weight(second_bits, second[t]));
  return alpha;
}

std::array<std::uint8_t, texels> of_mode_6(Bits& bits) {
  for (int colours = 0; colours < 6; ++colours) bits.take(7);
  unsigned ends[2] = {bits.take(7), 0};
  ends[1] = bits.take(7);
  for (unsigned& end : ends) end = end << 1 | bits.take(1);
  const Indices indices = indices_of(bits, 4);
  std::array<std::uint8_t, texels> alpha;
  for (std::size_t t = 0; t < texels; ++t) alpha[t] = between(ends[0], ends[1], weight(4, indices[t]));
  return alpha;
}

std::array<std::uint8_t, texels> of_mode_7(Bits& bits) {
  const unsigned partition = bits.take(6);
  for (int colours = 0; colours < 12; ++colours) bits.take(5);
  unsigned ends[4];
  for (unsigned& end : ends) end = bits.take(5);
  for (unsigned& end : ends) end = of_8_bits(end << 1 | bits.take(1), 6);
  const Indices indices = indices_of(bits, 2, second_anchors[partition]);
  std::array<std::uint8_t, texels> alpha;
  for (std::size_t t = 0; t < texels; ++t) {
    const std::size_t subset = partitions[partition] >> t & 1u;
    alpha[t] = between(ends[2 * subset], ends[2 * subset + 1], weight(2, indices[t]));
  }
  return alpha;
}

}  // namespace

std::array<std::uint8_t, 16> alpha_of_bc7(std::span<const unsigned char> block) {
  Bits bits(block);
  unsigned mode = 0;
  while (mode < 8 && bits.take(1) == 0) ++mode;
  std::array<std::uint8_t, texels> alpha;
  switch (mode) {
    case 4:
    case 5: return with_own_alpha(bits, mode == 4);
    case 6: return of_mode_6(bits);
    case 7: return of_mode_7(bits);
    default: alpha.fill(mode < 4 ? 255 : 0); return alpha;
  }
}

}  // namespace mmverify::impl::bake::blocks
