// A table of a family by the names of its columns.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families.hpp"
#include "delivery/vectors/forms/part.hpp"

namespace mmverify::tests {

/// A family by its name, made once.
inline const vectors::Family& family(const std::string& name) {
  for (const vectors::FamilyRow& row : vectors::families())
    if (row.name == name) {
      static std::vector<std::pair<std::string, vectors::Family>> made;
      for (const auto& [known, family] : made)
        if (known == name) return family;
      made.reserve(vectors::families().size());
      return made.emplace_back(name, row.make()).second;
    }
  throw std::invalid_argument("no family " + name);
}

class Reading {
 public:
  Reading(const vectors::Family& family, const std::string& table) : family_(family) {
    for (const vectors::Table& t : family.tables)
      if (t.name == table) table_ = &t;
    if (table_ == nullptr) throw std::invalid_argument("no table " + table);
  }

  std::size_t size() const { return table_->records(); }

  /// The first word, as it is.
  std::uint32_t operator()(std::size_t record, const std::string& column) const {
    return words(record, column)[0];
  }
  vectors::Optional optional(std::size_t record, const std::string& column) const {
    const auto value = words(record, column);
    if (value.size() != 2 || value[1] > 1) throw std::invalid_argument("no optional number: " + column);
    return value[1] != 0 ? vectors::Optional(value[0]) : vectors::none;
  }
  std::uint64_t wide(std::size_t record, const std::string& column) const {
    return vectors::wide_at(words(record, column));
  }
  float number(std::size_t record, const std::string& column) const {
    return std::bit_cast<float>((*this)(record, column));
  }
  vectors::Bytes part(std::size_t record, const std::string& column) const {
    const auto bytes = vectors::part_at(family_, words(record, column));
    return {bytes.begin(), bytes.end()};
  }
  std::vector<std::uint32_t> word_list(std::size_t record, const std::string& column) const {
    std::vector<std::uint32_t> list;
    const vectors::Bytes bytes = part(record, column);
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
      list.push_back(0);
      for (std::size_t k = 0; k < 4; ++k) list.back() |= std::uint32_t{bytes[at + k]} << 8 * k;
    }
    return list;
  }
  std::string about(std::size_t record) const { return family_.abouts.at((*this)(record, "about")); }

 private:
  std::span<const std::uint32_t> words(std::size_t record, const std::string& column) const {
    std::span<const std::uint32_t> found;
    vectors::for_each_value(*table_, record,
                            [&](const vectors::Column& c, std::span<const std::uint32_t> words) {
                              if (c.name == column) found = words;
                            });
    if (found.empty()) throw std::invalid_argument("no column " + column);
    return found;
  }

  const vectors::Family& family_;
  const vectors::Table* table_ = nullptr;
};

}  // namespace mmverify::tests
