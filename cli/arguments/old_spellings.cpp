#include "cli/arguments/old_spellings.hpp"

#include <algorithm>

namespace mmverify::cli {

std::vector<std::string> in_todays_spelling(std::vector<std::string> arguments) {
  if (arguments.empty()) return arguments;
  const std::string option = "--attributes", value = option + "=";
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  if (arguments.front() == "scene") {
    const auto flag = std::find(arguments.begin(), end, option);
    if (flag == end) return arguments;
    arguments.erase(flag);
    arguments.front() = "attributes";
  } else if (arguments.front() == "render") {
    const auto at = std::find_if(arguments.begin(), end, [&](const std::string& argument) {
      return argument == option || argument.starts_with(value);
    });
    if (at == end) return arguments;
    at->replace(0, option.size(), "--level");
    arguments.front() = "views";
  }
  return arguments;
}

}  // namespace mmverify::cli
