#include "impl/bake_sixteen.hpp"

#include <cmath>

#include "impl/bake_sixteen_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake_sixteen.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

// Compiled once for each target.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using Float = hn::Vec<F>;
using Int = hn::Vec<I>;
using Table = SixteenLanes::Floats;

// ---------------------------------------------------------------------------------------------------------------------
// Vectors
// ---------------------------------------------------------------------------------------------------------------------

HWY_INLINE Float set(float x) { return hn::Set(F(), x); }
HWY_INLINE Int set(std::int32_t x) { return hn::Set(I(), x); }

/// floor, as a whole number; exact for what is local.
HWY_INLINE Int floored(Float x) {
  const Int towards_zero = hn::ConvertTo(I(), x);
  return hn::Add(towards_zero,
                 hn::BitCast(I(), hn::VecFromMask(F(), hn::Lt(x, hn::ConvertTo(F(), towards_zero)))));
}

/// table[at].  Domain: at in [0, 16).
template <class D, class Value>
HWY_INLINE hn::Vec<D> among(D d, const Value* table, Int at) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, at));
#else
  return hn::GatherIndex(d, table, at);
#endif
}
/// Domain: at in [0, 32).
HWY_INLINE Int among_rows(const std::uint32_t* rows, Int at) {
  const auto* const table = reinterpret_cast<const std::int32_t*>(rows);
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  const auto index = hn::IndicesFromVec(I(), hn::And(at, set(15)));
  return hn::IfThenElse(hn::Gt(at, set(15)), hn::TableLookupLanes(hn::LoadU(I(), table + 16), index),
                        hn::TableLookupLanes(hn::LoadU(I(), table), index));
#else
  return hn::GatherIndex(I(), table, at);
#endif
}

template <class Mask>
HWY_INLINE std::uint32_t bits_of(Mask mask, std::size_t k) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(F(), mask, bytes.data());
  return (bytes[0] | std::uint32_t{bytes[1]} << 8) << k;
}
HWY_INLINE std::uint32_t zeros_of(Int x, std::size_t k) {
  return bits_of(hn::RebindMask(F(), hn::Eq(x, set(0))), k);
}

/// Bits [from, to].  Domain: 0 <= from <= to < 32.
HWY_INLINE Int run(Int from, Int to) {
  const U u;
  const auto length = hn::BitCast(u, hn::Sub(set(31), hn::Sub(to, from)));
  return hn::BitCast(I(), hn::Shl(hn::Shr(hn::Set(u, ~std::uint32_t{0}), length), hn::BitCast(u, from)));
}

// ---------------------------------------------------------------------------------------------------------------------
// Samples
// ---------------------------------------------------------------------------------------------------------------------

/// alpha = a + fx right + fy (below + fx twist), stored, of one cell.
struct Cell {
  Float a, right, below, twist;

  HWY_INLINE Float at(Float fx, Float fy) const {
    return hn::MulAdd(fy, hn::MulAdd(fx, twist, below), hn::MulAdd(fx, right, a));
  }
};
template <class Texel>
HWY_INLINE Cell cell(const SixteenInput& in, Int i, Int j) {
  constexpr int bits = 8 * sizeof(Texel);
  const Int mask = set((1 << bits) - 1), at = hn::Add(hn::Mul(j, set(in.pitch)), i);
  const auto word = [&](Int where) HWY_ATTR {
    return hn::GatherOffset(I(), static_cast<const std::int32_t*>(in.texels),
                            sizeof(Texel) == 1 ? where : hn::ShiftLeft<1>(where));
  };
  const auto first = [&](Int w) HWY_ATTR { return hn::And(w, mask); };
  const auto second = [&](Int w) HWY_ATTR { return hn::And(hn::ShiftRight<bits>(w), mask); };
  const Int top = word(at), under = word(hn::Add(at, set(in.pitch)));
  const Int a = first(top), right = hn::Sub(second(top), a), below = hn::Sub(first(under), a);
  const Int twist = hn::Sub(hn::Sub(second(under), first(under)), right);
  return {hn::ConvertTo(F(), a), hn::ConvertTo(F(), right), hn::ConvertTo(F(), below),
          hn::ConvertTo(F(), twist)};
}

/// A place's cell, and its place in it.
struct Located {
  Int i, j;
  Float x, y;

  HWY_INLINE Located(Float at_x, Float at_y)
      : i(floored(at_x)),
        j(floored(at_y)),
        x(hn::Sub(at_x, hn::ConvertTo(F(), i))),
        y(hn::Sub(at_y, hn::ConvertTo(F(), j))) {}
};

/// A row of texels from column i on, from bit 0.
HWY_INLINE Int row_from(const SixteenInput& in, const std::uint32_t* rows, const std::uint8_t* bytes, Int i,
                        Int j) {
  if (rows != nullptr) return hn::Shr(among_rows(rows, j), i);
  const Int x = hn::Add(i, set(in.bit_x)), at = hn::Add(hn::Mul(j, set(in.bit_pitch)), hn::ShiftRight<3>(x));
  return hn::Shr(hn::GatherOffset(I(), reinterpret_cast<const std::int32_t*>(bytes), at), hn::And(x, set(7)));
}

using Mask = hn::Mask<F>;
struct Marked {
  Mask below, opaque;
};
/// What the samples at places bear by their cells.
// This and the larger functions below are not inlined: under sanitizers a compiler would take minutes.
HWY_NOINLINE Marked by_cells(const SixteenInput& in, const Located& at) {
  const Int next = hn::Add(at.j, set(1)), one = set(1);
  Int top = row_from(in, in.rows_opaque, in.bits_opaque, at.i, at.j),
      under = row_from(in, in.rows_opaque, in.bits_opaque, at.i, next);
  const Int some = hn::Or(top, under);
  if (in.gap != 0) {
    top = row_from(in, in.rows_visible, in.bits_visible, at.i, at.j);
    under = row_from(in, in.rows_visible, in.bits_visible, at.i, next);
  }
  const Int all = hn::And(top, under);
  return {hn::RebindMask(F(), hn::Eq(hn::And(hn::Or(some, hn::ShiftRight<1>(some)), one), set(0))),
          hn::RebindMask(F(), hn::Eq(hn::And(hn::And(all, hn::ShiftRight<1>(all)), one), one))};
}

/// g at those places that are wanted.
template <class Texel>
HWY_INLINE Float sampled(const SixteenInput& in, const Located& at, Mask wanted) {
  // The others read one texel, which costs less than many.
  const auto is_wanted = hn::RebindMask(I(), wanted);
  const Cell c = cell<Texel>(in, hn::IfThenElseZero(is_wanted, at.i), hn::IfThenElseZero(is_wanted, at.j));
  return hn::Sub(c.at(at.x, at.y), set(in.threshold));
}

/// Lane l: bit k + l.
HWY_INLINE Mask mask_of(std::uint32_t bits, std::size_t k) {
  const Int lanes = hn::Shr(set(static_cast<std::int32_t>(bits >> k)), hn::Iota(I(), 0));
  return hn::RebindMask(F(), hn::Eq(hn::And(lanes, set(1)), set(1)));
}

/// p0 + i p01 + j p02, along an axis.
HWY_INLINE Float place(const SixteenInput& in, std::size_t axis, Float i, Float j) {
  return hn::MulAdd(j, set(in.p02[axis]), hn::MulAdd(i, set(in.p01[axis]), set(in.p0[axis])));
}

struct Vertices {
  HWY_ALIGN Table x, y;
  HWY_ALIGN SixteenLanes::Ints marks;  ///< 1 below, 2 opaque
};

// ---------------------------------------------------------------------------------------------------------------------
// Texels and centres
// ---------------------------------------------------------------------------------------------------------------------

/// One edge, with dx/dy.
struct Slope {
  Float x, y, low, high, slope;

  HWY_INLINE Slope(Float xa, Float ya, Float xb, Float yb)
      : x(xa), y(ya), low(hn::Min(ya, yb)), high(hn::Max(ya, yb)) {
    const Float dy = hn::Sub(yb, ya);
    slope = hn::IfThenZeroElse(hn::Eq(dy, hn::Zero(F())), hn::Div(hn::Sub(xb, xa), dy));
  }
};

/// Bits of texels, of micro-triangles [k, k + lanes).
struct Bits {
  Int have, have_not;      ///< of all cells
  Int within, within_not;  ///< of those whose centres are within
};

HWY_NOINLINE Bits texels(const SixteenInput& in, const Vertices& v, std::size_t k) {
  const auto corner = [&](const Table& of, std::size_t c) HWY_ATTR {
    return among(F(), of.data(), hn::LoadU(I(), sixteen_lanes.corner[c].data() + k));
  };
  const Float x0 = corner(v.x, 0), x1 = corner(v.x, 1), x2 = corner(v.x, 2);
  const Float y0 = corner(v.y, 0), y1 = corner(v.y, 1), y2 = corner(v.y, 2);
  const Slope edges[] = {{x0, y0, x1, y1}, {x1, y1, x2, y2}, {x2, y2, x0, y0}};
  const Float d = set(2 * in.delta);
  const auto least = [](Float a, Float b, Float c) HWY_ATTR { return hn::Min(a, hn::Min(b, c)); };
  const auto greatest = [](Float a, Float b, Float c) HWY_ATTR { return hn::Max(a, hn::Max(b, c)); };
  const Float left = least(x0, x1, x2), right = greatest(x0, x1, x2);
  const Int first = floored(hn::Sub(least(y0, y1, y2), d)),
            rows = hn::Add(hn::Sub(floored(hn::Add(greatest(y0, y1, y2), d)), first), set(1));
  const Int box = run(floored(hn::Sub(left, d)), hn::Add(floored(hn::Add(right, d)), set(1)));
  const std::int32_t last = hn::GetLane(hn::MaxOfLanes(I(), rows));
  const Int zero = set(0);
  Bits bits{zero, zero, zero, zero};
  Int row = first;
  for (std::int32_t r = 0; r <= last;
       ++r, row = hn::Min(hn::Add(row, set(1)), set(static_cast<std::int32_t>(sixteen_window) - 1))) {
    const Int real = hn::IfThenZeroElse(hn::Lt(rows, set(r)), box);
    const Int are = among_rows(in.rows_opaque, row),
              seen = in.rows_visible == in.rows_opaque ? are : among_rows(in.rows_visible, row);
    bits.have = hn::Or(bits.have, hn::And(real, seen));
    bits.have_not = hn::Or(bits.have_not, hn::AndNot(are, real));
    // Where the row's centres are within.
    const Float level = hn::ConvertTo(F(), row);
    Float from = set(HUGE_VALF), to = set(-HUGE_VALF);
    for (const Slope& e : edges) {
      const auto meets = hn::And(hn::Ge(level, e.low), hn::Le(level, e.high));
      const Float at = hn::MulAdd(hn::Sub(level, e.y), e.slope, e.x);
      from = hn::IfThenElse(meets, hn::Min(from, at), from);
      to = hn::IfThenElse(meets, hn::Max(to, at), to);
    }
    const auto none = hn::RebindMask(I(), hn::Gt(from, to));
    // However that rounds, within the box.
    const Int begin = hn::Neg(floored(hn::Neg(hn::Min(hn::Max(from, left), right)))),
              end = floored(hn::Max(hn::Min(to, right), left));
    const Int inner =
        hn::IfThenZeroElse(hn::Or(hn::Gt(begin, end), none), hn::And(real, run(hn::Min(begin, end), end)));
    bits.within = hn::Or(bits.within, hn::And(inner, seen));
    bits.within_not = hn::Or(bits.within_not, hn::AndNot(are, inner));
  }
  return bits;
}

// ---------------------------------------------------------------------------------------------------------------------
// Edges
// ---------------------------------------------------------------------------------------------------------------------

/// Along one axis.
struct Walk {
  Float p, d, per, next;
  Int cell, step;

  HWY_INLINE Walk(Float from, Float to, float delta) : p(from), d(hn::Sub(to, from)) {
    const auto moves = hn::Gt(hn::Abs(d), set(delta));
    d = hn::IfThenElseZero(moves, d);
    cell = floored(from);
    const auto down = hn::Lt(d, set(0.0f));
    step = hn::IfThenElse(hn::RebindMask(I(), down), set(-1), set(1));
    per = hn::IfThenElse(moves, hn::Abs(hn::Div(set(1.0f), d)), set(4.0f));
    const Float line = hn::Add(hn::ConvertTo(F(), cell), hn::IfThenElse(down, set(0.0f), set(1.0f)));
    next = hn::IfThenElse(moves, hn::Mul(hn::Abs(hn::Sub(line, p)), per), set(4.0f));
  }
  /// From the cell's corner, at t.
  HWY_INLINE Float at(Float t) const { return hn::Sub(hn::MulAdd(t, d, p), hn::ConvertTo(F(), cell)); }
  template <class Mask>
  HWY_INLINE void pass(Mask passes) {
    cell = hn::Add(cell, hn::IfThenElseZero(hn::RebindMask(I(), passes), step));
    next = hn::Add(next, hn::IfThenElseZero(passes, per));
  }
};

/// Bit n: of the edge list[n].
struct EdgeMarks {
  std::uint32_t below = 0, opaque = 0, lacks_below = 0, lacks_opaque = 0;
};

template <class Texel>
HWY_NOINLINE void walk(const SixteenInput& in, const Vertices& v, const std::int32_t* list, std::size_t n,
                       EdgeMarks& marks) {
  const Int edge = hn::LoadU(I(), list + n);
  const Int from = hn::GatherIndex(I(), sixteen_lanes.from.data(), edge),
            to = hn::GatherIndex(I(), sixteen_lanes.to.data(), edge);
  const auto of = [](const Table& table, Int at) HWY_ATTR { return among(F(), table.data(), at); };
  Walk x(of(v.x, from), of(v.x, to), in.delta), y(of(v.y, from), of(v.y, to), in.delta);
  const Float one = set(1.0f);
  Float t = set(0.0f), at = t, least = set(HUGE_VALF), greatest = set(-HUGE_VALF), low = least,
        high = greatest;
  // Enough for any edge in the window; of one that is not done with by then nothing is certain.
  constexpr int most = 2 * sixteen_window + 4;
  auto going = hn::Lt(t, one);
  for (int count = 0; count < most; ++count) {
    const Cell c = cell<Texel>(in, x.cell, y.cell);
    const Float until = hn::Min(one, hn::Min(x.next, y.next)), part = hn::Sub(until, t);
    if (count == 0) {
      at = hn::Sub(c.at(x.at(t), y.at(t)), set(in.threshold));
      least = greatest = at;
    }
    const Float w = hn::Sub(c.at(x.at(until), y.at(until)), set(in.threshold));
    const Float K = hn::Abs(hn::Mul(hn::Mul(c.twist, hn::Mul(x.d, part)), hn::Mul(y.d, part)));
    const Float beyond = hn::Mul(K, set(0.25f));
    least = hn::IfThenElse(going, hn::Min(least, w), least);
    greatest = hn::IfThenElse(going, hn::Max(greatest, w), greatest);
    low = hn::IfThenElse(going, hn::Min(low, hn::Sub(hn::Min(at, w), beyond)), low);
    high = hn::IfThenElse(going, hn::Max(high, hn::Add(hn::Max(at, w), beyond)), high);
    at = w;
    t = until;
    going = hn::Lt(t, one);
    if (hn::AllFalse(F(), going)) break;
    const auto across = hn::Le(x.next, y.next);
    x.pass(hn::And(going, across));
    y.pass(hn::AndNot(across, going));
  }
  const auto done = hn::Not(going);
  const float bound = in.edge_bound;
  marks.below |= bits_of(hn::Lt(least, set(-bound)), n);
  marks.opaque |= bits_of(hn::Gt(greatest, set(bound - in.gap)), n);
  marks.lacks_below |= bits_of(hn::And(done, hn::Gt(low, set(bound))), n);
  marks.lacks_opaque |= bits_of(hn::And(done, hn::Lt(high, set(-bound - in.gap))), n);
}

/// What the edges of those that are not decided say.
template <class Texel>
HWY_NOINLINE void ask_edges(const SixteenInput& in, const Vertices& v, std::uint32_t undecided,
                            std::uint32_t within_lack_below, std::uint32_t within_lack_opaque,
                            SixteenMarks& marks) {
  std::uint32_t wanted = 0;
  for (std::uint32_t k = undecided; k != 0; k &= k - 1)
    wanted |= sixteen_lanes.edges[static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(k))];
  HWY_ALIGN std::array<std::int32_t, 32> list;
  list.fill(30);
  std::size_t count = 0;
  for (std::uint32_t e = wanted; e != 0; e &= e - 1)
    list[count++] = static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(e));
  EdgeMarks asked;
  for (std::size_t n = 0; n < count; n += hn::Lanes(F())) walk<Texel>(in, v, list.data(), n, asked);
  EdgeMarks found;
  for (std::size_t n = 0; n < count; ++n) {
    const auto e = static_cast<std::uint32_t>(list[n]);
    found.below |= (asked.below >> n & 1) << e;
    found.opaque |= (asked.opaque >> n & 1) << e;
    found.lacks_below |= (asked.lacks_below >> n & 1) << e;
    found.lacks_opaque |= (asked.lacks_opaque >> n & 1) << e;
  }
  for (std::uint32_t rest = undecided; rest != 0; rest &= rest - 1) {
    const auto k = hwy::Num0BitsBelowLS1Bit_Nonzero32(rest);
    const std::uint32_t bit = std::uint32_t{1} << k, edges = sixteen_lanes.edges[static_cast<std::size_t>(k)];
    if ((found.below & edges) != 0) marks.below |= bit;
    if ((found.opaque & edges) != 0) marks.opaque |= bit;
    if ((found.lacks_below & edges) == edges) marks.lacks_below |= bit & within_lack_below;
    if ((found.lacks_opaque & edges) == edges) marks.lacks_opaque |= bit & within_lack_opaque;
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------------------------------

template <class Texel>
HWY_INLINE SixteenMarks sixteen_of(const SixteenInput& in) {
  const F f;
  const std::size_t step = hn::Lanes(f);
  const auto lanes = [](const Table& of, std::size_t k) HWY_ATTR { return hn::LoadU(F(), of.data() + k); };
  // Bits are near, texels may be far; but where edges are to be walked, they are needed all the same.
  const bool cells_first = in.as_one || in.rows_opaque == nullptr;
  Vertices v;
  std::uint32_t seen_below = 0, seen_opaque = 0;
  for (std::size_t k = 0; k < 16; k += step) {
    const Float i = lanes(sixteen_lanes.vertex_i, k), j = lanes(sixteen_lanes.vertex_j, k);
    const Float x = place(in, 0, i, j), y = place(in, 1, i, j);
    hn::StoreU(x, f, v.x.data() + k);
    hn::StoreU(y, f, v.y.data() + k);
    const Located at(x, y);
    Marked m{hn::Lt(x, x), hn::Lt(x, x)};
    if (in.clear && cells_first) m = by_cells(in, at);
    if (in.as_one) {
      seen_below |= bits_of(m.below, k);
      seen_opaque |= bits_of(m.opaque, k);
      if (seen_below != 0 && seen_opaque != 0) return {1, 1};
    }
    const Mask wanted = hn::Not(hn::Or(m.below, m.opaque));
    if (!hn::AllFalse(f, wanted)) {
      const Float g = sampled<Texel>(in, at, wanted);
      m.below = hn::Or(m.below, hn::And(wanted, hn::Lt(g, set(-in.bound))));
      m.opaque = hn::Or(m.opaque, hn::And(wanted, hn::Gt(g, set(in.bound - in.gap))));
    }
    hn::StoreU(hn::Or(hn::IfThenElseZero(hn::RebindMask(I(), m.below), set(1)),
                      hn::IfThenElseZero(hn::RebindMask(I(), m.opaque), set(2))),
               I(), v.marks.data() + k);
  }
  SixteenMarks marks;
  for (std::size_t k = 0; k < 16; k += step) {
    const auto corner = [&](std::size_t c) HWY_ATTR {
      return among(I(), v.marks.data(), hn::LoadU(I(), sixteen_lanes.corner[c].data() + k));
    };
    const Int all = hn::Or(corner(0), hn::Or(corner(1), corner(2)));
    const std::uint32_t here = ((1u << step) - 1) << k;
    marks.below |= here & ~zeros_of(hn::And(all, set(1)), k);
    marks.opaque |= here & ~zeros_of(hn::And(all, set(2)), k);
  }
  const auto enough = [&] { return in.as_one && marks.below != 0 && marks.opaque != 0; };
  if (enough()) return marks;
  if (in.rows_opaque != nullptr && (marks.below & marks.opaque) != 0xffff) {
    std::uint32_t within_lack_below = 0, within_lack_opaque = 0;
    for (std::size_t k = 0; k < 16; k += step) {
      const Bits bits = texels(in, v, k);
      marks.lacks_below |= zeros_of(bits.have_not, k);
      marks.lacks_opaque |= zeros_of(bits.have, k);
      within_lack_below |= zeros_of(bits.within_not, k);
      within_lack_opaque |= zeros_of(bits.within, k);
    }
    marks.by_texels = marks.lacks_below | marks.lacks_opaque;
    if (in.clear) {
      marks.below |= ~within_lack_below & 0xffff;
      marks.opaque |= ~within_lack_opaque & 0xffff;
    }
    if (enough()) return marks;
    const std::uint32_t undecided = ~(marks.by_texels | (marks.below & marks.opaque)) & 0xffff;
    if (undecided != 0) ask_edges<Texel>(in, v, undecided, within_lack_below, within_lack_opaque, marks);
  }
  const std::uint32_t unknowns = marks.below & marks.opaque;
  if (!in.as_one && (unknowns != 0 || in.rows_opaque == nullptr))
    for (std::size_t k = 0; k < 16; k += step) {
      const Float i = lanes(sixteen_lanes.centroid_i, k), j = lanes(sixteen_lanes.centroid_j, k);
      const Located at(place(in, 0, i, j), place(in, 1, i, j));
      Mask wanted = mask_of(unknowns, k);
      // With one limit, a cell of one mark leans as its mark.  Where only samples are taken, others may yet
      // turn out to bear both.
      if (in.clear && in.gap == 0 && cells_first) {
        const Marked m = by_cells(in, at);
        const Mask known = hn::Or(m.below, m.opaque);
        marks.leans |= bits_of(known, k);
        marks.leans_to_opaque |= bits_of(m.opaque, k);
        wanted = hn::AndNot(known, wanted);
      }
      if (hn::AllFalse(f, wanted)) continue;
      const Float g = hn::Sub(sampled<Texel>(in, at, wanted), set(in.lean));
      marks.leans |= bits_of(hn::And(wanted, hn::Gt(hn::Abs(g), set(in.bound))), k);
      marks.leans_to_opaque |= bits_of(hn::And(wanted, hn::Gt(g, set(0.0f))), k);
    }
  return marks;
}

SixteenMarks Sixteen8(const SixteenInput& in) { return sixteen_of<std::uint8_t>(in); }
SixteenMarks Sixteen16(const SixteenInput& in) { return sixteen_of<std::uint16_t>(in); }

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

HWY_EXPORT(Sixteen8);
HWY_EXPORT(Sixteen16);

template <>
SixteenMarks sixteen<std::uint8_t>(const SixteenInput& in) {
  return HWY_DYNAMIC_DISPATCH(Sixteen8)(in);
}
template <>
SixteenMarks sixteen<std::uint16_t>(const SixteenInput& in) {
  return HWY_DYNAMIC_DISPATCH(Sixteen16)(in);
}

}  // namespace mmverify::impl::bake::detail
#endif
