#include "impl/tree_pyramid.hpp"

#include <algorithm>
#include <stdexcept>

namespace mmverify::impl::tree::detail {
namespace {

constexpr std::uint64_t nibbles = 0x1111111111111111, pairs = 0x0303030303030303, bytes = 0x0101010101010101;

/// One bit a nibble: any of the four flags.
constexpr std::uint64_t any_of_four(std::uint64_t flags) noexcept {
  flags |= flags >> 1;
  return gather_nibbles((flags | flags >> 2) & nibbles);
}

/// What a word of children makes of their parents: 16 bits of states; of flags, 16 of 2-state, 8 of 4-state.
struct Parents {
  std::uint64_t mixed, states;
};

/// A parent is internal where a child is or where the first states of its children differ.
constexpr Parents parents_two(std::uint64_t mixed, std::uint64_t states) noexcept {
  const std::uint64_t first = states & nibbles;
  return {any_of_four(mixed | (states ^ first * 15)), gather_nibbles(first)};
}

constexpr Parents parents_four(std::uint64_t mixed, std::uint64_t states) noexcept {
  const std::uint64_t first = states & pairs;
  std::uint64_t differ = states ^ first * 0x55;
  differ |= differ >> 4;
  differ |= differ >> 2;
  differ = (differ | differ >> 1) & bytes;
  // A flag a byte, to the even nibbles' lowest bits, is eight flags.
  differ = (differ | differ >> 7) & 0x0003000300030003;
  differ = (differ | differ >> 14) & 0x0000000f0000000f;
  differ = (differ | differ >> 28) & 0xff;
  return {any_of_four(mixed) | differ, gather_pairs(first)};
}

constexpr std::size_t words_for(std::uint64_t bits) noexcept {
  return static_cast<std::size_t>((bits + 63) / 64);
}

constexpr std::uint64_t nodes_at(Level d) noexcept { return std::uint64_t{1} << (2 * d); }

}  // namespace

void require_map(Level n, Bits b, std::size_t map_bytes) {
  if (n > max_level) throw std::invalid_argument("tree: the level is above 12");
  if (b != Bits::two_state && b != Bits::four_state)
    throw std::invalid_argument("tree: a state has 1 or 2 bits");
  if (map_bytes != bytes_for(nodes_at(n) * static_cast<std::uint32_t>(b)))
    throw std::invalid_argument("tree: the map is not ceil(4^level * bits / 8) bytes long");
}

Pyramid::Pyramid(Level n, Bits b, std::span<const std::uint8_t> map) : b_(static_cast<std::uint32_t>(b)) {
  const Level depths = std::max<Level>(n, 1);
  std::size_t size = 0;
  for (Level d = 0; d < depths; ++d) {
    mixed_at_[d] = size;
    size += words_for(nodes_at(d));
  }
  mixed_at_[depths] = size;
  for (Level d = 0; d < depths; ++d) {
    states_at_[d] = size;
    size += words_for(nodes_at(d) * b_);
  }
  words_.assign(size, 0);

  if (n == 0) {
    words_[states_at_[0]] = map[0] & low_bits(b_);
    return;
  }
  // Depth n is the map itself, and no node of it is internal.
  const std::uint64_t states_bits = nodes_at(n) * b_;
  for (Level d = n; d-- > 0;) {
    const std::size_t count = words_for(nodes_at(d + 1) * b_);
    auto* const mixed = reinterpret_cast<std::uint8_t*>(words_.data() + mixed_at_[d]);
    auto* const states = reinterpret_cast<std::uint8_t*>(words_.data() + states_at_[d]);
    const std::uint64_t* const below_mixed = d + 1 < n ? words_.data() + mixed_at_[d + 1] : nullptr;
    const std::uint64_t* const below_states = d + 1 < n ? words_.data() + states_at_[d + 1] : nullptr;
    for (std::size_t k = 0; k < count; ++k) {
      std::uint64_t word = 0, flags = 0;
      if (below_states == nullptr) {
        word = load_word(map.data() + 8 * k, map.size() - 8 * k);
        if (states_bits < 64) word &= low_bits(static_cast<std::uint32_t>(states_bits));
      } else {
        word = below_states[k];
        flags = b_ == 1 ? below_mixed[k] : below_mixed[k / 2] >> (32 * (k % 2)) & 0xffffffff;
      }
      // Most words lie in the middle of one colour.
      if (flags == 0 && word == 0) continue;
      const Parents p = b_ == 1 ? parents_two(flags, word) : parents_four(flags, word);
      // Little-endian bytes of zeroed words.
      const auto p_states = static_cast<std::uint16_t>(p.states),
                 p_mixed = static_cast<std::uint16_t>(p.mixed);
      std::memcpy(states + 2 * k, &p_states, 2);
      if (b_ == 1)
        std::memcpy(mixed + 2 * k, &p_mixed, 2);
      else
        mixed[k] = static_cast<std::uint8_t>(p.mixed);
    }
  }
  for (Level d = 0; d < n; ++d)
    for (const std::uint64_t word : mixed(d)) internal_[d] += static_cast<std::uint64_t>(std::popcount(word));
}

}  // namespace mmverify::impl::tree::detail
