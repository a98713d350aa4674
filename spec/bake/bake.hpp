// Baking: the alpha of a texture on a closed convex polygon, with no sampling and no epsilon.
//
// Axes.  Coordinates are in texels, x along a row, y DOWN from the first row: texel (i, j) has its centre at
// (i + 1/2, j + 1/2).  The caller maps (u, v) to (u width, v height).
// Q is an exact number: Rational, or a narrower one that throws beyond its limits, as Rational128 does.
// Source: Vulkan, Image Operations ("Texel Filtering"); glTF 2.0, samplers.  Compressed Opacity Maps, 2, for the
// continuity of bilinear alpha, and its consequences for neighbours.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "spec/bake/texture.hpp"
#include "spec/rational.hpp"

namespace mmverify::spec::bake {

// ---- Cells

/// A point of the texture, in texels.
template <class Q>
struct TexturePoint {
  Q x, y;
};

/// floor(q) of either sign.  Domain: |q| < 2^62.
template <class Q>
std::int64_t floored(const Q& q) {
  const typename Q::int_type down = q.numerator() / q.denominator();  // towards zero
  return static_cast<std::int64_t>(down) - (Q(down) > q ? 1 : 0);
}

/// The square between the centres of the texels (i, j) and (i+1, j+1), on which
///   alpha = a + b x + c y + d x y,   (x, y) in [0, 1]^2 from its least corner.
/// Neighbouring cells agree on the edge that they share: alpha is continuous.
template <class Q>
struct Cell {
  std::int64_t i, j;
  Q a, b, c, d;

  template <class Texel>
  Cell(const TextureOf<Texel>& t, std::int64_t column, std::int64_t row) : i(column), j(row) {
    const Q right = texel<Q>(t, i + 1, j), below = texel<Q>(t, i, j + 1), across = texel<Q>(t, i + 1, j + 1);
    a = texel<Q>(t, i, j);
    b = right - a;
    c = below - a;
    d = a - right - below + across;
  }
  /// The place p in the cell's coordinates.
  TexturePoint<Q> local(const TexturePoint<Q>& p) const { return {p.x - along(i), p.y - along(j)}; }
  Q alpha(const TexturePoint<Q>& l) const { return a + b * l.x + c * l.y + d * l.x * l.y; }

  /// The coordinate at which cell k begins along an axis.
  static Q along(std::int64_t k) { return fraction<Q>(2 * k + 1, 2); }
};

/// The cell along one axis that contains a coordinate; of two, the one that begins there.
template <class Q>
std::int64_t cell_at(const Q& x) {
  return floored(x - fraction<Q>(1, 2));
}

/// Alpha at a point.
template <class Q, class Texel>
Q alpha(const TextureOf<Texel>& t, const TexturePoint<Q>& p) {
  if (t.filter == Filter::nearest) return texel<Q>(t, floored(p.x), floored(p.y));
  const Cell<Q> cell(t, cell_at(p.x), cell_at(p.y));
  return cell.alpha(cell.local(p));
}

// ---- Polygons

/// A convex and closed polygon, its corners in order, either way round.  One corner is a point, two are a segment, and
/// corners may repeat: nothing below needs an interior.
template <class Q>
using Polygon = std::vector<TexturePoint<Q>>;

/// The part with height >= 0; empty if there is none.  Domain: `height` is affine in the place.
template <class Q, class Height>
Polygon<Q> clipped(const Polygon<Q>& polygon, Height height) {
  Polygon<Q> part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const TexturePoint<Q>&from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const Q h = height(from), next = height(to);
    if (h >= 0) part.push_back(from);
    if ((h > 0 && next < 0) || (h < 0 && next > 0)) {
      const Q t = h / (h - next);
      part.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
  }
  return part;
}

/// The part with low <= x <= high, or low <= y <= high.
template <class Q>
Polygon<Q> clipped(const Polygon<Q>& polygon, Q TexturePoint<Q>::*axis, const Q& low, const Q& high) {
  return clipped(clipped(polygon, [&](const TexturePoint<Q>& p) { return p.*axis - low; }),
                 [&](const TexturePoint<Q>& p) { return high - p.*axis; });
}

/// Whether a polygon is more than a point or a segment.
template <class Q>
bool has_area(const Polygon<Q>& polygon) {
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const TexturePoint<Q>&p = polygon[0], &q = polygon[k - 1], &r = polygon[k];
    if ((q.x - p.x) * (r.y - p.y) != (q.y - p.y) * (r.x - p.x)) return true;
  }
  return false;
}

/// The centroid: the mean of the corners.
template <class Q>
TexturePoint<Q> centroid(const Polygon<Q>& polygon) {
  TexturePoint<Q> sum{0, 0};
  for (const TexturePoint<Q>& p : polygon) sum = {sum.x + p.x, sum.y + p.y};
  const Q share = fraction<Q>(1, static_cast<std::int64_t>(polygon.size()));
  return {sum.x * share, sum.y * share};
}

/// The corners of the convex hull of some points, each once; fewer than three if they are on a line.
/// Domain: any points.  Source: A. M. Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions.
template <class Q>
Polygon<Q> hull(Polygon<Q> points) {
  const auto before = [](const TexturePoint<Q>& p, const TexturePoint<Q>& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
  const auto left_of = [](const TexturePoint<Q>& p, const TexturePoint<Q>& q, const TexturePoint<Q>& r) {
    return (q.x - p.x) * (r.y - p.y) > (q.y - p.y) * (r.x - p.x);
  };
  std::sort(points.begin(), points.end(), before);
  const auto same = [&](const TexturePoint<Q>& p, const TexturePoint<Q>& q) { return !before(p, q); };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  Polygon<Q> corners;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t begin = corners.size();
    for (const TexturePoint<Q>& p : points) {
      while (corners.size() >= begin + 2 && !left_of(corners.end()[-2], corners.back(), p))
        corners.pop_back();
      corners.push_back(p);
    }
    corners.pop_back();  // it begins the other chain
    std::reverse(points.begin(), points.end());
  }
  return corners.empty() ? Polygon<Q>{points.at(0)} : corners;
}

/// The points within m of the polygon along x and within n along y: its sum with [-m, m] x [-n, n], which is the hull of
/// its corners moved by (-m, -n), (-m, n), (m, -n) and (m, n).
/// Errors: std::invalid_argument for m or n below 0.
template <class Q>
Polygon<Q> dilated(const Polygon<Q>& polygon, const Q& m, const Q& n) {
  if (m < 0 || n < 0) throw std::invalid_argument("bake: a margin below 0");
  if (m == 0 && n == 0) return polygon;
  Polygon<Q> points;
  for (const TexturePoint<Q>& p : polygon)
    for (const Q& x : {Q(p.x - m), Q(p.x + m)})
      for (const Q& y : {Q(p.y - n), Q(p.y + n)}) points.push_back({x, y});
  return hull(points);
}

/// The points within `margin` of the polygon along both axes at once.
template <class Q>
Polygon<Q> dilated(const Polygon<Q>& polygon, const Q& margin) {
  return dilated(polygon, margin, margin);
}

// ---- Extremes and states

/// A range of alpha: the least and the greatest.
template <class Q>
struct Range {
  Q least, greatest;

  explicit Range(const Q& q) : least(q), greatest(q) {}
  void take(const Q& q) {
    least = std::min(least, q);
    greatest = std::max(greatest, q);
  }
};

/// The range over a polygon within one cell.  It takes the corners, and on each edge from p to q the point where alpha
/// stands still,
///   alpha(p + t (q - p)) = m + l t + k t^2,   t = -l / 2k in (0, 1).
/// Inside there is no other extreme: d x y bends up one way and down the other (d = 0: alpha is affine).
/// Domain: the polygon has a corner, in the cell's own coordinates.
template <class Q>
Range<Q> range(const Cell<Q>& cell, const Polygon<Q>& local) {
  Range<Q> found(cell.alpha(local.at(0)));
  for (std::size_t corner = 0; corner < local.size(); ++corner) {
    const TexturePoint<Q>&p = local[corner], &q = local[(corner + 1) % local.size()];
    const Q x = q.x - p.x, y = q.y - p.y;
    const Q k = cell.d * x * y, l = cell.b * x + cell.c * y + cell.d * (p.x * y + p.y * x);
    found.take(cell.alpha(p));
    if (k == 0) continue;
    const Q t = -l / (k + k);
    if (t > 0 && t < 1) found.take(cell.alpha({p.x + t * x, p.y + t * y}));
  }
  return found;
}

/// The least and greatest whole part of a polygon's coordinates along an axis, each less `offset`.
template <class Q>
std::pair<std::int64_t, std::int64_t> ends(const Polygon<Q>& polygon, Q TexturePoint<Q>::*axis,
                                           const Q& offset) {
  const auto [low, high] = std::minmax_element(
      polygon.begin(), polygon.end(),
      [axis](const TexturePoint<Q>& p, const TexturePoint<Q>& q) { return p.*axis < q.*axis; });
  return {floored((*low).*axis - offset), floored((*high).*axis - offset)};
}

/// Calls visit(i, j, part) for each closed square [i, i+1] x [j, j+1], moved by (offset, offset), that the polygon
/// meets, unless it meets only the square's high sides: these are low sides of neighbours, which are visited.
/// That is exact, square by square: a convex part that comes below the high side i+1 at one point and below j+1 at
/// another comes below both midway between.
template <class Q, class Visit>
void for_each_square(const Polygon<Q>& polygon, const Q& offset, Visit visit) {
  const auto [top, bottom] = ends(polygon, &TexturePoint<Q>::y, offset);
  for (std::int64_t j = top; j <= bottom; ++j) {
    const Polygon<Q> row =
        clipped(polygon, &TexturePoint<Q>::y, fraction<Q>(j, 1) + offset, fraction<Q>(j + 1, 1) + offset);
    if (row.empty() || ends(row, &TexturePoint<Q>::y, offset).first > j) continue;
    const auto [left, right] = ends(row, &TexturePoint<Q>::x, offset);
    for (std::int64_t i = left; i <= right; ++i) {
      const Polygon<Q> part =
          clipped(row, &TexturePoint<Q>::x, fraction<Q>(i, 1) + offset, fraction<Q>(i + 1, 1) + offset);
      if (part.empty() || ends(part, &TexturePoint<Q>::x, offset).first > i ||
          ends(part, &TexturePoint<Q>::y, offset).first > j)
        continue;
      visit(i, j, part);
    }
  }
}

/// Calls visit(part, alpha) for the part of a polygon in each cell, or in each texel whose half-open square it meets,
/// with the range of alpha there.
/// Domain: coordinates below 2^62 in size; the work is that of the cells under its rows.
/// Errors: std::invalid_argument for a polygon of no corner, or a texture whose texels are not width x height or none.
template <class Q, class Texel, class Visit>
void for_each_part(const TextureOf<Texel>& t, const Polygon<Q>& polygon, Visit visit) {
  if (polygon.empty()) throw std::invalid_argument("bake: a polygon without corners");
  if (t.alpha.empty() || t.alpha.size() != static_cast<std::size_t>(t.width) * t.height)
    throw std::invalid_argument("bake: the texels are not width x height");
  if (t.filter == Filter::nearest)
    for_each_square(polygon, Q(0), [&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
      visit(part, Range<Q>(texel<Q>(t, i, j)));
    });
  else
    // Cells may leave out their high sides: their neighbours have the same alpha there.
    for_each_square(polygon, fraction<Q>(1, 2), [&](std::int64_t i, std::int64_t j, Polygon<Q> part) {
      const Cell<Q> cell(t, i, j);
      for (TexturePoint<Q>& p : part) p = cell.local(p);
      visit(part, range(cell, part));
    });
}

/// The range over any polygon: cell by cell, or of all texels whose half-open squares it meets.  range() of boxes.hpp is
/// the same in less time.
/// Domain, errors: those of for_each_part.
template <class Q, class Texel>
Range<Q> range_by_parts(const TextureOf<Texel>& t, const Polygon<Q>& polygon) {
  std::optional<Range<Q>> found;
  for_each_part(t, polygon, [&found](const Polygon<Q>&, const Range<Q>& here) {
    if (!found) found = here;
    found->take(here.least);
    found->take(here.greatest);
  });
  return found.value();
}

enum class State : std::uint8_t {
  T = 0,  ///< alpha < cutoff everywhere
  C = 1,  ///< neither
  O = 2,  ///< alpha >= cutoff everywhere
};

/// The state of an alpha-tested polygon.  The polygon is closed on purpose: a hit on a shared edge may be given to
/// either side, and both must be right about it.
template <class Q>
State state(const Range<Q>& alpha, const Q& cutoff) {
  return alpha.least >= cutoff ? State::O : alpha.greatest < cutoff ? State::T : State::C;
}

}  // namespace mmverify::spec::bake
