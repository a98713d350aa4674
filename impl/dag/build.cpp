#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "impl/dag/known.hpp"
#include "impl/dag/node.hpp"

namespace mmverify::impl::dag {

using namespace detail;

static_assert(std::endian::native == std::endian::little, "words are loaded from maps' bytes as they are");

Dag::Dag(Format b) : b_(static_cast<std::uint32_t>(b)), known_(std::make_unique<HashTables>()) {
  if (b != Format::two_state && b != Format::four_state)
    throw std::invalid_argument("dag: a state has 1 or 2 bits");
}

Dag::~Dag() = default;
Dag::Dag(Dag&&) noexcept = default;
Dag& Dag::operator=(Dag&&) noexcept = default;

std::uint32_t Dag::part_of_tile(const std::uint64_t* words) {
  const std::uint64_t state = words[0] & (b_ == 1 ? 1 : 3), all = repeated(state, b_);
  if (words[0] == all && words[b_ - 1] == all) return one_state + static_cast<std::uint32_t>(state);
  const std::uint32_t hash = hash_of(std::span<const std::uint64_t>(words, b_));
  const std::uint32_t there = known_->tiles.find(hash, [&](std::uint32_t t) {
    return tiles_[std::size_t{t} * b_] == words[0] && tiles_[std::size_t{t} * b_ + b_ - 1] == words[b_ - 1];
  });
  if (there != Table::none) return there;
  if (tiles_.size() >= most_words) throw std::length_error("dag: no room for another tile");
  const auto number = static_cast<std::uint32_t>(tiles_.size() / b_);
  tiles_.insert(tiles_.end(), words, words + b_);
  known_->tiles.insert(hash, number);
  return number;
}

std::uint32_t Dag::intern_node(Level m, std::span<const std::uint32_t> words, bool wide) {
  Table& table = known_->nodes[m];
  const std::uint32_t hash = hash_of(words);
  // Wide words never equal narrow ones: else the wide node's numbers would fit 16 bits.
  const std::uint32_t there = table.find(hash, [&](std::uint32_t reference) {
    const std::uint32_t at = reference / 2;
    return (reference % 2 == 1) == wide && nodes_.size() - at >= words.size() &&
           std::equal(words.begin(), words.end(), nodes_.begin() + at);
  });
  if (there != Table::none) return there;
  if (nodes_.size() + words.size() > most_nodes_end) throw std::length_error("dag: no room for another node");
  const auto reference = static_cast<std::uint32_t>(2 * nodes_.size() + (wide ? 1 : 0));
  nodes_.insert(nodes_.end(), words.begin(), words.end());
  table.insert(hash, reference);
  known_->added.push_back(m);
  return reference;
}

std::uint32_t Dag::part_of_children(Level m, const std::uint32_t* parts) {
  const std::uint32_t count = children(m);
  std::uint32_t mask = 0, low = 0, high = 0, differs = 0, greatest = 0, references[16], used = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t part = parts[k], is_mixed = mixed(part) ? 1 : 0;
    differs |= part ^ parts[0];
    mask |= is_mixed << k;
    low |= (part & (is_mixed ^ 1)) << k;
    high |= (part >> 1 & (is_mixed ^ 1)) << k;
    references[used] = part;
    greatest = std::max(greatest, is_mixed != 0 ? part : 0);
    used += is_mixed;
  }
  if (mask == 0 && differs == 0) return parts[0];
  const bool wide = child_level(m) > tile_level || greatest >= narrow_tiles;
  std::uint32_t words[18] = {mask | low << 16, b_ == 2 ? high : 0};
  if (wide) {
    std::copy_n(references, used, words + b_);
  } else {
    for (std::uint32_t k = 0, at = 1 + b_; k < used; ++k, ++at)
      words[at / 2] |= references[k] << (16 * (at % 2));
  }
  return intern_node(m, {words, node_words(b_, used, wide)}, wide);
}

std::uint32_t Dag::number_of_flat(Level n, std::span<const std::uint64_t> words) {
  const std::uint32_t hash = hash_of(words);
  const std::uint32_t there = known_->flat[n].find(hash, [&](std::uint32_t number) {
    return std::equal(words.begin(), words.end(),
                      flat_.begin() + static_cast<std::ptrdiff_t>(std::size_t{number} * b_));
  });
  if (there != Table::none) return there;
  if (flat_.size() + words.size() > most_words) throw std::length_error("dag: no room for another flat map");
  const auto number = static_cast<std::uint32_t>(flat_.size() / b_);
  flat_.insert(flat_.end(), words.begin(), words.end());
  known_->flat[n].insert(hash, number);
  return number;
}

void Dag::forget(std::size_t tiles, std::size_t nodes) {
  for (std::size_t k = tiles_.size(); k > tiles; k -= b_) known_->tiles.pop();
  tiles_.resize(tiles);
  for (; !known_->added.empty(); known_->added.pop_back()) known_->nodes[known_->added.back()].pop();
  nodes_.resize(nodes);
}

std::uint32_t Dag::add(Level n, std::span<const std::uint8_t> map) {
  if (n > max_level) throw std::invalid_argument("dag: the level is above 12");
  if (map.size() != map_bytes(n, b_))
    throw std::invalid_argument("dag: the map is not ceil(4^level * bits / 8) bytes long");
  if (records_.size() >= Table::none) throw std::length_error("dag: no room for another map");
  Record record{static_cast<std::uint8_t>(n), Kind::small, 0, 0};
  if (n < tile_level) {
    std::memcpy(&record.value, map.data(), map.size());
    const std::uint32_t used = b_ << (2 * n);
    if (used < 32) record.value &= (std::uint32_t{1} << used) - 1;
  } else {
    const std::size_t tiles_before = tiles_.size(), nodes_before = nodes_.size();
    known_->added.clear();
    try {
      std::vector<std::uint64_t> words(map.size() / 8);
      std::memcpy(words.data(), map.data(), map.size());
      std::vector<std::uint32_t> parts(subtrees(n, tile_level));
      for (std::size_t k = 0; k < parts.size(); ++k) parts[k] = part_of_tile(&words[k * b_]);
      for (Level below = tile_level; below < n;) {
        const Level m = std::min<Level>(n, below + 2);
        const std::uint32_t each = children(m);
        for (std::size_t k = 0; k < parts.size() / each; ++k)
          parts[k] = part_of_children(m, &parts[k * each]);
        parts.resize(parts.size() / each);
        below = m;
      }
      record.value = parts[0];
      record.kind = n == tile_level ? Kind::tile : Kind::node;
      if (!mixed(record.value)) {
        record.kind = Kind::uniform;
        record.value -= one_state;
      } else if (2 * (tiles_.size() - tiles_before) + nodes_.size() - nodes_before > 2 * words.size()) {
        forget(tiles_before, nodes_before);
        record.kind = Kind::flat;
        record.value = number_of_flat(n, words);
      }
    } catch (...) {
      forget(tiles_before, nodes_before);
      throw;
    }
  }
  records_.push_back(record);
  return maps() - 1;
}

std::uint64_t Dag::bits() const noexcept {
  return 64 * (records_.size() + tiles_.size() + flat_.size()) + 32 * nodes_.size();
}

}  // namespace mmverify::impl::dag
