#include "bench/dag/csm.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "bench/dag/csm_walk.hpp"

namespace mmverify::bench {
namespace {

using Level = CommonSubtrees::Level;
constexpr Level leaf_level = 4, word_level = 2;  ///< of a leaf, and of its 16 states that share a word
constexpr std::uint32_t children = 16, mean_one = 0xFFFF;
constexpr std::size_t most_words = std::size_t{1} << 31;

/// The level of the root of a map: padded to 4, 6, 8, 10 or 12.
constexpr Level root_level(Level n) { return std::max(leaf_level, n + n % 2); }
constexpr std::uint64_t subtrees(Level n, Level below) {
  return n > below ? std::uint64_t{1} << 2 * (n - below) : 1;
}
constexpr std::size_t bytes_of(Level n, std::uint32_t b) {
  return static_cast<std::size_t>(((std::uint64_t{b} << 2 * n) + 7) / 8);
}

std::uint32_t ones(std::uint32_t mask) { return static_cast<std::uint32_t>(std::popcount(mask)); }
std::uint32_t rank_of(std::uint32_t header, std::uint32_t child) {
  return ones(header & ((1u << child) - 1));
}
bool has(std::uint32_t header, std::uint32_t child) { return (header >> child & 1) != 0; }

/// The 16 states of rank `rank` in a leaf.
std::uint32_t states_of(const std::uint32_t* leaf, std::uint32_t b, std::uint32_t rank) {
  return b == 1 ? leaf[1 + rank / 2] >> 16 * (rank % 2) & 0xFFFF : leaf[1 + rank];
}

/// The states of a map, 16 in each element; those beyond the map are transparent.
std::vector<std::uint32_t> words_of_states(Level n, std::uint32_t b, std::span<const std::uint8_t> map) {
  std::vector<std::uint32_t> states(subtrees(n, word_level), 0);
  const std::size_t each = 2 * b;
  for (std::size_t k = 0; k < states.size(); ++k)
    for (std::size_t byte = 0; byte < std::min(each, map.size()); ++byte)
      states[k] |= std::uint32_t{map[each * k + byte]} << 8 * byte;
  if (n < word_level) states[0] &= (std::uint32_t{1} << (b << 2 * n)) - 1;
  return states;
}

}  // namespace

CommonSubtrees::Part CommonSubtrees::stored(std::uint32_t mask, std::uint64_t opaque,
                                            std::uint64_t micro_triangles,
                                            std::vector<std::uint32_t>& words) {
  if (mask == 0) return {0, 0};
  const std::uint64_t mean = (2 * mean_one * opaque + micro_triangles) / (2 * micro_triangles);
  words[0] = mask | (with_means_ ? static_cast<std::uint32_t>(mean) << 16 : 0);
  const std::uint32_t hash = impl::dag::hash_of(std::span<const std::uint32_t>(words));
  const std::uint32_t there = known_.find(hash, [&](std::uint32_t node) {
    return words_.size() - node >= words.size() &&
           std::equal(words.begin(), words.end(), words_.begin() + node);
  });
  if (there != impl::dag::Table::none) return {there, opaque};
  if (words_.size() + words.size() > most_words) throw std::length_error("csm: no room for another node");
  const auto node = static_cast<std::uint32_t>(words_.size());
  words_.insert(words_.end(), words.begin(), words.end());
  known_.insert(hash, node);
  return {node, opaque};
}

CommonSubtrees::Part CommonSubtrees::leaf(std::uint32_t b, std::span<const std::uint32_t> states,
                                          std::uint64_t micro_triangles) {
  std::vector<std::uint32_t> words(1);
  std::uint32_t mask = 0, used = 0;
  std::uint64_t opaque = 0;
  for (std::uint32_t k = 0; k < states.size(); ++k) {
    if (states[k] == 0) continue;
    mask |= 1u << k;
    opaque += ones(b == 1 ? states[k] : states[k] & 0x5555'5555);
    if (b == 2 || used % 2 == 0)
      words.push_back(states[k]);
    else
      words.back() |= states[k] << 16;
    ++used;
  }
  return stored(mask, opaque, micro_triangles, words);
}

CommonSubtrees::Part CommonSubtrees::interior(std::span<const Part> parts, std::uint64_t micro_triangles) {
  std::vector<std::uint32_t> words(1);
  std::uint32_t mask = 0;
  std::uint64_t opaque = 0;
  for (std::uint32_t k = 0; k < parts.size(); ++k) {
    if (parts[k].node == 0) continue;
    mask |= 1u << k;
    opaque += parts[k].opaque;
    words.push_back(parts[k].node);
  }
  return stored(mask, opaque, micro_triangles, words);
}

std::uint32_t CommonSubtrees::add(Level n, std::uint32_t b, std::span<const std::uint8_t> map) {
  if (n > max_level) throw std::invalid_argument("csm: the level is above 12");
  if (b != 1 && b != 2) throw std::invalid_argument("csm: a state has 1 or 2 bits");
  if (map.size() != bytes_of(n, b))
    throw std::invalid_argument("csm: the map is not ceil(4^level * bits / 8) bytes long");
  const std::vector<std::uint32_t> states = words_of_states(n, b, map);
  std::vector<Part> parts(subtrees(n, leaf_level));
  const std::size_t in_leaf = std::min<std::size_t>(children, states.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    parts[k] = leaf(b, std::span(states).subspan(in_leaf * k, in_leaf), subtrees(std::min(n, leaf_level), 0));
  for (Level m = leaf_level + 2; m <= root_level(n); m += 2) {
    const std::size_t each = std::min<std::size_t>(children, parts.size());
    for (std::size_t k = 0; k < parts.size() / each; ++k)
      parts[k] = interior(std::span(parts).subspan(each * k, each), subtrees(std::min(n, m), 0));
    parts.resize(parts.size() / each);
  }
  records_.push_back({static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(b), 0, parts[0].node});
  return maps() - 1;
}

std::uint32_t CommonSubtrees::child(std::uint32_t node, std::uint32_t number) const {
  const std::uint32_t header = words_[node];
  return has(header, number) ? words_[node + 1 + rank_of(header, number)] : 0;
}

std::uint8_t CommonSubtrees::at(std::uint32_t map, std::uint64_t index) const {
  const Record record = records_[map];
  index &= (std::uint64_t{1} << 2 * record.level) - 1;
  std::uint32_t node = record.root;
  for (Level m = root_level(record.level); m > leaf_level; m -= 2)
    node = child(node, static_cast<std::uint32_t>(index >> 2 * (m - 2) & 15));
  const auto number = static_cast<std::uint32_t>(index >> 4 & 15);
  if (!has(words_[node], number)) return 0;
  const std::uint32_t states = states_of(&words_[node], record.bits, rank_of(words_[node], number));
  return static_cast<std::uint8_t>(states >> (index & 15) * record.bits & ((1u << record.bits) - 1));
}

void CommonSubtrees::lookup(std::span<const std::uint32_t> map, std::span<const std::uint32_t> index,
                            std::span<std::uint8_t> state) const {
  if (map.size() != state.size() || index.size() != state.size())
    throw std::invalid_argument("csm: map, index and state differ in length");
  for (const std::uint32_t m : map)
    if (m >= maps()) throw std::invalid_argument("csm: a map beyond the last");
  CsmWalks walks;
  for (std::size_t from = 0; from < state.size(); from += CsmWalks::most) {
    walks.count = std::min(CsmWalks::most, state.size() - from);
    for (std::size_t k = 0; k < walks.count; ++k) {
      const Record record = records_[map[from + k]];
      walks.node[k] = record.root;
      walks.level[k] = root_level(record.level);
      walks.bits[k] = record.bits;
      walks.index[k] =
          index[from + k] & static_cast<std::uint32_t>((std::uint64_t{1} << 2 * record.level) - 1);
    }
    csm_walk(words_.data(), walks);
    for (std::size_t k = 0; k < walks.count; ++k) state[from + k] = static_cast<std::uint8_t>(walks.state[k]);
  }
}

void CommonSubtrees::expand(std::uint32_t node, Level m, std::uint32_t b, std::uint64_t word,
                            std::span<std::uint8_t> bytes) const {
  const std::uint32_t header = words_[node];
  for (std::uint32_t k = 0; k < children; ++k) {
    if (!has(header, k)) continue;
    if (m > leaf_level) {
      expand(child(node, k), m - 2, b, word + k * subtrees(m - 2, word_level), bytes);
      continue;
    }
    const std::uint32_t states = states_of(&words_[node], b, rank_of(header, k));
    const std::size_t at = 2 * b * (word + k);
    for (std::size_t byte = 0; byte < std::min<std::size_t>(2 * b, bytes.size()); ++byte)
      bytes[at + byte] = static_cast<std::uint8_t>(states >> 8 * byte);
  }
}

void CommonSubtrees::decode(std::uint32_t map, std::span<std::uint8_t> bytes) const {
  if (map >= maps()) throw std::invalid_argument("csm: a map beyond the last");
  const Record record = records_[map];
  if (bytes.size() != bytes_of(record.level, record.bits))
    throw std::invalid_argument("csm: the map is not ceil(4^level * bits / 8) bytes long");
  std::fill(bytes.begin(), bytes.end(), std::uint8_t{0});
  expand(record.root, root_level(record.level), record.bits, 0, bytes);
}

std::uint16_t CommonSubtrees::mean_opacity(std::uint32_t map, Level c, std::uint64_t index) const {
  if (!with_means_) throw std::invalid_argument("csm: built without mean opacity");
  if (map >= maps()) throw std::invalid_argument("csm: a map beyond the last");
  const Record record = records_[map];
  const Level n = record.level;
  if (c > n || (c > 0 && ((n - c) % 2 != 0 || n - c < leaf_level)))
    throw std::invalid_argument("csm: no node stands at this coarser level");
  if (index >> 2 * c != 0) throw std::invalid_argument("csm: no such micro-triangle at the coarser level");
  std::uint32_t node = record.root;
  if (c > 0)
    for (Level m = root_level(n); m > n - c; m -= 2)
      node = child(node, static_cast<std::uint32_t>(index >> 2 * (m - 2 - (n - c)) & 15));
  return static_cast<std::uint16_t>(words_[node] >> 16);
}

}  // namespace mmverify::bench
