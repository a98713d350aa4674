#include "subjects/source/circuit/patterns.hpp"

namespace mmverify::source::circuit {
namespace {

void set_state(std::vector<Values>& map, unsigned bits, std::size_t state, std::size_t k,
               std::uint64_t value) {
  for (unsigned bit = 0; bit < bits; ++bit) {
    std::uint64_t& word = map[state * bits + bit].words[k / 64];
    const std::uint64_t here = std::uint64_t{1} << k % 64;
    word = (value >> bit & 1) != 0 ? word | here : word & ~here;
  }
}

}  // namespace

void Patterns::fill(std::vector<Values>& map, unsigned bits, unsigned level, std::size_t first, std::size_t k,
                    unsigned uniform_in_100) {
  const std::size_t states = std::size_t{1} << 2 * level;
  if (level == 0 || random() % 100 < uniform_in_100) {
    const std::uint64_t value = random();
    for (std::size_t s = 0; s < states; ++s) set_state(map, bits, first + s, k, value);
    return;
  }
  for (std::size_t child = 0; child < 4; ++child)
    fill(map, bits, level - 1, first + child * states / 4, k, uniform_in_100);
}

void Patterns::map(unsigned level, unsigned bits) {
  const std::size_t states = std::size_t{1} << 2 * level;
  std::vector<Values> map(states * bits);
  for (std::size_t k = 0; k < pattern_count; ++k) {
    // Eight kinds of maps, from noise to large uniform subtrees; in every ninth pattern one state differs alone.
    const bool needle = k % 9 == 8;
    fill(map, bits, level, 0, k, needle ? 100 : static_cast<unsigned>(k % 8 * 9));
    if (needle) set_state(map, bits, random() % states, k, random());
  }
  waiting_.insert(waiting_.end(), map.begin(), map.end());
}

Values Patterns::next() {
  Values values;
  if (waiting_.empty()) {
    for (std::uint64_t& word : values.words) word = random();
    return values;
  }
  values = waiting_.front();
  waiting_.pop_front();
  return values;
}

}  // namespace mmverify::source::circuit
