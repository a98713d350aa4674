// The known word that a misspelt one is nearest to.
#pragma once

#include <string>
#include <vector>

namespace mmverify::cli {

/// The number of letters to insert, drop, replace or exchange with their neighbour to turn one word into the
/// other, upper and lower case alike. Each letter takes part in one change at most.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The one known word that begins with the word; else the one at the least edit_distance(), empty if that is above a third
/// of the word's letters, or if two words are equally near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

/// "; did you mean 'index'?", or nothing if no known word is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace mmverify::cli
