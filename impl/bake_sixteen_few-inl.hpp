// A node of sixteen that meets few mixed cells, cell by cell (impl/bake_sixteen.cpp).
#include <cmath>
#include <cstring>
#include <limits>

#include "impl/bake_sixteen_edges-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_BAKE_SIXTEEN_FEW_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_BAKE_SIXTEEN_FEW_INL_HPP_
#undef MMVERIFY_IMPL_BAKE_SIXTEEN_FEW_INL_HPP_
#else
#define MMVERIFY_IMPL_BAKE_SIXTEEN_FEW_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

/// The mixed cells that a node of a small shape may meet, in rows of 8 columns or of 16.
class FewCells {
 public:
  /// More than these take longer one by one than together.
  static constexpr int most = 16;

  /// Domain: words.is_small, shape.is_small.
  HWY_INLINE void take(const SixteenInput& in, const Words& words) {
    const SixteenShape& shape = *in.shape;
    const SixteenShape::Micro& node = shape.whole;
    // Not below 0: floor.
    row_ = static_cast<std::int32_t>(in.p0[1] + node.top);
    column_ = static_cast<std::int32_t>(in.p0[0] + node.left);
    const std::int32_t last_row = static_cast<std::int32_t>(in.p0[1] + node.bottom),
                       last_column = static_cast<std::int32_t>(in.p0[0] + node.right);
    const Float left = set(static_cast<float>(column_)), right = set(static_cast<float>(last_column + 1)),
                x0 = set(in.p0[0]), y0 = set(in.p0[1]);
    std::array<Float, 3> lines;
    for (std::size_t l = 0; l < 3; ++l)
      lines[l] = hn::Add(hn::NegMulAdd(y0, set(shape.slope[l]), x0), set(node.outside[l]));
    const bool is_narrow = last_column - column_ < 8;
    HWY_ALIGN std::array<std::uint16_t, 16> wide;
    HWY_ALIGN std::array<std::uint8_t, 16> narrow;
    Int begin = set(0);
    for (std::int32_t r = 0; r < 16; r += static_cast<std::int32_t>(hn::Lanes(F()))) {
      const Int row = hn::Add(hn::Iota(I(), 0), set(row_ + r));
      const Float level = hn::ConvertTo(F(), row);
      const auto line = [&](std::size_t l)
                            HWY_ATTR { return hn::MulAdd(level, set(shape.slope[l]), lines[l]); };
      Float from = left, to = right;
      if (shape.ab_left) {
        from = hn::Max(from, hn::Max(line(0), line(1)));
        to = hn::Min(to, line(2));
      } else {
        from = hn::Max(from, line(2));
        to = hn::Min(to, hn::Min(line(0), line(1)));
      }
      const auto rows = [&](const auto& of) HWY_ATTR {
        return hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(of.data()) + row_ + r);
      };
      const Int cells = hn::IfThenZeroElse(hn::Gt(row, set(last_row)), run(in_word(from), in_word(to)));
      begin = hn::Or(begin, hn::And(cells, rows(words.opaque[0])));
      const Int at_0 = hn::Shr(hn::And(cells, rows(words.mixed)), set(column_));
      if (is_narrow)
        hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint8_t, I>(), at_0), hn::Rebind<std::uint8_t, I>(),
                   narrow.data() + r);
      else
        hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint16_t, I>(), at_0), hn::Rebind<std::uint16_t, I>(),
                   wide.data() + r);
    }
    if (is_narrow) {
      shift_ = 3;
      std::memcpy(bits.data(), narrow.data(), sizeof narrow);
    } else {
      shift_ = 4;
      std::memcpy(bits.data(), wide.data(), sizeof wide);
    }
    int count = 0;
    for (const std::uint64_t b : bits) count += static_cast<int>(hwy::PopCount(b));
    are_few = count <= most;
    are_none = count == 0;
    begin_opaque = !hn::AllTrue(I(), hn::Eq(begin, set(0)));
  }

  bool are_few = false, are_none = false;
  bool begin_opaque = false;  ///< a cell that it may meet, mixed or not, begins with an opaque texel
  std::array<std::uint64_t, 4> bits{};
  HWY_INLINE std::int32_t first_column() const { return column_; }
  /// Of bit b of word n.
  HWY_INLINE std::int32_t column(int b) const { return column_ + (b & ((1 << shift_) - 1)); }
  HWY_INLINE std::int32_t row(std::size_t n, int b) const {
    return row_ + (b >> shift_) + (static_cast<std::int32_t>(n) << (6 - shift_));
  }

 private:
  std::int32_t row_ = 0, column_ = 0, shift_ = 3;
};

/// Sixteen numbers, each part's from a table of sixteen.
HWY_INLINE Floats among_all(const Floats& table, const Ints& at) {
  Floats found;
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  found[0] = hn::TableLookupLanes(table[0], hn::IndicesFromVec(F(), at[0]));
#else
  HWY_ALIGN Table stored;
  for (std::size_t n = 0; n < parts; ++n) hn::StoreU(table[n], F(), stored.data() + n * hn::Lanes(F()));
  for (std::size_t n = 0; n < parts; ++n) found[n] = hn::GatherIndex(F(), stored.data(), at[n]);
#endif
  return found;
}

/// Bit k of each, of micro-triangle k.
struct FewMarks {
  /// Of few's cells, in their order: those that it may meet and may bear the mark in; of all of them.
  std::array<std::uint32_t, FewCells::most> below_in, opaque_in;
  std::uint32_t perhaps_below = 0, perhaps_opaque = 0;
  std::uint32_t leans = 0, leans_to_opaque = 0;  ///< how it leans, and that this is certain
  SixteenLanes::Ints vertices;  ///< what they bear: 1 below, 2 opaque, 4 no below, 8 no opaque
};

/// Of places in cells that are not mixed what they bear, as vertices do, as far as it is certain.
HWY_INLINE Int unmixed(const SixteenInput& in, const Words& words, const Located& at) {
  const Float half = set(0.5f);
  const Float from_middle = hn::Max(hn::Abs(hn::Sub(at.x, half)), hn::Abs(hn::Sub(at.y, half)));
  // Where marks are clear, a border is as good.
  const float most = in.shape->clear && in.shape->gap == 0 ? 1.0f : 0.5f - 2 * in.shape->delta;
  const auto is_within = hn::RebindMask(I(), hn::Lt(from_middle, set(most)));
  const Int one = set(1), are = words.row(words.opaque[0], at.j), mixed = words.row(words.mixed, at.j);
  const auto has = [&](Int x) HWY_ATTR { return hn::Eq(hn::And(hn::Shr(x, at.i), one), one); };
  const Int marks = hn::IfThenElse(has(are), set(2 + 4), set(1 + 8));
  return hn::IfThenElseZero(hn::AndNot(has(mixed), is_within), marks);
}

/// Bits from `from` on, of no bits where that is not in [0, 32).
HWY_INLINE Int from_bit(Int x, Int from) {
  const auto bits = hn::BitCast(U(), x);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::BitCast(I(), hn::Shr(bits, hn::BitCast(U(), from)));
#else
  const auto is_in = hn::Eq(hn::And(from, set(~31)), set(0));
  return hn::IfThenElseZero(is_in, hn::BitCast(I(), hn::Shr(bits, hn::BitCast(U(), hn::And(from, set(31))))));
#endif
}

/// A cell and its alpha.
template <class Texel>
struct OneCell {
  std::int32_t column, row;
  std::int32_t a, right, below, twist;

  HWY_INLINE OneCell(const SixteenInput& in, std::int32_t i, std::int32_t j) : column(i), row(j) {
    const Texel* const top = static_cast<const Texel*>(in.texels) + std::ptrdiff_t{j} * in.pitch + i;
    const Texel* const under = top + in.pitch;
    a = top[0];
    right = top[1] - a;
    below = under[0] - a;
    twist = under[1] - under[0] - right;
  }
};

/// The same for all lanes.
struct CellOfAll {
  Float i, j;
  Int place;
  Cell alpha;

  template <class Texel>
  HWY_INLINE explicit CellOfAll(const OneCell<Texel>& one)
      : i(number(one.column)),
        j(number(one.row)),
        place(set(one.column | one.row << 8)),
        alpha{number(one.a), number(one.right), number(one.below), number(one.twist)} {}

 private:
  static HWY_INLINE Float number(std::int32_t x) { return hn::ConvertTo(F(), set(x)); }
};

/// Sixteen places: their cells, what is known without alpha, and alpha as far as it was met.
struct Places {
  Floats x, y, at;
  Ints place, unmixed;

  HWY_INLINE Places(const SixteenInput& in, const Words& words, const Table& of_i, const Table& of_j) {
    for (std::size_t p = 0; p < parts; ++p) {
      const Float i = hn::LoadU(F(), of_i.data() + p * hn::Lanes(F())),
                  j = hn::LoadU(F(), of_j.data() + p * hn::Lanes(F()));
      x[p] = detail::HWY_NAMESPACE::place(in, 0, i, j);
      y[p] = detail::HWY_NAMESPACE::place(in, 1, i, j);
      const Located located(x[p], y[p]);
      place[p] = hn::Or(located.i, hn::ShiftLeft<8>(located.j));
      unmixed[p] = detail::HWY_NAMESPACE::unmixed(in, words, located);
      at[p] = set(std::numeric_limits<float>::quiet_NaN());
    }
  }
  /// Alpha of a cell, taken where it is their own.
  HWY_INLINE Floats take(const CellOfAll& of) {
    Floats g;
    for (std::size_t p = 0; p < parts; ++p) {
      g[p] = of.alpha.at(hn::Sub(x[p], of.i), hn::Sub(y[p], of.j));
      at[p] = hn::IfThenElse(hn::RebindMask(F(), hn::Eq(place[p], of.place)), g[p], at[p]);
    }
    return g;
  }
};

/// What micro-triangles bear in the mixed cells that they meet, and vertices and centroids anywhere.
/// Domain: shape.is_small, words.is_small; few.are_few, met in columns from the first of few.
template <class Texel>
MMVERIFY_LARGE FewMarks ask_few(const SixteenInput& in, const Words& words, const MetCells& met,
                                const FewCells& few) {
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const SixteenShape& shape = *in.shape;
  Places vertices(in, words, sixteen_lanes.vertex_i, sixteen_lanes.vertex_j),
      centroids(in, words, sixteen_lanes.centroid_i, sixteen_lanes.centroid_j);
  std::array<Ints, 3> corner;
  for (std::size_t p = 0; p < parts; ++p)
    for (std::size_t c = 0; c < 3; ++c)
      corner[c][p] = hn::LoadU(I(), sixteen_lanes.corner[c].data() + p * lanes);
  FewMarks marks;
  const Float above = set(shape.threshold + shape.beyond_bound),
              under = set(shape.threshold - shape.beyond_bound - shape.gap);
  std::size_t at = 0;
  for (std::size_t n = 0; n < few.bits.size(); ++n)
    for (std::uint64_t rest = few.bits[n]; rest != 0; rest &= rest - 1) {
      const auto bit = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(rest));
      const OneCell<Texel> one_cell(in, few.column(bit), few.row(n, bit));
      const CellOfAll cell(one_cell);
      const Floats g = vertices.take(cell);
      centroids.take(cell);
      const Float one = hn::Mul(cell.alpha.twist, set(shape.least_bend)),
                  other = hn::Mul(cell.alpha.twist, set(shape.most_bend)), dip = hn::Max(one, other),
                  rise = hn::Min(one, other);
      const Floats a = among_all(g, corner[0]), b = among_all(g, corner[1]), c = among_all(g, corner[2]);
      std::uint32_t below = 0, opaque = 0;
      for (std::size_t p = 0; p < parts; ++p) {
        const Int from = hn::Sub(set(16 * one_cell.row), met.first[p]);
        const Int row = hn::Or(from_bit(met.low[p], from), from_bit(met.high[p], hn::Sub(from, set(32))));
        const Mask meets =
            hn::RebindMask(f, hn::Ne(hn::And(row, set(1 << (one_cell.column - met.column))), set(0)));
        const Float low = hn::Min(a[p], hn::Min(b[p], c[p])), high = hn::Max(a[p], hn::Max(b[p], c[p]));
        below |= bits_of(hn::And(meets, hn::Le(hn::Sub(low, dip), above)), p * lanes);
        opaque |= bits_of(hn::And(meets, hn::Ge(hn::Sub(high, rise), under)), p * lanes);
      }
      marks.below_in[at] = below;
      marks.opaque_in[at] = opaque;
      ++at;
    }
  for (std::size_t n = 0; n < at; ++n) {
    marks.perhaps_below |= marks.below_in[n];
    marks.perhaps_opaque |= marks.opaque_in[n];
  }
  for (std::size_t p = 0; p < parts; ++p) {
    const std::size_t k = p * lanes;
    const auto bit = [](Mask m, std::int32_t b)
                         HWY_ATTR { return hn::IfThenElseZero(hn::RebindMask(I(), m), set(b)); };
    const Float g = hn::Sub(vertices.at[p], set(shape.threshold)), bound = set(shape.bound);
    const Int of_g =
        hn::Or(hn::Or(bit(hn::Lt(g, hn::Neg(bound)), 1), bit(hn::Gt(g, set(shape.bound - shape.gap)), 2)),
               hn::Or(bit(hn::Gt(g, bound), 4), bit(hn::Lt(g, set(-shape.bound - shape.gap)), 8)));
    hn::StoreU(hn::Or(of_g, vertices.unmixed[p]), I(), marks.vertices.data() + k);
    const Float lean = hn::Sub(hn::Sub(centroids.at[p], set(shape.threshold)), set(shape.lean));
    const auto has = [&](std::int32_t b) HWY_ATTR {
      return hn::RebindMask(f, hn::Ne(hn::And(centroids.unmixed[p], set(b)), set(0)));
    };
    marks.leans |= bits_of(hn::Or(has(4 + 8), hn::Gt(hn::Abs(lean), bound)), k);
    marks.leans_to_opaque |= bits_of(hn::Or(has(4), hn::Gt(lean, hn::Zero(f))), k);
  }
  return marks;
}

/// A whole number of each of few's cells.
class OfCells {
 public:
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  HWY_INLINE OfCells() : of_(set(0)) {}
#else
  HWY_INLINE OfCells() : of_{} {}
#endif
  HWY_INLINE void put(std::size_t n, std::int32_t x) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    of_ = hn::IfThenElse(hn::RebindMask(I(), mask_of(1u << n, 0)), set(x), of_);
#else
    of_[n] = x;
#endif
  }
  HWY_INLINE Float operator()(Int cells) const {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return hn::ConvertTo(F(), hn::TableLookupLanes(of_, hn::IndicesFromVec(I(), cells)));
#else
    return hn::ConvertTo(F(), among(I(), of_.data(), cells));
#endif
  }

 private:
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  Int of_;
#else
  HWY_ALIGN SixteenLanes::Ints of_;
#endif
};

/// The edges of micro-triangles in those cells where they may bear a mark that is asked.
template <class Texel>
MMVERIFY_LARGE EdgeMarks ask_few_edges(const SixteenInput& in, const FewCells& few, const FewMarks& found,
                                       std::uint32_t ask_below, std::uint32_t ask_opaque) {
  const std::size_t lanes = hn::Lanes(F());
  HWY_ALIGN Table x, y;
  for (std::size_t k = 0; k < 16; k += lanes) {
    const Float i = hn::LoadU(F(), sixteen_lanes.vertex_i.data() + k),
                j = hn::LoadU(F(), sixteen_lanes.vertex_j.data() + k);
    hn::StoreU(place(in, 0, i, j), F(), x.data() + k);
    hn::StoreU(place(in, 1, i, j), F(), y.data() + k);
  }
  OfCells column, row, a, right, below, twist;
  // Edges, and from bit 20 on cells; room for a vector more.
  HWY_ALIGN std::array<std::int32_t, 32 * FewCells::most + 16> list;
  std::size_t count = 0, at = 0;
  for (std::size_t n = 0; n < few.bits.size(); ++n)
    for (std::uint64_t rest = few.bits[n]; rest != 0; rest &= rest - 1, ++at) {
      const std::uint32_t asked = (found.below_in[at] & ask_below) | (found.opaque_in[at] & ask_opaque);
      if (asked == 0) continue;
      const auto bit = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(rest));
      const OneCell<Texel> cell(in, few.column(bit), few.row(n, bit));
      column.put(at, cell.column);
      row.put(at, cell.row);
      a.put(at, cell.a);
      right.put(at, cell.right);
      below.put(at, cell.below);
      twist.put(at, cell.twist);
      const Int number = set(static_cast<std::int32_t>(at << 20));
      for (std::size_t e = 0; e < 32; e += lanes) {
        const Int edges = hn::LoadU(I(), sixteen_lanes.edges.data() + e);
        const Mask those = have_any(edges, asked);
        hn::StoreU(hn::Compress(hn::Or(edges, number), hn::RebindMask(I(), those)), I(), list.data() + count);
        count += hn::CountTrue(F(), those);
      }
    }
  PieceMarks pieces;
  for (std::size_t n = 0; n < count; n += lanes) {
    const auto is_one = hn::FirstN(I(), std::min(count - n, lanes));
    const Int edges = hn::IfThenElseZero(is_one, hn::LoadU(I(), list.data() + n)),
              cells = hn::And(hn::ShiftRight<20>(edges), set(15)), corners = first_corner_of(edges);
    pieces.judge(*in.shape, edges, Cell{a(cells), right(cells), below(cells), twist(cells)},
                 hn::Sub(among(F(), x.data(), corners), column(cells)),
                 hn::Sub(among(F(), y.data(), corners), row(cells)));
  }
  return pieces.marks();
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
