#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>
#include <vector>

#include "impl/tree/bits.hpp"
#include "impl/tree/form.hpp"
#include "impl/tree/layout.hpp"
#include "impl/tree/nodes.hpp"
#include "impl/tree/pyramid.hpp"

namespace mmverify::impl::tree::detail {
namespace {

/// The form of a map for one choice of k and m.
Layout layout_for(const Pyramid& pyramid, Level n, Format b, Level k, Level m) {
  std::uint64_t parents = 0;
  for (Level d = k; d < m; ++d) parents += pyramid.internal(d);
  const std::uint64_t blocks = pyramid.internal(m), ones = parents + blocks;
  return {.b = static_cast<std::uint32_t>(b),
          .count_size = ones < 1 << 8    ? 0u
                        : ones < 1 << 16 ? 1u
                                         : 2u,
          .top = 2 * k,
          .below_top = 2 * (n - k),
          .in_block = 2 * (n - m),
          .parents = parents,
          .blocks = blocks};
}

Layout chosen(const Pyramid& pyramid, Level n, Format b) {
  const std::uint64_t internal = pyramid.internal();
  const std::uint64_t paper = 4 * internal + 1 + (3 * internal + 1) * static_cast<std::uint32_t>(b);
  const std::uint64_t budget = (paper + paper / 17) / 8 + Layout::nodes_at;
  // Depth n has no internal nodes: m = n would only repeat depth n-1 at greater cost, but for level 0.
  const Level last = std::max<Level>(n, 1) - 1;
  std::optional<Layout> least;
  for (std::uint32_t steps = 0; steps <= last; ++steps) {
    std::array<Layout, max_level> tried;
    std::uint64_t best = ~std::uint64_t{0};
    for (Level k = 0; k + steps <= last; ++k) {
      tried[k] = layout_for(pyramid, n, b, k, k + steps);
      best = std::min(best, tried[k].size());
      if (!least || tried[k].size() < least->size()) least = tried[k];
    }
    if (best > budget) continue;
    for (Level k = 0; k + steps <= last; ++k)
      if (tried[k].size() <= std::min(budget, best + best / 32)) return tried[k];
  }
  return *least;
}

/// Calls each(k) for every bit k that is set, in order.
template <class Each>
void for_each_one(std::span<const std::uint64_t> words, Each each) {
  for (std::size_t w = 0; w < words.size(); ++w)
    for (std::uint64_t word = words[w]; word != 0; word &= word - 1)
      each(64 * w + static_cast<std::uint64_t>(std::countr_zero(word)));
}

/// The states of the leaves among four siblings, moved together.  It is indexed by bits a state - 1, the flags of
/// internal siblings, and the siblings' first states.
constexpr auto leaf_states = [] {
  std::array<std::array<std::array<std::uint8_t, 256>, 16>, 2> table{};
  for (std::uint32_t b = 1; b <= 2; ++b)
    for (std::uint32_t internal = 0; internal < 16; ++internal)
      for (std::uint32_t states = 0; states < 1u << (4 * b); ++states) {
        std::uint32_t kept = 0, bits = 0;
        for (std::uint32_t c = 0; c < 4; ++c)
          if ((internal >> c & 1) == 0) {
            kept |= (states >> (c * b) & ((1u << b) - 1)) << bits;
            bits += b;
          }
        table[b - 1][internal][states] = static_cast<std::uint8_t>(kept);
      }
  return table;
}();

/// Copies the states below each internal node of depth m, in the map's order.  Domain: `to` has zeros.
void put_blocks(std::span<const std::uint64_t> mixed, const std::uint8_t* map, std::uint64_t block_bits,
                std::uint8_t* to) {
  const auto copy = [&](auto bytes) {
    for_each_one(mixed, [&](std::uint64_t node) {
      std::memcpy(to, map + node * bytes, bytes);
      to += bytes;
    });
  };
  std::uint64_t bit = 0;
  switch (block_bits) {
    case 4:
      for_each_one(mixed, [&](std::uint64_t node) {
        const std::uint32_t states = map[node / 2] >> (4 * (node % 2)) & 15u;
        to[bit / 8] = static_cast<std::uint8_t>(to[bit / 8] | states << (bit % 8));
        bit += 4;
      });
      return;
    case 8: return copy(std::integral_constant<std::size_t, 1>());
    case 16: return copy(std::integral_constant<std::size_t, 2>());
    case 32: return copy(std::integral_constant<std::size_t, 4>());
    case 64: return copy(std::integral_constant<std::size_t, 8>());
    default: return copy(static_cast<std::size_t>(block_bits / 8));
  }
}

}  // namespace

std::unique_ptr<std::uint8_t[]> encode_form(Level n, Format b, std::span<const std::uint8_t> map,
                                            std::optional<Tree::Depths> depths) {
  const Pyramid pyramid(n, b, map);
  const Layout layout =
      depths ? layout_for(pyramid, n, b, depths->top, depths->block) : chosen(pyramid, n, b);
  const std::uint32_t width = layout.b;
  const Level k = layout.top / 2, m = n - layout.in_block / 2;
  const std::uint64_t size = layout.size();

  // Writers store whole words beyond their last bit.
  std::vector<std::uint64_t> words(size / 8 + 3);
  words[0] = layout.packed();
  auto* const work = reinterpret_cast<std::uint8_t*>(words.data());
  NodeWriter nodes(words.data() + 1, layout.per_word());
  BitWriter leaves(work, layout.leaves_at());

  // Writes the four children of a node of depth d-1.
  const auto put_children = [&](Level d, std::uint64_t parent) {
    const std::uint32_t children = pyramid.children(d, parent);
    nodes.put(children, 4);
    const auto kept_bits = (4 - ones_of_four(children)) * width;
    leaves.put(leaf_states[width - 1][children][pyramid.first_states(d, parent)], kept_bits);
  };
  // Writes depth k whole, then below it the children of internal nodes.
  if (k == 0) {
    nodes.put(pyramid.mixed(0)[0] & 1, 1);
    if (layout.parents + layout.blocks == 0) leaves.put(pyramid.first_state(0, 0), width);
  } else {
    for (std::uint64_t parent = 0; parent < layout.first_children() / 4; ++parent) put_children(k, parent);
  }
  for (Level d = k + 1; d <= m; ++d)
    for_each_one(pyramid.mixed(d - 1), [&](std::uint64_t parent) { put_children(d, parent); });
  nodes.count();

  put_blocks(pyramid.mixed(m), map.data(), (std::uint64_t{1} << layout.in_block) * width,
             work + layout.blocks_at());

  auto memory = std::unique_ptr<std::uint8_t[]>(new std::uint8_t[size]);
  std::memcpy(memory.get(), work, size);
  return memory;
}

}  // namespace mmverify::impl::tree::detail
