#include "delivery/vectors/builder.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace mmverify::vectors {
namespace {

Bytes little_endian(std::span<const std::uint32_t> words) {
  Bytes bytes;
  for (const std::uint32_t word : words)
    for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>(word >> 8 * k));
  return bytes;
}

}  // namespace

Builder::Builder(std::string name, std::uint32_t version, std::string about)
    : family_{std::move(name), version, std::move(about)} {}

void Builder::table(std::string name, std::string about, std::vector<Column> columns) {
  family_.tables.push_back({std::move(name), std::move(about), std::move(columns)});
}

void Builder::add(std::initializer_list<Value> values) {
  Table& table = family_.tables.back();
  if (values.size() != table.columns.size())
    throw std::logic_error("vectors: " + table.name + ": not a value a column");
  auto value = values.begin();
  for (const Column& column : table.columns) {
    const Value& v = *value++;
    const auto wrong = [&] { return std::logic_error("vectors: " + table.name + "." + column.name); };
    const auto put_part = [&](std::span<const std::uint8_t> bytes) {
      table.words.push_back(stored(bytes));
      table.words.push_back(static_cast<std::uint32_t>(bytes.size()));
    };
    if (const auto* word = std::get_if<std::uint32_t>(&v); word != nullptr && words_of(column.kind) == 1) {
      if (column.kind == Kind::name && *word >= column.names.size()) throw wrong();
      table.words.push_back(*word);
    } else if (const auto* number = std::get_if<Optional>(&v);
               number != nullptr && column.kind == Kind::optional) {
      table.words.push_back(number->value_or(0));
      table.words.push_back(number->has_value() ? 1 : 0);
    } else if (const auto* wide = std::get_if<std::uint64_t>(&v);
               wide != nullptr && (column.kind == Kind::wide || column.kind == Kind::set)) {
      if (*wide >> 53 != 0) throw wrong();
      table.words.push_back(static_cast<std::uint32_t>(*wide));
      table.words.push_back(static_cast<std::uint32_t>(*wide >> 32));
    } else if (const auto* about = std::get_if<std::string>(&v);
               about != nullptr && column.kind == Kind::about) {
      table.words.push_back(text(*about));
    } else if (const auto* bytes = std::get_if<Bytes>(&v);
               bytes != nullptr && (column.kind == Kind::bytes || column.kind == Kind::digits)) {
      put_part(*bytes);
    } else if (const auto* list = std::get_if<std::vector<std::uint32_t>>(&v);
               list != nullptr && (column.kind == Kind::words || column.kind == Kind::binary32s)) {
      put_part(little_endian(*list));
    } else {
      throw wrong();
    }
  }
}

std::uint32_t Builder::count() const { return static_cast<std::uint32_t>(family_.tables.back().records()); }

std::uint32_t Builder::text(const std::string& about) {
  if (about.empty() || about.size() > longest_about)
    throw std::logic_error("vectors: a text of no length that is due: " + about);
  const auto at = std::find(family_.abouts.begin(), family_.abouts.end(), about);
  if (at != family_.abouts.end()) return static_cast<std::uint32_t>(at - family_.abouts.begin());
  family_.abouts.push_back(about);
  return static_cast<std::uint32_t>(family_.abouts.size() - 1);
}

/// The offset of `bytes` in the family's data, a multiple of 4. They are appended unless the data has them
/// already.
std::uint32_t Builder::stored(std::span<const std::uint8_t> bytes) {
  Bytes& data = family_.data;
  for (std::size_t at = 0; at + bytes.size() <= data.size(); at += 4)
    if (std::equal(bytes.begin(), bytes.end(), data.begin() + static_cast<std::ptrdiff_t>(at)))
      return static_cast<std::uint32_t>(at);
  const std::size_t at = data.size();
  data.insert(data.end(), bytes.begin(), bytes.end());
  while (data.size() % 4 != 0) data.push_back(0);
  return static_cast<std::uint32_t>(at);
}

}  // namespace mmverify::vectors
