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

/// A triangle's corners from the top, the slopes dx/dy of its three edges, and rows counted from the window's first.
struct TriangleRows {
  PlanePoint top, middle, bottom;
  double long_slope, upper_slope, lower_slope;
  double margin;                       ///< 2 delta
  std::int32_t first_cell, last_cell;  ///< the rows of cells that it may meet
  std::int32_t first, last;            ///< the rows of centres in it
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

HWY_INLINE Double set(double x) { return hn::Set(Doubles(), x); }
HWY_INLINE Number set(std::int32_t x) { return hn::Set(Numbers(), x); }

/// The bits from `from` on; all if that is below 0, none from 32 on.
HWY_INLINE Word bits_from(Number from) {
  const Number at = hn::Max(from, set(0));
  const auto is_in = hn::RebindMask(Words(), hn::Lt(at, set(32)));
  const Word by = hn::BitCast(Words(), hn::And(at, set(31)));
  return hn::IfThenElseZero(is_in, hn::Shl(hn::Set(Words(), ~0u), by));
}
/// The bits [from, end).
HWY_INLINE Word run(Number from, Number end) { return hn::AndNot(bits_from(end), bits_from(from)); }
HWY_INLINE bool has_any(Word x) { return !hn::AllTrue(Words(), hn::Eq(x, hn::Zero(Words()))); }

/// The part of a row, or of a strip between rows, in a triangle.
struct Span {
  Double from, to;
};
HWY_INLINE Span at_level(const TriangleRows& of, Double level) {
  const auto line = [&](const PlanePoint& p, double slope)
                        HWY_ATTR { return hn::MulAdd(hn::Sub(level, set(p.y)), set(slope), set(p.x)); };
  const Double a = line(of.top, of.long_slope),
               b = hn::IfThenElse(hn::Le(level, set(of.middle.y)), line(of.top, of.upper_slope),
                                  line(of.middle, of.lower_slope));
  return {hn::Min(a, b), hn::Max(a, b)};
}
/// The part between two levels, grown by the margin along both axes.
HWY_INLINE Span between(const TriangleRows& of, Double low, Double high) {
  const auto within = [&](Double y) HWY_ATTR { return hn::Min(hn::Max(y, set(of.top.y)), set(of.bottom.y)); };
  const Double above = within(hn::Sub(low, set(of.margin))), under = within(hn::Add(high, set(of.margin)));
  const Span a = at_level(of, above), b = at_level(of, under);
  Double from = hn::Min(a.from, b.from), to = hn::Max(a.to, b.to);
  const Double x = set(of.middle.x), y = set(of.middle.y);
  const auto has_middle = hn::And(hn::Le(above, y), hn::Le(y, under));
  from = hn::IfThenElse(has_middle, hn::Min(from, x), from);
  to = hn::IfThenElse(has_middle, hn::Max(to, x), to);
  return {hn::Sub(from, set(of.margin)), hn::Add(to, set(of.margin))};
}

/// Some rows of bits, a row in each lane.
struct Rows {
  Word have, have_not;  ///< centres within: visible; not opaque
  Word mixed, begins;   ///< cells met: mixed; with an opaque first texel
};

/// Bits of a row and the row under it, together.
struct Pair {
  Word all, some;  ///< all are opaque; some are visible
};
HWY_INLINE Pair pair_at(const WindowBits& in, std::size_t word) {
  const auto at = [](const std::uint32_t* of) HWY_ATTR { return hn::LoadU(Words(), of); };
  return {hn::And(at(in.opaque + word), at(in.opaque + word + 1)),
          hn::Or(at(in.visible + word), at(in.visible + word + 1))};
}
/// x moved by one column to the left, with the first column of the next strip.
HWY_INLINE Word next_column(Word x, Word next) {
  return hn::Or(hn::ShiftRight<1>(x), hn::ShiftLeft<31>(next));
}

/// The rows from `row` on, counted from the window's first.
template <bool cells>
HWY_INLINE Rows block(const TriangleRows& of, const WindowBits& in, std::int32_t row) {
  const Doubles d;
  const Numbers n;
  const Double level = hn::Add(hn::Iota(d, 0), set(static_cast<double>(in.top + row)));
  const Double left = set(static_cast<double>(in.left));
  // A row beyond the last has crossings anywhere: they are cut to the window, and count for nothing.
  const auto column = [&](Double x, std::int32_t end) HWY_ATTR {
    return hn::DemoteTo(n, hn::Min(hn::Max(x, hn::Zero(d)), set(static_cast<double>(end))));
  };
  const auto rows = [&](std::int32_t first, std::int32_t last) HWY_ATTR {
    const Number at = hn::Add(hn::Iota(n, 0), set(row));
    return hn::RebindMask(Words(), hn::And(hn::Gt(at, set(first - 1)), hn::Lt(at, set(last + 1))));
  };
  const Span centre = at_level(of, level);
  const Number first = column(hn::Sub(hn::Ceil(centre.from), left), in.columns),
               beyond = column(hn::Add(hn::Sub(hn::Floor(centre.to), left), set(1.0)), in.columns);
  const auto real = rows(of.first, of.last), real_cells = rows(of.first_cell, of.last_cell);
  Number first_cell = first, beyond_cell = beyond;
  if constexpr (cells) {
    const Span cell = between(of, level, hn::Add(level, set(1.0)));
    // The last texel begins no cell that is met.
    first_cell = column(hn::Sub(hn::Floor(cell.from), left), in.columns - 1);
    beyond_cell = column(hn::Add(hn::Sub(hn::Floor(cell.to), left), set(1.0)), in.columns - 1);
  }
  Rows found{hn::Zero(Words()), hn::Zero(Words()), hn::Zero(Words()), hn::Zero(Words())};
  // The strips that a row reaches: of a large triangle, not all.
  std::int32_t s = 0, ends = static_cast<std::int32_t>(in.bit) + in.columns;
  if (ends > 64) {
    const auto bit = static_cast<std::int32_t>(in.bit);
    s = (bit + hn::GetLane(hn::MinOfLanes(n, hn::Min(first, first_cell)))) / 32 * 32;
    ends = bit + hn::GetLane(hn::MaxOfLanes(n, hn::Max(beyond, beyond_cell)));
  }
  std::size_t word = static_cast<std::size_t>(row) + in.strip * static_cast<std::size_t>(s / 32);
  for (; s < ends; s += 32, word += in.strip) {
    const Number at = set(static_cast<std::int32_t>(in.bit) - s);
    const Word are = hn::LoadU(Words(), in.opaque + word);
    const Word within = hn::IfThenElseZero(real, run(hn::Add(first, at), hn::Add(beyond, at)));
    found.have = hn::Or(found.have, hn::And(within, hn::LoadU(Words(), in.visible + word)));
    found.have_not = hn::Or(found.have_not, hn::AndNot(are, within));
    if constexpr (cells) {
      const Word met = hn::IfThenElseZero(real_cells, run(hn::Add(first_cell, at), hn::Add(beyond_cell, at)));
      const Pair here = pair_at(in, word), next = pair_at(in, word + in.strip);
      const Word all = hn::And(here.all, next_column(here.all, next.all)),
                 some = hn::Or(here.some, next_column(here.some, next.some));
      found.mixed = hn::Or(found.mixed, hn::AndNot(all, hn::And(met, some)));
      found.begins = hn::Or(found.begins, hn::And(met, are));
    }
  }
  return found;
}

/// All rows, until all wanted marks are found; cells until one is mixed.
HWY_INLINE TriangleBits take(const TriangleRows& of, const WindowBits& in, Marks wanted) {
  constexpr auto lanes = static_cast<std::int32_t>(hn::MaxLanes(Doubles()));
  const std::int32_t begin = in.has_cells ? of.first_cell : of.first,
                     last = in.has_cells ? of.last_cell : of.last;
  TriangleBits found{0, !in.has_cells, false};
  if (begin > last) return found;
  // The widest rows first, about the middle corner: most triangles have both marks there.
  const auto widest = static_cast<std::int32_t>(of.middle.y - static_cast<double>(in.top)) - lanes / 2;
  const std::int32_t from = last - begin < lanes ? begin : std::clamp(widest, begin, last);
  const auto look = [&](std::int32_t row) HWY_ATTR {
    const Rows rows = found.meets_mixed ? block<false>(of, in, row) : block<true>(of, in, row);
    found.centres = static_cast<Marks>(found.centres | (has_any(rows.have) ? opaque : 0) |
                                       (has_any(rows.have_not) ? below : 0));
    if (found.meets_mixed) return;
    found.meets_mixed = has_any(rows.mixed);
    found.begins_opaque = found.begins_opaque || has_any(rows.begins);
  };
  look(from);
  const auto has_all = [&]() HWY_ATTR { return (found.centres & wanted) == wanted; };
  // Then on both sides of them in turn.
  bool asked_all = true;
  for (std::int32_t up = from - lanes, down = from + lanes; asked_all && (up > begin - lanes || down <= last);
       up -= lanes, down += lanes) {
    asked_all = !has_all();
    if (asked_all && down <= last) look(down);
    if (up <= begin - lanes) continue;
    asked_all = asked_all && !has_all();
    if (asked_all) look(std::max(up, begin));
  }
  // A cell that nobody asked may be mixed: the caller may trust less marks than it wanted.
  found.meets_mixed = found.meets_mixed || !asked_all;
  return found;
}

}  // namespace centres

TriangleBits BitsWithin(const TriangleRows& of, const WindowBits& in, Marks wanted) {
  return centres::take(of, in, wanted);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

static_assert(Plane::rows_beyond >= 8 + 1);

HWY_EXPORT(BitsWithin);

TriangleBits bits_within(const Triangle& p, const WindowBits& bits, double delta, Marks wanted) {
  TriangleRows of{p[0], p[1], p[2], 0, 0, 0, 2 * delta, 0, 0, 0, 0};
  if (of.middle.y < of.top.y) std::swap(of.middle, of.top);
  if (of.bottom.y < of.top.y) std::swap(of.bottom, of.top);
  if (of.bottom.y < of.middle.y) std::swap(of.bottom, of.middle);
  // A flat triangle is its edges, and has no crossing at its last corner.
  if (!(of.bottom.y > of.top.y)) return {};
  const auto row = [&bits](std::int64_t j) { return static_cast<std::int32_t>(j - bits.top); };
  of.first = row(-floored(-of.top.y));
  of.last = row(floored(of.bottom.y));
  of.first_cell = row(floored(of.top.y - delta));
  of.last_cell = row(floored(of.bottom.y + delta));
  // A flat edge has no rows of its own.
  const auto slope = [](PlanePoint a, PlanePoint b) { return b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0; };
  of.long_slope = slope(of.top, of.bottom);
  of.upper_slope = slope(of.top, of.middle);
  of.lower_slope = slope(of.middle, of.bottom);
  return HWY_DYNAMIC_DISPATCH(BitsWithin)(of, bits, wanted);
}

}  // namespace mmverify::impl::bake::detail
#endif
