#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

#include "impl/tree/bits.hpp"
#include "impl/tree/form.hpp"
#include "impl/tree/layout.hpp"
#include "impl/tree/nodes.hpp"

namespace mmverify::impl::tree::detail {
namespace {

// Most of a tree is at its last depth, and branches on which of its nodes are leaves would be mispredicted: there are
// none.  Each call writes the four children of one node of the depth before.

/// Depths before the last: a run of bytes for each node, also for internal ones, whose runs are overwritten later.
template <std::uint32_t width>
struct MiddleDepth {
  NodeReader& nodes;
  BitReader& leaves;
  std::uint8_t* map;
  std::uint64_t run;  ///< bytes of a run, at least 2

  /// Writes the children, and the numbers of the internal ones to `internal`, which needs room for four; returns their
  /// count.
  std::size_t operator()(std::uint32_t parent, std::uint32_t* internal) const {
    const std::uint64_t flags = nodes.take(4);
    std::uint64_t one_each = leaves.peek();
    std::uint8_t* to = map + std::uint64_t{4} * parent * run;
    std::size_t found = 0;
    for (std::uint32_t c = 0; c < 4; ++c, to += run) {
      const std::uint64_t is_internal = flags >> c & 1;
      const std::uint64_t leaf = repeated(one_each & low_bits(width), width);
      one_each >>= width * (1 - is_internal);
      internal[found] = 4 * parent + c;
      found += is_internal;
      if (run > 64) {
        if (is_internal == 0) std::memset(to, static_cast<int>(leaf & 0xff), run);
      } else if (run >= 8) {
        for (std::uint64_t byte = 0; byte < run; byte += 8) std::memcpy(to + byte, &leaf, 8);
      } else if (run == 4) {
        std::memcpy(to, &leaf, 4);
      } else {
        std::memcpy(to, &leaf, 2);
      }
    }
    leaves.skip(width * (4 - static_cast<std::uint32_t>(found)));
    return found;
  }
};

/// The last depth with blocks of 16, 32 or 64 bits, a Word each.
template <class Word, std::uint32_t width>
struct LastDepth {
  NodeReader& nodes;
  BitReader& leaves;
  const std::uint8_t *block, *end;  ///< end: of the form's memory
  std::uint8_t* map;

  void operator()(std::uint64_t parent) {
    const std::uint64_t flags = nodes.take(4);
    std::uint64_t one_each = leaves.peek();
    std::uint8_t* const to = map + parent * 4 * sizeof(Word);
    for (std::uint32_t c = 0; c < 4; ++c) {
      const std::uint64_t internal = flags >> c & 1, mask = 0 - internal;
      // Behind the last block any bytes may be read, but the memory may end.
      Word states;
      std::memcpy(&states, std::min(block, end - sizeof states), sizeof states);
      const std::uint64_t leaf = repeated(one_each & low_bits(width), width);
      states = static_cast<Word>((states & mask) | (leaf & ~mask));
      std::memcpy(to + c * sizeof states, &states, sizeof states);
      block += sizeof(Word) * internal;
      one_each >>= width * (1 - internal);
    }
    leaves.skip(width * (4 - ones_of_four(flags)));
  }
};

/// The last depth with blocks of 4 or 8 bits.
template <std::uint32_t width>
struct SmallBlocks {
  NodeReader& nodes;
  BitReader& leaves;
  BitReader blocks;
  std::uint8_t* map;

  void operator()(std::uint64_t parent) {
    const std::uint64_t flags = nodes.take(4);
    std::uint64_t four_each = blocks.peek(), one_each = leaves.peek(), states = 0;
    for (std::uint32_t c = 0; c < 4; ++c) {
      const auto block = static_cast<std::uint32_t>(flags >> c & 1);
      const std::uint64_t mask = 0 - std::uint64_t{block};
      const std::uint64_t leaf = repeated(one_each & low_bits(width), width);
      states |= (((four_each & mask) | (leaf & ~mask)) & low_bits(4 * width)) << (4 * width * c);
      four_each >>= 4 * width * block;
      one_each >>= width * (1 - block);
    }
    const auto internal = ones_of_four(flags);
    blocks.skip(4 * width * internal);
    leaves.skip(width * (4 - internal));
    std::memcpy(map + parent * 2 * width, &states, 2 * width);
  }
};

/// Writes the map of a form of one node: a leaf, or else a block.
template <std::uint32_t width>
void write_one_node(bool is_leaf, const BitReader& leaves, const std::uint8_t* block, std::uint64_t all_bits,
                    std::span<std::uint8_t> map) {
  if (is_leaf)
    std::memset(map.data(), static_cast<int>(repeated(leaves.peek() & low_bits(width), width) & 0xff),
                map.size());
  else
    std::memcpy(map.data(), block, map.size());
  map[0] &=
      static_cast<std::uint8_t>(low_bits(static_cast<std::uint32_t>(std::min<std::uint64_t>(all_bits, 8))));
}

/// Writes the map of a form.
template <std::uint32_t width>
void decode_states(const Layout& layout, std::span<const std::uint8_t> all, std::span<std::uint8_t> map) {
  const Level n = layout.level(), k = layout.top / 2, m = n - layout.in_block / 2;
  NodeReader nodes(all.data() + Layout::nodes_at, layout.per_word());
  BitReader leaves(all, layout.leaves_at());
  const std::uint64_t all_bits = (std::uint64_t{1} << (2 * n)) * width,
                      block_bits = (std::uint64_t{1} << layout.in_block) * width;
  const std::uint8_t* const blocks = all.data() + layout.blocks_at();

  // The internal nodes of one depth, by their numbers at that depth, with room for three more.
  std::vector<std::uint32_t> internal(layout.parents + layout.blocks + 4), parents;
  std::size_t count = 0;
  Level d = k;
  if (k == 0) {
    const bool is_leaf = nodes.take(1) == 0;
    if (is_leaf || m == 0) return write_one_node<width>(is_leaf, leaves, blocks, all_bits, map);
    count = 1;  // internal[0] is the root
    d = 1;
  } else {
    // All nodes of depth k have parents.
    count = layout.first_children() / 4;
    internal.resize(std::max(internal.size(), count));
    std::iota(internal.begin(), internal.begin() + static_cast<std::ptrdiff_t>(count), 0u);
  }
  const auto each_parent = [&](auto four) {
    for (std::size_t r = 0; r < count; ++r) four(internal[r]);
  };
  for (; d < m || (d == m && block_bits > 64); ++d) {
    parents.resize(internal.size());
    parents.swap(internal);
    const MiddleDepth<width> middle{nodes, leaves, map.data(), all_bits >> (2 * d + 3)};
    std::size_t found = 0;
    for (std::size_t r = 0; r < count; ++r) found += middle(parents[r], internal.data() + found);
    count = found;
  }
  switch (block_bits) {
    case 64:
      return each_parent(
          LastDepth<std::uint64_t, width>{nodes, leaves, blocks, all.data() + all.size(), map.data()});
    case 32:
      return each_parent(
          LastDepth<std::uint32_t, width>{nodes, leaves, blocks, all.data() + all.size(), map.data()});
    case 16:
      return each_parent(
          LastDepth<std::uint16_t, width>{nodes, leaves, blocks, all.data() + all.size(), map.data()});
    case 8:
    case 4:
      return each_parent(
          SmallBlocks<width>{nodes, leaves, BitReader(all, 8 * layout.blocks_at()), map.data()});
    default:
      for (std::size_t r = 0; r < count; ++r)
        std::memcpy(map.data() + internal[r] * block_bits / 8, blocks + r * block_bits / 8, block_bits / 8);
  }
}

}  // namespace

void decode_form(const std::uint8_t* memory, std::span<std::uint8_t> map) {
  const Layout layout = Layout::of(memory);
  const std::span all(memory, layout.size());
  if (decode_without_steps(layout, all, map.data())) return;
  if (layout.b == 1)
    decode_states<1>(layout, all, map);
  else
    decode_states<2>(layout, all, map);
}

}  // namespace mmverify::impl::tree::detail
