#include "impl/tree.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>
#include <vector>

#include "impl/index.hpp"
#include "impl/tree_bits.hpp"
#include "impl/tree_layout.hpp"
#include "impl/tree_pyramid.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/tree.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target, for its population count and shifts.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::tree {
namespace HWY_NAMESPACE {

HWY_INLINE std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

template <class Count>
HWY_INLINE std::uint64_t count_at(const std::uint8_t* bytes) {
  Count count;
  std::memcpy(&count, bytes, sizeof count);
  return count;
}

// The state at an index.  No branch depends on the tree: a leaf steps onto itself until the steps are taken.
template <class Count>
HWY_INLINE std::uint32_t find(const std::uint8_t* memory, std::uint64_t header, std::uint64_t index) {
  const detail::Layout layout = detail::Layout::unpacked(header);
  const std::uint8_t* const nodes = memory + 8;
  const std::uint8_t* const counts = nodes + 8 * layout.words();
  // The children of the r-th one, counted from 1, are at first + 4r.
  const std::uint64_t first = layout.first_children() - 4;
  index &= (std::uint64_t{1} << (layout.top + layout.below_top)) - 1;
  std::uint32_t shift = layout.below_top;
  std::uint64_t p = index >> shift;
  // From the lowest node of the word up to p's, moved to the top, p's being the sign.
  std::uint64_t upto = word_at(nodes + p / 64 * 8) << (~p % 64);
  std::uint64_t ones = count_at<Count>(counts + p / 64 * sizeof(Count)) +
                       static_cast<std::uint64_t>(__builtin_popcountll(upto));
  while (shift != layout.in_block) {
    shift -= 2;
    const std::uint64_t child = first + 4 * ones + (index >> shift & 3);
    p = static_cast<std::int64_t>(upto) < 0 ? child : p;
    upto = word_at(nodes + p / 64 * 8) << (~p % 64);
    ones = count_at<Count>(counts + p / 64 * sizeof(Count)) +
           static_cast<std::uint64_t>(__builtin_popcountll(upto));
  }
  // Blocks are numbered by the ones after all that have children.
  const std::uint64_t inside = index & ((std::uint64_t{1} << layout.in_block) - 1);
  const std::uint64_t in_block = ((ones - 1 - layout.parents()) << layout.in_block) + inside;
  const std::uint64_t as_leaf = (layout.blocks << layout.in_block) + p - ones;
  const std::uint64_t place = static_cast<std::int64_t>(upto) < 0 ? in_block : as_leaf;
  const std::uint64_t bit = layout.blocks_at() + (place << (layout.b - 1));
  return memory[bit / 8] >> (bit % 8) & (2 * layout.b - 1);
}

HWY_INLINE std::uint8_t find_any(const std::uint8_t* memory, std::uint64_t index) {
  const std::uint64_t header = word_at(memory);
  return static_cast<std::uint8_t>((header & 2) != 0 ? find<std::uint32_t>(memory, header, index)
                                                     : find<std::uint16_t>(memory, header, index));
}

std::uint8_t find_one(const std::uint8_t* memory, std::uint64_t index) { return find_any(memory, index); }

void find_each(const std::uint8_t* memory, const std::uint32_t* index, std::uint8_t* state,
               std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) state[k] = find_any(memory, index[k]);
}

void find_in_many(const Tree* const* trees, const std::uint32_t* which, const std::uint32_t* index,
                  std::uint8_t* state, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) state[k] = find_any(trees[which[k]]->memory(), index[k]);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::tree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::tree {
namespace {

using detail::Layout;
using detail::Pyramid;

HWY_EXPORT(find_one);
HWY_EXPORT(find_each);
HWY_EXPORT(find_in_many);

std::uint64_t header_of(const std::uint8_t* memory) noexcept {
  std::uint64_t header;
  std::memcpy(&header, memory, sizeof header);
  return header;
}

constexpr std::uint64_t object_bits = 8 * sizeof(Tree);

/// The form of a map for one choice of k and m.
Layout layout_for(const Pyramid& pyramid, Level n, Bits b, Level k, Level m) {
  std::uint64_t parents = 0;
  for (Level d = k; d < m; ++d) parents += pyramid.internal(d);
  const std::uint64_t blocks = pyramid.internal(m);
  return {.b = static_cast<std::uint32_t>(b),
          .wide = parents + blocks > 0xffff,
          .top = 2 * k,
          .below_top = 2 * (n - k),
          .in_block = 2 * (n - m),
          .nodes = (std::uint64_t{1} << (2 * k)) + 4 * parents,
          .blocks = blocks};
}

Layout chosen(const Pyramid& pyramid, Level n, Bits b) {
  const std::uint64_t internal = pyramid.internal();
  const std::uint64_t paper = 4 * internal + 1 + (3 * internal + 1) * static_cast<std::uint32_t>(b);
  const std::uint64_t budget = paper + paper / 32;
  const auto total = [](const Layout& l) { return object_bits + 8 * detail::bytes_for(l.end()); };
  Layout best = layout_for(pyramid, n, b, 0, 0);
  for (Level k = 0; k <= n; ++k) {
    // At depth n there are no internal nodes: m = n, but at level 0, only repeats depth n-1 at greater cost.
    for (Level m = k; m < std::max<Level>(n, 1); ++m) {
      const Layout l = layout_for(pyramid, n, b, k, m);
      const bool fits = total(l) <= budget, best_fits = total(best) <= budget;
      if (fits != best_fits) {
        if (fits) best = l;
      } else if (fits && l.steps() != best.steps()) {
        if (l.steps() < best.steps()) best = l;
      } else if (total(l) < total(best)) {
        best = l;
      }
    }
  }
  return best;
}

/// Calls each(k) for every bit k that is set, in order.
template <class Each>
void for_each_one(std::span<const std::uint64_t> words, Each each) {
  for (std::size_t w = 0; w < words.size(); ++w)
    for (std::uint64_t word = words[w]; word != 0; word &= word - 1)
      each(64 * w + static_cast<std::uint64_t>(std::countr_zero(word)));
}

template <class Count>
void write_counts(const std::uint8_t* nodes, std::uint8_t* counts, std::uint64_t words) {
  std::uint64_t ones = 0;
  for (std::uint64_t w = 0; w < words; ++w) {
    const auto count = static_cast<Count>(ones);
    std::memcpy(counts + w * sizeof count, &count, sizeof count);
    ones += static_cast<std::uint64_t>(std::popcount(header_of(nodes + 8 * w)));
  }
}

}  // namespace

Tree Tree::encode(Level n, Bits b, std::span<const std::uint8_t> map) {
  detail::require_map(n, b, map.size());
  const Pyramid pyramid(n, b, map);
  const Layout layout = chosen(pyramid, n, b);
  const std::uint32_t width = layout.b;
  const Level k = layout.top / 2, m = n - layout.in_block / 2;
  const std::uint64_t size = detail::bytes_for(layout.end());

  // A writer stores whole words beyond its last bit.
  std::vector<std::uint64_t> words(size / 8 + 3);
  words[0] = layout.packed();
  auto* const work = reinterpret_cast<std::uint8_t*>(words.data());
  std::uint64_t p = Layout::nodes_at;
  const auto put_nodes = [&words, &p](std::uint64_t flags, std::uint32_t count) {
    words[p / 64] |= flags << (p % 64);
    if (p % 64 + count > 64) words[p / 64 + 1] = flags >> (64 - p % 64);
    p += count;
  };
  detail::BitWriter leaves(work, layout.leaves_at());

  // Depth k whole, then below it the children of what is internal.
  const std::uint64_t top = std::uint64_t{1} << layout.top;
  for (std::uint64_t node = 0; node < top; node += 32) {
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(32, top - node));
    put_nodes(pyramid.mixed(k)[node / 64] >> (node % 64) & 0xffffffff, count);
  }
  for (std::uint64_t node = 0; node < top; ++node)
    if ((pyramid.mixed(k)[node / 64] >> (node % 64) & 1) == 0)
      leaves.put(pyramid.first_state(k, node), width);
  for (Level d = k + 1; d <= m; ++d)
    for_each_one(pyramid.mixed(d - 1), [&](std::uint64_t parent) {
      const std::uint32_t children = pyramid.children(d, parent);
      std::uint32_t states = pyramid.first_states(d, parent);
      put_nodes(children, 4);
      for (std::uint32_t c = 0; c < 4; ++c, states >>= width)
        if ((children >> c & 1) == 0) leaves.put(states & detail::low_bits(width), width);
    });

  std::uint8_t* const node_bytes = work + Layout::nodes_at / 8;
  std::uint8_t* const counts = work + layout.counts_at() / 8;
  if (layout.wide)
    write_counts<std::uint32_t>(node_bytes, counts, layout.words());
  else
    write_counts<std::uint16_t>(node_bytes, counts, layout.words());

  const std::uint64_t block_bits = (std::uint64_t{1} << layout.in_block) * width;
  if (layout.blocks > 0) {
    std::uint64_t to = layout.blocks_at();
    for_each_one(pyramid.mixed(m), [&](std::uint64_t node) {
      const std::uint64_t from = node * block_bits;
      if (block_bits < 8) {
        const std::uint64_t states =
            map[from / 8] >> (from % 8) & detail::low_bits(static_cast<std::uint32_t>(block_bits));
        work[to / 8] = static_cast<std::uint8_t>(work[to / 8] | states << (to % 8));
      } else {
        std::memcpy(work + to / 8, map.data() + from / 8, block_bits / 8);
      }
      to += block_bits;
    });
  }

  auto memory = std::make_unique_for_overwrite<std::uint8_t[]>(size);
  std::memcpy(memory.get(), work, size);
  return Tree(std::move(memory));
}

std::uint8_t Tree::operator[](std::uint64_t index) const noexcept {
  return HWY_DYNAMIC_DISPATCH(find_one)(memory_.get(), index);
}

void Tree::lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const {
  if (index.size() != state.size()) throw std::invalid_argument("tree: index and state differ in length");
  HWY_DYNAMIC_DISPATCH(find_each)(memory_.get(), index.data(), state.data(), index.size());
}

std::uint8_t Tree::at(float u, float v) const noexcept {
  return (*this)[index::from_barycentrics(u, v, level())];
}

void Tree::decode(std::span<std::uint8_t> map) const {
  const Layout layout = Layout::unpacked(header_of(memory_.get()));
  const Level n = layout.level(), k = layout.top / 2, m = n - layout.in_block / 2;
  detail::require_map(n, format(), map.size());
  std::memset(map.data(), 0, map.size());

  const std::span<const std::uint8_t> all(memory_.get(), detail::bytes_for(layout.end()));
  const auto reader_at = [&](std::uint64_t bit) {
    detail::BitReader reader(all);
    reader.skip(static_cast<std::uint32_t>(bit));
    return reader;
  };
  detail::BitReader nodes = reader_at(Layout::nodes_at), leaves = reader_at(layout.leaves_at());
  const std::uint32_t width = layout.b;
  const std::uint64_t all_bits = (std::uint64_t{1} << (2 * n)) * width;

  // Internal nodes of one depth, as numbers at that depth.
  std::vector<std::uint32_t> parents, internal;
  const auto read_node = [&](Level d, std::uint64_t node) {
    const std::uint64_t bit = nodes.peek() & 1;
    nodes.skip(1);
    if (bit != 0) {
      internal.push_back(static_cast<std::uint32_t>(node));
      return;
    }
    const std::uint64_t run = all_bits >> (2 * d);
    detail::fill_run(map.data(), node * run, run,
                     detail::repeated(leaves.peek() & detail::low_bits(width), width));
    leaves.skip(width);
  };
  const std::uint64_t top = std::uint64_t{1} << layout.top;
  for (std::uint64_t node = 0; node < top; ++node) read_node(k, node);
  for (Level d = k + 1; d <= m; ++d) {
    parents.swap(internal);
    internal.clear();
    for (const std::uint64_t parent : parents)
      for (std::uint64_t c = 0; c < 4; ++c) read_node(d, 4 * parent + c);
  }
  const std::uint64_t block_bits = (std::uint64_t{1} << layout.in_block) * width;
  std::uint64_t from = layout.blocks_at();
  for (const std::uint64_t node : internal) {
    const std::uint64_t to = node * block_bits;
    if (block_bits < 8) {
      const std::uint64_t states =
          memory_[from / 8] >> (from % 8) & detail::low_bits(static_cast<std::uint32_t>(block_bits));
      map[to / 8] = static_cast<std::uint8_t>(map[to / 8] | states << (to % 8));
    } else {
      std::memcpy(map.data() + to / 8, memory_.get() + from / 8, block_bits / 8);
    }
    from += block_bits;
  }
}

std::uint64_t Tree::bits() const noexcept {
  return object_bits + 8 * detail::bytes_for(Layout::unpacked(header_of(memory_.get())).end());
}

Level Tree::level() const noexcept { return Layout::unpacked(header_of(memory_.get())).level(); }

Bits Tree::format() const noexcept {
  return Layout::unpacked(header_of(memory_.get())).b == 1 ? Bits::two_state : Bits::four_state;
}

std::uint32_t Tree::steps() const noexcept { return Layout::unpacked(header_of(memory_.get())).steps(); }

void lookup(std::span<const Tree* const> trees, std::span<const std::uint32_t> which,
            std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
  if (which.size() != state.size() || index.size() != state.size())
    throw std::invalid_argument("tree: which, index and state differ in length");
  std::uint32_t greatest = 0;
  for (const std::uint32_t tree : which) greatest = std::max(greatest, tree);
  if (!which.empty() && greatest >= trees.size())
    throw std::invalid_argument("tree: which names a tree beyond the last");
  HWY_DYNAMIC_DISPATCH(find_in_many)(trees.data(), which.data(), index.data(), state.data(), state.size());
}

}  // namespace mmverify::impl::tree
#endif  // HWY_ONCE
