#include "impl/bake/sixteen/sixteen.hpp"

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/bake/sixteen/sixteen.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "impl/bake/sixteen/edges-inl.hpp"
#include "impl/bake/sixteen/few-inl.hpp"

// Compiled once for each target.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::bake::detail {
namespace HWY_NAMESPACE {

/// The places of bits [k, k + lanes) in cells that are not mixed, and their marks.  With one limit, and if marks are
/// clear, alpha there is beyond all bounds on that side.  Bits are in cache, texels may not be.
struct KnownBits {
  std::uint32_t places = 0, opaque = 0;
};
HWY_INLINE KnownBits known_by_cells(const SixteenInput& in, const Words& words, const Located& at,
                                    std::size_t k) {
  if (!in.shape->clear || in.shape->gap != 0 || words.is_small) return {};
  const Int word = words.origin(at.i), bit = hn::Sub(at.i, hn::ShiftLeft<3>(word)), one = set(1);
  RowByRow row(in, words, word, at.j);
  row.ask();
  const auto has = [&](Int x) HWY_ATTR {
    return bits_of(hn::RebindMask(F(), hn::Eq(hn::And(hn::Shr(x, bit), one), one)), k);
  };
  const std::uint32_t here = ((1u << hn::Lanes(F())) - 1) << k, places = here & ~has(row.mixed);
  return {places, places & has(row.are)};
}

/// The marks of `asked` micro-triangles from their corners: the marks of any corner, and the marks that no corner
/// bears.
struct CornerMarks {
  std::uint32_t below = 0, opaque = 0, no_below = 0, no_opaque = 0;
  std::uint32_t one_no_below = 0, one_no_opaque = 0;  ///< marks that at least one corner certainly lacks
};
/// The bits of vertices: 1 below, 2 opaque, 4 no below, 8 no opaque.
HWY_INLINE CornerMarks of_corners(const SixteenLanes::Ints& vertices, std::uint32_t asked) {
  CornerMarks marks;
  for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) {
    const auto corner = [&](std::size_t c) HWY_ATTR {
      return among(I(), vertices.data(), hn::LoadU(I(), sixteen_lanes.corner[c].data() + k));
    };
    const Int a = corner(0), b = corner(1), c = corner(2), some = hn::Or(a, hn::Or(b, c)),
              all = hn::And(a, hn::And(b, c));
    const auto have = [k](Int x, std::int32_t bit) HWY_ATTR {
      return bits_of(hn::RebindMask(F(), hn::Eq(hn::And(x, set(bit)), set(bit))), k);
    };
    marks.below |= have(some, 1) & asked;
    marks.opaque |= have(some, 2) & asked;
    marks.no_below |= have(all, 4) & asked;
    marks.no_opaque |= have(all, 8) & asked;
    marks.one_no_below |= have(some, 4) & asked;
    marks.one_no_opaque |= have(some, 8) & asked;
  }
  return marks;
}
template <class Texel>
MMVERIFY_LARGE CornerMarks ask_corners(const SixteenInput& in, const Words& words, std::uint32_t asked) {
  const F f;
  const SixteenShape& shape = *in.shape;
  HWY_ALIGN SixteenLanes::Ints vertices;  // 1 below, 2 opaque, 4 no below, 8 no opaque
  for (std::size_t k = 0; k < 16; k += hn::Lanes(f)) {
    const Float i = hn::LoadU(f, sixteen_lanes.vertex_i.data() + k),
                j = hn::LoadU(f, sixteen_lanes.vertex_j.data() + k);
    const Located at(place(in, 0, i, j), place(in, 1, i, j));
    const KnownBits known = known_by_cells(in, words, at, k);
    const Mask is_known = mask_of(known.places, k),
               wanted =
                   hn::AndNot(is_known, have_any(hn::LoadU(I(), sixteen_lanes.at_vertex.data() + k), asked));
    const auto bit = [](Mask m, std::int32_t b)
                         HWY_ATTR { return hn::IfThenElseZero(hn::RebindMask(I(), m), set(b)); };
    Int marks =
        hn::IfThenElse(hn::RebindMask(I(), mask_of(known.opaque, k)), set(2 + 4), bit(is_known, 1 + 8));
    if (!hn::AllFalse(f, wanted)) {
      const Float g = sampled<Texel>(in, at, wanted), bound = set(shape.bound);
      const Int of_g =
          hn::Or(hn::Or(bit(hn::Lt(g, hn::Neg(bound)), 1), bit(hn::Gt(g, set(shape.bound - shape.gap)), 2)),
                 hn::Or(bit(hn::Gt(g, bound), 4), bit(hn::Lt(g, set(-shape.bound - shape.gap)), 8)));
      marks = hn::IfThenElse(hn::RebindMask(I(), wanted), of_g, marks);
    }
    hn::StoreU(marks, I(), vertices.data() + k);
  }
  return of_corners(vertices, asked);
}

/// Writes how alpha leans at the centroids of the micro-triangles `asked`, and adds the marks that it bears there.
template <class Texel>
MMVERIFY_LARGE void ask_centroids(const SixteenInput& in, const Words& words, std::uint32_t all,
                                  SixteenMarks& marks) {
  const F f;
  const Float bound = set(in.shape->bound);
  for (std::size_t k = 0; k < 16; k += hn::Lanes(f)) {
    const Float i = hn::LoadU(f, sixteen_lanes.centroid_i.data() + k),
                j = hn::LoadU(f, sixteen_lanes.centroid_j.data() + k);
    const Located at(place(in, 0, i, j), place(in, 1, i, j));
    std::uint32_t asked = all;
    const KnownBits known = known_by_cells(in, words, at, k);
    marks.leans |= known.places & all;
    marks.leans_to_opaque |= known.opaque & all;
    marks.below |= known.places & ~known.opaque & all;
    marks.opaque |= known.opaque & all;
    asked &= ~known.places;
    if ((asked >> k & ((1u << hn::Lanes(f)) - 1)) == 0) continue;
    const Float g = sampled<Texel>(in, at, mask_of(asked, k)), lean = hn::Sub(g, set(in.shape->lean));
    marks.below |= bits_of(hn::Lt(g, hn::Neg(bound)), k) & asked;
    marks.opaque |= bits_of(hn::Gt(g, set(in.shape->bound - in.shape->gap)), k) & asked;
    marks.leans |= bits_of(hn::Gt(hn::Abs(lean), bound), k) & asked;
    marks.leans_to_opaque |= bits_of(hn::Gt(lean, set(0.0f)), k) & asked;
  }
}

/// Takes the marks from cells; returns the micro-triangles at mixed cells that still lack a mark.
template <bool keeps>
HWY_INLINE std::uint32_t take_cells(const SixteenInput& in, const Words& words, CellMarks& cells,
                                    MetCells& met, SixteenMarks& marks) {
  for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) ask_cells<true, keeps>(in, words, k, cells, met);
  marks.by_texels = cells.fit & ~cells.meets_mixed;
  marks.lacks_below = marks.by_texels & cells.begins_opaque;
  marks.lacks_opaque = marks.by_texels & ~cells.begins_opaque;
  const std::uint32_t judged = cells.fit & cells.meets_mixed;
  if (in.shape->clear) {
    marks.below = judged & cells.have_not;
    marks.opaque = judged & cells.have;
  }
  return judged & ~(marks.below & marks.opaque);
}

/// Adds the marks of corners to the micro-triangles `left`, and removes those that now bear both.
HWY_INLINE void take_corners(const CornerMarks& corners, std::uint32_t& left, SixteenMarks& marks) {
  marks.below |= corners.below & left;
  marks.opaque |= corners.opaque & left;
  left &= ~(marks.below & marks.opaque);
}

/// Adds the marks of edges; no_below, no_opaque: lacking the mark but for edges and the centres within.
HWY_INLINE void take_edges(const EdgeMarks& edges, const CellMarks& cells, std::uint32_t no_below,
                           std::uint32_t no_opaque, std::uint32_t left, SixteenMarks& marks) {
  marks.below |= edges.below & left;
  marks.opaque |= edges.opaque & left;
  marks.lacks_below |= left & no_below & ~(marks.below | edges.perhaps_below | cells.perhaps_not);
  marks.lacks_opaque |= left & no_opaque & ~(marks.opaque | edges.perhaps_opaque | cells.perhaps);
}

/// Judges a node that meets few mixed cells.
template <class Texel>
HWY_INLINE void judge_few(const SixteenInput& in, const Words& words, const FewCells& few,
                          SixteenMarks& marks) {
  CellMarks cells;
  MetCells met;
  met.grid = few.grid;
  std::uint32_t left = take_cells<true>(in, words, cells, met, marks);
  if (left == 0) return;
  FewAlpha alpha;
  alpha.take<Texel>(in, few);
  const FewMarks found = ask_few(in, words, met, alpha);
  const CornerMarks corners = of_corners(found.vertices, left);
  marks.lacks_below |= corners.one_no_below & ~found.perhaps_below;
  marks.lacks_opaque |= corners.one_no_opaque & ~found.perhaps_opaque;
  marks.leans = found.leans;
  marks.leans_to_opaque = found.leans_to_opaque;
  left &= ~(marks.lacks_below | marks.lacks_opaque);
  take_corners(corners, left, marks);
  marks.below |= found.below & left;
  marks.opaque |= found.opaque & left;
  left &= ~(marks.below & marks.opaque);
  if (left == 0) return;
  const EdgeMarks edges = ask_few_edges(in, alpha, found, left & ~marks.below, left & ~marks.opaque);
  take_edges(edges, cells, corners.one_no_below, corners.one_no_opaque, left, marks);
}
/// Judges any node.
template <class Texel>
HWY_INLINE void judge_many(const SixteenInput& in, const Words& words, SixteenMarks& marks) {
  CellMarks cells;
  MetCells met;
  std::uint32_t left = take_cells<false>(in, words, cells, met, marks);
  if (left == 0) return;
  const CornerMarks corners = ask_corners<Texel>(in, words, left);
  take_corners(corners, left, marks);
  if (left == 0) return;
  ask_centroids<Texel>(in, words, left | (marks.below & marks.opaque), marks);
  left &= ~(marks.below & marks.opaque);
  if (left == 0) return;
  take_edges(ask_edges<Texel>(in, words, left), cells, corners.no_below, corners.no_opaque, left, marks);
}

template <class Texel>
HWY_INLINE SixteenMarks node_of(const SixteenInput& in, const Words& words) {
  SixteenMarks marks;
  FewCells few;
  if (in.shape->is_small && words.is_small) {
    few.take(in, words);
    if (few.are_none) {
      marks.by_texels = 0xffff;
      (few.begin_opaque ? marks.lacks_below : marks.lacks_opaque) = 0xffff;
      return marks;
    }
  }
  if (few.are_few)
    judge_few<Texel>(in, words, few, marks);
  else
    judge_many<Texel>(in, words, marks);
  const std::uint32_t unknowns = marks.below & marks.opaque;
  if ((unknowns & ~marks.leans) != 0) ask_centroids<Texel>(in, words, unknowns & ~marks.leans, marks);
  const std::uint32_t decided = marks.lacks_below | marks.lacks_opaque | (unknowns & marks.leans);
  marks.leaves = static_cast<std::uint32_t>(hwy::PopCount(decided & ~marks.by_texels));
  return marks;
}

template <class Texel>
HWY_INLINE void sixteen_of(const SixteenInput& window, std::span<const SixteenNode> nodes,
                           SixteenMarks* marks) {
  const Words words(window);
  constexpr auto line = static_cast<std::int32_t>(64 / sizeof(Texel));
  // Texels may be far: they are prefetched while bits are looked at.
  for (std::int32_t r = 0; r < window.rows; ++r) {
    const Texel* const row = static_cast<const Texel*>(window.texels) + std::ptrdiff_t{r} * window.pitch;
    if (words.is_small) {
      hwy::Prefetch(row + window.columns / 2);
      continue;
    }
    for (std::int32_t c = 0; c < window.columns; c += line) hwy::Prefetch(row + c);
    hwy::Prefetch(row + window.columns - 1);
  }
  SixteenInput in = window;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    in.shape = nodes[n].shape;
    in.p0 = nodes[n].p0;
    marks[n] = node_of<Texel>(in, words);
  }
}

SixteenNodes Nodes(const SixteenInput& in) {
  const Words words(in);
  CellMarks cells;
  MetCells met;
  for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) ask_cells<false, false>(in, words, k, cells, met);
  return {true, cells.fit & ~cells.meets_mixed, cells.begins_opaque};
}

void Sixteen8(const SixteenInput& in, std::span<const SixteenNode> nodes, SixteenMarks* marks) {
  sixteen_of<std::uint8_t>(in, nodes, marks);
}
void Sixteen16(const SixteenInput& in, std::span<const SixteenNode> nodes, SixteenMarks* marks) {
  sixteen_of<std::uint16_t>(in, nodes, marks);
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::bake::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::bake::detail {

HWY_EXPORT(Nodes);
HWY_EXPORT(Sixteen8);
HWY_EXPORT(Sixteen16);

SixteenNodes sixteen_nodes(const SixteenInput& in) { return HWY_DYNAMIC_DISPATCH(Nodes)(in); }
template <>
void sixteen<std::uint8_t>(const SixteenInput& in, std::span<const SixteenNode> nodes, SixteenMarks* marks) {
  HWY_DYNAMIC_DISPATCH(Sixteen8)(in, nodes, marks);
}
template <>
void sixteen<std::uint16_t>(const SixteenInput& in, std::span<const SixteenNode> nodes, SixteenMarks* marks) {
  HWY_DYNAMIC_DISPATCH(Sixteen16)(in, nodes, marks);
}

}  // namespace mmverify::impl::bake::detail
#endif
