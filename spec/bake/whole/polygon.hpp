// A micro-triangle in whole numbers: texture coordinates are m 2^e, so one power of two makes all of them whole.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "spec/bake/whole/texture.hpp"
#include "spec/index/index.hpp"

namespace mmverify::spec::bake::whole {

/// A micro-triangle of a base triangle, its margin in texels, and the movement of the vertices.
struct Place {
  std::array<std::array<Binary32, 2>, 3> uv;
  Level level;
  std::uint32_t index;
  Binary32 margin = {};
  std::array<Binary32, 2> travel = {};
};

/// A polygon in units of 2^-d texels from the corner of square (column, row), and the sum of the corners of the
/// micro-triangle that it is, or that it dilates.
/// Bilinear squares are those between the centres of texels, and square (i, j) has texel (i, j) at its least corner.
template <class N>
struct WholePolygon {
  Polygon<N> corners;
  TexturePoint<N> sum;
  std::int64_t column, row;
  int d;
  int bits;  ///< of the greatest coordinate plus 2^d
};

/// The numbers of a place with one exponent, and a bound on their bits.
struct Scale {
  int shift = 1;  ///< all numbers times 2^shift are whole, and half a texel is
  int bits = 0;   ///< all numbers are below 2^bits in size

  explicit Scale(const Place& place) {
    const auto take = [&](Binary32 x) {
      const Dyadic q = dyadic(x);
      if (q.m == 0) return;
      shift = std::max(shift, -q.e);
      bits = std::max(bits, q.e + bit_length(q.m));
    };
    for (const auto& vertex : place.uv)
      for (const Binary32 x : vertex) take(x);
    take(place.margin);
    for (const Binary32 x : place.travel) take(x);
  }
};

/// Divides a micro-triangle and its dilation by the greatest power of two that divides them and 2^d, and measures both.
template <class N>
void reduce(WholePolygon<N>& p, TexturePoint<N>& dilation) {
  int zeros = p.d;
  const auto take = [&](const N& x) {
    if (x != 0) zeros = std::min(zeros, trailing_zeros(x));
  };
  for (const auto& q : p.corners) take(q.x), take(q.y);
  for (const auto* q : {&p.sum, &dilation}) take(q->x), take(q->y);
  const N divisor = N(1) << zeros;
  for (auto& q : p.corners) q.x /= divisor, q.y /= divisor;
  for (auto* q : {&p.sum, &dilation}) q->x /= divisor, q->y /= divisor;
  p.d -= zeros;
  N greatest = 0;
  for (const auto& q : p.corners) greatest = std::max({greatest, N(q.x + dilation.x), N(q.y + dilation.y)});
  p.bits = bit_length(N(greatest + (N(1) << p.d)));
}

/// Moves a micro-triangle by whole squares, so that its dilation lies at coordinates of 0 and more and meets those below 1.
template <class N>
void move_to_corner(WholePolygon<N>& p, const TexturePoint<N>& dilation) {
  const auto least = [&](N TexturePoint<N>::*axis) {
    N found = p.corners[0].*axis;
    for (const auto& q : p.corners) found = std::min(found, N(q.*axis));
    return floor_shift(N(found - dilation.*axis), p.d);
  };
  const N column = least(&TexturePoint<N>::x), row = least(&TexturePoint<N>::y), unit = N(1) << p.d;
  p.column = static_cast<std::int64_t>(column);
  p.row = static_cast<std::int64_t>(row);
  p.sum = {0, 0};
  for (auto& q : p.corners) {
    q = {N(q.x - column * unit), N(q.y - row * unit)};
    p.sum = {N(p.sum.x + q.x), N(p.sum.y + q.y)};
  }
}

/// The micro-triangle of a place, dilated by its margin and its movement.  None where its numbers, or the products of
/// two of them, are beyond `bits` bits, or columns and rows beyond 2^60.
/// Errors: std::invalid_argument for a number that is not finite, or a margin or travel below 0.
template <class N, int bits>
std::optional<WholePolygon<N>> polygon_of(const WholeTexture& t, const Place& place) {
  const Scale scale(place);
  const int n = static_cast<int>(place.level),
            size_bits = bit_length(std::int64_t{std::max(t.width(), t.height())});
  constexpr int most_column_bits = 60, slack = 4;  // slack: sums of a few
  if (scale.bits + size_bits > most_column_bits || scale.bits + size_bits + scale.shift + n + slack > bits)
    return std::nullopt;
  const auto whole = [&](Binary32 x) {
    const Dyadic q = dyadic(x);
    return q.m == 0 ? N(0) : N(N(q.m) * (N(1) << (q.e + scale.shift)));
  };
  WholePolygon<N> p;
  p.d = n + scale.shift;
  const N side = N(1) << n, half = t.filter() == Filter::bilinear ? N(N(1) << (p.d - 1)) : N(0);
  const auto corner = [&](const index::Vertex& v, std::size_t axis, std::uint32_t texels) {
    const N at = whole(place.uv[0][axis]), first = whole(place.uv[1][axis]) - at,
            second = whole(place.uv[2][axis]) - at;
    return N(N(texels) * (side * at + N(v.i) * first + N(v.j) * second) - half);
  };
  p.corners.reserve(3);
  for (const index::Vertex& v : index::corners(place.index, place.level))
    p.corners.push_back({corner(v, 0, t.width()), corner(v, 1, t.height())});
  TexturePoint<N> dilation{N(side * (whole(place.margin) + whole(place.travel[0]) * N(t.width()))),
                           N(side * (whole(place.margin) + whole(place.travel[1]) * N(t.height())))};
  if (dilation.x < 0 || dilation.y < 0) throw std::invalid_argument("bake: a margin below 0");
  move_to_corner(p, dilation);
  reduce(p, dilation);
  // A crossing's numerator, and the hull's products, have twice the bits.
  if (2 * p.bits + slack > bits) return std::nullopt;
  p.corners = dilated(p.corners, dilation.x, dilation.y);
  return p;
}

}  // namespace mmverify::spec::bake::whole
