// Attribute micromaps: the exact error of a map against its texture.
//
// The sampled texture is a + b x + c y + d x y on each texel, or cell between four centres, and the shown map is
// affine in (s, t).  Their difference e is of degree 2 on a convex part of the micro-triangle, with no other second
// derivative than that of d x y.
//   Largest |e|.  If x and y are independent, d x y is a saddle, and e has no extreme inside.  If they are not (a
//   triangle that is a segment in the texture), x and y depend on one affine l(s, t) alone, so that e is k l^2 and an
//   affine function: if its gradient vanishes it does so along a whole line l = const, which ends on the part's edges.
//   So the extremes are at corners and where e stands still along an edge, all rational.
//   Mean of e^2.  A triangle's integral of the square of a quadratic is a form in its values at corners and middles of
//   edges, the mass matrix of quadratic finite elements.
// Source: Color and Attribute Micromaps, 6.3, which has images and FLIP in its place.  The form: Zienkiewicz, Taylor,
// The Finite Element Method, six-node triangle.
#pragma once

#include <array>
#include <cstdint>

#include "spec/attribute/bake.hpp"

namespace mmverify::spec::attribute {

/// The error over a micro-triangle.
template <class Q>
struct Error {
  Q largest;           ///< greatest |e|; with nearest filtering the supremum
  TexturePoint<Q> at;  ///< the (s, t) of the greatest |e|
  Q square;            ///< the mean of e^2
};

/// 2 integral of e^2 over a triangle.  Domain: e of degree 2 at most.
///   area / 180 x (6 e_k^2 - 2 e_k e_l - 8 e_k m_k + 32 m_k^2 + 32 m_k m_l),  m_k in the middle of the edge opposite k
template <class Q, class F>
Q square_integral(const TexturePoint<Q>& p, const TexturePoint<Q>& q, const TexturePoint<Q>& r, F e) {
  const Q half = fraction<Q>(1, 2);
  const auto middle = [&](const TexturePoint<Q>& a, const TexturePoint<Q>& b) {
    return TexturePoint<Q>{(a.x + b.x) * half, (a.y + b.y) * half};
  };
  const std::array<Q, 3> c{e(p), e(q), e(r)}, m{e(middle(q, r)), e(middle(r, p)), e(middle(p, q))};
  Q form(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    form += fraction<Q>(6, 1) * c[k] * c[k] - fraction<Q>(2, 1) * c[k] * c[l] -
            fraction<Q>(8, 1) * c[k] * m[k] + fraction<Q>(32, 1) * m[k] * m[k] +
            fraction<Q>(32, 1) * m[k] * m[l];
  }
  return double_area(Polygon<Q>{p, q, r}) * form * fraction<Q>(1, 180);
}

/// The shown values at the three corners; linear between.  A face shows one value at all of them.
template <class Q>
using Shown = std::array<Q, 3>;

/// The error of the shown values on a triangle (corners in texels) against a channel of the texture.
/// Errors: std::out_of_range without three corners.
template <class Q, class Texel>
Error<Q> error_on(const TextureOf<Texel>& t, const Polygon<Q>& corners, const Shown<Q>& shown) {
  const Image<Q> image(corners);
  Error<Q> error{Q(-1), {Q(0), Q(0)}, Q(0)};
  const auto judge = [&](const Polygon<Q>& part, auto texture) {
    const auto e = [&](const TexturePoint<Q>& p) {
      return Q(texture(TexturePoint<Q>{image.x(p), image.y(p)}) -
               (shown[0] + p.x * (shown[1] - shown[0]) + p.y * (shown[2] - shown[0])));
    };
    const auto take = [&](const TexturePoint<Q>& p) {
      const Q here = e(p), size = here < 0 ? Q(-here) : here;
      if (size > error.largest) error.largest = size, error.at = p;
    };
    for (std::size_t k = 0; k < part.size(); ++k) {
      const TexturePoint<Q>&p = part[k], &q = part[(k + 1) % part.size()];
      const auto along = [&](const Q& f) {
        return TexturePoint<Q>{p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
      };
      take(p);
      // e = e0 + l f + k f^2 on the edge.
      const Q e0 = e(p), em = e(along(fraction<Q>(1, 2))), e1 = e(q), two(2);
      const Q bend = two * (e0 - two * em + e1), slope = e1 - e0 - bend;
      if (bend == 0) continue;
      const Q f = -slope / (two * bend);
      if (f > 0 && f < 1) take(along(f));
    }
    for (std::size_t k = 2; k < part.size(); ++k)
      error.square += square_integral(part[0], part[k - 1], part[k], e);
  };
  for_each_part(image, square_offset<Q>(t.filter),
                [&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
                  if (t.filter == Filter::nearest) {
                    const Q c = bake::texel<Q>(t, i, j);
                    judge(part, [&](const TexturePoint<Q>&) { return c; });
                  } else {
                    const bake::Cell<Q> cell(t, i, j);
                    judge(part, [&](const TexturePoint<Q>& p) { return cell.alpha(cell.local(p)); });
                  }
                });
  return error;
}

/// The error of a map of faces, at micro-triangle `index` of the curve.
template <class Q, class Texel>
Error<Q> face_error(const TextureOf<Texel>& t, const BaseTriangle<Q>& uv, Level n, std::uint32_t index,
                    const Q& shown) {
  return error_on(t, bake::micro_triangle(uv, n, index, t.width, t.height), Shown<Q>{shown, shown, shown});
}

/// The error of a map of vertices; value(vertex) is its value at a vertex.
template <class Q, class Texel, class Value>
Error<Q> vertex_error(const TextureOf<Texel>& t, const BaseTriangle<Q>& uv, Level n, std::uint32_t index,
                      Value value) {
  const auto corners = index::corners(index, n);
  return error_on(t, bake::micro_triangle(uv, n, index, t.width, t.height),
                  Shown<Q>{value(corners[0]), value(corners[1]), value(corners[2])});
}

}  // namespace mmverify::spec::attribute
