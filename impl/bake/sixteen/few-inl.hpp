// A node of sixteen that meets few mixed cells, judged cell by cell (impl/bake/sixteen/sixteen.cpp).
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "impl/bake/sixteen/edges-inl.hpp"

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

/// The mixed cells that a node of a small shape may meet.
class FewCells {
 public:
  /// Above this number cells take longer one by one than together.
  static constexpr int most = 16;

  /// Domain: words.is_small, shape.is_small.
  HWY_INLINE void take(const SixteenInput& in, const Words& words) {
    const SixteenShape& shape = *in.shape;
    const SixteenShape::Micro& node = shape.whole;
    // The cast is floor, since the places are not below 0.
    grid.row = static_cast<std::int32_t>(in.p0[1] + node.top);
    grid.column = static_cast<std::int32_t>(in.p0[0] + node.left);
    const std::int32_t last_row = static_cast<std::int32_t>(in.p0[1] + node.bottom),
                       last_column = static_cast<std::int32_t>(in.p0[0] + node.right);
    const Float left = set(static_cast<float>(grid.column)), right = set(static_cast<float>(last_column + 1)),
                x0 = set(in.p0[0]), y0 = set(in.p0[1]);
    std::array<Float, 3> lines;
    for (std::size_t l = 0; l < 3; ++l)
      lines[l] = hn::Add(hn::NegMulAdd(y0, set(shape.slope[l]), x0), set(node.outside[l]));
    grid.is_narrow = last_column - grid.column < 8;
    grid.words = static_cast<std::size_t>((last_row - grid.row) / (grid.is_narrow ? 4 : 2) + 1);
    HWY_ALIGN std::array<std::uint16_t, 16> wide;
    HWY_ALIGN std::array<std::uint8_t, 16> narrow;
    Int begin = set(0);
    for (std::int32_t r = 0; r < 16; r += static_cast<std::int32_t>(hn::Lanes(F()))) {
      const Int row = hn::Add(hn::Iota(I(), 0), set(grid.row + r));
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
        return hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(of.data()) + grid.row + r);
      };
      const Int cells = hn::IfThenZeroElse(hn::Gt(row, set(last_row)), run(in_word(from), in_word(to)));
      begin = hn::Or(begin, hn::And(cells, rows(words.opaque)));
      const Int at_0 = hn::Shr(hn::And(cells, rows(words.mixed)), set(grid.column));
      if (grid.is_narrow)
        hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint8_t, I>(), at_0), hn::Rebind<std::uint8_t, I>(),
                   narrow.data() + r);
      else
        hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint16_t, I>(), at_0), hn::Rebind<std::uint16_t, I>(),
                   wide.data() + r);
    }
    if (grid.is_narrow)
      std::memcpy(bits_.data(), narrow.data(), sizeof narrow);
    else
      std::memcpy(bits_.data(), wide.data(), sizeof wide);
    std::size_t count = 0;
    for (const std::uint64_t b : bits_) count += hwy::PopCount(b);
    are_few = count <= most;
    are_none = count == 0;
    begin_opaque = !hn::AllTrue(I(), hn::Eq(begin, set(0)));
  }

  bool are_few = false, are_none = false;
  bool begin_opaque = false;  ///< a cell that it may meet, mixed or not, has an opaque first texel
  CellGrid grid;

  /// The bits of the grid's words 2 n, and from bit 32 on of 2 n + 1.
  HWY_INLINE std::uint64_t bits(std::size_t n) const { return bits_[n]; }

 private:
  std::array<std::uint64_t, CellGrid::most_words / 2> bits_{};
};

/// The cells of a FewCells, and their alpha.
class FewAlpha {
 public:
  template <class Texel>
  HWY_INLINE void take(const SixteenInput& in, const FewCells& few) {
    const CellGrid& grid = few.grid;
    const int bits = grid.is_narrow ? 3 : 4;
    for (std::size_t w = 0; w < grid.words; w += 2)
      for (std::uint64_t rest = few.bits(w / 2); rest != 0; rest &= rest - 1) {
        const auto at = static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(rest));
        const std::int32_t i = grid.column + (at & ((1 << bits) - 1)),
                           j = grid.row + ((static_cast<std::int32_t>(32 * w) + at) >> bits);
        const Texel* const top = static_cast<const Texel*>(in.texels) + std::ptrdiff_t{j} * in.pitch + i;
        const Texel* const under = top + in.pitch;
        place[count] = i | j << 8;
        word[count] = w + static_cast<std::size_t>(at >> 5);
        bit[count] = static_cast<std::int32_t>(1u << (at & 31));
        whole_[0][count] = top[0];
        whole_[1][count] = top[1] - top[0];
        whole_[2][count] = under[0] - top[0];
        whole_[3][count] = under[1] - under[0] - whole_[1][count];
        ++count;
      }
  }
  /// Converts the integers of the taken cells to floats and computes their limits.  Call it late: loading a vector
  /// right after its single stores would stall.
  HWY_INLINE void make_ready(const SixteenShape& shape) {
    for (std::size_t k = 0; k < FewCells::most; k += hn::Lanes(F())) {
      const auto put = [k](Float x, Table& to) HWY_ATTR { hn::StoreU(x, F(), to.data() + k); };
      const auto number = [](Int x) HWY_ATTR { return hn::ConvertTo(F(), x); };
      const auto stored = [k](const SixteenLanes::Ints& of)
                              HWY_ATTR { return hn::LoadU(I(), of.data() + k); };
      const Int at = stored(place);
      const Float t = number(stored(whole_[3])), one = hn::Mul(t, set(shape.least_bend)),
                  other = hn::Mul(t, set(shape.most_bend));
      put(number(hn::And(at, set(255))), column);
      put(number(hn::ShiftRight<8>(at)), row);
      put(number(stored(whole_[0])), a);
      put(number(stored(whole_[1])), right);
      put(number(stored(whole_[2])), below);
      put(t, twist);
      put(hn::Add(set(shape.threshold + shape.beyond_bound), hn::Max(one, other)), most_below);
      put(hn::Add(set(shape.threshold - shape.beyond_bound - shape.gap), hn::Min(one, other)), least_opaque);
    }
  }

  std::size_t count = 0;
  HWY_ALIGN SixteenLanes::Ints place;  ///< the column, and the row from bit 8 on
  /// The cell's word in the grid, and its bit there.
  std::array<std::size_t, FewCells::most> word;
  SixteenLanes::Ints bit;
  HWY_ALIGN Table column, row, a, right, below, twist;
  /// The limits of the cell's own alpha at all corners, beyond which a micro-triangle lacks the mark in the cell.
  HWY_ALIGN Table most_below, least_opaque;

 private:
  /// The numbers a, right, below and twist as integers.
  HWY_ALIGN std::array<SixteenLanes::Ints, 4> whole_;
};

/// table[at], for sixteen numbers and a table of sixteen.
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

/// Marks of micro-triangles from few cells: bit k for micro-triangle k.
struct FewMarks {
  /// The micro-triangles that may meet cell n and may bear the mark in it.
  std::array<std::uint32_t, FewCells::most> below_in, opaque_in;
  std::uint32_t perhaps_below = 0, perhaps_opaque = 0;
  std::uint32_t below = 0, opaque = 0;           ///< certain marks of centroids
  std::uint32_t leans = 0, leans_to_opaque = 0;  ///< the lean of the centroid is certain; it leans to opaque
  SixteenLanes::Ints vertices;  ///< marks of micro-vertices: 1 below, 2 opaque, 4 no below, 8 no opaque
};

/// The certain marks of places in cells that are not mixed, in the bits of FewMarks::vertices.
HWY_INLINE Int unmixed(const SixteenInput& in, const Words& words, const Located& at) {
  const Float half = set(0.5f);
  const Float from_middle = hn::Max(hn::Abs(hn::Sub(at.x, half)), hn::Abs(hn::Sub(at.y, half)));
  // If marks are clear, a place on a border is certain as well.
  const float most = in.shape->clear && in.shape->gap == 0 ? 1.0f : 0.5f - 2 * in.shape->delta;
  const auto is_within = hn::RebindMask(I(), hn::Lt(from_middle, set(most)));
  const Int one = set(1), are = words.row(words.opaque.data(), at.j),
            mixed = words.row(words.mixed.data(), at.j);
  const auto has = [&](Int x) HWY_ATTR { return hn::Eq(hn::And(hn::Shr(x, at.i), one), one); };
  const Int marks = hn::IfThenElse(has(are), set(2 + 4), set(1 + 8));
  return hn::IfThenElseZero(hn::AndNot(has(mixed), is_within), marks);
}

/// Sixteen places: their cells, the marks that cells alone prove, and alpha if a taken cell contains the place.
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
  /// Returns alpha of cell n at all places, and stores it for the places in that cell.
  HWY_INLINE Floats take(const FewAlpha& cells, std::size_t n) {
    const Cell cell{set(cells.a[n]), set(cells.right[n]), set(cells.below[n]), set(cells.twist[n])};
    Floats g;
    for (std::size_t p = 0; p < parts; ++p) {
      g[p] = cell.at(hn::Sub(x[p], set(cells.column[n])), hn::Sub(y[p], set(cells.row[n])));
      at[p] = hn::IfThenElse(hn::RebindMask(F(), hn::Eq(place[p], set(cells.place[n]))), g[p], at[p]);
    }
    return g;
  }
};

/// The marks of micro-triangles in the mixed cells that they meet, and of vertices and centroids anywhere.
/// Domain: shape.is_small, words.is_small; few.are_few, `cells` taken from it, `met` in its grid.
MMVERIFY_LARGE FewMarks ask_few(const SixteenInput& in, const Words& words, const MetCells& met,
                                FewAlpha& cells) {
  const F f;
  const std::size_t lanes = hn::Lanes(f);
  const SixteenShape& shape = *in.shape;
  Places vertices(in, words, sixteen_lanes.vertex_i, sixteen_lanes.vertex_j),
      centroids(in, words, sixteen_lanes.centroid_i, sixteen_lanes.centroid_j);
  std::array<Ints, 3> corner;
  for (std::size_t p = 0; p < parts; ++p)
    for (std::size_t c = 0; c < 3; ++c)
      corner[c][p] = hn::LoadU(I(), sixteen_lanes.corner[c].data() + p * lanes);
  cells.make_ready(shape);
  FewMarks marks;
  for (std::size_t n = 0; n < cells.count; ++n) {
    const Floats g = vertices.take(cells, n);
    centroids.take(cells, n);
    const Floats a = among_all(g, corner[0]), b = among_all(g, corner[1]), c = among_all(g, corner[2]);
    std::uint32_t below = 0, opaque = 0;
    for (std::size_t p = 0; p < parts; ++p) {
      const Mask meets = hn::RebindMask(f, hn::TestBit(met.words[cells.word[n]][p], set(cells.bit[n])));
      const Float low = hn::Min(a[p], hn::Min(b[p], c[p])), high = hn::Max(a[p], hn::Max(b[p], c[p]));
      below |= bits_of(hn::And(meets, hn::Le(low, set(cells.most_below[n]))), p * lanes);
      opaque |= bits_of(hn::And(meets, hn::Ge(high, set(cells.least_opaque[n]))), p * lanes);
    }
    marks.below_in[n] = below;
    marks.opaque_in[n] = opaque;
  }
  for (std::size_t n = 0; n < cells.count; ++n) {
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
    const Float at_centroid = hn::Sub(centroids.at[p], set(shape.threshold)),
                lean = hn::Sub(at_centroid, set(shape.lean));
    const auto has = [&](std::int32_t b) HWY_ATTR {
      return hn::RebindMask(f, hn::Ne(hn::And(centroids.unmixed[p], set(b)), set(0)));
    };
    marks.below |= bits_of(hn::Or(has(1), hn::Lt(at_centroid, hn::Neg(bound))), k);
    marks.opaque |= bits_of(hn::Or(has(2), hn::Gt(at_centroid, set(shape.bound - shape.gap))), k);
    marks.leans |= bits_of(hn::Or(has(4 + 8), hn::Gt(hn::Abs(lean), bound)), k);
    marks.leans_to_opaque |= bits_of(hn::Or(has(4), hn::Gt(lean, hn::Zero(f))), k);
  }
  return marks;
}

/// The marks of edges in the cells where their micro-triangles may bear a mark still asked for.
MMVERIFY_LARGE EdgeMarks ask_few_edges(const SixteenInput& in, const FewAlpha& cells, const FewMarks& found,
                                       std::uint32_t ask_below, std::uint32_t ask_opaque) {
  const std::size_t lanes = hn::Lanes(F());
  HWY_ALIGN Table x, y;
  for (std::size_t k = 0; k < 16; k += lanes) {
    const Float i = hn::LoadU(F(), sixteen_lanes.vertex_i.data() + k),
                j = hn::LoadU(F(), sixteen_lanes.vertex_j.data() + k);
    hn::StoreU(place(in, 0, i, j), F(), x.data() + k);
    hn::StoreU(place(in, 1, i, j), F(), y.data() + k);
  }
  // Edges, with the cell's number from bit 20 on; there is room for one more vector.
  HWY_ALIGN std::array<std::int32_t, 32 * FewCells::most + 16> list;
  std::size_t count = 0;
  for (std::size_t n = 0; n < cells.count; ++n) {
    const std::uint32_t asked = (found.below_in[n] & ask_below) | (found.opaque_in[n] & ask_opaque);
    const std::uint32_t asked_edges = micro_edges.low[asked & 255] | micro_edges.high[asked >> 8];
    const Int number = set(static_cast<std::int32_t>(n << 20));
    for (std::size_t e = 0; e < 32; e += lanes) {
      const std::uint32_t here = asked_edges >> e & ((1u << lanes) - 1);
      const Int edges = hn::Or(hn::LoadU(I(), sixteen_lanes.edges.data() + e), number);
      hn::StoreU(hn::Compress(edges, hn::RebindMask(I(), mask_of(here, 0))), I(), list.data() + count);
      count += hwy::PopCount(here);
    }
  }
  PieceMarks pieces;
  for (std::size_t n = 0; n < count; n += lanes) {
    const auto is_one = hn::FirstN(I(), std::min(count - n, lanes));
    const Int edges = hn::IfThenElseZero(is_one, hn::LoadU(I(), list.data() + n)),
              at = hn::And(hn::ShiftRight<20>(edges), set(15)), corners = first_corner_of(edges);
    const auto of_cell = [at](const Table& table) HWY_ATTR { return among(F(), table.data(), at); };
    pieces.judge(*in.shape, edges,
                 Cell{of_cell(cells.a), of_cell(cells.right), of_cell(cells.below), of_cell(cells.twist)},
                 hn::Sub(among(F(), x.data(), corners), of_cell(cells.column)),
                 hn::Sub(among(F(), y.data(), corners), of_cell(cells.row)));
  }
  return pieces.marks();
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
