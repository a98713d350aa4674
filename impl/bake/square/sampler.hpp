// The marks of alpha at points and over spans.  Internal to impl/bake.
//
// No integer overflows: with width, height <= 2^14, side <= 2^8 and so D <= 2^9, and cutoff =
// numerator/denominator below 2^32/2^32,
//   positions             D 2^14 + 2 2^14 2^8          < 2^25
//   on the diagonal       2^25 2^14, twice             < 2^41
//   a corner              255 D^2                      < 2^26, times the denominator < 2^58
//   an edge's point       255 D                        smaller
//   a diagonal's point    255 D max(width, height)     < 2^31, times the denominator < 2^63
// and the diagonal's turning points are in 128 bits (impl/bake/square/triangle.cpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "impl/bake/bake.hpp"
#include "impl/bake/marks.hpp"
#include "impl/bake/square/axis.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::bake::detail {

/// The state of a region with these marks.  Domain: marks is not 0.
constexpr vq::State state_of(Marks marks) noexcept {
  return marks == both ? vq::State::C : marks == opaque ? vq::State::O : vq::State::T;
}

struct Sampler {
  const AlphaView& texture;
  Cutoff cutoff;
  Axis across, down;
  /// The least opaque byte; 256 if none is opaque.
  std::int64_t least_opaque = 0;

  Sampler(const AlphaView& t, const Box& box, Cutoff c, std::uint32_t side)
      : texture(t),
        cutoff(c),
        across(box.x, box.width, t.width, side),
        down(box.y, box.height, t.height, side),
        least_opaque(std::min<std::int64_t>(
            256, (255 * std::int64_t{c.numerator} + c.denominator - 1) / c.denominator)) {}

  const std::uint8_t* row(std::int64_t y) const noexcept {
    return texture.texels + static_cast<std::size_t>(down.wrapped(y)) * texture.pitch;
  }
  std::int64_t byte(std::int64_t x, std::int64_t y) const noexcept { return row(y)[across.wrapped(x)]; }

  /// The mark of alpha = value / (255 unit).
  Marks mark(std::int64_t value, std::int64_t unit) const noexcept {
    return value * cutoff.denominator >= 255 * unit * cutoff.numerator ? opaque : below;
  }

  /// The marks of the texels [begin, end) of a row.  Domain: all of them are in the texture.
  Marks span(const std::uint8_t* of, std::int64_t begin, std::int64_t end) const noexcept {
    if (begin >= end) return 0;
    std::uint8_t least = 255, greatest = 0;
    for (std::int64_t x = begin; x < end; ++x) {
      least = std::min(least, of[x]);
      greatest = std::max(greatest, of[x]);
    }
    return static_cast<Marks>((least < least_opaque ? below : 0) | (greatest >= least_opaque ? opaque : 0));
  }

  /// The mark on the row of centres y, f/unit of the way from texel k to k + 1.
  Marks on_row(Between x, std::int64_t unit, std::int64_t y) const noexcept {
    return mark(byte(x.k, y) * (unit - x.f) + byte(x.k + 1, y) * x.f, unit);
  }
  /// The mark on the column of centres x, f/unit of the way from texel k to k + 1.
  Marks on_column(std::int64_t x, Between y, std::int64_t unit) const noexcept {
    return mark(byte(x, y.k) * (unit - y.f) + byte(x, y.k + 1) * y.f, unit);
  }
  /// The mark where edge i across meets edge j down.
  Marks corner(std::int64_t i, std::int64_t j) const noexcept {
    const Between &x = across.at_edge(i), &y = down.at_edge(j);
    const std::int64_t d = across.d;
    const auto along = [&](std::int64_t r) { return byte(x.k, r) * (d - x.f) + byte(x.k + 1, r) * x.f; };
    return mark(along(y.k) * (d - y.f) + along(y.k + 1) * y.f, d * d);
  }
};

/// Throws std::invalid_argument unless the box is in the texture, the side in 1..max_side and states = expected.
void check(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side, std::size_t states,
           std::size_t expected);

}  // namespace mmverify::impl::bake::detail
