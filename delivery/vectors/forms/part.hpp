// Access to a record's values by column, for all forms.
#pragma once

#include <cstdint>
#include <span>

#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

/// The 64-bit value of a wide number or a set.
constexpr std::uint64_t wide_at(std::span<const std::uint32_t> words) {
  return words[0] | std::uint64_t{words[1]} << 32;
}

/// The part of the family's data that two words refer to.
inline std::span<const std::uint8_t> part_at(const Family& family, std::span<const std::uint32_t> words) {
  return std::span(family.data).subspan(words[0], words[1]);
}

/// Calls each(column, its words) for each column of a record.
template <class Each>
void for_each_value(const Table& table, std::size_t record, Each each) {
  std::size_t at = 0;
  const auto words = table.record(record);
  for (const Column& column : table.columns) {
    each(column, words.subspan(at, words_of(column.kind)));
    at += words_of(column.kind);
  }
}

/// The word as 8 hexadecimal digits.
inline std::string hex(std::uint32_t word) {
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 15];
  return text;
}

}  // namespace mmverify::vectors
