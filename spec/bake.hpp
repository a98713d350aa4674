// Baking: what a closed convex polygon sees of a texture's alpha, bilinearly sampled, with no sampling and no
// epsilon.
//
// Axes.  Coordinates are in texels, x along a row, y DOWN from the first row: texel (i, j) has its centre at
// (i + 1/2, j + 1/2).  The caller maps (u, v) to (u width, v height).
// Q is an exact number: Rational, or Rational128 where its limits will do.
// Source: Vulkan, Image Operations ("Wrapping Operation", "Texel Filtering"); glTF 2.0, samplers.  That alpha
// so sampled is continuous, and what follows for neighbours: Compressed Opacity Maps, 2.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "spec/rational.hpp"

namespace mmverify::spec::bake {

// ---------------------------------------------------------------------------------------------------------------------
// Texels
// ---------------------------------------------------------------------------------------------------------------------

enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border };

/// Alpha in 8 bits, byte / 255; texel (i, j) at i + width j, rows from the top.
struct Texture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> alpha = {};
  Wrap wrap_x = Wrap::clamp_to_edge, wrap_y = Wrap::clamp_to_edge;
  std::uint8_t border = 0;  ///< what lies outside with clamp_to_border
};

/// Which texel of a row (or column) of `size` an index means; none is the border.
///   repeat i mod size; mirrored size-1 - mirror(i mod 2 size - size), mirror(n) = n or, below 0, -(1+n)
/// Domain: size in 1..2^31.
inline std::optional<std::uint32_t> wrapped(Wrap wrap, std::int64_t i, std::uint32_t size) {
  const auto n = static_cast<std::int64_t>(size);
  const auto mod = [](std::int64_t k, std::int64_t m) { return (k % m + m) % m; };
  const auto mirror = [](std::int64_t k) { return k >= 0 ? k : -(1 + k); };
  switch (wrap) {
    case Wrap::repeat:
      i = mod(i, n);
      break;
    case Wrap::mirrored_repeat:
      i = n - 1 - mirror(mod(i, 2 * n) - n);
      break;
    case Wrap::clamp_to_edge:
      i = std::clamp<std::int64_t>(i, 0, n - 1);
      break;
    case Wrap::clamp_to_border:
      if (i < 0 || i >= n) return std::nullopt;
      break;
  }
  return static_cast<std::uint32_t>(i);
}

template <class Q>
Q fraction(std::int64_t m, std::int64_t n) {
  return Q(typename Q::int_type(m), typename Q::int_type(n));
}

/// Alpha of texel (i, j), wrapped: byte / 255.
template <class Q>
Q texel(const Texture& t, std::int64_t i, std::int64_t j) {
  const auto x = wrapped(t.wrap_x, i, t.width), y = wrapped(t.wrap_y, j, t.height);
  const std::uint8_t byte =
      x && y ? t.alpha.at(static_cast<std::size_t>(*x) + static_cast<std::size_t>(*y) * t.width) : t.border;
  return fraction<Q>(byte, 255);
}

// ---------------------------------------------------------------------------------------------------------------------
// Cells
// ---------------------------------------------------------------------------------------------------------------------

template <class Q>
struct Place {
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

  Cell(const Texture& t, std::int64_t column, std::int64_t row) : i(column), j(row) {
    const Q right = texel<Q>(t, i + 1, j), below = texel<Q>(t, i, j + 1), across = texel<Q>(t, i + 1, j + 1);
    a = texel<Q>(t, i, j);
    b = right - a;
    c = below - a;
    d = a - right - below + across;
  }
  /// From the texture's coordinates to the cell's.
  Place<Q> local(const Place<Q>& p) const { return {p.x - along(i), p.y - along(j)}; }
  Q alpha(const Place<Q>& l) const { return a + b * l.x + c * l.y + d * l.x * l.y; }

  /// Where the cell of an index begins along an axis.
  static Q along(std::int64_t k) { return fraction<Q>(2 * k + 1, 2); }
};

/// The cell along one axis that holds a coordinate; of two, the one that begins there.
template <class Q>
std::int64_t cell_at(const Q& x) {
  return floored(x - fraction<Q>(1, 2));
}

/// Alpha at a point.
template <class Q>
Q alpha(const Texture& t, const Place<Q>& p) {
  const Cell<Q> cell(t, cell_at(p.x), cell_at(p.y));
  return cell.alpha(cell.local(p));
}

// ---------------------------------------------------------------------------------------------------------------------
// Polygons
// ---------------------------------------------------------------------------------------------------------------------

/// Convex and closed, its corners in order, either way round.  One corner is a point, two are a segment, and
/// corners may repeat: nothing below asks for an interior.
template <class Q>
using Polygon = std::vector<Place<Q>>;

/// The part where `height`, affine in the place, is not negative; empty if there is none.
template <class Q, class Height>
Polygon<Q> clipped(const Polygon<Q>& polygon, Height height) {
  Polygon<Q> part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Place<Q>&from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const Q h = height(from), next = height(to);
    if (h >= 0) part.push_back(from);
    if ((h > 0 && next < 0) || (h < 0 && next > 0)) {
      const Q t = h / (h - next);
      part.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
  }
  return part;
}

/// The part with low <= x <= high, or the same of y.
template <class Q>
Polygon<Q> clipped(const Polygon<Q>& polygon, Q Place<Q>::*axis, const Q& low, const Q& high) {
  return clipped(clipped(polygon, [&](const Place<Q>& p) { return p.*axis - low; }),
                 [&](const Place<Q>& p) { return high - p.*axis; });
}

// ---------------------------------------------------------------------------------------------------------------------
// Extremes and states
// ---------------------------------------------------------------------------------------------------------------------

/// The least and the greatest alpha.
template <class Q>
struct Range {
  Q least, greatest;

  explicit Range(const Q& q) : least(q), greatest(q) {}
  void take(const Q& q) {
    least = std::min(least, q);
    greatest = std::max(greatest, q);
  }
};

/// Over a polygon within one cell: its corners, and on each edge from p to q the point where alpha stands
/// still,
///   alpha(p + t (q - p)) = m + l t + k t^2,   t = -l / 2k in (0, 1).
/// Inside there is no other extreme: d x y bends up one way and down the other (d = 0: alpha is affine).
/// Domain: the polygon has a corner, in the cell's own coordinates.
template <class Q>
Range<Q> range(const Cell<Q>& cell, const Polygon<Q>& local) {
  Range<Q> found(cell.alpha(local.at(0)));
  for (std::size_t corner = 0; corner < local.size(); ++corner) {
    const Place<Q>&p = local[corner], &q = local[(corner + 1) % local.size()];
    const Q x = q.x - p.x, y = q.y - p.y;
    const Q k = cell.d * x * y, l = cell.b * x + cell.c * y + cell.d * (p.x * y + p.y * x);
    found.take(cell.alpha(p));
    if (k == 0) continue;
    const Q t = -l / (k + k);
    if (t > 0 && t < 1) found.take(cell.alpha({p.x + t * x, p.y + t * y}));
  }
  return found;
}

/// Over any polygon: cell by cell.  Cells that it touches in an edge or a corner alone may be visited or not:
/// their neighbour has the same alpha there.
/// Domain: coordinates below 2^62 in size; the work is that of the cells under its rows.
/// Errors: std::invalid_argument for a polygon of no corner, or a texture whose texels are not width x height
/// or none.
template <class Q>
Range<Q> range(const Texture& t, const Polygon<Q>& polygon) {
  if (polygon.empty()) throw std::invalid_argument("bake: a polygon without corners");
  if (t.alpha.empty() || t.alpha.size() != static_cast<std::size_t>(t.width) * t.height)
    throw std::invalid_argument("bake: the texels are not width x height");
  const auto ends = [](const Polygon<Q>& of, Q Place<Q>::*axis) {
    const auto [low, high] = std::minmax_element(
        of.begin(), of.end(), [axis](const Place<Q>& p, const Place<Q>& q) { return p.*axis < q.*axis; });
    return std::pair{cell_at((*low).*axis), cell_at((*high).*axis)};
  };
  std::optional<Range<Q>> found;
  const auto [top, bottom] = ends(polygon, &Place<Q>::y);
  for (std::int64_t j = top; j <= bottom; ++j) {
    const Polygon<Q> row = clipped(polygon, &Place<Q>::y, Cell<Q>::along(j), Cell<Q>::along(j + 1));
    if (row.empty()) continue;
    const auto [left, right] = ends(row, &Place<Q>::x);
    for (std::int64_t i = left; i <= right; ++i) {
      Polygon<Q> piece = clipped(row, &Place<Q>::x, Cell<Q>::along(i), Cell<Q>::along(i + 1));
      if (piece.empty()) continue;
      const Cell<Q> cell(t, i, j);
      for (Place<Q>& p : piece) p = cell.local(p);
      const Range<Q> here = range(cell, piece);
      if (!found) found = here;
      found->take(here.least);
      found->take(here.greatest);
    }
  }
  return found.value();
}

enum class State : std::uint8_t {
  T = 0,  ///< alpha < cutoff everywhere
  C = 1,  ///< neither
  O = 2,  ///< alpha >= cutoff everywhere
};

/// Of an alpha-tested polygon.  Closed on purpose: a hit on a shared edge may be given to either side, and
/// both must be right about it.
template <class Q>
State state(const Range<Q>& alpha, const Q& cutoff) {
  return alpha.least >= cutoff ? State::O : alpha.greatest < cutoff ? State::T : State::C;
}

template <class Q>
State state(const Texture& t, const Polygon<Q>& polygon, const Q& cutoff) {
  return state(range(t, polygon), cutoff);
}

}  // namespace mmverify::spec::bake
