// The marks of the edges of a node of sixteen, in mixed cells (impl/bake/sixteen/sixteen.cpp).
#include <algorithm>

#include "impl/bake/sixteen/cells-inl.hpp"

// Once for each target.
#if defined(MMVERIFY_IMPL_BAKE_SIXTEEN_EDGES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef MMVERIFY_IMPL_BAKE_SIXTEEN_EDGES_INL_HPP_
#undef MMVERIFY_IMPL_BAKE_SIXTEEN_EDGES_INL_HPP_
#else
#define MMVERIFY_IMPL_BAKE_SIXTEEN_EDGES_INL_HPP_
#endif

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

/// Marks of micro-triangles from their edges: bit k for micro-triangle k.
struct EdgeMarks {
  std::uint32_t below = 0, opaque = 0;                  ///< certain marks
  std::uint32_t perhaps_below = 0, perhaps_opaque = 0;  ///< marks that cannot be excluded
};

/// The direction and the first corner of edges (SixteenLanes).
HWY_INLINE Int direction_of(Int edges) { return hn::ShiftRight<24>(edges); }
HWY_INLINE Int first_corner_of(Int edges) { return hn::And(hn::ShiftRight<16>(edges), set(15)); }

/// The marks of pieces of edges.
class PieceMarks {
 public:
  HWY_INLINE PieceMarks() : certain_(set(0)), perhaps_(certain_) {}

  /// Judges edges, each in a cell; edge 0 is none.  x, y: the edge's first corner, counted from the cell's.
  HWY_INLINE void judge(const SixteenShape& shape, Int edge, const Cell& c, Float x, Float y) {
    const Directions by(direction_of(edge));
    const Float dx = by(shape.dx), dy = by(shape.dy), zero = hn::Zero(F()), one = set(1.0f);
    const Float low = set(-4 * shape.delta), high = set(1 + 4 * shape.delta);
    Float from = zero, to = one;
    const auto cut = [&](Float p, Float d, Float per) HWY_ATTR {
      const Float one_end = hn::Mul(hn::Sub(low, p), per), other = hn::Mul(hn::Sub(high, p), per);
      const Mask stays = hn::Eq(d, zero);
      const Mask outside = hn::And(stays, hn::Or(hn::Lt(p, low), hn::Gt(p, high)));
      const Float begin = hn::IfThenElse(stays, zero, hn::Min(one_end, other)),
                  end = hn::IfThenElse(stays, one, hn::Max(one_end, other));
      from = hn::Max(from, begin);
      to = hn::IfThenElse(outside, set(-1.0f), hn::Min(to, end));
    };
    cut(x, dx, by(shape.per_x));
    cut(y, dy, by(shape.per_y));
    const auto at = [&](Float t) HWY_ATTR {
      return hn::Sub(c.at(hn::MulAdd(t, dx, x), hn::MulAdd(t, dy, y)), set(shape.threshold));
    };
    const Float v = at(from), w = at(to), part = hn::Sub(to, from), rise = hn::Sub(w, v);
    const Float K = hn::Mul(hn::Mul(c.twist, hn::Mul(dx, part)), hn::Mul(dy, part));
    // The value v + rise s - K s (1 - s) where it stands still, else v.
    const Mask stands = hn::Lt(hn::Abs(rise), hn::Abs(K));
    const Float s = hn::IfThenElseZero(
        stands, hn::Sub(set(0.5f), hn::Div(rise, hn::IfThenElse(stands, hn::Add(K, K), one))));
    const Float still = hn::MulAdd(s, hn::NegMulAdd(K, hn::Sub(one, s), rise), v);
    const Float least = hn::Min(still, hn::Min(v, w)), greatest = hn::Max(still, hn::Max(v, w));
    const Float bound = set(shape.edge_bound), beyond = set(shape.edge_bound + shape.gap);
    const Int at_edge = hn::IfThenElseZero(hn::RebindMask(I(), hn::Le(from, to)), hn::And(edge, set(0xffff))),
              above = hn::ShiftLeft<16>(at_edge);
    const auto those = [](Int of, Mask m) HWY_ATTR { return hn::IfThenElseZero(hn::RebindMask(I(), m), of); };
    certain_ = hn::Or(certain_, hn::Or(those(at_edge, hn::Lt(least, hn::Neg(bound))),
                                       those(above, hn::Gt(greatest, set(shape.edge_bound - shape.gap)))));
    perhaps_ = hn::Or(perhaps_, hn::Or(those(at_edge, hn::Not(hn::Gt(least, bound))),
                                       those(above, hn::Not(hn::Lt(greatest, hn::Neg(beyond))))));
  }
  HWY_INLINE EdgeMarks marks() const {
    const std::uint32_t certain = any_of(certain_), perhaps = any_of(perhaps_);
    return {certain & 0xffff, certain >> 16, perhaps & 0xffff, perhaps >> 16};
  }

 private:
  /// The marks by micro-triangle: below from bit 0 on, opaque from bit 16 on.
  Int certain_, perhaps_;
};

/// The pieces of some edges in mixed cells, judged a vector of them at a time.
template <class Texel>
class Pieces {
 public:
  HWY_INLINE explicit Pieces(const SixteenInput& in) : in_(in), pending_(set(0)) {}

  /// Sets the vector of edges; x, y are their first corners.
  HWY_INLINE void edges(Float x, Float y, Int edges) {
    hn::StoreU(x, F(), x_.data());
    hn::StoreU(y, F(), y_.data());
    hn::StoreU(edges, I(), edges_.data());
  }
  /// Adds the pieces of `those` edges in the cells (i, j).
  HWY_INLINE void add(Mask those, Int i, Int j) {
    const Int all = hn::Or(hn::Iota(I(), 0), hn::Or(hn::ShiftLeft<8>(i), hn::ShiftLeft<16>(j)));
    const Int more = hn::Compress(all, hn::RebindMask(I(), those));
    const std::size_t count = hn::CountTrue(F(), those), lanes = hn::Lanes(F());
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    // Pending pieces stay in a register: a load of a vector stored in parts is slow.
    const auto from = [](std::size_t lane) { return static_cast<__mmask16>(0xffffu << lane); };
    pending_ = Int{_mm512_mask_expand_epi32(pending_.raw, from(count_), more.raw)};
    count_ += count;
    if (count_ < lanes) return;
    judge(lanes);
    count_ -= lanes;
    pending_ = Int{_mm512_maskz_compress_epi32(from(count - count_), more.raw)};
#else
    hn::StoreU(more, I(), places_.data() + count_);
    count_ += count;
    if (count_ < lanes) return;
    pending_ = hn::LoadU(I(), places_.data());
    judge(lanes);
    count_ -= lanes;
    hn::StoreU(hn::LoadU(I(), places_.data() + lanes), I(), places_.data());
#endif
  }
  /// Judges all pending pieces.
  HWY_INLINE void finish() {
    if (count_ == 0) return;
#if HWY_TARGET != HWY_AVX3 && HWY_TARGET != HWY_AVX3_DL
    pending_ = hn::LoadU(I(), places_.data());
#endif
    judge(count_);
    count_ = 0;
  }
  HWY_INLINE EdgeMarks marks() const { return found_.marks(); }

 private:
  MMVERIFY_LARGE void judge(std::size_t count) {
    // Lanes beyond `count` take cell (0, 0), which can be read.
    const auto is_one = hn::FirstN(I(), count);
    const Int all = hn::IfThenElseZero(is_one, pending_), byte = set(255);
    const Int place = hn::And(all, byte), i = hn::And(hn::ShiftRight<8>(all), byte),
              j = hn::ShiftRight<16>(all);
    const auto of = [&place](const Table& table) HWY_ATTR { return among(F(), table.data(), place); };
    const Int edge = among(I(), edges_.data(), place);
    found_.judge(*in_.shape, hn::IfThenElseZero(is_one, edge), cell<Texel>(in_, i, j),
                 hn::Sub(of(x_), hn::ConvertTo(F(), i)), hn::Sub(of(y_), hn::ConvertTo(F(), j)));
  }

  const SixteenInput& in_;
  PieceMarks found_;
  HWY_ALIGN Table x_, y_;
  HWY_ALIGN SixteenLanes::Ints edges_;
  /// The pending pieces: the place in the vector of edges from bit 0 on, the column from bit 8, the row from bit 16.
  /// places_ gathers them, with room for one more vector.
  static_assert(sixteen_window <= 256);
  Int pending_;
#if HWY_TARGET != HWY_AVX3 && HWY_TARGET != HWY_AVX3_DL
  HWY_ALIGN std::array<std::int32_t, 32> places_;
#endif
  std::size_t count_ = 0;
};

/// Adds the pieces of the edges list[0..count), a vector of them at most.
template <class Texel>
HWY_INLINE void add_pieces(const SixteenInput& in, const Words& words, const std::int32_t* list,
                           std::size_t count, Pieces<Texel>& pieces) {
  const SixteenShape& shape = *in.shape;
  const Int edges = hn::LoadU(I(), list), corner = first_corner_of(edges);
  const Float i = among(F(), sixteen_lanes.vertex_i.data(), corner),
              j = among(F(), sixteen_lanes.vertex_j.data(), corner);
  const Float x0 = place(in, 0, i, j), y0 = place(in, 1, i, j);
  pieces.edges(x0, y0, edges);
  const Directions by(direction_of(edges));
  const Int first = floored(hn::Add(y0, by(shape.top))),
            rows = hn::Add(hn::Sub(floored(hn::Add(y0, by(shape.bottom))), first), set(1));
  const Int first_column = floored(hn::Add(x0, by(shape.left))),
            end_column = hn::Add(floored(hn::Add(x0, by(shape.right))), set(1));
  const Int word = words.origin(first_column), origin = hn::ShiftLeft<3>(word);
  const Float left = hn::ConvertTo(F(), hn::Sub(first_column, origin)),
              right = hn::ConvertTo(F(), hn::Sub(end_column, origin));
  const Float s = by(shape.edge_slope), at = hn::Sub(hn::NegMulAdd(y0, s, x0), hn::ConvertTo(F(), origin)),
              low = hn::Add(at, by(shape.low)), high = hn::Add(at, by(shape.high));
  const auto listed = hn::FirstN(I(), std::min(count, hn::Lanes(F())));
  RowByRow rows_of(in, words, word, first);
  const std::int32_t last = hn::GetLane(hn::MaxOfLanes(I(), hn::IfThenElseZero(listed, rows)));
  for (std::int32_t r = 0; r < last; ++r) {
    const auto real = hn::And(listed, hn::Gt(rows, set(r)));
    const Float level = hn::ConvertTo(F(), rows_of.row);
    rows_of.ask();
    const Int cells = run(in_word(hn::Max(hn::MulAdd(level, s, low), left)),
                          in_word(hn::Min(hn::MulAdd(level, s, high), right)));
    Int met = hn::IfThenElseZero(real, hn::And(cells, rows_of.mixed));
    while (true) {
      const Mask those = hn::RebindMask(F(), hn::Ne(met, set(0)));
      if (hn::AllFalse(F(), those)) break;
      // The lowest bit, a power of 2 below 2^31, and its number from the exponent.
      const Int lowest = hn::And(met, hn::Neg(met));
      const Int bit = hn::Sub(hn::ShiftRight<23>(hn::BitCast(I(), hn::ConvertTo(F(), lowest))), set(127));
      pieces.add(those, hn::Add(origin, bit), rows_of.row);
      met = hn::Xor(met, lowest);
    }
    rows_of.go_on();
  }
  pieces.finish();
}

/// The marks of the edges of micro-triangles `asked`.
template <class Texel>
MMVERIFY_LARGE EdgeMarks ask_edges(const SixteenInput& in, const Words& words, std::uint32_t asked) {
  HWY_ALIGN std::array<std::int32_t, 48> list;
  std::size_t count = 0;
  const std::size_t lanes = hn::Lanes(F());
  for (std::size_t e = 0; e < 32; e += lanes) {
    const Int edges = hn::LoadU(I(), sixteen_lanes.edges.data() + e);
    const Mask those = have_any(edges, asked);
    hn::StoreU(hn::Compress(edges, hn::RebindMask(I(), those)), I(), list.data() + count);
    count += hn::CountTrue(F(), those);
  }
  // Edge 0 belongs to no micro-triangle, and fills the last vector.
  hn::StoreU(set(0), I(), list.data() + count);
  Pieces<Texel> pieces(in);
  for (std::size_t n = 0; n < count; n += lanes) add_pieces(in, words, list.data() + n, count - n, pieces);
  return pieces.marks();
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
