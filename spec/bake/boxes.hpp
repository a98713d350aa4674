// Baking: the range of alpha over a polygon, from as few of its texels as decide it.
//
// Squares repeat where a texture does.  A box of squares has the range of its distinct texels, so that a polygon over
// many repeats takes the work of a few.  range_by_parts() (bake.hpp) is the definition; this is the same number.
// Work: at most the distinct texels under each box, times the boxes that the polygon's edges cut; these are few but
// for thin polygons across many repeats, whose squares are cut one by one.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "spec/bake/bake.hpp"

namespace mmverify::spec::bake {

// ---- Indices

/// The whole numbers first..last.
struct Interval {
  std::int64_t first, last;
  std::int64_t size() const { return last - first + 1; }
};

/// The shortest interval whose indices mean the same texels.
///   repeat: one period; mirrored: two sizes; else the indices up to the first beyond each end
/// Domain: |first|, |last| < 2^62; size in 1..2^31.
inline Interval distinct(Wrap wrap, const Interval& indices, std::uint32_t size) {
  const auto n = static_cast<std::int64_t>(size);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return Interval{std::clamp(indices.first, low, high), std::clamp(indices.last, low, high)};
  };
  const auto at_most = [&](std::int64_t period) {
    return Interval{indices.first, std::min(indices.last, indices.first + period - 1)};
  };
  switch (wrap) {
    case Wrap::repeat: return at_most(n);
    case Wrap::mirrored_repeat: return at_most(n == 1 ? 1 : 2 * n);
    case Wrap::clamp_to_edge: return between(0, n - 1);
    case Wrap::mirror_once: return between(-n, n - 1);
    case Wrap::clamp_to_border: break;
  }
  return between(-1, n);
}

// ---- Texels of a box

/// A box of squares: columns and rows.
struct Box {
  Interval columns, rows;
};

/// Texels in the order of their numbers.
inline std::int64_t order_of(std::uint32_t texel) { return texel; }
inline std::int64_t order_of(Binary32 texel) {
  const std::int64_t size = texel.bits & 0x7fffffff;
  return texel.bits >> 31 != 0 ? -size : size;
}

/// A texel and its index.
template <class Texel>
struct TexelAt {
  Texel texel;
  std::int64_t i, j;
};

/// The least and the greatest texel of a box.
template <class Texel>
struct BoxTexels {
  TexelAt<Texel> least, greatest;
};

/// The texels that alpha on a box depends on: bilinear also those of the next column and row.
template <class Texel>
Box texels_of(const TextureOf<Texel>& t, const Box& box) {
  const std::int64_t next = t.filter == Filter::bilinear ? 1 : 0;
  return {distinct(t.wrap_x, {box.columns.first, box.columns.last + next}, t.width),
          distinct(t.wrap_y, {box.rows.first, box.rows.last + next}, t.height)};
}

template <class Texel>
BoxTexels<Texel> least_and_greatest(const TextureOf<Texel>& t, const Box& texels) {
  std::vector<std::optional<std::uint32_t>> columns;
  for (std::int64_t i = texels.columns.first; i <= texels.columns.last; ++i)
    columns.push_back(wrapped(t.wrap_x, i, t.width));
  std::optional<BoxTexels<Texel>> found;
  for (std::int64_t j = texels.rows.first; j <= texels.rows.last; ++j) {
    const auto row = wrapped(t.wrap_y, j, t.height);
    const Texel* const from = row ? t.alpha.data() + std::size_t{*row} * t.width : nullptr;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const Texel texel = row && columns[k] ? from[*columns[k]] : t.border;
      const TexelAt<Texel> here{texel, texels.columns.first + static_cast<std::int64_t>(k), j};
      if (!found) found = BoxTexels<Texel>{here, here};
      if (order_of(texel) < order_of(found->least.texel)) found->least = here;
      if (order_of(texel) > order_of(found->greatest.texel)) found->greatest = here;
    }
  }
  return found.value();
}

/// The range of alpha over whole squares.  A square has its extremes at its corners: bilinear alpha is affine along
/// each side, and has none within.
template <class Q, class Texel>
Range<Q> range(const TextureOf<Texel>& t, const BoxTexels<Texel>& texels) {
  Range<Q> all(texel<Q>(t, texels.least.i, texels.least.j));
  all.take(texel<Q>(t, texels.greatest.i, texels.greatest.j));
  return all;
}

// ---- Boxes of a polygon

/// The part of a polygon in a box.
template <class Q>
struct BoxPart {
  Box box;
  Polygon<Q> part;
};

/// Whether a box is all of its part: each corner of the box is a corner of the part.
template <class Q>
bool is_whole(const BoxPart<Q>& one, const Q& offset) {
  for (const std::int64_t column : {one.box.columns.first, one.box.columns.last + 1})
    for (const std::int64_t row : {one.box.rows.first, one.box.rows.last + 1}) {
      const Q x = fraction<Q>(column, 1) + offset, y = fraction<Q>(row, 1) + offset;
      const auto is_corner = [&](const TexturePoint<Q>& p) { return p.x == x && p.y == y; };
      if (std::none_of(one.part.begin(), one.part.end(), is_corner)) return false;
    }
  return true;
}

/// Both halves of a box, cut across its columns or across its rows, without parts that are empty or only on a box's
/// high side: that side is its neighbour's low side.
template <class Q, class Take>
void halves(const BoxPart<Q>& one, bool by_column, const Q& offset, Take take) {
  Q TexturePoint<Q>::*const axis = by_column ? &TexturePoint<Q>::x : &TexturePoint<Q>::y;
  const Interval& all = by_column ? one.box.columns : one.box.rows;
  const std::int64_t middle = all.first + all.size() / 2;
  const Q line = fraction<Q>(middle, 1) + offset;
  for (const bool low : {true, false}) {
    BoxPart<Q> half{one.box, clipped(one.part, [&](const TexturePoint<Q>& p) {
                      return low ? line - p.*axis : p.*axis - line;
                    })};
    (by_column ? half.box.columns : half.box.rows) =
        low ? Interval{all.first, middle - 1} : Interval{middle, all.last};
    if (half.part.empty()) continue;
    if (ends(half.part, &TexturePoint<Q>::x, offset).first > half.box.columns.last) continue;
    if (ends(half.part, &TexturePoint<Q>::y, offset).first > half.box.rows.last) continue;
    take(std::move(half));
  }
}

/// Whether a box is cut across its columns: the longer axis, but for one along which it holds whole periods: halves of
/// these hold the same texels.
template <class Texel>
bool across_columns(const TextureOf<Texel>& t, const Box& box, const Box& texels) {
  const auto holds_periods = [](Wrap wrap, const Interval& squares, const Interval& indices) {
    return (wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat) && squares.size() > 2 * indices.size();
  };
  const bool columns_do = holds_periods(t.wrap_x, box.columns, texels.columns),
             rows_do = holds_periods(t.wrap_y, box.rows, texels.rows);
  if (columns_do != rows_do) return rows_do;
  return box.columns.size() >= box.rows.size();
}

/// Cuts a polygon into parts in boxes of squares, the largest first, until each is settled.
///   settled(texels, one, whole): whether nothing more is to be learnt from a box and its part, given the box's least
///   and greatest texel; `whole`: all of the box is in the polygon
///   leaf(i, j, part): the part in one square, or in squares along whose side alpha is constant
/// Domain, errors: those of for_each_part.
template <class Q, class Texel, class Settled, class Leaf>
void for_each_box(const TextureOf<Texel>& t, const Polygon<Q>& polygon, Settled settled, Leaf leaf) {
  if (polygon.empty()) throw std::invalid_argument("bake: a polygon without corners");
  if (t.alpha.empty() || t.alpha.size() != static_cast<std::size_t>(t.width) * t.height)
    throw std::invalid_argument("bake: the texels are not width x height");
  const Q offset = t.filter == Filter::bilinear ? fraction<Q>(1, 2) : Q(0);
  const auto [left, right] = ends(polygon, &TexturePoint<Q>::x, offset);
  const auto [top, bottom] = ends(polygon, &TexturePoint<Q>::y, offset);
  std::deque<BoxPart<Q>> boxes{{{{left, right}, {top, bottom}}, polygon}};
  for (; !boxes.empty(); boxes.pop_front()) {
    const BoxPart<Q>& one = boxes.front();
    const Box texels = texels_of(t, one.box);
    if (settled(least_and_greatest(t, texels), one, is_whole(one, offset))) continue;
    const bool by_column = one.box.columns.size() > 1 && texels.columns.size() > 1,
               by_row = one.box.rows.size() > 1 && texels.rows.size() > 1;
    if (!by_column && !by_row)
      leaf(one.box.columns.first, one.box.rows.first, one.part);
    else
      halves(one, by_column && (!by_row || across_columns(t, one.box, texels)), offset,
             [&boxes](BoxPart<Q> half) { boxes.push_back(std::move(half)); });
  }
}

/// Boxes of fewer squares are halved without a look at single texels.
inline constexpr std::int64_t few_squares = 8;

/// Whether a convex polygon with an area holds a place.
template <class Q>
bool holds(const Polygon<Q>& polygon, const TexturePoint<Q>& p) {
  bool left = false, right = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const TexturePoint<Q>&from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const Q side = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    (side > 0 ? left : right) |= side != 0;
  }
  return left != right;
}

/// The index that means the same texel as `index` whose centre is nearest to a coordinate.
template <class Q>
std::int64_t nearest_index(Wrap wrap, std::int64_t index, std::uint32_t size, const Q& coordinate) {
  if (wrap != Wrap::repeat && wrap != Wrap::mirrored_repeat) return index;
  const std::int64_t period = (wrap == Wrap::repeat ? 1 : 2) * static_cast<std::int64_t>(size);
  return index + period * floored((coordinate - fraction<Q>(index, 1)) / Q(period));
}

/// Whether the centre of a texel, or of one that means the same, lies in the part of a box.
template <class Q, class Texel>
bool has_centre(const TextureOf<Texel>& t, const Polygon<Q>& part, const TexturePoint<Q>& middle,
                const TexelAt<Texel>& at) {
  return holds(part, {Cell<Q>::along(nearest_index(t.wrap_x, at.i, t.width, middle.x)),
                      Cell<Q>::along(nearest_index(t.wrap_y, at.j, t.height, middle.y))});
}

/// The range over the part of a polygon in one square, or in squares along whose side alpha is constant.
template <class Q, class Texel>
Range<Q> range_in_square(const TextureOf<Texel>& t, std::int64_t i, std::int64_t j, Polygon<Q> part) {
  if (t.filter == Filter::nearest) return Range<Q>(texel<Q>(t, i, j));
  const Cell<Q> cell(t, i, j);
  for (TexturePoint<Q>& p : part) p = cell.local(p);
  return range(cell, part);
}

}  // namespace mmverify::spec::bake
