#include "cli/bench/strips.hpp"

#include <fmt/format.h>

#include <iterator>

namespace mmverify::cli {
namespace {

using bench::Column;
using bench::Form;
using bench::Row;
using bench::RowLayout;
using bench::Table;
using bench::Value;

struct CellText {
  const bench::Print& print;

  std::string operator()(std::monostate) const { return print.none; }
  std::string operator()(std::uint64_t n) const { return fmt::format("{}", fmt::group_digits(n)); }
  std::string operator()(double value) const {
    const double x = value * print.factor;
    switch (print.type) {
      case 'e': return fmt::format("{:.{}e}", x, print.digits);
      case 'g': return fmt::format("{:.{}g}", x, print.digits);
      default: return fmt::format("{:.{}f}", x, print.digits);
    }
  }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<std::uint64_t>& numbers) const {
    return fmt::format("{}", fmt::join(numbers, " "));
  }
  std::string operator()(const std::vector<Row>&) const { return ""; }
};

bool is_text(const std::vector<Row>& rows, std::size_t k) {
  for (const Row& row : rows)
    if (row[k].index() != 0) return std::holds_alternative<std::string>(row[k]);
  return false;
}

Strip strip_of(const Column& column, const std::vector<Row>& rows, std::size_t k) {
  return {column.group, column.heading, printed_unit(column), column.leads, is_text(rows, k)};
}

const std::vector<Row>* rows_within(const Value& value) { return std::get_if<std::vector<Row>>(&value); }

/// The name of a row of an inner table. Members of a JSON object are written with underscores.
std::string name_of(const Column& column, const Row& row) {
  std::string name = text_of(column.columns[0], row[0]);
  if (column.form == Form::object) std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Column k as strips: for each figure, one strip for each name of the inner rows.
std::vector<Strip> beside(const Table& table, std::size_t k) {
  const Column& column = table.columns[k];
  std::vector<Row> names;  // of all rows, in order of appearance
  for (const Row& row : table.rows)
    if (const auto* rows = rows_within(row[k]))
      for (const Row& one : *rows)
        if (std::none_of(names.begin(), names.end(), [&](const Row& name) { return name[0] == one[0]; }))
          names.push_back(one);
  std::vector<Strip> strips;
  std::size_t figures = 0;
  for (std::size_t j = 1; j < column.columns.size(); ++j) figures += !column.columns[j].heading.empty();
  for (std::size_t j = 1; j < column.columns.size(); ++j) {
    const Column& figure = column.columns[j];
    if (figure.heading.empty()) continue;
    const std::string unit = printed_unit(figure);
    const std::string group = figures == 1 && !column.group.empty()
                                  ? column.group
                                  : figure.heading + (unit.empty() ? "" : ", " + unit);
    for (const Row& named : names) {
      Strip strip{group, name_of(column, named), "", false, is_text(names, j)};
      for (const Row& row : table.rows) {
        std::string cell = "-";
        if (const auto* rows = rows_within(row[k]))
          for (const Row& one : *rows)
            if (one[0] == named[0]) cell = text_of(figure, one[j]);
        strip.cells.push_back(cell);
      }
      strips.push_back(strip);
    }
  }
  return strips;
}

/// The number of lines in a row: as many as the longest inner table below it has rows.
std::size_t lines_of(const Table& table, const Row& row) {
  std::size_t lines = 1;
  for (std::size_t k = 0; k < row.size(); ++k)
    if (const auto* rows = rows_within(row[k]))
      if (table.columns[k].within == RowLayout::below && !table.columns[k].heading.empty())
        lines = std::max(lines, rows->size());
  return lines;
}

std::vector<Strip> below(const Table& table, std::size_t k) {
  std::vector<Strip> strips;
  const std::vector<Column>& columns = table.columns[k].columns;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j].heading.empty()) continue;
    Strip strip{table.columns[k].group, columns[j].heading, printed_unit(columns[j]), columns[j].leads, true};
    for (const Row& row : table.rows) {
      const std::vector<Row>& rows = *rows_within(row[k]);
      for (const Row& one : rows) strip.cells.push_back(text_of(columns[j], one[j]));
      strip.left = strip.left && is_text(rows, j);
      strip.cells.resize(strip.cells.size() + lines_of(table, row) - rows.size());
    }
    strips.push_back(strip);
  }
  return strips;
}

/// Moves the columns of a group together, to the place of the first.
std::vector<Strip> gathered(std::vector<Strip> strips) {
  std::vector<Strip> in_order;
  for (std::size_t k = 0; k < strips.size(); ++k) {
    const std::string group = strips[k].group;
    const auto alike = [&](const Strip& s) { return !group.empty() && s.group == group; };
    if (std::any_of(in_order.begin(), in_order.end(), alike)) continue;
    if (group.empty())
      in_order.push_back(strips[k]);
    else
      std::copy_if(strips.begin(), strips.end(), std::back_inserter(in_order), alike);
  }
  return in_order;
}

/// Turns rows that differ only in the last leading column into one row with an inner table.
Table spread(const Table& table) {
  std::size_t leading = 0;
  while (leading < table.columns.size() && table.columns[leading].leads) ++leading;
  const auto split = static_cast<std::ptrdiff_t>(leading - 1);
  Table spread{.key = table.key, .caption = table.caption};
  spread.columns.assign(table.columns.begin(), table.columns.begin() + split);
  spread.columns.push_back({.key = "",
                            .heading = "beside",
                            .columns = {table.columns.begin() + split, table.columns.end()},
                            .within = RowLayout::beside});
  for (const Row& row : table.rows) {
    const Row begin(row.begin(), row.begin() + split), rest(row.begin() + split, row.end());
    const auto same = [&](const Row& other) { return std::equal(begin.begin(), begin.end(), other.begin()); };
    auto at = std::find_if(spread.rows.begin(), spread.rows.end(), same);
    if (at == spread.rows.end()) {
      spread.rows.push_back(begin);
      spread.rows.back().push_back(std::vector<Row>{});
      at = spread.rows.end() - 1;
    }
    std::get<std::vector<Row>>(at->back()).push_back(rest);
  }
  return spread;
}

}  // namespace

std::string text_of(const Column& column, const Value& value) {
  return std::visit(CellText{column.print}, value);
}

std::string printed_unit(const Column& column) {
  return *column.print.unit == 0 ? column.unit : column.print.unit;
}

std::vector<Strip> strips_of(const Table& given) {
  const Table table = given.beside ? spread(given) : given;
  std::vector<Strip> strips;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    if (column.heading.empty()) continue;
    if (!column.columns.empty()) {
      const auto parts = column.within == RowLayout::beside ? beside(table, k) : below(table, k);
      strips.insert(strips.end(), parts.begin(), parts.end());
      continue;
    }
    Strip strip = strip_of(column, table.rows, k);
    for (const Row& row : table.rows) {
      strip.cells.push_back(text_of(column, row[k]));
      strip.cells.resize(strip.cells.size() + lines_of(table, row) - 1);
    }
    strips.push_back(strip);
  }
  return gathered(strips);
}

}  // namespace mmverify::cli
