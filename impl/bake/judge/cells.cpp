#include "impl/bake/judge/cells.hpp"

#include <algorithm>
#include <cmath>

#include "impl/bake/judge/piece.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake/judge/cells.cpp"
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
using Bits = hn::Vec<U>;

HWY_INLINE Float set(float x) { return hn::Set(F(), x); }

/// Columns of a word that are asked at once: a cell's right texels are in the word, too.
constexpr std::int32_t stride = 31;
constexpr std::size_t most_strips = CellWindow::most / stride, most_rows = 96;
static_assert(most_strips * stride == CellWindow::most && most_rows >= CellWindow::most + 1);

/// Rows [r, r + lanes) of a plane from column x on, from bit 0.
HWY_INLINE Bits rows_of(const CellWindow& w, const std::uint32_t* plane, std::int32_t r, std::int32_t x) {
  const std::uint32_t at = w.bit + static_cast<std::uint32_t>(x), bit = at % 32;
  const std::uint32_t* const word = plane + w.strip * (at / 32) + r;
  const U u;
  const Bits low = hn::Shr(hn::LoadU(u, word), hn::Set(u, bit));
  // 32 - bit places, which no shift may be.
  const Bits high =
      hn::Shl(hn::Add(hn::LoadU(u, word + w.strip), hn::LoadU(u, word + w.strip)), hn::Set(u, 31 - bit));
  return hn::Or(low, high);
}

/// From x to x on a row.
struct Span {
  Float from, to;

  /// Bits of [ceil(from) or floor(from), floor(to)] less x, of `count` at most 31; `closed`: floor(from).
  template <bool closed>
  HWY_INLINE Bits run(std::int32_t x, std::int32_t count) const {
    const Float zero = hn::Zero(F()), origin = set(static_cast<float>(x)),
                before = set(static_cast<float>(x - 1)), end = set(static_cast<float>(count));
    const Float begins = hn::Sub(from, closed ? origin : before), ends = hn::Sub(to, before);
    const U u;
    const Bits all = hn::Set(u, ~std::uint32_t{0});
    const auto whole = [](Float place) HWY_ATTR { return hn::BitCast(U(), hn::ConvertTo(I(), place)); };
    return hn::AndNot(hn::Shl(all, whole(hn::Min(hn::Max(ends, zero), end))),
                      hn::Shl(all, whole(hn::Min(hn::Max(begins, zero), set(31)))));
  }
};

/// What the lines leave, each moved: by `out` outwards along x, in rows [y, y + 1) where `of_cells`.
struct Between {
  std::array<Float, 3> slope, low, high;
  bool ab_left;

  HWY_INLINE Between(const CellWindow& w, float margins, bool of_cells) : ab_left(w.ab_left) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float s = w.slope[k], out = margins * w.margin[k];
      slope[k] = set(s);
      low[k] = set(w.at[k] - out + (of_cells ? std::min(s, 0.0f) : 0));
      high[k] = set(w.at[k] + out + (of_cells ? std::max(s, 0.0f) : 0));
    }
  }
  HWY_INLINE Span at(Float row) const {
    const auto line = [&](const std::array<Float, 3>& of, std::size_t k)
                          HWY_ATTR { return hn::MulAdd(row, slope[k], of[k]); };
    if (ab_left) return {hn::Max(line(low, 0), line(low, 1)), line(high, 2)};
    return {line(low, 2), hn::Min(line(high, 0), line(high, 1))};
  }
};

HWY_INLINE Float row_numbers(std::int32_t r) { return hn::ConvertTo(F(), hn::Iota(I(), r)); }

/// Those of `count` columns from x on, of rows [r, r + lanes), that are mixed.
HWY_INLINE Bits mixed_cells(const CellWindow& w, std::int32_t r, std::int32_t x) {
  const Bits top = rows_of(w, w.opaque, r, x), under = rows_of(w, w.opaque, r + 1, x);
  const Bits all = hn::And(top, under);
  Bits some = hn::Or(top, under);
  if (w.visible != w.opaque) some = hn::Or(rows_of(w, w.visible, r, x), rows_of(w, w.visible, r + 1, x));
  return hn::AndNot(hn::And(all, hn::ShiftRight<1>(all)), hn::Or(some, hn::ShiftRight<1>(some)));
}

/// By strip and row, the mixed cells that may be met.
struct Mixed {
  std::array<std::array<std::uint32_t, most_rows>, most_strips> words;
};

HWY_INLINE bool mixed_met(const CellWindow& w, Mixed& mixed) {
  const U u;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(u));
  const Between outside(w, 1, true);
  Bits any = hn::Zero(u);
  for (std::int32_t r = 0; r < w.rows; r += lanes) {
    const Float row = row_numbers(r);
    const Span span = outside.at(row);
    const auto real = hn::RebindMask(u, hn::Lt(row, set(static_cast<float>(w.rows))));
    std::size_t strip = 0;
    for (std::int32_t x = 0; x < w.columns; x += stride, ++strip) {
      const Bits run = span.run<true>(x, std::min(stride, w.columns - x));
      const Bits met = hn::IfThenElseZero(real, hn::And(run, mixed_cells(w, r, x)));
      any = hn::Or(any, met);
      hn::StoreU(met, u, mixed.words[strip].data() + r);
    }
  }
  return !hn::AllTrue(u, hn::Eq(any, hn::Zero(u)));
}

/// Of the centres between the lines, `margins` margins outside, in rows from `top` to `bottom`.
HWY_INLINE Marks centres(const CellWindow& w, float margins, float top, float bottom) {
  const U u;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(u));
  const Between lines(w, margins, false);
  Bits have = hn::Zero(u), have_not = have;
  for (std::int32_t r = 0; r < w.rows; r += lanes) {
    const Float row = row_numbers(r);
    const Span span = lines.at(row);
    const auto real = hn::RebindMask(u, hn::And(hn::Ge(row, set(top)), hn::Le(row, set(bottom))));
    for (std::int32_t x = 0; x < w.columns; x += stride) {
      const Bits run = hn::IfThenElseZero(real, span.run<false>(x, std::min(stride, w.columns - x)));
      const Bits are = rows_of(w, w.opaque, r, x);
      have_not = hn::Or(have_not, hn::AndNot(are, run));
      have = hn::Or(have, hn::And(w.visible == w.opaque ? are : rows_of(w, w.visible, r, x), run));
    }
  }
  const auto is_some = [](Bits b) HWY_ATTR { return !hn::AllTrue(U(), hn::Eq(b, hn::Zero(U()))); };
  return static_cast<Marks>((is_some(have) ? opaque : 0) | (is_some(have_not) ? below : 0));
}

/// Of edge k in the mixed cells that it may meet.
template <class Texel>
HWY_INLINE void edge(const CellWindow& w, const CellTriangle<Texel>& t, const Mixed& mixed, std::size_t k,
                     Extremes& seen) {
  const U u;
  const auto lanes = static_cast<std::int32_t>(hn::Lanes(u));
  const Spot p = t.p[k], q = t.p[k == 2 ? 0 : k + 1];
  const Edge edge(p, q);
  const auto left = static_cast<float>(std::min(p.x, q.x) - 2 * t.margin),
             right = static_cast<float>(std::max(p.x, q.x) + 2 * t.margin),
             first = static_cast<float>(floored(std::min(p.y, q.y) - t.margin)),
             last = static_cast<float>(floored(std::max(p.y, q.y) + t.margin));
  // Where it falls by next to nothing, its box is all that bounds it.  Else slopes are off by less than
  // 2^8 delta (1 + |s|) (bake_lines.hpp), on rows that are not a whole one from its ends.
  const double dy = q.y - p.y;
  const bool is_flat = std::fabs(dy) < 0x1p-5;
  const double s = is_flat ? 0 : (q.x - p.x) / dy, out = t.margin * (1 + std::fabs(s)), at = p.x - p.y * s;
  const auto slope = static_cast<float>(s), low = static_cast<float>(at - out + std::min(s, 0.0)),
             high = static_cast<float>(at + out + std::max(s, 0.0));
  const auto from_row = std::max(static_cast<std::int32_t>(first), 0) / lanes * lanes,
             end_row = std::min(static_cast<std::int32_t>(last) + 1, w.rows);
  for (std::int32_t r = from_row; r < end_row; r += lanes) {
    const Float row = row_numbers(r);
    const auto real = hn::RebindMask(u, hn::And(hn::Ge(row, set(first)), hn::Le(row, set(last))));
    Span span{set(left), set(right)};
    if (!is_flat) {
      span.from = hn::Max(span.from, hn::MulAdd(row, set(slope), set(low)));
      span.to = hn::Min(span.to, hn::MulAdd(row, set(slope), set(high)));
    }
    std::size_t strip = 0;
    for (std::int32_t x = 0; x < w.columns; x += stride, ++strip) {
      const Bits run = span.run<true>(x, std::min(stride, w.columns - x));
      const Bits met = hn::IfThenElseZero(real, hn::And(run, hn::LoadU(u, mixed.words[strip].data() + r)));
      const auto is_met = hn::Ne(met, hn::Zero(u));
      if (hn::AllFalse(u, is_met)) continue;
      HWY_ALIGN std::array<std::uint32_t, 16> words;
      hn::StoreU(met, u, words.data());
      for (std::int32_t n = 0; n < lanes; ++n)
        for (std::uint32_t rest = words[static_cast<std::size_t>(n)]; rest != 0; rest &= rest - 1) {
          const std::int32_t i = x + static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(rest)),
                             j = r + n;
          edge.piece(CellAlpha<Texel>(t.texels, t.pitch, i, j, t.threshold), i, j, 4 * t.delta, seen);
        }
    }
  }
}

template <class Texel>
HWY_INLINE Marks judged_of(const CellWindow& w, const CellTriangle<Texel>& t, bool& texels_say_so) {
  Mixed mixed;
  const auto cell_of = [](Spot p) {
    return std::array<std::int32_t, 2>{static_cast<std::int32_t>(floored(p.x)),
                                       static_cast<std::int32_t>(floored(p.y))};
  };
  texels_say_so = !mixed_met(w, mixed);
  if (texels_say_so) {
    const auto [i, j] = cell_of(t.p[0]);
    const std::uint32_t at = w.bit + static_cast<std::uint32_t>(i);
    return (w.opaque[w.strip * (at / 32) + static_cast<std::size_t>(j)] >> (at % 32) & 1) != 0 ? opaque
                                                                                               : below;
  }
  const Marks within = centres(w, -1, static_cast<float>(t.top), static_cast<float>(t.bottom));
  if (within == both) return both;
  Extremes seen;
  const auto is_both = [&] {
    return ((within & opaque) != 0 || seen.greatest > t.bound - t.gap) &&
           ((within & below) != 0 || seen.least < -t.bound);
  };
  for (const Spot& p : t.p) {
    const auto [i, j] = cell_of(p);
    seen.take(CellAlpha<Texel>(t.texels, t.pitch, i, j, t.threshold).at(p.x - i, p.y - j));
  }
  if (is_both()) return both;
  for (std::size_t k = 0; k < 3; ++k) {
    edge(w, t, mixed, k, seen);
    if (is_both()) return both;
  }
  const bool lacks_below = seen.least > t.bound, lacks_opaque = seen.greatest < -t.bound - t.gap;
  if (!lacks_below && !lacks_opaque) return uncertain;
  double low = t.p[0].y, high = low;
  for (const Spot& p : t.p) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const Marks perhaps =
      centres(w, 1, static_cast<float>(low - 2 * t.margin), static_cast<float>(high + 2 * t.margin));
  if (lacks_below && (perhaps & below) == 0) return opaque;
  if (lacks_opaque && (perhaps & opaque) == 0) return below;
  return uncertain;
}

Marks Judged8(const CellWindow& w, const CellTriangle<std::uint8_t>& t, bool& by_texels) {
  return judged_of(w, t, by_texels);
}
Marks Judged16(const CellWindow& w, const CellTriangle<std::uint16_t>& t, bool& by_texels) {
  return judged_of(w, t, by_texels);
}
Marks JudgedFloat(const CellWindow& w, const CellTriangle<float>& t, bool& by_texels) {
  return judged_of(w, t, by_texels);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

HWY_EXPORT(Judged8);
HWY_EXPORT(Judged16);
HWY_EXPORT(JudgedFloat);

template <>
Marks judged<std::uint8_t>(const CellWindow& w, const CellTriangle<std::uint8_t>& t, bool& by_texels) {
  return HWY_DYNAMIC_DISPATCH(Judged8)(w, t, by_texels);
}
template <>
Marks judged<std::uint16_t>(const CellWindow& w, const CellTriangle<std::uint16_t>& t, bool& by_texels) {
  return HWY_DYNAMIC_DISPATCH(Judged16)(w, t, by_texels);
}
template <>
Marks judged<float>(const CellWindow& w, const CellTriangle<float>& t, bool& by_texels) {
  return HWY_DYNAMIC_DISPATCH(JudgedFloat)(w, t, by_texels);
}

}  // namespace mmverify::impl::bake::detail
#endif
