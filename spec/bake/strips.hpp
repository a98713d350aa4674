// Baking: strips, boxes of one row or one column of squares, or along whose short side alpha is constant.
//
// A triangle over many repeats has edges that run within one row for thousands of squares.  A strip is judged as a whole.
#pragma once

#include <array>
#include <optional>

#include "spec/bake/boxes.hpp"

namespace mmverify::spec::bake {

/// An axis of the texture: a strip's long one, or the other.
template <class Q>
struct Axis {
  Q TexturePoint<Q>::*along;
  Interval Box::*squares;
  Wrap wrap;
  std::uint32_t size;
};

template <class Q, class Texel>
std::array<Axis<Q>, 2> axes(const TextureOf<Texel>& t, bool along_x) {
  const Axis<Q> x{&TexturePoint<Q>::x, &Box::columns, t.wrap_x, t.width},
      y{&TexturePoint<Q>::y, &Box::rows, t.wrap_y, t.height};
  return along_x ? std::array{x, y} : std::array{y, x};
}

/// The least and the greatest coordinate of a polygon.
template <class Q>
Range<Q> extent(const Polygon<Q>& polygon, Q TexturePoint<Q>::*axis) {
  Range<Q> all(polygon.at(0).*axis);
  for (const TexturePoint<Q>& p : polygon) all.take(p.*axis);
  return all;
}

/// The part of a polygon where a coordinate has one value: a segment.
template <class Q>
Polygon<Q> slice(const Polygon<Q>& polygon, Q TexturePoint<Q>::*axis, const Q& at) {
  return clipped(polygon, axis, at, at);
}

/// Takes the range of bilinear alpha over a part along which alpha is constant across the strip: the centres of texels
/// in its extent, and both ends, decide.  Domain: `across` constant in the box.
template <class Q, class Texel, class Take>
void take_constant_strip(const TextureOf<Texel>& t, const BoxPart<Q>& one, const Axis<Q>& axis, Take take) {
  const Range<Q> all = extent(one.part, axis.along);
  const auto alpha_at = [&](const Q& at) {
    TexturePoint<Q> p = one.part[0];
    p.*axis.along = at;
    take(Range<Q>(alpha(t, p)));
  };
  alpha_at(all.least);
  alpha_at(all.greatest);
  const Q half = fraction<Q>(1, 2);
  const Interval centres =
      distinct(axis.wrap, {-floored(half - all.least), floored(all.greatest - half)}, axis.size);
  for (std::int64_t k = centres.first; k <= centres.last; ++k) alpha_at(Cell<Q>::along(k));
}

/// Bilinear alpha over the rectangle of a strip's columns and the extent of its part across: the least and the
/// greatest, and their texels' indices along the strip.
template <class Q>
struct StripBound {
  Range<Q> alpha;
  std::int64_t least_at, greatest_at;
};
template <class Q, class Texel>
StripBound<Q> bound_of(const TextureOf<Texel>& t, const BoxPart<Q>& one, const std::array<Axis<Q>, 2>& axis) {
  const Range<Q> across = extent(one.part, axis[1].along);
  const Interval squares = one.box.*axis[0].squares,
                 indices = distinct(axis[0].wrap, {squares.first, squares.last + 1}, axis[0].size);
  std::optional<StripBound<Q>> found;
  for (std::int64_t k = indices.first; k <= indices.last; ++k)
    for (const Q& at : {across.least, across.greatest}) {
      TexturePoint<Q> p;
      p.*axis[0].along = Cell<Q>::along(k);
      p.*axis[1].along = at;
      const Q here = alpha(t, p);
      if (!found) found = StripBound<Q>{Range<Q>(here), k, k};
      if (here < found->alpha.least) found->least_at = k;
      if (here > found->alpha.greatest) found->greatest_at = k;
      found->alpha.take(here);
    }
  return found.value();
}

/// Whether a part is its own bounding box, from the strip's one end to the other.
template <class Q>
bool is_rectangle(const BoxPart<Q>& one, const std::array<Axis<Q>, 2>& axis) {
  const Range<Q> along = extent(one.part, axis[0].along), across = extent(one.part, axis[1].along);
  const Interval squares = one.box.*axis[0].squares;
  if (along.least != Cell<Q>::along(squares.first) || along.greatest != Cell<Q>::along(squares.last + 1))
    return false;
  for (const Q& a : {along.least, along.greatest})
    for (const Q& b : {across.least, across.greatest}) {
      const auto is_corner = [&](const TexturePoint<Q>& p) {
        return p.*axis[0].along == a && p.*axis[1].along == b;
      };
      if (std::none_of(one.part.begin(), one.part.end(), is_corner)) return false;
    }
  return true;
}

/// Takes alpha on the slices of a part through a texel's centre that are nearest to its corners farthest across.
template <class Q, class Texel, class Take>
void take_slices(const TextureOf<Texel>& t, const BoxPart<Q>& one, const std::array<Axis<Q>, 2>& axis,
                 std::int64_t index, Take take) {
  const auto [low, high] = std::minmax_element(one.part.begin(), one.part.end(),
                                               [&](const TexturePoint<Q>& a, const TexturePoint<Q>& b) {
                                                 return a.*axis[1].along < b.*axis[1].along;
                                               });
  const Range<Q> along = extent(one.part, axis[0].along);
  const std::int64_t period =
      axis[0].wrap == Wrap::mirrored_repeat ? 2 * std::int64_t{axis[0].size} : axis[0].size;
  for (const TexturePoint<Q>& corner : {*low, *high}) {
    std::int64_t k = nearest_index(axis[0].wrap, index, axis[0].size, corner.*axis[0].along);
    if (Cell<Q>::along(k) < along.least) k += period;
    if (Cell<Q>::along(k) > along.greatest) k -= period;
    for (const TexturePoint<Q>& p : slice(one.part, axis[0].along, Cell<Q>::along(k)))
      take(Range<Q>(alpha(t, p)));
  }
}

/// The range of the texels that a part in a row or a column owns, with nearest filtering.  The part's far end may lie
/// on the strip's high side alone, and then only the squares before it are met.
template <class Q, class Texel>
Range<Q> nearest_strip(const TextureOf<Texel>& t, const BoxPart<Q>& one, const std::array<Axis<Q>, 2>& axis) {
  const Range<Q> along = extent(one.part, axis[0].along);
  const Q high = Q((one.box.*axis[1].squares).last + 1);
  const bool owned = std::any_of(one.part.begin(), one.part.end(), [&](const TexturePoint<Q>& p) {
    return p.*axis[0].along == along.greatest && p.*axis[1].along < high;
  });
  const std::int64_t first = floored(along.least),
                     last = owned ? floored(along.greatest) : -floored(-along.greatest) - 1;
  Box met = one.box;
  met.*axis[0].squares = {first, std::max(first, last)};
  return range<Q>(t, least_and_greatest(t, texels_of(t, met)));
}

/// The range of the texels that a part in a row or a column meets in an area, with nearest filtering.
/// Domain: a part with an area.
template <class Q, class Texel>
Range<Q> open_strip(const TextureOf<Texel>& t, const BoxPart<Q>& one, bool along_x) {
  const auto axis = axes<Q>(t, along_x);
  const Range<Q> along = extent(one.part, axis[0].along);
  Box met = one.box;
  met.*axis[0].squares = {floored(along.least), -floored(-along.greatest) - 1};
  return range<Q>(t, least_and_greatest(t, texels_of(t, met)));
}

/// Takes what a strip's part tells.  Returns whether nothing more is to be learnt from it.
/// Domain: one row, or rows of one meaning, `along_x`; else columns.
template <class Q, class Texel, class Take, class Known>
bool settle_strip(const TextureOf<Texel>& t, const BoxPart<Q>& one, bool along_x, Take take, Known known) {
  const auto axis = axes<Q>(t, along_x);
  if (t.filter == Filter::nearest) {
    take(nearest_strip(t, one, axis));
    return true;
  }
  const Box texels = texels_of(t, one.box);
  if ((texels.*axis[1].squares).size() == 1) {
    take_constant_strip(t, one, axis[0], take);
    return true;
  }
  const StripBound<Q> bound = bound_of(t, one, axis);
  if (known(bound.alpha)) return true;
  if (is_rectangle(one, axis)) {
    take(bound.alpha);
    return true;
  }
  take_slices(t, one, axis, bound.least_at, take);
  take_slices(t, one, axis, bound.greatest_at, take);
  return known(bound.alpha);
}

}  // namespace mmverify::spec::bake
