#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "impl/dag/dag.hpp"
#include "impl/dag/node.hpp"
#include "impl/dag/walk.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::dag {

using namespace detail;

namespace {

/// State number `index` of packed words.
std::uint8_t state_in(const std::uint64_t* words, std::uint32_t b, std::uint64_t index) noexcept {
  const std::uint64_t bit = index * b;
  return static_cast<std::uint8_t>(words[bit / 64] >> (bit % 64) & (b == 1 ? 1 : 3));
}

/// The arrays of a graph as plain pointers, which stay in registers.
struct Arrays {
  const Record* records;
  const std::uint64_t *tiles, *flat;
  const std::uint32_t* nodes;
  std::uint32_t b;

  template <std::uint32_t bits>
  std::uint8_t at(std::uint32_t map, std::uint64_t index) const noexcept {
    const Record record = records[map];
    const std::uint32_t value = record.value;
    index &= (std::uint64_t{1} << (2 * record.level)) - 1;
    switch (record.kind) {
      case Kind::node: return from_node<bits>(value, record.level, index);
      case Kind::flat: return state_in(flat + std::size_t{value} * bits, bits, index);
      case Kind::tile: return state_in(tiles + std::size_t{value} * bits, bits, index);
      case Kind::small: return static_cast<std::uint8_t>(value >> (index * bits) & (bits == 1 ? 1 : 3));
      case Kind::uniform: break;
    }
    return static_cast<std::uint8_t>(value);
  }

  template <std::uint32_t bits>
  std::uint8_t from_node(std::uint32_t reference, Level m, std::uint64_t index) const noexcept {
    while (true) {
      const std::uint32_t* node = nodes + reference / 2;
      const Level below = child_level(m);
      const auto child = static_cast<std::uint32_t>(index >> (2 * below)) & (children(m) - 1);
      const std::uint32_t first = node[0];
      if ((first >> child & 1) == 0) return static_cast<std::uint8_t>(state_of(node, bits, child));
      const std::uint32_t rank = ones(mask_of(first) & ((1u << child) - 1));
      reference = reference % 2 == 1 ? node[bits + rank] : half(node, 1 + bits + rank);
      if (below == tile_level) return state_in(tiles + std::size_t{reference} * bits, bits, index & 63);
      m = below;
    }
  }
};

/// Looks up many micro-triangles.  Walks that begin at a node go side by side, so that their waits for memory overlap.
template <std::uint32_t bits>
void in_batches(const Arrays& arrays, std::span<const std::uint32_t> map,
                std::span<const std::uint32_t> index, std::span<std::uint8_t> state) noexcept {
  Walks walks;
  const std::uint32_t none = 0;
  const auto* tiles = arrays.tiles != nullptr ? reinterpret_cast<const std::uint32_t*>(arrays.tiles) : &none;
  std::uint32_t element[Walks::most];
  for (std::size_t from = 0; from < state.size(); from += Walks::most) {
    walks.count = 0;
    const std::size_t to = std::min(from + Walks::most, state.size());
    for (std::size_t k = from; k < to; ++k) {
      const Record record = arrays.records[map[k]];
      if (record.kind != Kind::node) {
        state[k] = arrays.template at<bits>(map[k], index[k]);
        continue;
      }
      element[walks.count] = static_cast<std::uint32_t>(k - from);
      walks.reference[walks.count] = record.value;
      walks.level[walks.count] = record.level;
      walks.index[walks.count++] =
          index[k] & static_cast<std::uint32_t>((std::uint64_t{1} << (2 * record.level)) - 1);
    }
    if (walks.count == 0) continue;
    walk(arrays.nodes, tiles, bits, walks);
    for (std::size_t k = 0; k < walks.count; ++k)
      state[from + element[k]] = static_cast<std::uint8_t>(walks.state[k]);
  }
}

}  // namespace

std::uint8_t Dag::at(std::uint32_t map, std::uint64_t index) const noexcept {
  const Arrays arrays{records_.data(), tiles_.data(), flat_.data(), nodes_.data(), b_};
  return b_ == 1 ? arrays.at<1>(map, index) : arrays.at<2>(map, index);
}

std::uint8_t Dag::at_point(std::uint32_t map, float u, float v) const noexcept {
  return at(map, index::from_barycentrics(u, v, level(map)));
}

void Dag::lookup(std::span<const std::uint32_t> map, std::span<const std::uint32_t> index,
                 std::span<std::uint8_t> state) const {
  if (map.size() != state.size() || index.size() != state.size())
    throw std::invalid_argument("dag: map, index and state differ in length");
  std::uint32_t greatest = 0;
  for (const std::uint32_t m : map) greatest = std::max(greatest, m);
  if (!map.empty() && greatest >= maps()) throw std::invalid_argument("dag: a map beyond the last");
  const Arrays arrays{records_.data(), tiles_.empty() ? nullptr : tiles_.data(), flat_.data(), nodes_.data(),
                      b_};
  // Vectors read places of 31 bits.
  if (tiles_.size() >= std::size_t{1} << 30)
    for (std::size_t k = 0; k < state.size(); ++k) state[k] = at(map[k], index[k]);
  else if (b_ == 1)
    in_batches<1>(arrays, map, index, state);
  else
    in_batches<2>(arrays, map, index, state);
}

namespace {

/// Writes a map from its nodes; node() writes the subtree of level m at tile `tile` of the map.
struct Expansion {
  const std::uint64_t* tiles;
  const std::uint32_t* nodes;
  std::uint32_t b;
  std::uint8_t* map;

  void node(std::uint32_t reference, Level m, std::uint64_t tile) const {
    const std::uint32_t* at = nodes + reference / 2;
    const Level below = child_level(m);
    const std::uint64_t each = subtrees(below, tile_level);
    std::uint32_t rank = 0;
    for (std::uint32_t k = 0; k < children(m); ++k, tile += each) {
      std::uint8_t* to = map + 8 * b * tile;
      if ((at[0] >> k & 1) == 0) {
        std::memset(to, static_cast<int>(repeated(state_of(at, b, k), b) & 0xFF), 8 * b * each);
        continue;
      }
      const std::uint32_t next = reference % 2 == 1 ? at[b + rank] : half(at, 1 + b + rank);
      ++rank;
      if (below == tile_level)
        std::memcpy(to, tiles + std::size_t{next} * b, 8 * b);
      else
        node(next, below, tile);
    }
  }
};

}  // namespace

void Dag::decode(std::uint32_t map, std::span<std::uint8_t> bytes) const {
  if (map >= maps()) throw std::invalid_argument("dag: a map beyond the last");
  const Record record = records_[map];
  if (bytes.size() != map_bytes(record.level, b_))
    throw std::invalid_argument("dag: the map is not ceil(4^level * bits / 8) bytes long");
  switch (record.kind) {
    case Kind::small: std::memcpy(bytes.data(), &record.value, bytes.size()); return;
    case Kind::uniform:
      std::memset(bytes.data(), static_cast<int>(repeated(record.value, b_) & 0xFF), bytes.size());
      return;
    case Kind::tile:
      std::memcpy(bytes.data(), tiles_.data() + std::size_t{record.value} * b_, bytes.size());
      return;
    case Kind::flat:
      std::memcpy(bytes.data(), flat_.data() + std::size_t{record.value} * b_, bytes.size());
      return;
    case Kind::node:
      Expansion{tiles_.data(), nodes_.data(), b_, bytes.data()}.node(record.value, record.level, 0);
  }
}

}  // namespace mmverify::impl::dag
