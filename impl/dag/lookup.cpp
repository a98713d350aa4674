#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "impl/dag/dag.hpp"
#include "impl/dag/node.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::dag {

using namespace detail;

namespace {

/// State number `index` of packed words.
std::uint8_t state_in(const std::uint64_t* words, std::uint32_t b, std::uint64_t index) noexcept {
  const std::uint64_t bit = index * b;
  return static_cast<std::uint8_t>(words[bit / 64] >> (bit % 64) & (b == 1 ? 1 : 3));
}

/// The arrays, so that they stay in registers.
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
      case Kind::node:
        return from_node<bits>(value, record.level, index);
      case Kind::flat:
        return state_in(flat + std::size_t{value} * bits, bits, index);
      case Kind::tile:
        return state_in(tiles + std::size_t{value} * bits, bits, index);
      case Kind::small:
        return static_cast<std::uint8_t>(value >> (index * bits) & (bits == 1 ? 1 : 3));
      case Kind::uniform:
        break;
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

/// Lookups side by side, a node of each in turn: what one waits for from memory, the others do not wait for.  No branch
/// depends on a map's states.
template <std::uint32_t bits>
class Batch {
 public:
  static constexpr std::size_t most = 64;

  Batch(const Arrays& arrays, const std::uint32_t* map, const std::uint32_t* index, std::uint8_t* state,
        std::size_t count) noexcept
      : arrays_(arrays), state_(state) {
    std::uint32_t walking = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const Record record = arrays.records[map[k]];
      if (record.kind != Kind::node) {
        state[k] = arrays.template at<bits>(map[k], index[k]);
        continue;
      }
      walk_[walking++] = {
          record.value, k, record.level,
          static_cast<std::uint32_t>(index[k] & ((std::uint64_t{1} << (2 * record.level)) - 1))};
    }
    while (walking > 0) walking = step(walking);
    for (std::uint32_t k = 0; k < ended_; ++k)
      state[end_[k].element] = state_in(arrays.tiles + std::size_t{end_[k].tile} * bits, bits, end_[k].index);
  }

 private:
  struct Walk {
    std::uint32_t reference, element;
    Level level;
    std::uint32_t index;
  };
  struct End {
    std::uint32_t tile, element, index;
  };

  /// How many go on.
  std::uint32_t step(std::uint32_t walking) noexcept {
    std::uint32_t on = 0;
    for (std::uint32_t k = 0; k < walking; ++k) {
      const Walk w = walk_[k];
      const std::uint32_t* node = arrays_.nodes + w.reference / 2;
      const Level below = child_level(w.level);
      const std::uint32_t child = w.index >> (2 * below) & (children(w.level) - 1), first = node[0],
                          goes_on = first >> child & 1, wide = w.reference & 1,
                          rank = ones(mask_of(first) & ((1u << child) - 1));
      // The word of the reference; of a child of one state, that of the last plane.
      const std::uint32_t at = wide != 0 ? bits + rank : (1 + bits + rank) / 2;
      const std::uint32_t word = node[goes_on != 0 ? at : bits - 1];
      const std::uint32_t half_shift = ((1 + bits + rank) & 1) * 16;
      const std::uint32_t next = wide != 0 ? word : word >> half_shift & 0xFFFF;
      const std::uint32_t low = first >> (16 + child) & 1;
      state_[w.element] = static_cast<std::uint8_t>(bits == 1 ? low : low | (word >> child & 1) << 1);
      const std::uint32_t is_tile = below == tile_level ? 1 : 0;
      end_[ended_] = {next, w.element, w.index & 63};
      ended_ += goes_on & is_tile;
      walk_[on] = {next, w.element, below, w.index};
      on += goes_on & (is_tile ^ 1);
    }
    return on;
  }

  Arrays arrays_;
  std::uint8_t* state_;
  Walk walk_[most];
  End end_[most + 1];
  std::uint32_t ended_ = 0;
};

template <std::uint32_t bits>
void in_batches(const Arrays& arrays, std::span<const std::uint32_t> map,
                std::span<const std::uint32_t> index, std::span<std::uint8_t> state) noexcept {
  for (std::size_t k = 0; k < state.size(); k += Batch<bits>::most)
    Batch<bits>(arrays, &map[k], &index[k], &state[k], std::min(Batch<bits>::most, state.size() - k));
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
  const Arrays arrays{records_.data(), tiles_.data(), flat_.data(), nodes_.data(), b_};
  if (b_ == 1)
    in_batches<1>(arrays, map, index, state);
  else
    in_batches<2>(arrays, map, index, state);
}

namespace {

/// Writes the subtree of level m at tile `tile` of the map.
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
    case Kind::small:
      std::memcpy(bytes.data(), &record.value, bytes.size());
      return;
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
