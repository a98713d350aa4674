#include "cli/bench/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

namespace mmverify::cli {
namespace {

using bench::Column;
using bench::Form;
using bench::Row;
using bench::Value;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

/// The plain figures of a row by their names, tables within included.
struct Line {
  std::vector<std::pair<std::string, std::string>> fields = {};

  void add(const std::string& before, const std::vector<Column>& columns, const Row& row) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (!columns[k].key.name.empty()) add(before + columns[k].key.name, columns[k], row[k]);
  }

  void add(const std::string& name, const Column& column, const Value& value) {
    if (const auto* rows = std::get_if<std::vector<Row>>(&value)) {
      for (std::size_t k = 0; k < rows->size(); ++k) {
        const auto* key = std::get_if<std::string>(&(*rows)[k].front());
        add(fmt::format("{}.{}.", name, key != nullptr ? *key : std::to_string(k)), column.columns,
            (*rows)[k]);
      }
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      fields.emplace_back(name, csv_field(*text));
    } else if (const auto* whole = std::get_if<std::uint64_t>(&value)) {
      fields.emplace_back(name, std::to_string(*whole));
    } else if (const auto* real = std::get_if<double>(&value)) {
      fields.emplace_back(name, fmt::format("{}", *real));
    } else if (const auto* list = std::get_if<std::vector<std::uint64_t>>(&value)) {
      fields.emplace_back(name, fmt::format("{}", fmt::join(*list, " ")));
    }
  }
};

std::string csv(const bench::Table& table) {
  std::vector<std::map<std::string, std::string>> lines;
  std::vector<std::string> names;  // in the order in which they come first
  for (const Row& row : table.rows) {
    Line line;
    line.add("", table.columns, row);
    lines.emplace_back();
    for (const auto& [name, value] : line.fields) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      lines.back()[name] = value;
    }
  }
  std::string out = fmt::format("{}\n", fmt::join(names, ","));
  for (auto& line : lines) {
    std::vector<std::string> values;
    for (const std::string& name : names) values.push_back(line[name]);
    out += fmt::format("{}\n", fmt::join(values, ","));
  }
  return out;
}

}  // namespace

std::string result_csv(const bench::Result& result) {
  std::string out;
  for (const bench::Table& table : result.tables)
    if (table.form != Form::printed) out += (out.empty() ? "" : "\n") + csv(table);
  return out;
}

}  // namespace mmverify::cli
