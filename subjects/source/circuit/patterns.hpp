// Inputs that a graph is simulated on: random bits, and maps with uniform subtrees.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace mmverify::source::circuit {

/// Words of 64 values that are simulated at once.
inline constexpr std::size_t pattern_words = 32;
inline constexpr std::size_t pattern_count = 64 * pattern_words;

/// The values of one literal in all patterns.
struct Values {
  std::uint64_t words[pattern_words] = {};
};

class Patterns {
 public:
  /// The next 4^level * bits calls of next() are the bits of a map's states, state by state.
  void map(unsigned level, unsigned bits);
  /// An input's values.
  Values next();
  /// 64 random bits.
  std::uint64_t random() { return generator_(); }

 private:
  /// Fills 4^level states of pattern k from `first` on: one random state, or its four children.
  void fill(std::vector<Values>& map, unsigned bits, unsigned level, std::size_t first, std::size_t k,
            unsigned uniform_in_100);

  // The seed is fixed: a run can be repeated.
  std::mt19937_64 generator_{7};
  std::deque<Values> waiting_;
};

}  // namespace mmverify::source::circuit
