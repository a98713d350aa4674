#include "bench/dag/csm_walk.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/dag/csm_walk.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Takes one node a turn in all lanes; lanes at a leaf wait for the others, and lanes of a transparent subtree stay at
// node 0, whose mask is empty.  No branch depends on the maps.
void csm_walk(const std::uint32_t* words, CsmWalks& walks) {
  const hn::CappedTag<std::uint32_t, CsmWalks::most> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](std::uint32_t x) { return hn::Set(d, x); };
  const auto at = [&](V place) {
    return hn::BitCast(
        d, hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(words), hn::BitCast(di, place)));
  };
  const V one = set(1), zero = hn::Zero(d), leaf = set(4);
  const std::uint32_t turns = (*std::max_element(walks.level, walks.level + walks.count) - 4) / 2;
  for (std::size_t k = 0; k < walks.count; k += hn::Lanes(d)) {
    V node = hn::Load(d, walks.node + k), level = hn::Load(d, walks.level + k);
    const V index = hn::Load(d, walks.index + k), bits = hn::Load(d, walks.bits + k);
    for (std::uint32_t turn = 0; turn < turns; ++turn) {
      const auto inner = hn::Ne(level, leaf);
      const V below = hn::Sub(level, set(2));
      const V child = hn::And(hn::Shr(index, hn::Add(below, below)), set(15)), header = at(node);
      const auto present = hn::And(inner, hn::Ne(hn::And(hn::Shr(header, child), one), zero));
      const V rank = hn::PopulationCount(hn::And(header, hn::Sub(hn::Shl(one, child), one)));
      const V next = at(hn::Add(node, hn::IfThenElseZero(present, hn::Add(rank, one))));
      node = hn::IfThenElse(inner, hn::IfThenElseZero(present, next), node);
      level = hn::IfThenElse(inner, below, level);
    }
    const V child = hn::And(hn::ShiftRight<4>(index), set(15)), header = at(node);
    const auto present = hn::Ne(hn::And(hn::Shr(header, child), one), zero);
    const V rank = hn::PopulationCount(hn::And(header, hn::Sub(hn::Shl(one, child), one)));
    // 16 states take half a word, or a whole one: the bit counts from the end of the header.
    const V bit = hn::Add(hn::Mul(hn::ShiftLeft<4>(rank), bits), hn::Mul(hn::And(index, set(15)), bits));
    const V word = at(hn::Add(node, hn::IfThenElseZero(present, hn::Add(hn::ShiftRight<5>(bit), one))));
    const V state = hn::And(hn::Shr(word, hn::And(bit, set(31))), hn::Sub(hn::Shl(one, bits), one));
    hn::Store(hn::IfThenElseZero(present, state), d, walks.state + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::bench {

HWY_EXPORT(csm_walk);

void csm_walk(const std::uint32_t* words, CsmWalks& walks) noexcept {
  // Lanes beyond the last begin at node 0.
  constexpr std::uint32_t leaf_level = 4;
  std::fill(walks.node + walks.count, walks.node + CsmWalks::most, 0);
  std::fill(walks.level + walks.count, walks.level + CsmWalks::most, leaf_level);
  std::fill(walks.bits + walks.count, walks.bits + CsmWalks::most, 1);
  HWY_DYNAMIC_DISPATCH(csm_walk)(words, walks);
}

}  // namespace mmverify::bench
#endif  // HWY_ONCE
