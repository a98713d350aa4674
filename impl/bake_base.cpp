#include "impl/bake_base.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "impl/bake_exact.hpp"

namespace mmverify::impl::bake::detail {
namespace {

/// Takes the least coordinate's cell away, and says which it is.
/// Domain: coordinates below 2^36 texels in size.
template <class Int>
std::int64_t moved_to_origin(std::array<Int, 3>& x, int fraction_bits) {
  const Int least = std::min({x[0], x[1], x[2]}), unit = Int(1) << fraction_bits;
  std::int64_t low = -(std::int64_t{1} << 36), high = -low;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (Int(middle) * unit <= least ? low : high) = middle;
  }
  for (Int& k : x) k = k - Int(low) * unit;
  return low;
}

}  // namespace

ExactBase::ExactBase(const Sides& sides, const BaseTriangle& uv, std::uint32_t width, std::uint32_t height,
                     index::Level level)
    : sides_(sides), width_(width), height_(height), level_(static_cast<int>(level)) {
  const auto binary = [this](float x) {
    if (x == 0) return Binary{};
    Binary b;
    b.m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &b.e), 24));  // 24 bits: exact
    b.e -= 24;
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(b.m));
    b.m /= std::int64_t{1} << zeros;
    b.e += zeros;
    below_point_ = std::max(below_point_, -b.e);
    return b;
  };
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u_[k] = binary(uv[k].u);
    v_[k] = binary(uv[k].v);
    const TexturePoint &p = uv[k], &q = uv[(k + 1) % 3];
    extent = std::max({extent, std::fabs(double{p.u} - double{q.u}) * width,
                       std::fabs(double{p.v} - double{q.v}) * height});
  }
  // One cell more for where it begins, one for the last, one for rounding.
  cells_ = static_cast<std::int64_t>(std::ldexp(extent, -level_)) + 3;
  const int fraction = below_point_ + level_;
  const auto bits = [](std::int64_t x) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x)));
  };
  const int position = fraction + bits(cells_ + 1);
  const int texel = bits(4 * std::max(255 * sides.unit, sides.limit));
  // 20 bits of u and v, 15 of width and height, 3 for sums and a sign.
  bits_ = std::max(4 * position + 2 * texel + 12, fraction + 20 + 15 + 3);
}

/// (texels (U0 N + i (U1 - U0) + j (U2 - U0))) / N - 1/2, in units of 2^-(below_point + level).
template <class Int>
std::array<Int, 3> ExactBase::along(const Axis& axis, std::uint32_t texels,
                                    const index::Corners& corners) const {
  const auto whole = [this](const Binary& b) {
    return b.m == 0 ? Int(0) : Int(b.m) * (Int(1) << (b.e + below_point_));
  };
  const Int first = whole(axis[0]), across = whole(axis[1]) - first, down = whole(axis[2]) - first;
  std::array<Int, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] =
        Int(texels) * (first * (Int(1) << level_) + Int(corners[k].i) * across + Int(corners[k].j) * down) -
        (Int(1) << (below_point_ + level_ - 1));
  return x;
}

template <class Int>
ExactBase::Answer ExactBase::in(const index::Corners& corners) const {
  std::array<Int, 3> x = along<Int>(u_, width_, corners), y = along<Int>(v_, height_, corners);
  const int fraction = below_point_ + level_;
  const std::int64_t column = moved_to_origin(x, fraction), row = moved_to_origin(y, fraction);
  Exact<Int> exact(sides_, column, row, cells_, fraction, x, y);
  return {exact.marks(), exact.at_centroid()};
}

ExactBase::Answer ExactBase::operator()(std::uint32_t index) const {
  const index::Corners corners = index::corners(index, static_cast<index::Level>(level_));
  if (bits_ <= 128) return in<Int128>(corners);
  if (bits_ <= 384) return in<Wide<6>>(corners);
  // The most that can be: 150 + 12 below the point, 35 above it, 43 for texels.
  static_assert(4 * (150 + 12 + 36) + 2 * 43 + 12 <= 1024);
  return in<Wide<16>>(corners);
}

}  // namespace mmverify::impl::bake::detail
