#include "cli/bench/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/arguments.hpp"

namespace mmverify::cli {
namespace {

using bench::Column;
using bench::Form;
using bench::Row;
using bench::Table;
using bench::Value;
using bench::Within;

constexpr std::size_t widest = 150;
constexpr std::size_t gap = 2, gap_of_groups = 4;

struct CellText {
  const bench::Print& print;

  std::string operator()(std::monostate) const { return print.none; }
  std::string operator()(std::uint64_t n) const { return grouped(n); }
  std::string operator()(double value) const {
    const double x = value * print.factor;
    switch (print.type) {
      case 'e':
        return fmt::format("{:.{}e}", x, print.digits);
      case 'g':
        return fmt::format("{:.{}g}", x, print.digits);
      default:
        return fmt::format("{:.{}f}", x, print.digits);
    }
  }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<std::uint64_t>& numbers) const {
    return fmt::format("{}", fmt::join(numbers, " "));
  }
  std::string operator()(const std::vector<Row>&) const { return ""; }
};

std::string text_of(const Column& column, const Value& value) {
  return std::visit(CellText{column.print}, value);
}

std::string printed_unit(const Column& column) {
  return *column.print.unit == 0 ? column.unit : column.print.unit;
}

/// A column as it is printed, with its cells, a line each.
struct Strip {
  std::string group, heading, unit;
  bool leads = false, left = false;
  std::vector<std::string> cells = {};

  std::size_t width() const {
    std::size_t width = std::max(heading.size(), unit.size());
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    return width;
  }
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

/// What names a row of a table within.  Members of an object in JSON are written with underscores.
std::string name_of(const Column& column, const Row& row) {
  std::string name = text_of(column.columns[0], row[0]);
  if (column.form == Form::object) std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Column k, a figure after the other: each under the names of the rows within.
std::vector<Strip> beside(const Table& table, std::size_t k) {
  const Column& column = table.columns[k];
  const std::vector<Row>* most = nullptr;
  for (const Row& row : table.rows)
    if (const auto* rows = rows_within(row[k]); rows && (most == nullptr || rows->size() > most->size()))
      most = rows;
  std::vector<Strip> strips;
  if (most == nullptr) return strips;
  std::size_t figures = 0;
  for (std::size_t j = 1; j < column.columns.size(); ++j) figures += !column.columns[j].heading.empty();
  for (std::size_t j = 1; j < column.columns.size(); ++j) {
    const Column& figure = column.columns[j];
    if (figure.heading.empty()) continue;
    const std::string unit = printed_unit(figure);
    const std::string group = figures == 1 && !column.group.empty()
                                  ? column.group
                                  : figure.heading + (unit.empty() ? "" : ", " + unit);
    for (const Row& named : *most) {
      Strip strip{group, name_of(column, named), "", false, is_text(*most, j)};
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

/// How many lines a row takes: as many as the rows of a table below it.
std::size_t lines_of(const Table& table, const Row& row) {
  std::size_t lines = 1;
  for (std::size_t k = 0; k < row.size(); ++k)
    if (const auto* rows = rows_within(row[k]))
      if (table.columns[k].within == Within::below && !table.columns[k].heading.empty())
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

/// Columns of one group next to one another, where the first of them is.
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

std::vector<Strip> strips_of(const Table& table) {
  std::vector<Strip> strips;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    if (column.heading.empty()) continue;
    if (!column.columns.empty()) {
      const auto parts = column.within == Within::beside ? beside(table, k) : below(table, k);
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

/// A table whose rows differ in the last leading column alone, as one with these as a table within.
Table spread(const Table& table) {
  std::size_t leading = 0;
  while (leading < table.columns.size() && table.columns[leading].leads) ++leading;
  const auto split = static_cast<std::ptrdiff_t>(leading - 1);
  Table spread{.key = table.key, .caption = table.caption, .note = table.note};
  spread.columns.assign(table.columns.begin(), table.columns.begin() + split);
  spread.columns.push_back({.key = "",
                            .heading = "beside",
                            .columns = {table.columns.begin() + split, table.columns.end()},
                            .within = Within::beside});
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

/// Columns that are printed together, and the blanks before each.
struct Block {
  std::vector<Strip> strips;
  std::vector<std::size_t> blanks = {};
  std::size_t width = 0;

  void append(const Strip& strip) {
    const bool apart = !strips.empty() && strips.back().group != strip.group;
    blanks.push_back(strips.empty() ? 0 : apart ? gap_of_groups : gap);
    width += blanks.back() + strip.width();
    strips.push_back(strip);
  }
};

/// The end of the group that begins at k.
std::size_t group_end(const std::vector<Strip>& strips, std::size_t k) {
  std::size_t end = k + 1;
  while (end < strips.size() && !strips[k].group.empty() && strips[end].group == strips[k].group) ++end;
  return end;
}

/// Parts that are no wider than a line; a group is divided only where it is wider than that alone.
std::vector<Block> parted(const std::vector<Strip>& strips) {
  Block leading;
  std::vector<Strip> others;
  for (const Strip& strip : strips)
    if (strip.leads)
      leading.append(strip);
    else
      others.push_back(strip);
  std::vector<Block> parts{leading};
  for (std::size_t k = 0; k < others.size();) {
    const std::size_t end = group_end(others, k);
    Block whole = parts.back();
    for (std::size_t j = k; j < end; ++j) whole.append(others[j]);
    if (whole.width <= widest) {
      parts.back() = whole;
    } else {
      if (parts.back().strips.size() > leading.strips.size()) parts.push_back(leading);
      for (std::size_t j = k; j < end; ++j) {
        Block longer = parts.back();
        longer.append(others[j]);
        if (longer.width > widest && parts.back().strips.size() > leading.strips.size()) {
          parts.push_back(leading);
          parts.back().append(others[j]);
        } else {
          parts.back() = longer;
        }
      }
    }
    k = end;
  }
  return parts;
}

void print_line(std::FILE* out, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  fmt::print(out, "{}\n", line);
}

/// The names of the groups, each over the middle of its columns, which make room for a longer one.
std::string groups_line(Block& block) {
  std::string line;
  for (std::size_t k = 0, end = 0; k < block.strips.size(); k = end) {
    end = group_end(block.strips, k);
    const std::string& name = block.strips[k].group;
    std::size_t width = block.strips[k].width();
    for (std::size_t j = k + 1; j < end; ++j) width += block.blanks[j] + block.strips[j].width();
    line.append(block.blanks[k], ' ');
    line += fmt::format("{:^{}}", name, width);
    if (name.size() > width) block.blanks[k] += name.size() - width;
  }
  return line;
}

void print_block(std::FILE* out, Block block) {
  const auto has = [&](std::string Strip::*text) {
    return std::any_of(block.strips.begin(), block.strips.end(),
                       [&](const Strip& s) { return !(s.*text).empty(); });
  };
  if (has(&Strip::group)) print_line(out, groups_line(block));
  const auto print = [&](auto text) {
    std::string line;
    for (std::size_t k = 0; k < block.strips.size(); ++k) {
      const Strip& strip = block.strips[k];
      line.append(block.blanks[k], ' ');
      line += strip.left ? fmt::format("{:<{}}", text(strip), strip.width())
                         : fmt::format("{:>{}}", text(strip), strip.width());
    }
    print_line(out, line);
  };
  print([](const Strip& strip) { return strip.heading; });
  if (has(&Strip::unit)) print([](const Strip& strip) { return strip.unit; });
  for (std::size_t line = 0; line < block.strips.front().cells.size(); ++line)
    print([line](const Strip& strip) { return strip.cells[line]; });
}

/// Figures beside no others: "heading  value unit", a line each.
void print_members(std::FILE* out, const Table& table) {
  Strip headings, values;
  std::vector<std::string> units;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    if (column.heading.empty() || table.rows.front()[k].index() == 0) continue;
    headings.cells.push_back(column.heading);
    values.cells.push_back(text_of(column, table.rows.front()[k]));
    units.push_back(printed_unit(column));
  }
  for (std::size_t k = 0; k < units.size(); ++k)
    print_line(out, fmt::format("{:<{}}  {:>{}} {}", headings.cells[k], headings.width(), values.cells[k],
                                values.width(), units[k]));
}

void print_table(std::FILE* out, const Table& table) {
  if (!table.caption.empty()) fmt::print(out, "{}\n", table.caption);
  if (table.form == Form::members) {
    print_members(out, table);
  } else {
    bool first = true;
    for (const Block& part : parted(strips_of(table.beside ? spread(table) : table))) {
      fmt::print(out, "{}", first ? "" : "\n");
      print_block(out, part);
      first = false;
    }
  }
  if (!table.note.empty()) fmt::print(out, "{}\n", table.note);
}

bool is_printed(const Table& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const Column& c) { return !c.heading.empty(); });
}

}  // namespace

void print_result(std::FILE* out, const bench::Result& result) {
  std::string settings;
  for (const auto& [name, value] : result.settings)
    settings += (settings.empty() ? "" : ", ") + fmt::format("{} {}", name, text_of({}, value));
  fmt::print(out, "{}{}{}\n{}", result.topic, settings.empty() ? "" : ": ", settings,
             result.about.empty() ? "" : result.about + "\n");
  for (const Table& table : result.tables)
    if (is_printed(table)) {
      fmt::print(out, "\n");
      print_table(out, table);
    }
}

}  // namespace mmverify::cli
