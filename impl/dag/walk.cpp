#include "impl/dag/walk.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/dag/walk.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::dag {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Takes one node a turn in all lanes; lanes whose state is known wait for the others, at word 0.  No branch depends on
// the maps.  Domain: `turns` for the highest level.
template <int bits>
void walk_all(const std::uint32_t* nodes, const std::uint32_t* tiles, std::uint32_t turns,
              detail::Walks& walks) {
  const hn::CappedTag<std::uint32_t, detail::Walks::most> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](std::uint32_t x) { return hn::Set(d, x); };
  const auto at = [&](const std::uint32_t* words, V place) {
    return hn::BitCast(
        d, hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(words), hn::BitCast(di, place)));
  };
  const V one = set(1), zero = hn::Zero(d);
  for (std::size_t k = 0; k < walks.count; k += hn::Lanes(d)) {
    V reference = hn::Load(d, walks.reference + k), level = hn::Load(d, walks.level + k), state = zero,
      tile = zero;
    const V index = hn::Load(d, walks.index + k);
    auto walking = hn::Ne(level, zero), in_tile = hn::Ne(zero, zero);
    level = hn::IfThenElse(walking, level, set(4));  // level 4, whose shifts are valid
    for (std::uint32_t turn = 0; turn < turns; ++turn) {
      // 16 children two levels below an odd level, 4 one level below an even one.
      const V odd = hn::And(level, one), below = hn::Sub(level, hn::Add(one, odd));
      const V child = hn::And(hn::Shr(index, hn::Add(below, below)),
                              hn::Or(set(3), hn::And(hn::Sub(zero, odd), set(12))));
      const V place = hn::IfThenElseZero(walking, hn::ShiftRight<1>(reference)), first = at(nodes, place);
      const auto mixed = hn::Ne(hn::And(hn::Shr(first, child), one), zero);
      const auto wide = hn::Ne(hn::And(reference, one), zero);
      const V rank = hn::PopulationCount(hn::And(first, hn::Sub(hn::Shl(one, child), one)));
      const V half = hn::Add(rank, set(1 + bits));
      const V of_reference = hn::IfThenElse(wide, hn::Add(rank, set(bits)), hn::ShiftRight<1>(half));
      // For a child of one state the word is the one with the last plane.
      const V word =
          at(nodes, hn::Add(place, hn::IfThenElse(hn::And(walking, mixed), of_reference, set(bits - 1))));
      const V narrow = hn::And(hn::Shr(word, hn::ShiftLeft<4>(hn::And(half, one))), set(0xFFFF));
      reference = hn::IfThenElse(wide, word, narrow);
      V plain = hn::And(hn::Shr(first, hn::Add(child, set(16))), one);
      if (bits == 2) plain = hn::Or(plain, hn::ShiftLeft<1>(hn::And(hn::Shr(word, child), one)));
      state = hn::IfThenElse(hn::And(walking, hn::Not(mixed)), plain, state);
      const auto ends = hn::And(hn::And(walking, mixed), hn::Eq(below, set(3)));
      tile = hn::IfThenElse(ends, reference, tile);
      in_tile = hn::Or(in_tile, ends);
      level = hn::IfThenElse(walking, below, level);
      walking = hn::And(hn::And(walking, mixed), hn::Ne(below, set(3)));
    }
    const V bit = hn::Mul(hn::And(index, set(63)), set(bits));
    const V place = hn::Add(hn::Mul(tile, set(2 * bits)), hn::ShiftRight<5>(bit));
    const V word = at(tiles, hn::IfThenElseZero(in_tile, place));
    const V found = hn::And(hn::Shr(word, hn::And(bit, set(31))), set((1 << bits) - 1));
    hn::Store(hn::IfThenElse(in_tile, found, state), d, walks.state + k);
  }
}

void walk(const std::uint32_t* nodes, const std::uint32_t* tiles, std::uint32_t bits, detail::Walks& walks) {
  const std::uint32_t highest = *std::max_element(walks.level, walks.level + walks.count),
                      turns = (highest - 2) / 2;
  if (bits == 1)
    walk_all<1>(nodes, tiles, turns, walks);
  else
    walk_all<2>(nodes, tiles, turns, walks);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::dag
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::dag {

HWY_EXPORT(walk);

namespace detail {

void walk(const std::uint32_t* nodes, const std::uint32_t* tiles, std::uint32_t bits, Walks& walks) noexcept {
  // Lanes beyond the last have level 0, and so nothing to walk.
  std::fill(walks.level + walks.count, walks.level + Walks::most, 0);
  HWY_DYNAMIC_DISPATCH(walk)(nodes, tiles, bits, walks);
}

}  // namespace detail
}  // namespace mmverify::impl::dag
#endif  // HWY_ONCE
