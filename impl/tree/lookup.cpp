#include "impl/tree/lookup.hpp"

#include <algorithm>
#include <cstring>

#include "impl/tree/layout.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/tree/lookup.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

// Compiled once for each target, for its population count and shifts.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::tree {
namespace HWY_NAMESPACE {

using detail::Layout;

HWY_INLINE std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

// a if the highest bit of `sign` is set, else b; in arithmetic, since compilers like to make it a branch.
HWY_INLINE std::uint64_t either(std::uint64_t sign, std::uint64_t a, std::uint64_t b) {
  const auto mask = static_cast<std::uint64_t>(static_cast<std::int64_t>(sign) >> 63);
  return b ^ ((a ^ b) & mask);
}

// A node, read from its word.
struct Look {
  std::uint64_t upto;  // the nodes of its word up to it, moved to the top: the sign bit is its own
  std::uint64_t ones;  // ones in all nodes up to it, itself included
};

HWY_INLINE Look look(const std::uint8_t* memory, const Layout& l, std::uint64_t p) {
  const std::uint64_t w = l.word_of(p), word = word_at(memory + Layout::nodes_at + 8 * w);
  const std::uint64_t upto = word << (63 - (p - w * l.per_word()));
  return {upto, (word >> l.per_word()) + static_cast<std::uint64_t>(__builtin_popcountll(upto))};
}

HWY_INLINE std::uint64_t first_node(const Layout& l, std::uint64_t index) {
  return (index & ((std::uint64_t{1} << (l.top + l.below_top)) - 1)) >> l.below_top;
}

// The child named by the two bits of the index at `shift`; a leaf steps onto itself.
HWY_INLINE std::uint64_t child(const Layout& l, const Look& at, std::uint64_t p, std::uint64_t index,
                               std::uint32_t shift) {
  return either(at.upto, l.first_children() + 4 * (at.ones - 1) + (index >> shift & 3), p);
}

// The place of the state, in bits from the blocks on.  Domain: p is of depth m, or a leaf above it.
HWY_INLINE std::uint64_t place(const Layout& l, const Look& at, std::uint64_t p, std::uint64_t index) {
  // Blocks are numbered by the ones after all nodes with children.
  const std::uint64_t inside = index & ((std::uint64_t{1} << l.in_block) - 1);
  const std::uint64_t in_block = ((at.ones - 1 - l.parents) << l.in_block) + inside;
  const std::uint64_t as_leaf = (l.blocks << l.in_block) + p - at.ones;
  return either(at.upto, in_block, as_leaf) << (l.b - 1);
}

// The state at an index.  No branch depends on the tree but for the number of steps.
HWY_INLINE std::uint8_t find(const std::uint8_t* memory, std::uint64_t index) {
  const Layout l = Layout::of(memory);
  std::uint64_t p = first_node(l, index);
  for (std::uint32_t shift = l.below_top; shift > l.in_block;) {
    const Look at = look(memory, l, p);
    shift -= 2;
    p = child(l, at, p, index, shift);
  }
  const std::uint64_t bit = place(l, look(memory, l, p), p, index);
  return static_cast<std::uint8_t>(memory[l.blocks_at() + bit / 8] >> (bit % 8) & (2 * l.b - 1));
}

std::uint8_t find_one(const std::uint8_t* memory, std::uint64_t index) { return find(memory, index); }

// ---- Many at once

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET <= HWY_AVX3  // gathers pay from four lanes on

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint64_t>;
using Offsets = hn::RebindToSigned<Words>;
using WordVec = hn::Vec<Words>;

HWY_INLINE WordVec all(std::uint64_t x) { return hn::Set(Words(), x); }

// The even number stored halved at bit `at`; see Layout::packed.
template <int at>
HWY_INLINE WordVec even(WordVec header) {
  return hn::And(hn::ShiftRight<at>(header), all(30));
}

// The members of Layout that a lookup reads, a tree a lane.
struct Layouts {
  WordVec header;

  HWY_INLINE WordVec log_b() const { return hn::And(header, all(1)); }
  HWY_INLINE WordVec count_size() const { return hn::And(hn::ShiftRight<1>(header), all(3)); }
  HWY_INLINE WordVec top() const { return even<2>(header); }
  HWY_INLINE WordVec below_top() const { return even<6>(header); }
  HWY_INLINE WordVec in_block() const { return even<10>(header); }
  HWY_INLINE WordVec parents() const {
    return hn::And(hn::ShiftRight<Layout::parents_at>(header), all((1u << Layout::parents_bits) - 1));
  }
  HWY_INLINE WordVec blocks() const { return hn::ShiftRight<Layout::pack_blocks_at>(header); }
  HWY_INLINE WordVec per_word() const { return hn::Sub(all(56), hn::ShiftLeft<3>(count_size())); }
  HWY_INLINE WordVec word_of(WordVec p) const {
    const hn::Repartition<std::uint32_t, Words> halves;
    const auto size = count_size();
    const auto reciprocal = hn::IfThenElse(
        hn::Eq(size, hn::Zero(Words())), all(Layout::reciprocals[0]),
        hn::IfThenElse(hn::Eq(size, all(1)), all(Layout::reciprocals[1]), all(Layout::reciprocals[2])));
    return hn::ShiftRight<Layout::reciprocal_shift>(
        hn::MulEven(hn::BitCast(halves, p), hn::BitCast(halves, reciprocal)));
  }
};

// Loads eight bytes at each address; offsets count from an object that exists.
HWY_INLINE WordVec load_each(const std::uint8_t* base, WordVec address) {
  const auto from = all(reinterpret_cast<std::uintptr_t>(base));
  return hn::GatherOffset(Words(), reinterpret_cast<const std::uint64_t*>(base),
                          hn::BitCast(Offsets(), hn::Sub(address, from)));
}

HWY_INLINE void prefetch_each(WordVec address) {
  HWY_ALIGN std::uint64_t each[hn::MaxLanes(Words())];
  hn::Store(address, Words(), each);
  for (std::size_t lane = 0; lane < hn::Lanes(Words()); ++lane)
    hwy::Prefetch(reinterpret_cast<const std::uint8_t*>(each[lane]));
}

// The number of lookups that go down together, each step for all of them before the next step.  A step reads what was
// prefetched in the pass before, so that the misses of a group overlap.
constexpr std::size_t group = 128;

class Group {
 public:
  // Looks up index[k] in memory_of(k) for k < count, count in 1..group, and writes state[k].
  template <class MemoryOf>
  void find(const std::uint32_t* index, std::uint8_t* state, std::size_t count, MemoryOf memory_of) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint8_t* const memory = memory_of(k);
      hwy::Prefetch(memory);
      memory_[k] = reinterpret_cast<std::uintptr_t>(memory);
      index_[k] = index[k];
    }
    base_ = memory_of(0);
    // The size is rounded up to whole vectors.
    const std::size_t lanes = hn::Lanes(Words());
    size_ = (count + lanes - 1) / lanes * lanes;
    for (std::size_t k = count; k < size_; ++k) {
      memory_[k] = memory_[0];
      index_[k] = index_[0];
    }
    for (std::uint64_t s = begin(); s > 0; --s) step(s);
    look_for_states();
    for (std::size_t k = 0; k < size_; k += lanes) {
      const auto bytes = load_each(base_, hn::Load(Words(), state_at_ + k));
      const auto found = hn::And(hn::Shr(bytes, hn::Load(Words(), p_ + k)), hn::Load(Words(), header_ + k));
      hn::StoreU(hn::TruncateTo(Bytes(), found), Bytes(), state_ + k);
    }
    std::memcpy(state, state_, count);
  }

 private:
  using Narrow = hn::Rebind<std::uint32_t, Words>;
  using Bytes = hn::Rebind<std::uint8_t, Words>;

  HWY_INLINE WordVec index_at(std::size_t k) const {
    return hn::PromoteTo(Words(), hn::Load(Narrow(), index_ + k));
  }
  HWY_INLINE WordVec word_address(const Layouts& l, WordVec p, std::size_t k) const {
    return hn::Add(hn::Load(Words(), memory_ + k),
                   hn::Add(all(Layout::nodes_at), hn::ShiftLeft<3>(l.word_of(p))));
  }
  // Reads nodes as the scalar look(): the nodes of p's word up to p, and the ones up to p.
  HWY_INLINE void look(const Layouts& l, WordVec p, std::size_t k, WordVec& upto, WordVec& ones) const {
    const auto w = l.word_of(p), per = l.per_word();
    const auto word = load_each(
        base_, hn::Add(hn::Load(Words(), memory_ + k), hn::Add(all(Layout::nodes_at), hn::ShiftLeft<3>(w))));
    const hn::Repartition<std::uint32_t, Words> halves;
    const auto before = hn::MulEven(hn::BitCast(halves, w), hn::BitCast(halves, per));
    upto = hn::Shl(word, hn::Sub(all(63), hn::Sub(p, before)));
    ones = hn::Add(hn::Shr(word, per), hn::PopulationCount(upto));
  }

  // Finds the first nodes; returns the greatest number of steps in the group.
  std::uint64_t begin() {
    auto steps = hn::Zero(Words());
    for (std::size_t k = 0; k < size_; k += hn::Lanes(Words())) {
      const Layouts l{load_each(base_, hn::Load(Words(), memory_ + k))};
      hn::Store(l.header, Words(), header_ + k);
      const auto below = l.below_top();
      const auto mask = hn::Sub(hn::Shl(all(1), hn::Add(l.top(), below)), all(1));
      const auto p = hn::Shr(hn::And(index_at(k), mask), below);
      hn::Store(p, Words(), p_ + k);
      prefetch_each(word_address(l, p, k));
      steps = hn::Max(steps, hn::ShiftRight<1>(hn::Sub(below, l.in_block())));
    }
    return hn::GetLane(hn::MaxOfLanes(Words(), steps));
  }

  // Takes one step of all lookups with at least `left` steps to go: the longest ways go first.
  void step(std::uint64_t left) {
    for (std::size_t k = 0; k < size_; k += hn::Lanes(Words())) {
      const Layouts l{hn::Load(Words(), header_ + k)};
      auto p = hn::Load(Words(), p_ + k), upto = p, ones = p;
      look(l, p, k, upto, ones);
      const auto in_block = l.in_block(), shift = hn::Add(in_block, all(2 * (left - 1)));
      const auto digit = hn::And(hn::Shr(index_at(k), shift), all(3));
      const auto child =
          hn::Add(hn::Add(hn::Sub(hn::Shl(all(1), l.top()), all(4)), hn::ShiftLeft<2>(ones)), digit);
      const auto internal = hn::Lt(hn::BitCast(Offsets(), upto), hn::Zero(Offsets()));
      const auto waits = hn::Lt(hn::BitCast(Offsets(), hn::Sub(l.below_top(), in_block)),
                                hn::Set(Offsets(), static_cast<std::int64_t>(2 * left)));
      p = hn::IfThenElse(hn::RebindMask(Words(), hn::AndNot(waits, internal)), child, p);
      hn::Store(p, Words(), p_ + k);
      prefetch_each(word_address(l, p, k));
    }
  }

  // Finds, from the last nodes, the eight bytes that end with the state's byte, the shift, and the mask.
  void look_for_states() {
    for (std::size_t k = 0; k < size_; k += hn::Lanes(Words())) {
      const Layouts l{hn::Load(Words(), header_ + k)};
      auto p = hn::Load(Words(), p_ + k), upto = p, ones = p;
      look(l, p, k, upto, ones);
      const auto in_block = l.in_block(), parents = l.parents(), log_b = l.log_b();
      const auto inside = hn::And(index_at(k), hn::Sub(hn::Shl(all(1), in_block), all(1)));
      const auto block = hn::Add(hn::Shl(hn::Sub(hn::Sub(ones, all(1)), parents), in_block), inside);
      const auto leaf = hn::Sub(hn::Add(hn::Shl(l.blocks(), in_block), p), ones);
      const auto internal =
          hn::RebindMask(Words(), hn::Lt(hn::BitCast(Offsets(), upto), hn::Zero(Offsets())));
      const auto bit = hn::Shl(hn::IfThenElse(internal, block, leaf), log_b);
      // The last node is (1 << top) + 4 parents - 1.
      const auto last =
          l.word_of(hn::Add(hn::Shl(all(1), l.top()), hn::Sub(hn::ShiftLeft<2>(parents), all(1))));
      const auto blocks_at = hn::Add(hn::ShiftLeft<3>(hn::Add(last, all(1))), all(Layout::nodes_at));
      const auto byte = hn::Add(hn::Add(hn::Load(Words(), memory_ + k), blocks_at), hn::ShiftRight<3>(bit));
      hn::Store(hn::Sub(byte, all(7)), Words(), state_at_ + k);
      hn::Store(hn::Add(hn::And(bit, all(7)), all(56)), Words(), p_ + k);
      hn::Store(hn::Add(hn::Add(log_b, log_b), all(1)), Words(), header_ + k);
      prefetch_each(byte);
    }
  }

  const std::uint8_t* base_;
  std::size_t size_;
  HWY_ALIGN std::uint64_t memory_[group], header_[group], p_[group], state_at_[group];
  HWY_ALIGN std::uint32_t index_[group];
  HWY_ALIGN std::uint8_t state_[group];
};

template <class MemoryOf>
void find_all(const std::uint32_t* index, std::uint8_t* state, std::size_t count, MemoryOf memory_of) {
  Group together;
  for (std::size_t k = 0; k < count; k += group)
    together.find(index + k, state + k, std::min(group, count - k),
                  [&memory_of, k](std::size_t i) { return memory_of(k + i); });
}

#else

template <class MemoryOf>
void find_all(const std::uint32_t* index, std::uint8_t* state, std::size_t count, MemoryOf memory_of) {
  for (std::size_t k = 0; k < count; ++k) state[k] = HWY_NAMESPACE::find(memory_of(k), index[k]);
}

#endif

void find_each(const std::uint8_t* memory, const std::uint32_t* index, std::uint8_t* state,
               std::size_t count) {
  find_all(index, state, count, [memory](std::size_t) { return memory; });
}

void find_in_many(const Tree* const* trees, const std::uint32_t* which, const std::uint32_t* index,
                  std::uint8_t* state, std::size_t count) {
  find_all(index, state, count, [=](std::size_t k) { return trees[which[k]]->memory(); });
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::tree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::tree {

HWY_EXPORT(find_one);
HWY_EXPORT(find_each);
HWY_EXPORT(find_in_many);

namespace detail {

std::uint8_t find(const std::uint8_t* memory, std::uint64_t index) noexcept {
  return HWY_DYNAMIC_DISPATCH(find_one)(memory, index);
}

void find_each(const std::uint8_t* memory, const std::uint32_t* index, std::uint8_t* state,
               std::size_t count) noexcept {
  HWY_DYNAMIC_DISPATCH(find_each)(memory, index, state, count);
}

void find_in_many(const Tree* const* trees, const std::uint32_t* which, const std::uint32_t* index,
                  std::uint8_t* state, std::size_t count) noexcept {
  HWY_DYNAMIC_DISPATCH(find_in_many)(trees, which, index, state, count);
}

}  // namespace detail
}  // namespace mmverify::impl::tree
#endif  // HWY_ONCE
