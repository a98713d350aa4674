// Attribute micromaps from textures: the number at a micro-vertex, and the mean over a micro-triangle.
//
// A channel is a texture of spec/bake/texture.hpp, with the channel in the place of alpha.  A mip level is a texture of
// its own, addressed by the same (u, v).
//
// A vertex gets the sampler's value at the micro-vertex.  A face gets the mean of the sampler's values over the
// micro-triangle, over its own area,
//   2 integral of texture(x(s, t), y(s, t)) ds dt   over s, t >= 0, s + t <= 1,
// the corner of (s, t) = (0, 0) first.  If the triangle has an area in the texture, that is the mean over the texels
// beneath, each by its share of the area.  If it has none, it is the limit of triangles that have: along a segment
// texels weigh by how much of the micro-triangle maps to them, and a point has the sampler's value there.  So the mean
// of the four children is always the parent's.
// Source: Color and Attribute Micromaps, 5.1 ("averaging the pixels covered", "bilinear sampling"), which does not
// define the covered pixels (docs/ERRATA.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "spec/attribute/colour.hpp"
#include "spec/bake/state.hpp"

namespace mmverify::spec::attribute {

using bake::BaseTriangle;
using bake::Filter;
using bake::Polygon;
using bake::TextureOf;
using bake::TexturePoint;

// ---- Shares

/// A texel (i, j), before wrapping, and its weight.
template <class Q>
struct Share {
  std::int64_t i, j;
  Q weight;
};

/// The weights of texels, which sum to 1.  A texel may come more than once.
template <class Q>
using Shares = std::vector<Share<Q>>;

/// The sum of weight x texel, wrapped.
template <class Q, class Texel>
Q mean(const TextureOf<Texel>& t, const Shares<Q>& shares) {
  Q sum(0);
  for (const Share<Q>& s : shares) sum += s.weight * bake::texel<Q>(t, s.i, s.j);
  return sum;
}

/// The shares of the sampler at a point: nearest, the texel that owns it; bilinear, (1-x)(1-y), x(1-y), (1-x)y, xy.
template <class Q>
Shares<Q> shares_at(const TexturePoint<Q>& p, Filter filter) {
  if (filter == Filter::nearest) return {{bake::floored(p.x), bake::floored(p.y), Q(1)}};
  const std::int64_t i = bake::cell_at(p.x), j = bake::cell_at(p.y);
  const Q x = p.x - fraction<Q>(2 * i + 1, 2), y = p.y - fraction<Q>(2 * j + 1, 2), one(1);
  return {{i, j, (one - x) * (one - y)},
          {i + 1, j, x * (one - y)},
          {i, j + 1, (one - x) * y},
          {i + 1, j + 1, x * y}};
}

// ---- Parts of a triangle

/// A triangle in the texture as the image of s, t >= 0, s + t <= 1.
template <class Q>
struct Image {
  TexturePoint<Q> corner, along_s, along_t;

  /// Errors: std::out_of_range without three corners.
  explicit Image(const Polygon<Q>& corners)
      : corner(corners.at(0)),
        along_s{corners.at(1).x - corner.x, corners.at(1).y - corner.y},
        along_t{corners.at(2).x - corner.x, corners.at(2).y - corner.y} {}

  Q x(const TexturePoint<Q>& st) const { return corner.x + st.x * along_s.x + st.y * along_t.x; }
  Q y(const TexturePoint<Q>& st) const { return corner.y + st.x * along_s.y + st.y * along_t.y; }
};

/// The whole triangle, in (s, t).
template <class Q>
Polygon<Q> unit_triangle() {
  return {{Q(0), Q(0)}, {Q(1), Q(0)}, {Q(0), Q(1)}};
}

/// Twice a polygon's area, not below 0; that of the unit triangle is 1.
template <class Q>
Q double_area(const Polygon<Q>& polygon) {
  Q sum(0);
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const TexturePoint<Q>&p = polygon[0], &q = polygon[k - 1], &r = polygon[k];
    sum += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return sum < 0 ? Q(-sum) : sum;
}

/// Calls visit(k, part) for the strips k <= height - offset <= k + 1 of a polygon in (s, t).  A part with only
/// height - offset = k + 1 belongs to the next strip.
template <class Q, class Height, class Visit>
void for_each_strip(const Polygon<Q>& polygon, Height height, const Q& offset, Visit visit) {
  const auto whole = [&](const TexturePoint<Q>& p) { return bake::floored(Q(height(p) - offset)); };
  std::vector<std::int64_t> wholes;
  for (const TexturePoint<Q>& p : polygon) wholes.push_back(whole(p));
  const auto [least, greatest] = std::minmax_element(wholes.begin(), wholes.end());
  for (std::int64_t k = *least; k <= *greatest; ++k) {
    const Q low = fraction<Q>(k, 1) + offset, high = fraction<Q>(k + 1, 1) + offset;
    const Polygon<Q> above =
        bake::clipped(polygon, [&](const TexturePoint<Q>& p) { return Q(height(p) - low); });
    const Polygon<Q> part =
        bake::clipped(above, [&](const TexturePoint<Q>& p) { return Q(high - height(p)); });
    if (std::any_of(part.begin(), part.end(), [&](const TexturePoint<Q>& p) { return whole(p) <= k; }))
      visit(k, part);
  }
}

/// Calls visit(i, j, part) for each closed square [i, i+1] x [j, j+1], moved by (offset, offset), that the triangle
/// meets, with that part in (s, t); a square met by its high sides alone is left out.
template <class Q, class Visit>
void for_each_part(const Image<Q>& image, const Q& offset, Visit visit) {
  const auto x = [&](const TexturePoint<Q>& p) { return image.x(p); };
  const auto y = [&](const TexturePoint<Q>& p) { return image.y(p); };
  for_each_strip(unit_triangle<Q>(), y, offset, [&](std::int64_t j, const Polygon<Q>& row) {
    for_each_strip(row, x, offset, [&](std::int64_t i, const Polygon<Q>& part) {
      const auto reached = [&](const TexturePoint<Q>& p) { return bake::floored(Q(y(p) - offset)) <= j; };
      if (std::any_of(part.begin(), part.end(), reached)) visit(i, j, part);
    });
  });
}

/// The offset of a filter's squares: texels begin at whole numbers, cells between centres at halves.
template <class Q>
Q square_offset(Filter filter) {
  return filter == Filter::nearest ? Q(0) : fraction<Q>(1, 2);
}

/// 2 integral of f over a polygon.  Domain: f of degree 2 at most; it is exact, by the middles of the edges of
/// triangles.
template <class Q, class F>
Q integral(const Polygon<Q>& polygon, F f) {
  Q sum(0);
  const Q half = fraction<Q>(1, 2), third = fraction<Q>(1, 3);
  const auto middle = [&](const TexturePoint<Q>& p, const TexturePoint<Q>& q) {
    return TexturePoint<Q>{(p.x + q.x) * half, (p.y + q.y) * half};
  };
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const TexturePoint<Q>&p = polygon[0], &q = polygon[k - 1], &r = polygon[k];
    sum += double_area(Polygon<Q>{p, q, r}) * third * (f(middle(p, q)) + f(middle(q, r)) + f(middle(r, p)));
  }
  return sum;
}

/// The shares of the mean over a triangle: nearest, each texel's share of the area; bilinear, the integral of the
/// weights above over each cell's part.
/// Errors: std::out_of_range without three corners.
template <class Q>
Shares<Q> shares_on(const Polygon<Q>& corners, Filter filter) {
  const Image<Q> image(corners);
  Shares<Q> shares;
  for_each_part(image, square_offset<Q>(filter), [&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
    const Q all = double_area(part);
    if (all == 0) return;
    if (filter == Filter::nearest) {
      shares.push_back({i, j, all});
      return;
    }
    const Q column = fraction<Q>(2 * i + 1, 2), row = fraction<Q>(2 * j + 1, 2);
    const auto x = [&](const TexturePoint<Q>& p) { return Q(image.x(p) - column); };
    const auto y = [&](const TexturePoint<Q>& p) { return Q(image.y(p) - row); };
    const Q right = integral(part, x), below = integral(part, y),
            across = integral(part, [&](const TexturePoint<Q>&p) { return Q(x(p) * y(p)); });
    shares.push_back({i, j, all - right - below + across});
    shares.push_back({i + 1, j, right - across});
    shares.push_back({i, j + 1, below - across});
    shares.push_back({i + 1, j + 1, across});
  });
  return shares;
}

// ---- Micro-vertices and micro-triangles

/// The place of micro-vertex (i, j), in texels:  (P + i/N (Q - P) + j/N (R - P)) x (width, height).
/// Domain: i + j <= 2^n, n in 0..16.
template <class Q>
TexturePoint<Q> micro_vertex(const BaseTriangle<Q>& uv, Level n, const index::Vertex& at, std::uint32_t width,
                             std::uint32_t height) {
  const Q i = fraction<Q>(at.i, side(n)), j = fraction<Q>(at.j, side(n));
  const auto along = [&](Q TexturePoint<Q>::*axis) {
    return uv[0].*axis + i * (uv[1].*axis - uv[0].*axis) + j * (uv[2].*axis - uv[0].*axis);
  };
  return {along(&TexturePoint<Q>::x) * Q(width), along(&TexturePoint<Q>::y) * Q(height)};
}

/// The number at micro-vertex (i, j).
template <class Q, class Texel>
Q vertex_value(const TextureOf<Texel>& t, const BaseTriangle<Q>& uv, Level n, const index::Vertex& at) {
  return mean(t, shares_at(micro_vertex(uv, n, at, t.width, t.height), t.filter));
}

/// The mean over micro-triangle `index` of the curve.
template <class Q, class Texel>
Q face_value(const TextureOf<Texel>& t, const BaseTriangle<Q>& uv, Level n, std::uint32_t index) {
  return mean(t, shares_on(bake::micro_triangle(uv, n, index, t.width, t.height), t.filter));
}

/// The value between two mips: (1 - f) value(mip m) + f value(mip m + 1), m = floor(lod), f the rest, lod clamped to
/// the chain.  Source: Vulkan, Level-of-Detail Operation (`linear` mipmap mode).
/// Errors: std::invalid_argument without mips.
template <class Q, class Texel, class Value>
Q between_mips(std::span<const TextureOf<Texel>> mips, const Q& lod, Value value) {
  if (mips.empty()) throw std::invalid_argument("attribute: no mip level");
  const std::size_t last = mips.size() - 1;
  if (lod <= 0) return value(mips.front());
  if (lod >= fraction<Q>(static_cast<std::int64_t>(last), 1)) return value(mips.back());
  const std::int64_t m = bake::floored(lod);
  const Q f = lod - fraction<Q>(m, 1);
  const auto at = static_cast<std::size_t>(m);
  return (Q(1) - f) * value(mips[at]) + f * value(mips[at + 1]);
}

}  // namespace mmverify::spec::attribute
