// Builds a family record by record and stores its texts and bytes beside the records.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

/// A number of Kind::optional: any 32-bit word, or none.
using Optional = std::optional<std::uint32_t>;
inline constexpr Optional none;

/// The value of one column: a word, an optional one, a wide number or a set, a text of Kind::about, bytes, or words.
struct Value
    : std::variant<std::uint32_t, Optional, std::uint64_t, std::string, Bytes, std::vector<std::uint32_t>> {
  using variant::variant;
  template <std::unsigned_integral Narrow>
  requires(sizeof(Narrow) < sizeof(std::uint32_t)) Value(Narrow word) : variant(std::uint32_t{word}) {}
};

/// Builds a family. Its tables are filled one after another.
class Builder {
 public:
  Builder(std::string name, std::uint32_t version, std::string about);

  /// Begins a table; later records go into it.
  void table(std::string name, std::string about, std::vector<Column> columns);

  /// Adds a record: a value for each column, in their order. Equal bytes and texts are stored once.
  /// Errors: std::logic_error if a value does not match its column.
  void add(std::initializer_list<Value> values);

  /// The number of records in the current table.
  std::uint32_t count() const;

  Family take() { return std::move(family_); }

 private:
  std::uint32_t text(const std::string& about);
  std::uint32_t stored(std::span<const std::uint8_t> bytes);

  Family family_;
};

}  // namespace mmverify::vectors
