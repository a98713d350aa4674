#include "impl/tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
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

// a where the highest bit of `sign` is set, else b; in arithmetic, as compilers like to make it a branch.
HWY_INLINE std::uint64_t either(std::uint64_t sign, std::uint64_t a, std::uint64_t b) {
  const auto mask = static_cast<std::uint64_t>(static_cast<std::int64_t>(sign) >> 63);
  return b ^ ((a ^ b) & mask);
}

// The state at an index.  No branch depends on the tree: a leaf steps onto itself until the steps are taken.
HWY_INLINE std::uint8_t find(const std::uint8_t* memory, std::uint64_t index) {
  const detail::Layout layout = detail::Layout::unpacked(word_at(memory));
  const std::uint8_t* const nodes = memory + detail::Layout::nodes_at;
  const std::uint8_t* const counts = memory + layout.counts_at();
  const std::uint64_t count_mask = 0xffffffff >> (32 - (8u << layout.log_count));
  // The children of the r-th one, counted from 1, are at first + 4r.
  const std::uint64_t first = layout.first_children() - 4;
  index &= (std::uint64_t{1} << (layout.top + layout.below_top)) - 1;
  std::uint32_t shift = layout.below_top;
  std::uint64_t p = index >> shift;
  while (true) {
    const std::uint64_t word = p / 64;
    // The nodes of the word up to p, moved to the top: p's is the sign.
    const std::uint64_t upto = word_at(nodes + 8 * word) << (~p % 64);
    std::uint32_t count;
    std::memcpy(&count, counts + (word << layout.log_count), sizeof count);
    const std::uint64_t ones = (count & count_mask) + static_cast<std::uint64_t>(__builtin_popcountll(upto));
    if (shift == layout.in_block) {
      // Blocks are numbered by the ones after all that have children.
      const std::uint64_t inside = index & ((std::uint64_t{1} << layout.in_block) - 1);
      const std::uint64_t in_block = ((ones - 1 - layout.parents) << layout.in_block) + inside;
      const std::uint64_t as_leaf = (layout.blocks << layout.in_block) + p - ones;
      const std::uint64_t bit = either(upto, in_block, as_leaf) << (layout.b - 1);
      return static_cast<std::uint8_t>(memory[layout.blocks_at() + bit / 8] >> (bit % 8) &
                                       (2 * layout.b - 1));
    }
    shift -= 2;
    p = either(upto, first + 4 * ones + (index >> shift & 3), p);
  }
}

std::uint8_t find_one(const std::uint8_t* memory, std::uint64_t index) { return find(memory, index); }

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint64_t>;
using Offsets = hn::RebindToSigned<Words>;
using WordVec = hn::Vec<Words>;

// Gathers pay from four lanes on.
constexpr bool vectors = HWY_TARGET == HWY_AVX2 || HWY_TARGET <= HWY_AVX3;

// Eight bytes at each address.  Offsets are counted from an object that exists.
WordVec load_each(const std::uint8_t* base, WordVec address) {
  const Words dw;
  const auto from = hn::Set(dw, reinterpret_cast<std::uintptr_t>(base));
  return hn::GatherOffset(dw, reinterpret_cast<const std::uint64_t*>(base),
                          hn::BitCast(Offsets(), hn::Sub(address, from)));
}

WordVec part(WordVec header, int shift, std::uint64_t mask) {
  return hn::And(hn::ShiftRightSame(header, shift), hn::Set(Words(), mask));
}

// find, a lookup a lane.
WordVec find_lanes(const std::uint8_t* base, WordVec memory, WordVec index) {
  using detail::Layout;
  const Words dw;
  const Offsets di;
  const auto one = hn::Set(dw, 1);
  const auto header = load_each(base, memory);
  const auto log_b = hn::And(header, one), log_count = part(header, 1, 3), top = part(header, 2, 30),
             in_block = part(header, 10, 30),
             parents = part(header, Layout::parents_at, (1u << Layout::parents_bits) - 1),
             blocks = hn::ShiftRight<Layout::pack_blocks_at>(header);
  auto shift = part(header, 6, 30);
  const auto roots = hn::Shl(one, top), node_bits = hn::Add(roots, hn::ShiftLeft<2>(parents));
  const auto nodes = hn::Add(memory, hn::Set(dw, Layout::nodes_at));
  const auto counts = hn::Add(nodes, hn::ShiftRight<3>(hn::Add(node_bits, hn::Set(dw, 7))));
  const auto after_counts =
      hn::Add(counts, hn::Shl(hn::ShiftRight<6>(hn::Add(node_bits, hn::Set(dw, 63))), log_count));
  const auto count_mask = hn::Sub(hn::Shl(one, hn::Shl(hn::Set(dw, 8), log_count)), one);
  const auto first = hn::Sub(roots, hn::Set(dw, 4));
  index = hn::And(index, hn::Sub(hn::Shl(one, hn::Add(top, shift)), one));
  auto p = hn::Shr(index, shift);
  while (true) {
    const auto word = hn::ShiftRight<6>(p);
    const auto upto =
        hn::Shl(load_each(base, hn::Add(nodes, hn::ShiftLeft<3>(word))), hn::AndNot(p, hn::Set(dw, 63)));
    const auto count = hn::And(load_each(base, hn::Add(counts, hn::Shl(word, log_count))), count_mask);
    const auto ones = hn::Add(count, hn::PopulationCount(upto));
    const auto internal = hn::RebindMask(dw, hn::Lt(hn::BitCast(di, upto), hn::Zero(di)));
    const auto done = hn::Eq(shift, in_block);
    if (hn::AllTrue(dw, done)) {
      const auto inside = hn::And(index, hn::Sub(hn::Shl(one, in_block), one));
      const auto block = hn::Add(hn::Shl(hn::Sub(hn::Sub(ones, one), parents), in_block), inside);
      const auto leaf = hn::Sub(hn::Add(hn::Shl(blocks, in_block), p), ones);
      const auto bit = hn::Shl(hn::IfThenElse(internal, block, leaf), log_b);
      // The eight bytes that end with the state's.
      const auto last = hn::Add(after_counts, hn::ShiftRight<3>(bit));
      const auto bytes = load_each(base, hn::Sub(last, hn::Set(dw, 7)));
      const auto in_byte = hn::Add(hn::And(bit, hn::Set(dw, 7)), hn::Set(dw, 56));
      return hn::And(hn::Shr(bytes, in_byte), hn::Add(hn::Add(log_b, log_b), one));
    }
    shift = hn::Sub(shift, hn::IfThenZeroElse(done, hn::Set(dw, 2)));
    const auto child =
        hn::Add(hn::Add(first, hn::ShiftLeft<2>(ones)), hn::And(hn::Shr(index, shift), hn::Set(dw, 3)));
    p = hn::IfThenElse(hn::AndNot(done, internal), child, p);
  }
}

template <class MemoryOf>
void find_all(const std::uint8_t* base, const std::uint32_t* index, std::uint8_t* state, std::size_t count,
              MemoryOf memory_of) {
  const Words dw;
  const hn::Rebind<std::uint32_t, Words> narrow;
  const hn::Rebind<std::uint8_t, Words> bytes;
  std::size_t k = 0;
  if constexpr (vectors) {
    HWY_ALIGN std::uint64_t address[hn::MaxLanes(dw)];
    for (const std::size_t lanes = hn::Lanes(dw); count - k >= lanes; k += lanes) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        address[lane] = reinterpret_cast<std::uintptr_t>(memory_of(k + lane));
      }
      const auto found =
          find_lanes(base, hn::Load(dw, address), hn::PromoteTo(dw, hn::LoadU(narrow, index + k)));
      hn::StoreU(hn::TruncateTo(bytes, found), bytes, state + k);
    }
  }
  for (; k < count; ++k) state[k] = find(memory_of(k), index[k]);
}

void find_each(const std::uint8_t* memory, const std::uint32_t* index, std::uint8_t* state,
               std::size_t count) {
  find_all(memory, index, state, count, [memory](std::size_t) { return memory; });
}

void find_in_many(const Tree* const* trees, const std::uint32_t* which, const std::uint32_t* index,
                  std::uint8_t* state, std::size_t count) {
  if (count > 0)
    find_all(trees[which[0]]->memory(), index, state, count,
             [=](std::size_t k) { return trees[which[k]]->memory(); });
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

/// The form of a map for one choice of k and m.
Layout layout_for(const Pyramid& pyramid, Level n, Bits b, Level k, Level m) {
  std::uint64_t parents = 0;
  for (Level d = k; d < m; ++d) parents += pyramid.internal(d);
  const std::uint64_t blocks = pyramid.internal(m), ones = parents + blocks;
  return {.b = static_cast<std::uint32_t>(b),
          .log_count = ones < 1 << 8    ? 0u
                       : ones < 1 << 16 ? 1u
                                        : 2u,
          .top = 2 * k,
          .below_top = 2 * (n - k),
          .in_block = 2 * (n - m),
          .parents = parents,
          .blocks = blocks};
}

/// The steps that maps of a level do with, as a rule.  All maps of a level take the same number where they
/// can: a processor that looks up in many maps guesses the end of the loop only then.
constexpr std::array<std::uint32_t, max_level + 1> usual_steps{0, 0, 0, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5};

Layout chosen(const Pyramid& pyramid, Level n, Bits b) {
  const std::uint64_t internal = pyramid.internal();
  const std::uint64_t paper = 4 * internal + 1 + (3 * internal + 1) * static_cast<std::uint32_t>(b);
  const std::uint64_t budget = paper + paper / 32 + 64;
  std::optional<Layout> best, least;
  // Depth n has no internal nodes: m = n, but at level 0, only repeats depth n-1 at greater cost.
  const Level last = std::max<Level>(n, 1) - 1;
  for (std::uint32_t steps = std::min(usual_steps[n], last); steps <= last && !best; ++steps)
    for (Level k = 0; k + steps <= last; ++k) {
      const Layout l = layout_for(pyramid, n, b, k, k + steps);
      if (!least || l.size() < least->size()) least = l;
      if (8 * l.size() <= budget && (!best || l.size() < best->size())) best = l;
    }
  return best ? *best : *least;
}

/// Calls each(k) for every bit k that is set, in order.
template <class Each>
void for_each_one(std::span<const std::uint64_t> words, Each each) {
  for (std::size_t w = 0; w < words.size(); ++w)
    for (std::uint64_t word = words[w]; word != 0; word &= word - 1)
      each(64 * w + static_cast<std::uint64_t>(std::countr_zero(word)));
}

}  // namespace

Tree Tree::encode(Level n, Bits b, std::span<const std::uint8_t> map) {
  detail::require_map(n, b, map.size());
  const Pyramid pyramid(n, b, map);
  const Layout layout = chosen(pyramid, n, b);
  const std::uint32_t width = layout.b;
  const Level k = layout.top / 2, m = n - layout.in_block / 2;
  const std::uint64_t size = layout.size();

  // A writer stores whole words beyond its last bit.
  std::vector<std::uint64_t> words(size / 8 + 3);
  words[0] = layout.packed();
  auto* const work = reinterpret_cast<std::uint8_t*>(words.data());
  std::uint64_t p = 8 * Layout::nodes_at;
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
      std::uint64_t kept = 0;
      std::uint32_t kept_bits = 0;
      for (std::uint32_t c = 0; c < 4; ++c, states >>= width) {
        const std::uint32_t leaf = ~children >> c & 1;
        kept |= (states & detail::low_bits(width) & (0 - std::uint64_t{leaf})) << kept_bits;
        kept_bits += leaf * width;
      }
      leaves.put(kept, kept_bits);
    });

  std::uint64_t ones = 0;
  for (std::uint64_t w = 0; w < layout.words(); ++w) {
    std::memcpy(work + layout.counts_at() + (w << layout.log_count), &ones,
                std::size_t{1} << layout.log_count);
    // Whatever follows the last node is in words, but after all that is counted.
    ones += static_cast<std::uint64_t>(std::popcount(words[1 + w]));
  }

  const std::uint64_t block_bits = (std::uint64_t{1} << layout.in_block) * width;
  if (layout.blocks > 0) {
    std::uint64_t to = 8 * layout.blocks_at();
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

  const std::span<const std::uint8_t> all(memory_.get(), layout.size());
  const auto reader_at = [&](std::uint64_t bit) {
    detail::BitReader reader(all);
    reader.skip(static_cast<std::uint32_t>(bit));
    return reader;
  };
  detail::BitReader nodes = reader_at(8 * Layout::nodes_at), leaves = reader_at(layout.leaves_at());
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
    if (d == m && m + 1 == n) {
      // Most of the tree is here, and no processor foresees which nodes are leaves.
      detail::BitReader blocks = reader_at(8 * layout.blocks_at());
      for (const std::uint64_t parent : parents) {
        const std::uint64_t flags = nodes.peek();
        std::uint64_t four_each = blocks.peek(), one_each = leaves.peek(), states = 0;
        std::uint32_t of_blocks = 0, of_leaves = 0;
        for (std::uint32_t c = 0; c < 4; ++c) {
          const auto block = static_cast<std::uint32_t>(flags >> c & 1);
          const std::uint64_t mask = 0 - std::uint64_t{block};
          const std::uint64_t leaf = detail::repeated(one_each & detail::low_bits(width), width);
          states |= (((four_each & mask) | (leaf & ~mask)) & detail::low_bits(4 * width)) << (4 * width * c);
          four_each >>= 4 * width * block;
          one_each >>= width * (1 - block);
          of_blocks += 4 * width * block;
          of_leaves += width * (1 - block);
        }
        nodes.skip(4);
        blocks.skip(of_blocks);
        leaves.skip(of_leaves);
        std::memcpy(map.data() + parent * 2 * width, &states, 2 * width);
      }
      return;
    }
    for (const std::uint64_t parent : parents)
      for (std::uint64_t c = 0; c < 4; ++c) read_node(d, 4 * parent + c);
  }
  const std::uint64_t block_bits = (std::uint64_t{1} << layout.in_block) * width;
  std::uint64_t from = 8 * layout.blocks_at();
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

std::uint64_t Tree::bits() const noexcept { return 8 * Layout::unpacked(header_of(memory_.get())).size(); }

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
