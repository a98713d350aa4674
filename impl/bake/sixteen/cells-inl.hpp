// The marks of a node of sixteen from mixed cells, and from texels within (impl/bake/sixteen/sixteen.cpp).
#include <algorithm>

#include "impl/bake/sixteen/vectors-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_BAKE_SIXTEEN_CELLS_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_BAKE_SIXTEEN_CELLS_INL_HPP_
#undef MMVERIFY_IMPL_BAKE_SIXTEEN_CELLS_INL_HPP_
#else
#define MMVERIFY_IMPL_BAKE_SIXTEEN_CELLS_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

/// Columns of cells of a word of texels: the word has the last cell's right texel, too.
constexpr std::int32_t word_cells = 31;  // check-magic: 31 == 32 - 1

/// The mixed cells between two rows of texels, a bit each.
HWY_INLINE Int mixed_of(Int opaque_top, Int opaque_under, Int seen_top, Int seen_under) {
  const Int all = hn::And(opaque_top, opaque_under), some = hn::Or(seen_top, seen_under);
  const auto next = [](Int x) HWY_ATTR { return hn::BitCast(I(), hn::ShiftRight<1>(hn::BitCast(U(), x))); };
  return hn::AndNot(hn::And(all, next(all)), hn::Or(some, next(some)));
}

/// The window's bits: word s rows + row has 32 texels from column 8 s on, so that one word has any 24 columns.
struct Words {
  static constexpr std::size_t rows = sixteen_window + 16, most = sixteen_window / 8;
  using Rows = std::array<std::uint32_t, rows * most>;
  static_assert(rows >= sixteen_window + 4, "for FourRows");
  HWY_ALIGN Rows opaque, visible;
  HWY_ALIGN std::array<std::uint32_t, rows> mixed;  ///< the mixed cells, if the window is small
  const Rows* seen;                                 ///< visible, or opaque with MASK
  bool is_small;  ///< the words from column 0 on have all texels, in 32 rows at most
  bool few_rows;  ///< 16 rows at most

  HWY_INLINE explicit Words(const SixteenInput& in)
      : seen(in.visible == in.opaque ? &opaque : &visible),
        is_small(in.columns <= 32 && in.rows <= 32),
        few_rows(in.rows <= 16) {
    take(in, in.opaque, opaque);
    if (seen == &visible) take(in, in.visible, visible);
    if (!is_small) return;
    const U u;
    for (std::size_t r = 0; r + 1 < static_cast<std::size_t>(in.rows); r += hn::Lanes(u)) {
      const auto at = [r](const Rows& of, std::size_t next)
                          HWY_ATTR { return hn::BitCast(I(), hn::LoadU(U(), of.data() + r + next)); };
      hn::StoreU(hn::BitCast(u, mixed_of(at(opaque, 0), at(opaque, 1), at(*seen, 0), at(*seen, 1))), u,
                 mixed.data() + r);
    }
  }

  /// Row j, of texels or of cells.  Domain: is_small.
  HWY_INLINE Int row(const std::uint32_t* of, Int j) const {
    return few_rows ? among(I(), reinterpret_cast<const std::int32_t*>(of), j) : among_rows(of, j);
  }
  /// The number s of the words that have column x.
  HWY_INLINE Int origin(Int x) const { return is_small ? set(0) : hn::ShiftRight<3>(x); }

 private:
  HWY_INLINE std::size_t words(const SixteenInput& in) const {
    return is_small ? 1 : (static_cast<std::size_t>(in.columns) + 7) / 8;
  }
  HWY_INLINE void take(const SixteenInput& in, const std::uint32_t* plane, Rows& to) {
    const U u;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(u));
    const std::size_t end = words(in);
    for (std::size_t s = 0; s < end; ++s) {
      const std::uint32_t at = in.bit + 8 * static_cast<std::uint32_t>(s), bit = at % 32;
      const std::uint32_t* const word = plane + in.strip * (at / 32);
      const auto low_shift = hn::Set(u, bit), high_shift = hn::Set(u, 31 - bit);
      for (std::int32_t r = 0; r < in.rows; r += lanes) {
        const auto low = hn::LoadU(u, word + r), high = hn::LoadU(u, word + in.strip + r);
        // A shift by 32 - bit places in two steps, for 32 is no valid shift.
        hn::StoreU(hn::Or(hn::Shr(low, low_shift), hn::Shl(hn::Add(high, high), high_shift)), u,
                   to.data() + s * rows + static_cast<std::size_t>(r));
      }
    }
  }
};

/// Four rows of each lane's own word, from the lane's own row on.
class FourRows {
 public:
  HWY_INLINE void take(const Words::Rows& of, Int word, Int first) {
    const I d;
    const auto* const all = reinterpret_cast<const std::int32_t*>(of.data());
    const Int at = hn::Add(hn::Mul(word, set(static_cast<std::int32_t>(Words::rows))), first);
#if HWY_TARGET == HWY_SCALAR
    for (std::int32_t r = 0; r < 4; ++r)
      hn::StoreU(hn::GatherIndex(d, all, hn::Add(at, set(r))), d, rows_[static_cast<std::size_t>(r)].data());
#else
    // Each lane's four words are loaded at once, which costs less than a gather, and transposed.
    HWY_ALIGN SixteenLanes::Ints begin;
    hn::StoreU(at, d, begin.data());
    const auto fours = [&](std::size_t n) HWY_ATTR { return fours_of(d, all, begin.data() + n); };
    const Int a = fours(0), b = fours(1), c = fours(2), e = fours(3);
    const hn::Repartition<std::int64_t, I> two;
    const auto low = [two](Int x, Int y)
                         HWY_ATTR { return hn::BitCast(two, hn::InterleaveLower(I(), x, y)); };
    const auto high = [two](Int x, Int y)
                          HWY_ATTR { return hn::BitCast(two, hn::InterleaveUpper(I(), x, y)); };
    const auto put = [&](std::size_t r, auto x)
                         HWY_ATTR { hn::StoreU(hn::BitCast(d, x), d, rows_[r].data()); };
    put(0, hn::InterleaveLower(two, low(a, b), low(c, e)));
    put(1, hn::InterleaveUpper(two, low(a, b), low(c, e)));
    put(2, hn::InterleaveLower(two, high(a, b), high(c, e)));
    put(3, hn::InterleaveUpper(two, high(a, b), high(c, e)));
#endif
  }
  HWY_INLINE Int operator[](std::size_t r) const { return hn::LoadU(I(), rows_[r].data()); }

 private:
#if HWY_TARGET != HWY_SCALAR
  /// The words for block b: four from begin[4 b] on.
  template <class D>
  static HWY_INLINE hn::Vec<D> fours_of(D d, const std::int32_t* all, const std::int32_t* begin) {
    if constexpr (hn::MaxLanes(D()) == 4) {
      return hn::LoadU(d, all + begin[0]);
    } else {
      const hn::Half<D> half;
      return hn::Combine(d, fours_of(half, all, begin + hn::MaxLanes(half)), fours_of(half, all, begin));
    }
  }
#endif

  HWY_ALIGN std::array<SixteenLanes::Ints, 4> rows_;
};

/// Each lane's own word, row after row.
class RowByRow {
 public:
  HWY_INLINE RowByRow(const SixteenInput& in, const Words& words, Int word, Int first)
      : row(first),
        words_(words),
        word_(word),
        one_plane_(words.seen == &words.opaque),
        last_(set(in.rows - 2)),
        next_are_(set(0)),
        next_seen_(next_are_) {
    if (!words.is_small) take_next(first);
  }
  HWY_INLINE void ask() {
    if (words_.is_small) {
      // Lanes that are done repeat the last row.
      const Int at = hn::Min(row, last_);
      are = words_.row(words_.opaque.data(), at);
      seen = one_plane_ ? are : words_.row(words_.seen->data(), at);
      mixed = words_.row(words_.mixed.data(), at);
      return;
    }
    are = next_are_;
    seen = next_seen_;
    take_next(hn::Add(row, set(1)));
    mixed = mixed_of(are, next_are_, seen, next_seen_);
  }
  HWY_INLINE void go_on() { row = hn::Add(row, set(1)); }

  Int row;
  Int are, seen, mixed;  ///< results of ask(): opaque texels, visible texels, mixed cells

 private:
  HWY_INLINE void take_next(Int at) {
    const std::size_t r = taken_++ % 4;
    if (r == 0) {
      // Lanes that are done stay near the window, where Words has room.
      const Int first = hn::Min(at, hn::Add(last_, set(2)));
      opaque_.take(words_.opaque, word_, first);
      if (!one_plane_) visible_.take(*words_.seen, word_, first);
    }
    next_are_ = opaque_[r];
    next_seen_ = one_plane_ ? next_are_ : visible_[r];
  }

  const Words& words_;
  Int word_;
  bool one_plane_;
  Int last_, next_are_, next_seen_;
  std::size_t taken_ = 0;
  FourRows opaque_, visible_;
};

/// The bits [from, end).  Domain: 0 <= from, end < 32.
HWY_INLINE Int run(Int from, Int end) {
  const Int all = set(-1);
  return hn::AndNot(hn::Shl(all, end), hn::Shl(all, from));
}
/// x rounded to the nearest whole number, clamped to a word.
HWY_INLINE Int in_word(Float x) {
  const Float within = hn::Min(hn::Max(x, hn::Zero(F())), set(static_cast<float>(word_cells)));
  return hn::And(hn::BitCast(I(), hn::Add(within, set(whole_only))), set(word_cells));
}

/// Marks of micro-triangles from cells: bit k for micro-triangle k.
struct CellMarks {
  std::uint32_t fit = 0;                       ///< a word has all its cells; the others are not judged here
  std::uint32_t meets_mixed = 0;               ///< may meet a mixed cell
  std::uint32_t begins_opaque = 0;             ///< a cell that it may meet has an opaque first texel
  std::uint32_t have = 0, have_not = 0;        ///< centres within: visible; not opaque
  std::uint32_t perhaps = 0, perhaps_not = 0;  ///< the same with the rows beside a flat edge
};

/// x shifted to begin at bit `to`; 0 if `to` is not in [0, 32).
HWY_INLINE Int to_bit(Int x, Int to) {
  const auto bits = hn::BitCast(U(), x);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::BitCast(I(), hn::Shl(bits, hn::BitCast(U(), to)));
#else
  const auto is_in = hn::Eq(hn::And(to, set(~31)), set(0));
  return hn::IfThenElseZero(is_in, hn::BitCast(I(), hn::Shl(bits, hn::BitCast(U(), hn::And(to, set(31))))));
#endif
}

/// A grid of up to 16 rows of 8 or 16 columns of cells, in words: bit b of word w is in row row + (32 w + b) / columns.
struct CellGrid {
  static constexpr std::size_t most_words = 8;
  std::int32_t row = 0, column = 0;
  bool is_narrow = true;  ///< 8 columns
  std::size_t words = 0;  ///< words of its rows
};
/// The mixed cells of a grid that each micro-triangle of a small shape may meet, a word after the other.
struct MetCells {
  CellGrid grid;
  std::array<Ints, CellGrid::most_words> words;
};

/// Judges micro-triangles [k, k + lanes) by cells.  `centres`: also by the centres within; `keeps`: writes the met
/// cells.
/// Domain, if kept: shape.is_small, words.is_small, and met.grid covers the cells that the node may meet.
template <bool centres, bool keeps>
MMVERIFY_LARGE void ask_cells(const SixteenInput& in, const Words& words, std::size_t k, CellMarks& marks,
                              MetCells& met) {
  const SixteenShape& shape = *in.shape;
  const Mask turned = mask_of(sixteen_lanes.turned, k), ab_left = shape.ab_left ? hn::Not(turned) : turned;
  const auto of = [&](auto member) HWY_ATTR {
    return hn::IfThenElse(turned, set(member(shape.micro[1])), set(member(shape.micro[0])));
  };
  using Micro = SixteenShape::Micro;
  const Float i = hn::LoadU(F(), sixteen_lanes.micro_i.data() + k),
              j = hn::LoadU(F(), sixteen_lanes.micro_j.data() + k), x0 = place(in, 0, i, j),
              y0 = place(in, 1, i, j);
  const Float top = hn::Add(y0, of([](const Micro&m) { return m.top; })),
              bottom = hn::Add(y0, of([](const Micro&m) { return m.bottom; }));
  const Int first = floored(top), rows = hn::Add(hn::Sub(floored(bottom), first), set(1));
  const Int first_column = floored(hn::Add(x0, of([](const Micro&m) { return m.left; }))),
            end_column = hn::Add(floored(hn::Add(x0, of([](const Micro&m) { return m.right; }))), set(1));
  const Int word = words.origin(first_column), origin = hn::ShiftLeft<3>(word);
  marks.fit |= bits_of(hn::RebindMask(F(), hn::Lt(hn::Sub(end_column, origin), set(word_cells + 1))), k);
  const Float x = hn::ConvertTo(F(), origin), left = hn::ConvertTo(F(), hn::Sub(first_column, origin)),
              right = hn::ConvertTo(F(), hn::Sub(end_column, origin));
  // The lines, in columns counted from the word's first.
  std::array<Float, 3> outside, at;
  for (std::size_t l = 0; l < 3; ++l) {
    const Float line = hn::Sub(hn::NegMulAdd(y0, set(shape.slope[l]), x0), x);
    outside[l] = hn::Add(line, of([l](const Micro& m) { return m.outside[l]; }));
    at[l] = hn::Add(line, of([l](const Micro& m) { return m.at[l]; }));
  }
  // The part of a row between the lines.
  struct Span {
    Float from, to;
  };
  const auto span = [&](const std::array<Float, 3>& lines, Float level) HWY_ATTR {
    const auto line = [&](std::size_t l)
                          HWY_ATTR { return hn::MulAdd(level, set(shape.slope[l]), lines[l]); };
    const Float a = line(0), b = line(1), c = line(2);
    return Span{hn::IfThenElse(ab_left, hn::Max(a, b), c), hn::IfThenElse(ab_left, c, hn::Min(a, b))};
  };
  // An edge's line bounds nothing beyond its corners: there the box does.  Rows at a flat edge have centres beyond it.
  const Float from_column = hn::Sub(hn::Add(x0, of([](const Micro&m) { return m.first_column; })), x),
              to_column = hn::Sub(hn::Add(x0, of([](const Micro&m) { return m.last_column; })), x);
  const Float from_row = hn::Add(y0, of([](const Micro&m) { return m.first_row; })),
              to_row = hn::Add(y0, of([](const Micro&m) { return m.last_row; }));
  const Int zero = set(0);
  Int some_mixed = zero, begins = zero, have = zero, have_not = zero, perhaps = zero, perhaps_not = zero,
      met_0 = zero, met_1 = zero, to = zero, to_next = zero;
  const std::size_t part = k / hn::Lanes(F());
  if constexpr (keeps) {
    const Int rows_on = hn::Sub(first, set(met.grid.row));
    to = met.grid.is_narrow ? hn::ShiftLeft<3>(rows_on) : hn::ShiftLeft<4>(rows_on);
    to_next = set(met.grid.is_narrow ? 8 : 16);
    for (std::size_t w = 2; w < met.grid.words; ++w) met.words[w][part] = zero;
  }
  RowByRow rows_of(in, words, word, first);
  const std::int32_t last = hn::GetLane(hn::MaxOfLanes(I(), rows));
  for (std::int32_t r = 0; r < last; ++r) {
    const auto real = hn::Gt(rows, set(r));
    const Float level = hn::ConvertTo(F(), rows_of.row);
    rows_of.ask();
    rows_of.go_on();
    const Int are = rows_of.are, seen = rows_of.seen;
    const Span about = span(outside, level);
    const Int cells =
        hn::IfThenElseZero(real, run(in_word(hn::Max(about.from, left)), in_word(hn::Min(about.to, right))));
    const Int mixed = hn::And(cells, rows_of.mixed);
    some_mixed = hn::Or(some_mixed, mixed);
    if constexpr (keeps) {
      // No micro-triangle meets a cell before the first column of the grid: it lies in the margin only.  A cell beyond
      // the last column sets a bit of the next row, and a mark may then stay uncertain, never wrong.
      const Int in_grid = hn::Shr(mixed, set(met.grid.column));
      met_0 = hn::Or(met_0, to_bit(in_grid, to));
      met_1 = hn::Or(met_1, to_bit(in_grid, hn::Sub(to, set(32))));
      for (std::size_t w = 2; w < met.grid.words; ++w) {
        const Int here = hn::Sub(to, set(static_cast<std::int32_t>(32 * w)));
        met.words[w][part] = hn::Or(met.words[w][part], to_bit(in_grid, here));
      }
      to = hn::Add(to, to_next);
    }
    begins = hn::Or(begins, hn::And(cells, are));
    if constexpr (!centres) continue;
    const Span inside = span(at, level);
    Int within = hn::IfThenElseZero(
        real, run(in_word(hn::Max(inside.from, from_column)), in_word(hn::Min(inside.to, to_column))));
    const auto in_rows = [&](Float from, Float to) HWY_ATTR {
      const Mask are_in = hn::And(hn::Ge(level, from), hn::Le(level, to));
      return hn::IfThenElseZero(hn::RebindMask(I(), are_in), within);
    };
    if (shape.has_flat) {
      const Int of_margin = in_rows(top, bottom);
      perhaps = hn::Or(perhaps, hn::And(of_margin, seen));
      perhaps_not = hn::Or(perhaps_not, hn::AndNot(are, of_margin));
    }
    within = in_rows(from_row, to_row);
    have = hn::Or(have, hn::And(within, seen));
    have_not = hn::Or(have_not, hn::AndNot(are, within));
  }
  const std::uint32_t here = ((1u << hn::Lanes(F())) - 1) << k;
  if constexpr (keeps) {
    met.words[0][part] = met_0;
    met.words[1][part] = met_1;
  }
  marks.meets_mixed |= here & ~zeros_of(some_mixed, k);
  marks.begins_opaque |= here & ~zeros_of(begins, k);
  marks.have |= here & ~zeros_of(have, k);
  marks.have_not |= here & ~zeros_of(have_not, k);
  marks.perhaps |= here & ~zeros_of(hn::Or(have, perhaps), k);
  marks.perhaps_not |= here & ~zeros_of(hn::Or(have_not, perhaps_not), k);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
