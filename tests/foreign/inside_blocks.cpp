// Topic vq: a block's fields and its bits.
// Source: Compressed Opacity Maps, 4, 5.1, table 2, figure 11; the order of the bits: spec/vq/block.hpp, its head.
#include <cstdint>
#include <memory>
#include <utility>

#include "tests/foreign/inside_vq.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;
using proofs::Levels;

enum class Wrong {
  nothing,
  last_bit_lost,
  neighbours_meet,
  transforms_of_bl_and_br,
  own_by_entry,
  index_order,
  saturated_index,
  carries_between_fields,
  three_bits_meet,
  transform_and_entry_meet,
  vertical_has_17_bits,
  big_codes_lose_a_bit,
  generic_minis_turned,
  reads_seven_as_zero,
  depends_on_an_index,
  index_and_transform_meet,
};

template <class Format>
constexpr std::uint32_t index_bits = Format::side == 2 ? 3 : 4;

template <class Format>
BlockBytes<Format> to_bytes(const Format& block, Wrong wrong) {
  BlockBytes<Format> bytes;
  BitWriter out(bytes);
  for (std::uint32_t k = 0; k < 64; ++k) {
    std::uint32_t at = k;
    if (wrong == Wrong::index_order && (k == 36 || k == 27)) at = 63 - k;
    std::uint32_t index = block.indices[at];
    if (wrong == Wrong::saturated_index && k == 63 && index > 6) index = 6;
    if (wrong == Wrong::three_bits_meet && k == 40 && index == 7) index = 3;
    if (wrong == Wrong::index_and_transform_meet && k == 20 && index == 5 &&
        block.transforms[2].number() == 6)
      index = 2;
    out.put(index, index_bits<Format>);
  }
  const bool exchanged = wrong == Wrong::transforms_of_bl_and_br;
  for (const std::size_t q : {1u, exchanged ? 3u : 2u, exchanged ? 2u : 3u})
    out.put(block.transforms[q].number(), 3);
  if constexpr (Format::side == 2) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t code = block.shared[k];
      if (wrong == Wrong::transform_and_entry_meet && k == 2 && code == 31 &&
          block.transforms[3].number() == 7)
        code = 30;
      out.put(code, 5);
    }
    for (std::size_t k = 0; k < 8; ++k)
      out.put(wrong == Wrong::own_by_entry ? block.own[k % 4][k / 4] : block.own[k / 2][k % 2], 5);
  } else {
    for (std::size_t k = 0; k < 13; ++k) {
      std::uint32_t code = block.codebook[k], bits = entry_bits[k];
      if (wrong == Wrong::vertical_has_17_bits && k == 3) code &= 0x1ffff;
      if (wrong == Wrong::big_codes_lose_a_bit && k == 9 && (code & 0x8c631) == 0x8c631) code ^= 0x800;
      if (wrong == Wrong::generic_minis_turned && k == 12) code = (code << 5 | code >> 15) & 0xfffff;
      out.put(code, bits);
    }
  }
  if (wrong == Wrong::last_bit_lost) bytes.back() = static_cast<std::uint8_t>(bytes.back() & 0x7f);
  if (wrong == Wrong::neighbours_meet && (bytes[8] & 0x81) == 0x81)
    bytes[8] = static_cast<std::uint8_t>(bytes[8] ^ 1);
  return bytes;
}

template <class Format>
Format to_fields(const BlockBytes<Format>& bytes, Wrong wrong) {
  Format block{};
  BitReader in(bytes);
  for (std::uint32_t k = 0; k < 64; ++k) {
    std::uint32_t at = k;
    if (wrong == Wrong::index_order && (k == 36 || k == 27)) at = 63 - k;
    block.indices[at] = static_cast<std::uint8_t>(in.take(index_bits<Format>));
  }
  const bool exchanged = wrong == Wrong::transforms_of_bl_and_br;
  for (const std::size_t q : {1u, exchanged ? 3u : 2u, exchanged ? 2u : 3u})
    block.transforms[q] = Transform::of(in.take(3));
  if (wrong == Wrong::reads_seven_as_zero && block.transforms[1].number() == 7) block.transforms[1] = {};
  if constexpr (Format::side == 2) {
    for (auto& code : block.shared) code = static_cast<std::uint8_t>(in.take(5));
    for (std::size_t k = 0; k < 8; ++k)
      (wrong == Wrong::own_by_entry ? block.own[k % 4][k / 4] : block.own[k / 2][k % 2]) =
          static_cast<std::uint8_t>(in.take(5));
  } else {
    for (std::size_t k = 0; k < 13; ++k) block.codebook[k] = in.take(entry_bits[k]);
    if (wrong == Wrong::generic_minis_turned)
      block.codebook[12] = (block.codebook[12] >> 5 | block.codebook[12] << 15) & 0xfffff;
  }
  if (wrong == Wrong::carries_between_fields && block.indices[5] == 7 && block.indices[6] == 7)
    block.indices[7] ^= 1;
  if (wrong == Wrong::depends_on_an_index && block.indices[0] == 6 && block.indices[63] == 1 &&
      block.indices[31] == 4)
    block.transforms[3].rotate_90 = !block.transforms[3].rotate_90;
  return block;
}

template <class Format>
Codec<Format> codec(Wrong wrong) {
  Codec<Format> c;
  c.bytes = [wrong](const Format& block) { return to_bytes(block, wrong); };
  c.fields = [wrong](const BlockBytes<Format>& bytes) { return to_fields<Format>(bytes, wrong); };
  return c;
}

proofs::SubjectPtr subject(Wrong wrong) {
  Functions parts;
  parts.vq2 = codec<Vq2>(wrong);
  parts.vq4 = codec<Vq4>(wrong);
  return std::make_shared<VqSubject>("foreign-blocks", "fields through a window of 32 bits",
                                     std::move(parts));
}

InsideFault row(const char* law, const char* name, const char* wrong, Wrong which) {
  const proofs::Level n = law[2] == '2' ? level_of<Vq2> : level_of<Vq4>;
  return {law, name, wrong, subject(which), {n, n}};
}
constexpr char bits2[] = "vq2.block_bits", bits4[] = "vq4.block_bits";
constexpr char values2[] = "vq2.field_values", values4[] = "vq4.field_values";

}  // namespace

BlockBytes<Vq2> written(const Vq2& block) { return to_bytes(block, Wrong::nothing); }
BlockBytes<Vq4> written(const Vq4& block) { return to_bytes(block, Wrong::nothing); }

InsideRows faults_of_blocks() {
  return {
      row(bits2, "last_bit_lost", "the last bit is not written", Wrong::last_bit_lost),
      row(bits2, "neighbours_meet", "two bits of byte 8 share a place", Wrong::neighbours_meet),
      row(bits2, "transforms_of_bl_and_br", "the transforms of BL and BR change places, both ways",
          Wrong::transforms_of_bl_and_br),
      row(bits2, "own_by_entry", "the quadrants' entries 6 come before their entries 7, both ways",
          Wrong::own_by_entry),
      row(bits2, "index_order", "two vectors change places, both ways", Wrong::index_order),
      row(bits4, "neighbours_meet", "two bits of byte 8 share a place", Wrong::neighbours_meet),
      row(bits4, "vertical_has_17_bits", "the second palette of the vertical entry is lost",
          Wrong::vertical_has_17_bits),
      row(bits4, "generic_minis_turned", "the minis of the last entry are turned, both ways",
          Wrong::generic_minis_turned),
      row(values2, "saturated_index", "the last index is 6 at most", Wrong::saturated_index),
      row(values2, "three_bits_meet", "index 40 loses a bit where it is 7", Wrong::three_bits_meet),
      row(values2, "reads_seven_as_zero", "Rotate 270 in TR is read as the identity",
          Wrong::reads_seven_as_zero),
      row(values2, "carries_between_fields", "two indices of 7 change the next one",
          Wrong::carries_between_fields),
      row(values2, "transform_and_entry_meet", "all ones in BR's transform and in entry 5 lose a bit",
          Wrong::transform_and_entry_meet),
      row(values2, "index_and_transform_meet", "index 20 is 2 for 5 where BL is rotated by 180",
          Wrong::index_and_transform_meet),
      row(values2, "depends_on_an_index", "BR's transform is another where three indices have one value each",
          Wrong::depends_on_an_index),
      row(values4, "saturated_index", "the last index is 6 at most", Wrong::saturated_index),
      row(values4, "big_codes_lose_a_bit", "entry 12 loses a bit where eight others are set",
          Wrong::big_codes_lose_a_bit),
      row(values4, "reads_seven_as_zero", "Rotate 270 in TR is read as the identity",
          Wrong::reads_seven_as_zero),
      row(values4, "index_and_transform_meet", "index 20 is 2 for 5 where BL is rotated by 180",
          Wrong::index_and_transform_meet),
  };
}

InsideRows right_blocks() {
  return {row(bits2, "writes", "", Wrong::nothing), row(bits4, "writes", "", Wrong::nothing),
          row(values2, "writes", "", Wrong::nothing), row(values4, "writes", "", Wrong::nothing)};
}

}  // namespace mmverify::tests::foreign
