// Short texts taken apart by a regular expression.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mmverify::proofs {

/// What the groups of an ECMAScript regular expression hold where it fits the whole text: [0] the text, [k]
/// group k, empty where it took no part; nothing where it does not fit.
/// Nor does any text beyond `longest`: the standard library's matcher calls itself for each character.
inline constexpr std::size_t longest = 2048;
using Groups = std::optional<std::vector<std::string>>;
Groups groups_of(const std::string& text, const char* regex);

}  // namespace mmverify::proofs
