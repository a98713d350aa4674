// The edges of a node of sixteen, in mixed cells (impl/bake_sixteen.cpp).
#include <algorithm>

#include "impl/bake_sixteen_cells-inl.hpp"

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

/// Bit k of each: of some edge of micro-triangle k.
struct EdgeMarks {
  std::uint32_t below = 0, opaque = 0;                  ///< certain
  std::uint32_t perhaps_below = 0, perhaps_opaque = 0;  ///< not certain that there is none
};

/// Pieces of some edges, in mixed cells, judged a vector of them at a time.
template <class Texel>
class Pieces {
 public:
  HWY_INLINE Pieces(const SixteenInput& in, EdgeMarks& marks) : in_(in), marks_(marks) {}

  /// Of edges, by their place in a list.
  HWY_INLINE void edges(Float x, Float y, Float dx, Float dy, Int at_edge) {
    const F f;
    const auto per = [](Float d) HWY_ATTR {
      return hn::IfThenZeroElse(hn::Eq(d, hn::Zero(F())), hn::Div(set(1.0f), d));
    };
    hn::StoreU(x, f, x_.data());
    hn::StoreU(y, f, y_.data());
    hn::StoreU(dx, f, dx_.data());
    hn::StoreU(dy, f, dy_.data());
    hn::StoreU(per(dx), f, per_x_.data());
    hn::StoreU(per(dy), f, per_y_.data());
    hn::StoreU(at_edge, I(), at_edge_.data());
  }
  /// Of those edges, in cells (i, j).
  HWY_INLINE void add(Mask those, Int i, Int j) {
    const Int all = hn::Or(hn::Iota(I(), 0), hn::Or(hn::ShiftLeft<8>(i), hn::ShiftLeft<16>(j)));
    hn::StoreU(hn::Compress(all, hn::RebindMask(I(), those)), I(), places_.data() + count_);
    count_ += hn::CountTrue(F(), those);
    const std::size_t lanes = hn::Lanes(F());
    if (count_ < lanes) return;
    judge(lanes);
    count_ -= lanes;
    hn::StoreU(hn::LoadU(I(), places_.data() + lanes), I(), places_.data());
  }
  /// All that were added.
  HWY_INLINE void finish() {
    if (count_ != 0) judge(count_);
    count_ = 0;
  }

 private:
  MMVERIFY_LARGE void judge(std::size_t count) {
    // Those beyond are at (0, 0), which can be read.
    const auto is_one = hn::FirstN(I(), count);
    const Int all = hn::IfThenElseZero(is_one, hn::LoadU(I(), places_.data())), byte = set(255);
    const Int place = hn::And(all, byte), i = hn::And(hn::ShiftRight<8>(all), byte),
              j = hn::ShiftRight<16>(all);
    const auto of = [&place](const Table& table) HWY_ATTR { return among(F(), table.data(), place); };
    const Cell c = cell<Texel>(in_, i, j);
    // From the cell's corner.
    const Float x = hn::Sub(of(x_), hn::ConvertTo(F(), i)), y = hn::Sub(of(y_), hn::ConvertTo(F(), j)),
                dx = of(dx_), dy = of(dy_), zero = hn::Zero(F()), one = set(1.0f);
    const Float low = set(-4 * in_.delta), high = set(1 + 4 * in_.delta);
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
    cut(x, dx, of(per_x_));
    cut(y, dy, of(per_y_));
    const auto at = [&](Float t) HWY_ATTR {
      return hn::Sub(c.at(hn::MulAdd(t, dx, x), hn::MulAdd(t, dy, y)), set(in_.threshold));
    };
    const Float v = at(from), w = at(to), part = hn::Sub(to, from), rise = hn::Sub(w, v);
    const Float K = hn::Mul(hn::Mul(c.twist, hn::Mul(dx, part)), hn::Mul(dy, part));
    // v + rise s - K s (1 - s), where it stands still; elsewhere v.
    const Mask stands = hn::Lt(hn::Abs(rise), hn::Abs(K));
    const Float s = hn::IfThenElseZero(
        stands, hn::Sub(set(0.5f), hn::Div(rise, hn::IfThenElse(stands, hn::Add(K, K), one))));
    const Float still = hn::MulAdd(s, hn::NegMulAdd(K, hn::Sub(one, s), rise), v);
    const Float least = hn::Min(still, hn::Min(v, w)), greatest = hn::Max(still, hn::Max(v, w));
    const Float bound = set(in_.edge_bound), beyond = set(in_.edge_bound + in_.gap);
    const Int at_edge = hn::IfThenElseZero(hn::And(is_one, hn::RebindMask(I(), hn::Le(from, to))),
                                           among(I(), at_edge_.data(), place)),
              above = hn::ShiftLeft<16>(at_edge);
    const auto those = [](Int of, Mask m) HWY_ATTR { return hn::IfThenElseZero(hn::RebindMask(I(), m), of); };
    const std::uint32_t certain =
                            any_of(hn::Or(those(at_edge, hn::Lt(least, hn::Neg(bound))),
                                          those(above, hn::Gt(greatest, set(in_.edge_bound - in_.gap))))),
                        perhaps = any_of(hn::Or(those(at_edge, hn::Not(hn::Gt(least, bound))),
                                                those(above, hn::Not(hn::Lt(greatest, hn::Neg(beyond))))));
    marks_.below |= certain & 0xffff;
    marks_.opaque |= certain >> 16;
    marks_.perhaps_below |= perhaps & 0xffff;
    marks_.perhaps_opaque |= perhaps >> 16;
  }
  /// All bits of all lanes.
  static HWY_INLINE std::uint32_t any_of(Int x) {
    HWY_ALIGN SixteenLanes::Ints lanes{};
    hn::StoreU(x, I(), lanes.data());
    std::int32_t any = 0;
    for (std::size_t n = 0; n < hn::MaxLanes(F()); ++n) any |= lanes[n];
    return static_cast<std::uint32_t>(any);
  }

  const SixteenInput& in_;
  EdgeMarks& marks_;
  HWY_ALIGN Table x_, y_, dx_, dy_, per_x_, per_y_;
  HWY_ALIGN SixteenLanes::Ints at_edge_;
  /// Places in the vector of edges, columns and rows, from bits 0, 8 and 16 on: a vector of them, and room
  /// for what one more adds.
  static_assert(sixteen_window <= 256);
  HWY_ALIGN std::array<std::int32_t, 32> places_;
  std::size_t count_ = 0;
};

/// The pieces of a vector of edges, those of list.
template <class Texel>
HWY_INLINE void add_pieces(const SixteenInput& in, const Words& words, const Vertices& v,
                           const std::int32_t* list, std::size_t count, Pieces<Texel>& pieces) {
  const Int edge = hn::LoadU(I(), list);
  const auto table = [&edge](const std::array<std::int32_t, 32>& of) HWY_ATTR {
    return among_rows(reinterpret_cast<const std::uint32_t*>(of.data()), edge);
  };
  const Int from = table(sixteen_lanes.from), to = table(sixteen_lanes.to);
  const auto of = [](const Table& table, Int at) HWY_ATTR { return among(F(), table.data(), at); };
  const Float xa = of(v.x, from), ya = of(v.y, from), xb = of(v.x, to), yb = of(v.y, to);
  const Float dx = hn::Sub(xb, xa), dy = hn::Sub(yb, ya), d = set(in.row_margin), one = set(1.0f),
              zero = hn::Zero(F());
  pieces.edges(xa, ya, dx, dy, table(sixteen_lanes.at_edge));
  const Int first = floored(hn::Sub(hn::Min(ya, yb), d)),
            rows = hn::Add(hn::Sub(floored(hn::Add(hn::Max(ya, yb), d)), first), set(1));
  const Int first_column = floored(hn::Sub(hn::Min(xa, xb), d)),
            end_column = hn::Add(floored(hn::Add(hn::Max(xa, xb), d)), set(1));
  const Int word = words.origin(first_column), origin = hn::ShiftLeft<3>(word);
  const Float left = hn::ConvertTo(F(), hn::Sub(first_column, origin)),
              right = hn::ConvertTo(F(), hn::Sub(end_column, origin));
  const Mask is_flat = hn::Lt(hn::Abs(dy), set(0.25f));
  const Float s = hn::IfThenZeroElse(is_flat, hn::Div(dx, hn::IfThenElse(is_flat, one, dy)));
  const Float at = hn::Sub(hn::NegMulAdd(ya, s, xa), hn::ConvertTo(F(), origin));
  // A flat one's line is everywhere.
  const Float out = hn::IfThenElse(is_flat, set(1e6f), hn::Mul(set(16 * in.delta), hn::Add(one, hn::Abs(s))));
  // As of micro-triangles.
  const Float half = set(0.5f), low = hn::Sub(hn::Add(hn::Sub(at, out), hn::Min(s, zero)), half),
              high = hn::Add(hn::Add(hn::Add(at, out), hn::Max(s, zero)), half);
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
      // The lowest bit, a power of 2 below 2^31, and its number.
      const Int lowest = hn::And(met, hn::Neg(met));
      const Int bit = hn::Sub(hn::ShiftRight<23>(hn::BitCast(I(), hn::ConvertTo(F(), lowest))), set(127));
      pieces.add(those, hn::Add(origin, bit), rows_of.row);
      met = hn::Xor(met, lowest);
    }
    rows_of.go_on();
  }
  pieces.finish();
}

/// Of the edges of some micro-triangles.
template <class Texel>
MMVERIFY_LARGE void ask_edges(const SixteenInput& in, const Words& words, const Vertices& v,
                              std::uint32_t asked, EdgeMarks& marks) {
  HWY_ALIGN std::array<std::int32_t, 48> list;
  std::size_t count = 0;
  const std::size_t lanes = hn::Lanes(F());
  for (std::size_t e = 0; e < 32; e += lanes) {
    const Mask those = have_any(hn::LoadU(I(), sixteen_lanes.at_edge.data() + e), asked);
    hn::StoreU(hn::Compress(hn::Iota(I(), static_cast<std::int32_t>(e)), hn::RebindMask(I(), those)), I(),
               list.data() + count);
    count += hn::CountTrue(F(), those);
  }
  // Those that fill the last vector are of no length.
  hn::StoreU(set(30), I(), list.data() + count);
  Pieces<Texel> pieces(in, marks);
  for (std::size_t n = 0; n < count; n += lanes) add_pieces(in, words, v, list.data() + n, count - n, pieces);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#endif
