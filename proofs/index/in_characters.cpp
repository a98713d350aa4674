#include "proofs/index/in_characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "proofs/index/picture.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index {
namespace {

/// The laws whose two answers are indices of the case's level, and the order of these indices.
constexpr std::array<std::pair<std::string_view, Order>, 8> laws_of_indices{
    {{"index.equals_reference", Order::curve},
     {"index.rounding", Order::curve},
     {"index.exact_on_floats", Order::curve},
     {"index.exact_or_published", Order::curve},
     {"index.equals_published", Order::curve},
     {"index.exact_on_doubles", Order::curve},
     {"index.row_order", Order::rows},
     {"index.row_exact_on_floats", Order::rows}}};

std::optional<std::uint32_t> index_in(const std::string& text) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

/// The micro-triangle with an index: its grid square, and which half of the square.
MicroTriangle place_of(std::uint32_t index, Level n, Order order) {
  const spec::index::Corners corners =
      order == Order::curve ? spec::index::corners(index, n) : spec::index::w_minor_corners(index);
  std::uint32_t i = corners[0].i, j = corners[0].j;
  for (const auto& corner : corners) {
    i = std::min(i, corner.i);
    j = std::min(j, corner.j);
  }
  const bool upright = std::any_of(corners.begin(), corners.end(),
                                   [&](const auto& corner) { return corner.i == i && corner.j == j; });
  return {i, j, !upright};
}

}  // namespace

std::vector<std::string> in_characters(const Result& result, const Counterexample& c) {
  const auto law = std::find_if(laws_of_indices.begin(), laws_of_indices.end(),
                                [&](const auto& one) { return one.first == result.law; });
  const Level n = result.at_once.empty() ? result.level : c.level;
  const auto expected = index_in(c.expected), got = index_in(c.got);
  if (law == laws_of_indices.end() || n > 16 || !expected || !got || *expected >= triangle_count(n))
    return {};
  const bool in_range = *got < triangle_count(n);
  const MicroTriangle right = place_of(*expected, n, law->second);
  const MicroTriangle wrong = in_range ? place_of(*got, n, law->second) : right;

  constexpr std::uint32_t rows = 5, before = 2;
  const std::uint32_t all = side(n), shown = std::min(rows, all);
  const auto first = [&](std::uint32_t at) { return std::min(at < before ? 0 : at - before, all - shown); };
  const std::uint32_t i0 = first(right.i), j0 = first(right.j);
  std::vector<std::string> lines;
  bool is_seen = false;
  for (std::uint32_t j = j0 + shown; j-- > j0;) {
    std::string line(6 + (j - j0), ' ');
    for (std::uint32_t i = i0; i < i0 + shown; ++i)
      for (const bool upside_down : {false, true}) {
        if (i + j + (upside_down ? 1 : 0) >= all) continue;
        const auto is = [&](const MicroTriangle& t) {
          return t.i == i && t.j == j && t.inverted == upside_down;
        };
        const bool is_wrong = in_range && is(wrong);
        is_seen = is_seen || is_wrong;
        line += is(right) ? 'E' : is_wrong ? 'G' : upside_down ? 'v' : '^';
      }
    if (line.find_first_not_of(' ') != std::string::npos) lines.push_back(line);
  }
  lines.push_back(fmt::format("  E: {} expected; G: {} returned{}", *expected, *got,
                              !in_range ? ", which is no index of this level"
                              : is_seen ? ""
                                        : ", outside of this part"));
  return lines;
}

}  // namespace mmverify::proofs::index
