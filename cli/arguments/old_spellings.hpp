// Spellings of commands that earlier versions had.
#pragma once

#include <string>
#include <vector>

namespace mmverify::cli {

/// The arguments, without the program's name, in today's spelling: `scene --attributes` is `attributes`, and
/// `render --attributes A..B` is `views --level A..B`. All others are as they were.
std::vector<std::string> in_todays_spelling(std::vector<std::string> arguments);

}  // namespace mmverify::cli
