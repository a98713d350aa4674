#include "cli/bench/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/bench/strips.hpp"
#include "cli/output/streams.hpp"

namespace mmverify::cli {
namespace {

using bench::Column;
using bench::Form;
using bench::Table;

constexpr std::size_t widest = 150;
constexpr std::size_t gap = 2, gap_of_groups = 4;

/// Columns that are printed together, with the number of blanks before each.
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

/// Splits the columns into blocks no wider than a line; a group is split only if it is wider than a line
/// itself.
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
  say(out, "{}\n", line);
}

/// The line with the groups' names, centred over their columns; a longer name widens them.
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

/// Prints the figures of a table with one row: "heading  value unit", a line each.
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
  if (!table.caption.empty()) say(out, "{}\n", table.caption);
  if (table.form == Form::members) {
    print_members(out, table);
  } else {
    bool first = true;
    for (const Block& part : parted(strips_of(table))) {
      say(out, "{}", first ? "" : "\n");
      print_block(out, part);
      first = false;
    }
  }
}

bool is_printed(const Table& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const Column& c) { return !c.heading.empty(); });
}

}  // namespace

void print_result(std::FILE* out, const bench::Result& result) {
  std::string settings;
  for (const auto& [key, value] : result.settings)
    settings += (settings.empty() ? "" : ", ") + fmt::format("{} {}", key.name, text_of({}, value));
  say(out, "{}{}{}\n{}", result.topic, settings.empty() ? "" : ": ", settings,
      result.about.empty() ? "" : result.about + "\n");
  for (const Table& table : result.tables)
    if (is_printed(table)) {
      say(out, "\n");
      print_table(out, table);
    }
}

}  // namespace mmverify::cli
