#include "bench/papers/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace mmverify::bench::papers {
namespace {

/// 1234567 as 1,234,567; other numbers with four significant digits.
std::string rounded(double value) {
  if (std::isnan(value)) return "-";
  if (std::abs(value) < 1000) return fmt::format("{:.4g}", value);
  std::string digits = fmt::format("{:.0f}", value);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// The papers print three digits behind the point at most.
std::string printed(double value) {
  if (value == std::floor(value)) return rounded(value);
  std::string digits = fmt::format("{:.3f}", value);
  return digits.substr(0, digits.find_last_not_of('0') + 1);
}

std::string joined(const std::vector<double>& values, const char* between, std::string (*text_of)(double)) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : between) + text_of(value);
  return text;
}

std::string theirs(const Number& number) {
  if (!number.printed.empty()) return number.printed;
  return joined(number.theirs, number.theirs.size() == 2 ? " to " : "; ", printed);
}

/// Ours over theirs in words: "0.52", "within", "0.9 to 1.2", or nothing.
std::string ratios(const Number& number, const std::vector<double>& ours) {
  if (number.theirs.empty() || ours.empty()) return {};
  std::vector<double> all;
  for (const double one : ours) all.push_back(ratio(number, one));
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  if (!std::isfinite(*least) || !std::isfinite(*most) || *least < 0) return {};
  if (*least == 1 && *most == 1 && number.theirs.size() > 1) return "within";
  const std::string low = fmt::format("{:.3g}", *least), high = fmt::format("{:.3g}", *most);
  return low == high ? low : low + " to " + high;
}

/// A number of a paper beside ours, as texts.
struct Beside {
  std::string what, theirs, ours, ratio;
};
Beside beside(const Number& number, Measured& measured) {
  const std::vector<double> ours = number.ours ? number.ours(measured) : std::vector<double>();
  const auto with_unit = [&](std::string text) {
    return text.empty() || number.unit.empty() ? text : text + " " + number.unit;
  };
  return {number.what, with_unit(theirs(number)), with_unit(joined(ours, "; ", rounded)),
          ratios(number, ours)};
}

std::string commands(const std::string& show) {
  static const std::regex between("; ");
  return show.empty() ? "" : "`" + std::regex_replace(show, between, "`; `") + "`";
}

std::string linked_names(const std::string& text) {
  static const std::regex name("\\b([A-Z_]+)[.]md\\b");
  return std::regex_replace(text, name, "[$1.md]($1.md)");
}

std::string markdown(const Grid& grid) {
  const auto row = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = row(grid.heading) + row(std::vector<std::string>(grid.heading.size(), "---"));
  for (const auto& cells : grid.rows) text += row(cells);
  return text;
}

constexpr char introduction[] =
    R"(# The papers beside this project

Each figure, table, algorithm, equation and numbered claim of five sources, with its place here, the paper's numbers and
ours. `mmverify paper` prints any row (`mmverify paper som --figure 5`), and `mmverify paper -o DIR` writes a page a
paper, with the tables and pictures that can be made here; `./run tables` writes this page. The last column leaves out
the word `mmverify`: type it before each command. FILE is a glTF scene of yours, since the papers do not ship theirs.

Status *ok*: it is here, and as far as it has numbers, one of ours equals the paper's, lies in its range, or keeps its
bound. *differs*: it is here with other numbers or another reading, for the reason given. *not here*: the reason is
given.

Numbers of ours are those of the suite's own scene and of 60 generated leaves, unless the row names others: small, free,
and the same everywhere. `--scenes DIR` and `--textures DIR` take others in their place. Two numbers of ours for
attributes are the own scene's and a quad's, unless the line names levels (the first and the last), assets, or "least;
greatest".

*Ratio* is our number divided by the paper's. Where the paper gives a range, or a list by scene, the ratio is `within`
if ours lies between its ends, else ours divided by the nearest end. Several numbers of ours have a least and a greatest
ratio. [ERRATA.md](ERRATA.md) has the claims that are wrong or open.
)";

}  // namespace

std::string lines(const Paper& paper, const Item& item, Measured& measured) {
  std::string text = fmt::format("{} {}: {} ({})\n", paper.id, item.id, item.what, to_string(item.status));
  for (const Number& number : item.numbers) {
    const auto [what, theirs, ours, ratio] = beside(number, measured);
    text += fmt::format("  {}: paper {}, here {}{}\n", what, theirs.empty() ? "a picture" : theirs,
                        ours.empty() ? "nothing" : ours, ratio.empty() ? "" : ", ratio " + ratio);
  }
  text += fmt::format("  why   {}\n", item.why);
  if (!item.show.empty())
    text +=
        fmt::format("  show  mmverify {}\n", std::regex_replace(item.show, std::regex("; "), "; mmverify "));
  return text;
}

std::string table(const Paper& paper, Measured& measured, bool linked) {
  Grid grid{
      {"item", "in the paper", "paper", "here", "ratio", "status", "where, or why not", "command or law"},
      {}};
  for (const Item& item : paper.items) {
    grid.rows.push_back({item.id, item.what, "", "", "", to_string(item.status),
                         linked ? linked_names(item.why) : item.why, commands(item.show)});
    for (const Number& number : item.numbers) {
      const auto [what, theirs, ours, ratio] = beside(number, measured);
      grid.rows.push_back({"", "- " + what, theirs, ours, ratio, "", "", ""});
    }
  }
  return markdown(grid);
}

std::string index(Measured& measured) {
  std::string text = introduction;
  for (const Paper& paper : all())
    text += fmt::format("\n## {}\n\n{}", paper.title, table(paper, measured, true));
  return text;
}

std::string page(const Paper& paper, Measured& measured, const std::vector<PictureLink>& pictures) {
  std::string text = fmt::format("# {}\n\n{}", paper.title, table(paper, measured, false));
  for (const Item& item : paper.items) {
    std::string below;
    if (item.grid)
      if (const Grid grid = item.grid(measured); !grid.rows.empty()) below += "\n" + markdown(grid);
    if (item.on_this_machine)
      if (const Grid times = item.on_this_machine(measured); !times.rows.empty())
        below += "\nOn this machine, another time at each run:\n\n" + markdown(times);
    for (const PictureLink& picture : pictures)
      if (picture.item == item.id)
        below += fmt::format("\n![{}]({})\n\n{}\n", picture.caption, picture.file, picture.caption);
    if (!below.empty()) text += fmt::format("\n## {}: {}\n{}", item.id, item.what, below);
  }
  return text;
}

}  // namespace mmverify::bench::papers
