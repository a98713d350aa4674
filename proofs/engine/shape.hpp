// Short texts split by a regular expression.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mmverify::proofs {

/// The groups of an ECMAScript regular expression that matches the whole text: [0] the text, [k] group k, empty if it
/// took no part.  Nothing if it does not match, or if the text is longer than `longest`: the standard library's
/// matcher recurses for each character.
inline constexpr std::size_t longest = 2048;
using Groups = std::optional<std::vector<std::string>>;
Groups groups_of(const std::string& text, const char* regex);

}  // namespace mmverify::proofs
