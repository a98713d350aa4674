#include "impl/tree/pyramid.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "impl/micromap/words.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/tree/pyramid.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target: without branches, the compiler vectorises the loops.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::tree::detail {
namespace HWY_NAMESPACE {

using micromap::detail::bytes_to_pairs, micromap::detail::nibbles_to_bits;

constexpr std::uint64_t nibbles = 0x1111111111111111, pairs = 0x0303030303030303, bytes = 0x0101010101010101;

/// One bit a nibble: whether any of its four flags is set.
constexpr std::uint64_t any_of_four(std::uint64_t flags) noexcept {
  flags |= flags >> 1;
  return nibbles_to_bits((flags | flags >> 2) & nibbles);
}

/// The parents of a word of children: 16 bits of states, and 16 flags in 2-state, 8 in 4-state.
struct Parents {
  std::uint64_t mixed, states;
};

/// A parent is internal if a child is, or if the first states of its children differ.
constexpr Parents parents_two(std::uint64_t mixed, std::uint64_t states) noexcept {
  const std::uint64_t first = states & nibbles;
  return {any_of_four(mixed | (states ^ first * 15)), nibbles_to_bits(first)};
}

constexpr Parents parents_four(std::uint64_t mixed, std::uint64_t states) noexcept {
  const std::uint64_t first = states & pairs;
  std::uint64_t differ = states ^ first * 0x55;
  differ |= differ >> 4;
  differ |= differ >> 2;
  differ = (differ | differ >> 1) & bytes;
  // The flags, one a byte, move together to eight bits.
  differ = (differ | differ >> 7) & 0x0003000300030003;
  differ = (differ | differ >> 14) & 0x0000000f0000000f;
  differ = (differ | differ >> 28) & 0xff;
  return {any_of_four(mixed) | differ, bytes_to_pairs(first)};
}

// Writes the parents' states and flags of words of children.  mixed_below: nullptr if the children are the map's.
template <class Flags, class Mixed, Parents parents(std::uint64_t, std::uint64_t)>
HWY_INLINE void each_word(const std::uint8_t* HWY_RESTRICT below,
                          const std::uint8_t* HWY_RESTRICT mixed_below, std::size_t count,
                          std::uint8_t* HWY_RESTRICT states, std::uint8_t* HWY_RESTRICT mixed) {
  for (std::size_t k = 0; k < count; ++k) {
    std::uint64_t word;
    Flags flags = 0;
    std::memcpy(&word, below + 8 * k, sizeof word);
    if (mixed_below != nullptr) std::memcpy(&flags, mixed_below + sizeof flags * k, sizeof flags);
    const Parents p = parents(flags, word);
    const auto p_states = static_cast<std::uint16_t>(p.states);
    const auto p_mixed = static_cast<Mixed>(p.mixed);
    std::memcpy(states + sizeof p_states * k, &p_states, sizeof p_states);
    std::memcpy(mixed + sizeof p_mixed * k, &p_mixed, sizeof p_mixed);
  }
}

void parents_of(std::uint32_t b, const std::uint8_t* below, const std::uint8_t* mixed_below,
                std::size_t count, std::uint8_t* HWY_RESTRICT states, std::uint8_t* HWY_RESTRICT mixed) {
  if (b == 1 && mixed_below == nullptr)
    each_word<std::uint64_t, std::uint16_t, parents_two>(below, nullptr, count, states, mixed);
  else if (b == 1)
    each_word<std::uint64_t, std::uint16_t, parents_two>(below, mixed_below, count, states, mixed);
  else if (mixed_below == nullptr)
    each_word<std::uint32_t, std::uint8_t, parents_four>(below, nullptr, count, states, mixed);
  else
    each_word<std::uint32_t, std::uint8_t, parents_four>(below, mixed_below, count, states, mixed);
}

std::uint64_t ones_of(const std::uint64_t* words, std::size_t count) {
  std::uint64_t ones = 0;
  for (std::size_t k = 0; k < count; ++k) ones += static_cast<std::uint64_t>(__builtin_popcountll(words[k]));
  return ones;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::tree::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::tree::detail {

HWY_EXPORT(parents_of);
HWY_EXPORT(ones_of);

namespace {

constexpr std::size_t words_for(std::uint64_t bits) noexcept {
  return static_cast<std::size_t>((bits + 63) / 64);
}

constexpr std::uint64_t nodes_at(Level d) noexcept { return std::uint64_t{1} << (2 * d); }

}  // namespace

void require_map(Level n, Format b, std::size_t map_bytes) {
  if (n > max_level) throw std::invalid_argument("tree: the level is above 12");
  if (b != Format::two_state && b != Format::four_state)
    throw std::invalid_argument("tree: a state has 1 or 2 bits");
  if (map_bytes != bytes_for(nodes_at(n) * static_cast<std::uint32_t>(b)))
    throw std::invalid_argument("tree: the map is not ceil(4^level * bits / 8) bytes long");
}

Pyramid::Pyramid(Level n, Format b, std::span<const std::uint8_t> map) : b_(static_cast<std::uint32_t>(b)) {
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
  // Depth n is the map itself, and has no internal node.
  const std::uint64_t states_bits = nodes_at(n) * b_;
  const auto bytes_of = [this](std::size_t word) {
    return reinterpret_cast<std::uint8_t*>(words_.data() + word);
  };
  for (Level d = n; d-- > 0;) {
    std::uint8_t *const mixed = bytes_of(mixed_at_[d]), *const states = bytes_of(states_at_[d]);
    if (d + 1 < n) {
      HWY_DYNAMIC_DISPATCH(parents_of)
      (b_, bytes_of(states_at_[d + 1]), bytes_of(mixed_at_[d + 1]), words_for(nodes_at(d + 1) * b_), states,
       mixed);
    } else if (states_bits >= 64) {
      HWY_DYNAMIC_DISPATCH(parents_of)(b_, map.data(), nullptr, states_bits / 64, states, mixed);
    } else {
      const std::uint64_t word =
          load_word(map.data(), map.size()) & low_bits(static_cast<std::uint32_t>(states_bits));
      std::uint8_t bytes[8];
      std::memcpy(bytes, &word, sizeof word);
      HWY_DYNAMIC_DISPATCH(parents_of)(b_, bytes, nullptr, 1, states, mixed);
    }
  }
  for (Level d = 0; d < n; ++d)
    internal_[d] = HWY_DYNAMIC_DISPATCH(ones_of)(mixed(d).data(), mixed(d).size());
}

}  // namespace mmverify::impl::tree::detail
#endif  // HWY_ONCE
