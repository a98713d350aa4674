// A block as a row of fields, by a table of their places; spec/vq/block.hpp writes and reads them one by one.
#pragma once

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The source of the fields; docs/VQ.md has their order.
inline constexpr char figure_11[] = "Compressed Opacity Maps, 4, 4.1, 5.1, table 2 and figure 11";

template <class Format>
constexpr std::size_t entries = Format::side == 2 ? 11 : 13;  ///< codes in a codebook

/// The place of a field.
struct BitField {
  std::uint32_t first, bits;
};

template <class Format>
constexpr std::size_t fields_of = 64 + 3 + entries<Format>;

template <class Format>
constexpr std::array<BitField, fields_of<Format>> places = [] {
  std::array<BitField, fields_of<Format>> all{};
  std::size_t at = 0;
  const std::uint32_t index_bits = Format::side == 2 ? 3 : 4;
  for (std::uint32_t k = 0; k < 64; ++k) all[at++] = {index_bits * k, index_bits};
  const std::uint32_t turns = 64 * index_bits;
  for (std::uint32_t k = 0; k < 3; ++k) all[at++] = {turns + 3 * k, 3};
  if (Format::side == 2) {
    for (std::uint32_t k = 0; k < 11; ++k) all[at++] = {turns + 9 + 5 * k, 5};
  } else {
    for (std::uint32_t k = 0; k < 3; ++k) all[at++] = {turns + 9 + 17 * k, 17};
    for (std::uint32_t k = 0; k < 2; ++k) all[at++] = {turns + 60 + 18 * k, 18};
    for (std::uint32_t k = 0; k < 8; ++k) all[at++] = {turns + 96 + 20 * k, 20};
  }
  return all;
}();
static_assert(places<Vq2>.back().first + places<Vq2>.back().bits == 256);
static_assert(places<Vq4>.back().first + places<Vq4>.back().bits == 512);

/// The values of all fields.
template <class Format>
using Values = std::array<std::uint32_t, fields_of<Format>>;

template <class Format>
Format with(const Values<Format>& values) {
  Format f;
  for (std::size_t k = 0; k < 64; ++k) f.indices[k] = static_cast<std::uint8_t>(values[k]);
  for (std::size_t k = 0; k < 3; ++k) f.transforms[k + 1] = Transform::of(values[64 + k]);
  for (std::size_t k = 0; k < entries<Format>; ++k) {
    const std::uint32_t code = values[67 + k];
    if constexpr (Format::side == 2)
      (k < 3 ? f.shared[k] : f.own[(k - 3) / 2][(k - 3) % 2]) = static_cast<std::uint8_t>(code);
    else
      f.codebook[k] = code;
  }
  return f;
}

template <class Format>
BlockBytes<Format> bits_of_values(const Values<Format>& values) {
  BlockBytes<Format> block{};
  for (std::size_t k = 0; k < values.size(); ++k)
    for (std::uint64_t at = places<Format>[k].first, left = values[k]; left != 0;
         left >>= 8 - at % 8, at += 8 - at % 8)
      block[at / 8] = static_cast<std::uint8_t>(block[at / 8] | left << at % 8);
  return block;
}

template <class Format>
Values<Format> values_of_bits(const BlockBytes<Format>& block) {
  Values<Format> values;
  for (std::size_t field = 0; field < values.size(); ++field) {
    const BitField& place = places<Format>[field];
    std::uint32_t value = 0;
    for (std::uint32_t k = 0; k < place.bits; ++k)
      value |= (block[(place.first + k) / 8] >> ((place.first + k) % 8) & 1u) << k;
    values[field] = value;
  }
  return values;
}

}  // namespace mmverify::proofs::vq
