#include "cli/arguments/nearest_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace mmverify::cli {
namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::size_t edit_distance(const std::string& a, const std::string& b) {
  const std::string from = in_lower_case(a), to = in_lower_case(b);
  // Row i has the distances of the first i letters of `from` to each beginning of `to`.
  std::vector<std::vector<std::size_t>> d(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i)
    for (std::size_t j = 0; j <= to.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[from.size()][to.size()];
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  // A hostile argument may have megabytes; no known word has 64 letters.
  if (word.size() > 64) return {};
  const auto begins = [&](const std::string& one) { return !word.empty() && one.starts_with(word); };
  if (std::count_if(known.begin(), known.end(), begins) == 1)
    return *std::find_if(known.begin(), known.end(), begins);
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  std::string nearest;
  for (const std::string& one : known) {
    const std::size_t distance = edit_distance(word, one);
    if (distance == least && one != nearest) nearest.clear();
    if (distance >= least) continue;
    least = distance;
    nearest = one;
  }
  return nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

}  // namespace mmverify::cli
