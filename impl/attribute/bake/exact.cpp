#include "impl/attribute/bake/exact.hpp"

#include <algorithm>
#include <cmath>

#include "impl/attribute/bake/exact_face.hpp"
#include "impl/common/wide.hpp"

namespace mmverify::impl::attribute::detail {
namespace {

/// Subtracts floor(x / 2^fraction_bits), in texels, from x and returns it.  Domain: below 2^36 texels in size.
template <class Int>
std::int64_t whole_taken(Int& x, int fraction_bits) {
  const Int unit = Int(1) << fraction_bits;
  std::int64_t low = -(std::int64_t{1} << 36), high = -low;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (Int(middle) * unit <= x ? low : high) = middle;
  }
  x = x - Int(low) * unit;
  return low;
}

}  // namespace

template <class Channel>
Exact<Channel>::Exact(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level)
    : source_(source), level_(static_cast<int>(level)) {
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u_[k] = binary(uv[k].u);
    v_[k] = binary(uv[k].v);
    below_point_ = std::max({below_point_, -u_[k].e, -v_[k].e});
    const TexturePoint &p = uv[k], &q = uv[(k + 1) % 3];
    extent = std::max({extent, std::fabs(double{p.u} - double{q.u}) * source.texture().width,
                       std::fabs(double{p.v} - double{q.v}) * source.texture().height});
  }
  // 4 more: one for the first texel, one for the last, and room for rounding.
  cell_bits_ = bits(static_cast<std::int64_t>(std::ldexp(extent, -level_)) + 4);
}

/// The coordinate (texels (U0 N + i (U1 - U0) + j (U2 - U0))) / N, in units of 2^-(below_point + level).
template <class Channel>
template <class Int>
Int Exact<Channel>::along(const Axis& axis, std::uint32_t texels, const index::Vertex& at) const {
  const auto number = [this](const Binary& b) {
    return b.m == 0 ? Int(0) : Int(b.m) * (Int(1) << (b.e + below_point_));
  };
  const Int first = number(axis[0]);
  return Int(texels) * (first * (Int(1) << level_) + Int(at.i) * (number(axis[1]) - first) +
                        Int(at.j) * (number(axis[2]) - first));
}

template <class Channel>
template <class Int>
RgbaOf<Channel> Exact<Channel>::vertex_in(const index::Vertex& at) const {
  const int fraction = below_point_ + level_;
  Int x = along<Int>(u_, source_.texture().width, at), y = along<Int>(v_, source_.texture().height, at);
  const bool nearest = source_.sampling().filter == Filter::nearest;
  const Int unit = Int(1) << fraction, half = Int(1) << (fraction - 1);
  if (!nearest) {
    x = x - half;
    y = y - half;
  }
  const std::int64_t i = whole_taken(x, fraction), j = whole_taken(y, fraction);
  const auto texel = [&](std::int64_t column, std::int64_t row) {
    return source_.texel(source_.column(column), source_.row(row));
  };
  std::array<Int, 4> sums;
  sums.fill(Int(0));
  const auto add = [&](const Channel* from, const Int& weight) {
    for (std::size_t k = 0; k < 4; ++k)
      sums[k] = sums[k] + weight * Int(source_.coding().template number<Int>(from[k], k));
  };
  if (nearest) {
    add(texel(i, j), Int(1));
    return source_.coding().exactly_encoded(sums, Int(1));
  }
  add(texel(i, j), (unit - x) * (unit - y));
  add(texel(i + 1, j), x * (unit - y));
  add(texel(i, j + 1), (unit - x) * y);
  add(texel(i + 1, j + 1), x * y);
  return source_.coding().exactly_encoded(sums, unit * unit);
}

template <class Channel>
template <class Int>
RgbaOf<Channel> Exact<Channel>::face_in(const index::Corners& corners) const {
  const int fraction = below_point_ + level_;
  std::array<Int, 3> x, y;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = along<Int>(u_, source_.texture().width, corners[k]);
    y[k] = along<Int>(v_, source_.texture().height, corners[k]);
  }
  const Int unit = Int(1) << fraction;
  const auto moved = [&](std::array<Int, 3>& at) {
    Int least = std::min({at[0], at[1], at[2]});
    const std::int64_t cell = whole_taken(least, fraction);
    for (Int& k : at) k = k - Int(cell) * unit;
    return cell;
  };
  const std::int64_t column = moved(x), row = moved(y);
  ExactFace<Channel, Int> face(source_, column, row, std::int64_t{1} << cell_bits_, fraction, x, y);
  const auto [sums, count] = face.mean();
  return source_.coding().exactly_encoded(sums, count);
}

template <class Channel>
RgbaOf<Channel> Exact<Channel>::vertex(const index::Vertex& at) const {
  const int fraction = below_point_ + level_;
  // Values: two fractions, a number, a code, sums.  Positions: 20 bits of u, 14 of the size and 3 for sums.
  const int values = 2 * fraction + source_.coding().number_bits() + source_.coding().code_bits + 3;
  const int bits = std::max(source_.coding().normal() ? 2 * values + 32 : values, fraction + 20 + 14 + 4);
  if (bits <= 128) return vertex_in<Int128>(at);
  if (bits <= 384) return vertex_in<Wide<6>>(at);
  // The widest case: 150 + 12 bits below the point.
  static_assert(2 * (2 * (150 + 12) + 25 + 10 + 3) + 32 <= 12 * 64 &&
                2 * (150 + 12) + 278 + 4 + 3 <= 12 * 64);
  return vertex_in<Wide<12>>(at);
}

template <class Channel>
RgbaOf<Channel> Exact<Channel>::face(const index::Corners& corners) const {
  const int fraction = below_point_ + level_, position = fraction + cell_bits_ + 1;
  const int values = 8 * position + 41 + source_.coding().number_bits() + source_.coding().code_bits;
  const int bits = std::max(source_.coding().normal() ? 2 * values + 32 : values, fraction + 20 + 14 + 4);
  if (bits <= 256) return face_in<Wide<4>>(corners);
  if (bits <= 512) return face_in<Wide<8>>(corners);
  if (bits <= 1024) return face_in<Wide<16>>(corners);
  // The widest case: 150 + 12 bits below the point, 16 above it.
  static_assert(2 * (8 * (150 + 12 + 17) + 41 + 25 + 10) + 32 <= 50 * 64 &&
                8 * (150 + 12 + 17) + 41 + 278 + 4 <= 50 * 64);
  return face_in<Wide<50>>(corners);
}

template class Exact<std::uint8_t>;
template class Exact<std::uint16_t>;
template class Exact<float>;

}  // namespace mmverify::impl::attribute::detail
