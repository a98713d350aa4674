// Topic vq: a block's fields and its bits.
// Source: Compressed Opacity Maps, 4, 5.1, table 2, figure 11; the order of the bits: spec/vq/block.hpp, its head.
#include <cstdint>
#include <memory>
#include <utility>

#include "tests/foreign/inside/vq.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;
using proofs::Levels;

template <class Format>
constexpr std::uint32_t index_bits = Format::side == 2 ? 3 : 4;

template <class Format>
BlockBytes<Format> to_bytes(const Format& block, Fault wrong) {
  BlockBytes<Format> bytes;
  BitWriter out(bytes);
  for (std::uint32_t k = 0; k < 64; ++k) {
    std::uint32_t at = k;
    if (wrong == "index_order"_fault && (k == 36 || k == 27)) at = 63 - k;
    std::uint32_t index = block.indices[at];
    if (wrong == "saturated_index"_fault && k == 63 && index > 6) index = 6;
    if (wrong == "three_bits_meet"_fault && k == 40 && index == 7) index = 3;
    if (wrong == "index_and_transform_meet"_fault && k == 20 && index == 5 &&
        block.transforms[2].number() == 6)
      index = 2;
    out.put(index, index_bits<Format>);
  }
  const bool exchanged = wrong == "transforms_of_bl_and_br"_fault;
  for (const std::size_t q : {1u, exchanged ? 3u : 2u, exchanged ? 2u : 3u})
    out.put(block.transforms[q].number(), 3);
  if constexpr (Format::side == 2) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t code = block.shared[k];
      if (wrong == "transform_and_entry_meet"_fault && k == 2 && code == 31 &&
          block.transforms[3].number() == 7)
        code = 30;
      out.put(code, 5);
    }
    for (std::size_t k = 0; k < 8; ++k)
      out.put(wrong == "own_by_entry"_fault ? block.own[k % 4][k / 4] : block.own[k / 2][k % 2], 5);
  } else {
    for (std::size_t k = 0; k < 13; ++k) {
      std::uint32_t code = block.codebook[k], bits = entry_bits[k];
      if (wrong == "vertical_has_17_bits"_fault && k == 3) code &= 0x1ffff;
      if (wrong == "big_codes_lose_a_bit"_fault && k == 9 && (code & 0x8c631) == 0x8c631) code ^= 0x800;
      if (wrong == "generic_minis_turned"_fault && k == 12) code = (code << 5 | code >> 15) & 0xfffff;
      out.put(code, bits);
    }
  }
  if (wrong == "last_bit_lost"_fault) bytes.back() = static_cast<std::uint8_t>(bytes.back() & 0x7f);
  if (wrong == "neighbours_meet"_fault && (bytes[8] & 0x81) == 0x81)
    bytes[8] = static_cast<std::uint8_t>(bytes[8] ^ 1);
  return bytes;
}

template <class Format>
Format to_fields(const BlockBytes<Format>& bytes, Fault wrong) {
  Format block{};
  BitReader in(bytes);
  for (std::uint32_t k = 0; k < 64; ++k) {
    std::uint32_t at = k;
    if (wrong == "index_order"_fault && (k == 36 || k == 27)) at = 63 - k;
    block.indices[at] = static_cast<std::uint8_t>(in.take(index_bits<Format>));
  }
  const bool exchanged = wrong == "transforms_of_bl_and_br"_fault;
  for (const std::size_t q : {1u, exchanged ? 3u : 2u, exchanged ? 2u : 3u})
    block.transforms[q] = Transform::of(in.take(3));
  if (wrong == "reads_seven_as_zero"_fault && block.transforms[1].number() == 7) block.transforms[1] = {};
  if constexpr (Format::side == 2) {
    for (auto& code : block.shared) code = static_cast<std::uint8_t>(in.take(5));
    for (std::size_t k = 0; k < 8; ++k)
      (wrong == "own_by_entry"_fault ? block.own[k % 4][k / 4] : block.own[k / 2][k % 2]) =
          static_cast<std::uint8_t>(in.take(5));
  } else {
    for (std::size_t k = 0; k < 13; ++k) block.codebook[k] = in.take(entry_bits[k]);
    if (wrong == "generic_minis_turned"_fault)
      block.codebook[12] = (block.codebook[12] >> 5 | block.codebook[12] << 15) & 0xfffff;
  }
  if (wrong == "carries_between_fields"_fault && block.indices[5] == 7 && block.indices[6] == 7)
    block.indices[7] ^= 1;
  if (wrong == "depends_on_an_index"_fault && block.indices[0] == 6 && block.indices[63] == 1 &&
      block.indices[31] == 4)
    block.transforms[3].rotate_90 = !block.transforms[3].rotate_90;
  return block;
}

template <class Format>
Codec<Format> codec(Fault wrong) {
  Codec<Format> c;
  c.bytes = [wrong](const Format& block) { return to_bytes(block, wrong); };
  c.fields = [wrong](const BlockBytes<Format>& bytes) { return to_fields<Format>(bytes, wrong); };
  return c;
}

proofs::SubjectPtr subject(Fault wrong) {
  Functions parts;
  parts.vq2 = codec<Vq2>(wrong);
  parts.vq4 = codec<Vq4>(wrong);
  return std::make_shared<VqSubject>("foreign-blocks", "fields through a window of 32 bits",
                                     std::move(parts));
}

InsideFault row(const char* law, const char* name, const char* wrong) {
  const proofs::Level n = law[2] == '2' ? level_of<Vq2> : level_of<Vq4>;
  return {law, name, wrong, subject(named(name)), {n, n}};
}
constexpr char bits2[] = "vq2.block_bits", bits4[] = "vq4.block_bits";
constexpr char values2[] = "vq2.field_values", values4[] = "vq4.field_values";

}  // namespace

BlockBytes<Vq2> written(const Vq2& block) { return to_bytes(block, Fault::none); }
BlockBytes<Vq4> written(const Vq4& block) { return to_bytes(block, Fault::none); }

InsideRows faults_of_blocks() {
  return {
      row(bits2, "last_bit_lost", "the last bit is not written"),
      row(bits2, "neighbours_meet", "two bits of byte 8 share a place"),
      row(bits2, "transforms_of_bl_and_br", "the transforms of BL and BR change places, both ways"),
      row(bits2, "own_by_entry", "the quadrants' entries 6 come before their entries 7, both ways"),
      row(bits2, "index_order", "two vectors change places, both ways"),
      row(bits4, "neighbours_meet", "two bits of byte 8 share a place"),
      row(bits4, "vertical_has_17_bits", "the second palette of the vertical entry is lost"),
      row(bits4, "generic_minis_turned", "the minis of the last entry are turned, both ways"),
      row(values2, "saturated_index", "the last index is 6 at most"),
      row(values2, "three_bits_meet", "index 40 loses a bit where it is 7"),
      row(values2, "reads_seven_as_zero", "Rotate 270 in TR is read as the identity"),
      row(values2, "carries_between_fields", "two indices of 7 change the next one"),
      row(values2, "transform_and_entry_meet", "all ones in BR's transform and in entry 5 lose a bit"),
      row(values2, "index_and_transform_meet", "index 20 is 2 for 5 where BL is rotated by 180"),
      row(values2, "depends_on_an_index",
          "BR's transform is another where three indices have one value each"),
      row(values4, "saturated_index", "the last index is 6 at most"),
      row(values4, "big_codes_lose_a_bit", "entry 12 loses a bit where eight others are set"),
      row(values4, "reads_seven_as_zero", "Rotate 270 in TR is read as the identity"),
      row(values4, "index_and_transform_meet", "index 20 is 2 for 5 where BL is rotated by 180"),
  };
}

InsideRows right_blocks() {
  return {row(bits2, "writes", ""), row(bits4, "writes", ""), row(values2, "writes", ""),
          row(values4, "writes", "")};
}

}  // namespace mmverify::tests::foreign
