#include "impl/bake/judge/centres.hpp"

#include <algorithm>
#include <cmath>

#include "impl/bake/texture/plane.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake/judge/centres.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#ifndef MMVERIFY_IMPL_BAKE_JUDGE_CENTRES_ROWS
#define MMVERIFY_IMPL_BAKE_JUDGE_CENTRES_ROWS
namespace mmverify::impl::bake::detail {

/// A triangle's corners from the top, the slopes dx/dy of its three edges, and the rows of centres in it.
struct CentreRows {
  PlanePoint top, middle, bottom;
  double long_slope, upper_slope, lower_slope;
  std::int32_t first, last;  ///< counted from the window's first row
};

}  // namespace mmverify::impl::bake::detail
#endif

// Compiled once for each target.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {
namespace centres {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Numbers = hn::Rebind<std::int32_t, Doubles>;
using Words = hn::RebindToUnsigned<Numbers>;
using Double = hn::Vec<Doubles>;
using Number = hn::Vec<Numbers>;
using Word = hn::Vec<Words>;

/// The bits from `from` on; all if that is below 0, none from 32 on.
HWY_INLINE Word bits_from(Number from) {
  const Numbers n;
  const Number at = hn::Max(from, hn::Zero(n));
  const auto is_in = hn::RebindMask(Words(), hn::Lt(at, hn::Set(n, 32)));
  const Word by = hn::BitCast(Words(), hn::And(at, hn::Set(n, 31)));
  return hn::IfThenElseZero(is_in, hn::Shl(hn::Set(Words(), ~0u), by));
}
HWY_INLINE bool has_any(Word x) { return !hn::AllTrue(Words(), hn::Eq(x, hn::Zero(Words()))); }

/// The marks of the rows from `row` on, counted from the window's first.
HWY_INLINE Marks block(const CentreRows& of, const WindowBits& in, std::int32_t row) {
  const Doubles d;
  const Numbers n;
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const Double level = hn::Add(hn::Iota(d, 0), set(static_cast<double>(in.top + row)));
  const auto line = [&](const PlanePoint& p, double slope) HWY_ATTR {
    return hn::MulAdd(hn::Sub(level, set(p.y)), set(slope), set(p.x));
  };
  const Double a = line(of.top, of.long_slope),
               b = hn::IfThenElse(hn::Le(level, set(of.middle.y)), line(of.top, of.upper_slope),
                                  line(of.middle, of.lower_slope));
  const Double left = set(static_cast<double>(in.left)), end = set(static_cast<double>(in.columns));
  // A row beyond the last has crossings anywhere: they are cut to the window, and count for nothing.
  const auto column = [&](Double x)
                          HWY_ATTR { return hn::DemoteTo(n, hn::Min(hn::Max(x, hn::Zero(d)), end)); };
  const Number first = column(hn::Sub(hn::Ceil(hn::Min(a, b)), left)),
               beyond = column(hn::Add(hn::Sub(hn::Floor(hn::Max(a, b)), left), set(1)));
  const auto real = hn::RebindMask(
      Words(), hn::Lt(hn::Add(hn::Iota(n, 0), hn::Set(n, row)), hn::Set(n, of.last + 1)));
  Word have = hn::Zero(Words()), have_not = have;
  const std::int32_t ends = static_cast<std::int32_t>(in.bit) + in.columns;
  std::size_t word = static_cast<std::size_t>(row);
  for (std::int32_t s = 0; s < ends; s += 32, word += in.strip) {
    const Number at = hn::Set(n, static_cast<std::int32_t>(in.bit) - s);
    const Word within = hn::IfThenElseZero(
        real, hn::AndNot(bits_from(hn::Add(beyond, at)), bits_from(hn::Add(first, at))));
    have = hn::Or(have, hn::And(within, hn::LoadU(Words(), in.visible + word)));
    have_not = hn::Or(have_not, hn::AndNot(hn::LoadU(Words(), in.opaque + word), within));
  }
  return static_cast<Marks>((has_any(have) ? opaque : 0) | (has_any(have_not) ? below : 0));
}

}  // namespace centres

Marks Within(const CentreRows& of, const WindowBits& in, Marks wanted) {
  constexpr auto lanes = static_cast<std::int32_t>(centres::hn::MaxLanes(centres::Doubles()));
  // The widest rows first, about the middle corner: most triangles have both marks there.
  const auto widest = static_cast<std::int32_t>(of.middle.y - static_cast<double>(in.top)) - lanes / 2;
  const std::int32_t from = std::clamp(widest, of.first, of.last);
  Marks marks = centres::block(of, in, from);
  for (std::int32_t row = of.first; row <= of.last && (marks & wanted) != wanted; row += lanes) {
    if (row == from) continue;
    marks = static_cast<Marks>(marks | centres::block(of, in, row));
  }
  return marks;
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

static_assert(Plane::rows_beyond >= 8);

HWY_EXPORT(Within);

Marks centres_within(const Triangle& p, const WindowBits& bits, Marks wanted) {
  CentreRows of{p[0], p[1], p[2], 0, 0, 0, 0, 0};
  if (of.middle.y < of.top.y) std::swap(of.middle, of.top);
  if (of.bottom.y < of.top.y) std::swap(of.bottom, of.top);
  if (of.bottom.y < of.middle.y) std::swap(of.bottom, of.middle);
  of.first = static_cast<std::int32_t>(-floored(-of.top.y) - bits.top);
  of.last = static_cast<std::int32_t>(floored(of.bottom.y) - bits.top);
  if (of.first > of.last) return 0;
  // A flat edge has no rows of its own.
  const auto slope = [](PlanePoint a, PlanePoint b) { return b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0; };
  of.long_slope = slope(of.top, of.bottom);
  of.upper_slope = slope(of.top, of.middle);
  of.lower_slope = slope(of.middle, of.bottom);
  return HWY_DYNAMIC_DISPATCH(Within)(of, bits, wanted);
}

}  // namespace mmverify::impl::bake::detail
#endif
