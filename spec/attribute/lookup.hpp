// A point's micro-triangle, the triplet of vertices around it, its weights there in three ways, and the interpolated
// value, over any exact number.
#pragma once

#include <array>
#include <cstdint>

#include "spec/attribute/order.hpp"
#include "spec/index/index.hpp"
#include "spec/number.hpp"

namespace mmverify::spec::attribute {

// ---- The micro-triangle of a point

/// The rule for a point on the edge between two micro-triangles.  A face's value depends on it, one between vertices
/// not.
enum class Ties : std::uint32_t {
  vulkan,  ///< on a line of constant u the side of +u, of constant v of +v, on a diagonal the far side; but no point
           ///< leaves the triangle
  figure_4,  ///< rows: on a line of constant u the side of -u; the rest as above
};

/// The micro-triangle that contains the point, by Vulkan's reference code: its grid square, and the upper half if uf+vf
/// >= 1.
/// Domain: u, v >= 0, u+v <= 1; n in 0..31.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <Number Q>
constexpr MicroTriangle vulkan_triangle(const Point<Q>& p, Level n) {
  const auto q = spec::index::quantise<std::uint32_t>(p, n);
  // iw = NOT(iu+iv), one less for the upper half.
  return {q.iu, q.iv, ~q.iw != q.iu + q.iv};
}

/// The micro-triangle that contains the point, as figure 4 finds it:
///   row = min(N-1, floor((u+v)N)), col = min(row, floor(vN)), dia = min(N-1, floor((1-u)N)),
/// and col + (dia - (N-1-row)) is the place in the row, where lower and upper ones alternate.
/// Domain: u, v >= 0, u+v <= 1; n in 0..16.  Source: Color and Attribute Micromaps, figure 4.
template <Number Q>
constexpr MicroTriangle figure_4_triangle(const Point<Q>& p, Level n) {
  return row_triangle(spec::index::w_minor(p, n));
}

template <Number Q>
constexpr MicroTriangle holder(Ties ties, const Point<Q>& p, Level n) {
  return ties == Ties::vulkan ? vulkan_triangle(p, n) : figure_4_triangle(p, n);
}

// ---- Weights: the point's barycentrics on its micro-triangle, in the order of corners_of

template <class Q>
using Weights = std::array<Q, 3>;

/// The weights by the uniform pattern: with fu = uN - iu and fv = vN - iv,
///   lower (1-fu-fv, fu, fv);  upper (fu+fv-1, 1-fu, 1-fv)
/// A point outside the micro-triangle has weights in its plane: some are negative.
/// Domain: any point, any micro-triangle of the level.
/// Source: Color and Attribute Micromaps, 4.1, which omits it; the formula is ours.
template <Coordinate Q>
constexpr Weights<Q> weights_by_pattern(const Point<Q>& p, const MicroTriangle& t, Level n) {
  const Q one(1), fu = times(side(n), p.u) - Q(t.iu), fv = times(side(n), p.v) - Q(t.iv);
  if (t.upper) return {fu + fv - one, one - fu, one - fv};
  return {one - fu - fv, fu, fv};
}

/// The weights by two of the three equations of the over-determined system, in units of 1/N: with corners (i_c, j_c)
/// and x = uN, y = vN,
///   (i1-i0) w1 + (i2-i0) w2 = x - i0,  (j1-j0) w1 + (j2-j0) w2 = y - j0,  w0 = 1 - w1 - w2
/// The determinant is +1: both kinds of micro-triangles wind like the base triangle.
/// Domain: corners that wind so, as corners_of() gives them.  Source: Color and Attribute Micromaps, 4.1.
template <Coordinate Q>
constexpr Weights<Q> weights_by_two(const Point<Q>& p, const Corners& c, Level n) {
  const auto step = [](std::uint32_t from, std::uint32_t to, const Q& q) {
    // (to - from) q, for a difference of -1, 0 or 1.
    return to == from ? Q(0) : to > from ? q : Q(0) - q;
  };
  const Q x = times(side(n), p.u) - Q(c[0].i), y = times(side(n), p.v) - Q(c[0].j);
  const Q w1 = step(c[0].j, c[2].j, x) - step(c[0].i, c[2].i, y);
  const Q w2 = step(c[0].i, c[1].i, y) - step(c[0].j, c[1].j, x);
  return {Q(1) - w1 - w2, w1, w2};
}

/// The determinant of three columns.
template <class Q>
constexpr Q determinant(const std::array<Q, 3>& a, const std::array<Q, 3>& b, const std::array<Q, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
         c[0] * (a[1] * b[2] - a[2] * b[1]);
}

/// The weights by Cramer's rule on the system of the paper, columns (w_c, u_c, v_c): weight c is the determinant with
/// the point in the place of column c, over the determinant, which is 4^-n.
/// Domain: corners of a triangle with an area; a number type with division.
/// Source: Color and Attribute Micromaps, 4.1, items 1 to 4.
template <class Q>
constexpr Weights<Q> weights_by_cramer(const Point<Q>& p, const Corners& c, Level n) {
  const Q one(1), N = Q(side(n));
  const auto column = [&](const Q& u, const Q& v) { return std::array<Q, 3>{one - u - v, u, v}; };
  const std::array<Q, 3> a = column(Q(c[0].i) / N, Q(c[0].j) / N), b = column(Q(c[1].i) / N, Q(c[1].j) / N),
                         d = column(Q(c[2].i) / N, Q(c[2].j) / N), x = column(p.u, p.v);
  const Q whole = determinant(a, b, d);
  return {determinant(x, b, d) / whole, determinant(a, x, d) / whole, determinant(a, b, x) / whole};
}

/// The condition number of that system in the 1-norm: the greatest factor from an error of the point or of the matrix
/// to one of the weights, each relative to the whole.  The matrix has norm 1, for its columns are barycentrics.  The
/// inverse's columns are the weights of the base triangle's corners in the micro-triangle's plane:
///   max over w, u, v of |w0| + |w1| + |w2|, an integer of 2N-1 at most, which the corners' micro-triangles have
/// The condition of the two equations is 1: their matrix, in units of 1/N, is the identity or its opposite.
/// Domain: a micro-triangle of level n, n in 0..16.  Source: the definition; Higham 2002, section 6.2.
template <Coordinate Q>
constexpr Q system_condition(const MicroTriangle& t, Level n) {
  const Q zero(0), one(1);
  Q greatest(0);
  for (const Point<Q>& corner : {Point<Q>{zero, zero}, Point<Q>{one, zero}, Point<Q>{zero, one}}) {
    Q sum(0);
    for (const Q& weight : weights_by_pattern(corner, t, n))
      sum = sum + (weight < zero ? zero - weight : weight);
    if (greatest < sum) greatest = sum;
  }
  return greatest;
}

/// The point in its micro-triangle as a point of a base triangle: the second and third weight are its u and v.
template <class Q>
constexpr Point<Q> within(const Weights<Q>& w) {
  return {w[1], w[2]};
}

/// The micro-vertex of level n+m at a micro-vertex of level m of a micro-triangle of level n:
///   base M + (i, j), backwards in an upper one
/// Domain: (i, j) a vertex of level m.
constexpr Vertex vertex_within(const MicroTriangle& t, const Vertex& at, Level m) {
  const std::uint32_t M = side(m);
  if (t.upper) return {(t.iu + 1) * M - at.i, (t.iv + 1) * M - at.j};
  return {t.iu * M + at.i, t.iv * M + at.j};
}

/// The value between three vertices: w0 c0 + w1 c1 + w2 c2, c integers.
/// Source: Color and Attribute Micromaps, 4.1, step 5.
template <Coordinate Q>
constexpr Q interpolated(const Weights<Q>& w, const std::array<std::uint32_t, 3>& c) {
  return times(c[0], w[0]) + times(c[1], w[1]) + times(c[2], w[2]);
}

}  // namespace mmverify::spec::attribute
