// A texture by the sides of a cutoff: for any rectangle of wrapped texels, whether all are opaque, all are
// not, or some are.  Internal to impl/bake*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "impl/bake.hpp"
#include "impl/bake_sampler.hpp"
#include "impl/bake_wrap.hpp"

namespace mmverify::impl::bake::detail {

class Sides {
 public:
  /// Domain: 1..16384 texels a side, which outlive this; a cutoff over 1..2^32-1.
  Sides(const AlphaView& texture, Cutoff cutoff, Wrap x, Wrap y, std::uint8_t border);

  /// The sides that the texels [left, right] x [top, bottom] are on, ends included, before wrapping.
  Marks of(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    if (left >= 0 && right < width_ && top >= 0 && bottom < height_) return within(left, right, top, bottom);
    return wrapped_around(left, right, top, bottom);
  }

  /// The same of few texels, a row of them in one word.  Domain: width at most 56.
  Marks of_few(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    if (left < 0 || right >= width_ || top < 0 || bottom >= height_)
      return wrapped_around(left, right, top, bottom);
    const std::uint64_t mask = (std::uint64_t{1} << (right - left + 1)) - 1;
    std::uint64_t any = 0, all = mask;
    const std::uint8_t* at =
        bits_.data() + static_cast<std::size_t>(top) * bytes_ + static_cast<std::size_t>(left / 8);
    for (std::int64_t j = top; j <= bottom; ++j, at += bytes_) {
      std::uint64_t row;
      std::memcpy(&row, at, sizeof row);
      row >>= left % 8;
      any |= row;
      all &= row;
      if ((any & mask) != 0 && all != mask) return both;
    }
    return (any & mask) == 0 ? below : all == mask ? opaque : both;
  }

  std::uint8_t byte(std::int64_t i, std::int64_t j) const noexcept {
    const std::int64_t x = wrapped(wrap_x_, i, width_), y = wrapped(wrap_y_, j, height_);
    return x < 0 || y < 0
               ? border_
               : texture_.texels[static_cast<std::size_t>(y) * texture_.pitch + static_cast<std::size_t>(x)];
  }

  /// The bytes of the texels (i, j), (i+1, j), (i, j+1), (i+1, j+1).
  struct Four {
    std::int32_t a, right, below, across;
  };
  Four four(std::int64_t i, std::int64_t j) const noexcept {
    if (i >= 0 && i + 1 < width_ && j >= 0 && j + 1 < height_) {
      const std::uint8_t* const p =
          texture_.texels + static_cast<std::size_t>(j) * texture_.pitch + static_cast<std::size_t>(i);
      return {p[0], p[1], p[texture_.pitch], p[texture_.pitch + 1]};
    }
    return {byte(i, j), byte(i + 1, j), byte(i, j + 1), byte(i + 1, j + 1)};
  }

  /// The least byte that is opaque; 256 if none is.
  std::int32_t least_opaque;
  /// 255 cutoff, rounded; and as the whole numbers limit / unit, lowest terms.
  double threshold;
  std::int64_t limit, unit;
  /// How far the threshold is from the nearest whole number: alpha that differs less from a texel's is on the
  /// texel's side.
  double clearance;

 private:
  Marks within(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    const auto pitch = static_cast<std::size_t>(width_) + 1;
    const std::uint32_t* const above = sums_.data() + static_cast<std::size_t>(top) * pitch;
    const std::uint32_t* const under = sums_.data() + static_cast<std::size_t>(bottom + 1) * pitch;
    const std::uint32_t n = under[right + 1] - under[left] - above[right + 1] + above[left];
    const auto area = static_cast<std::uint32_t>((right + 1 - left) * (bottom + 1 - top));
    return n == 0 ? below : n == area ? opaque : both;
  }
  Marks wrapped_around(std::int64_t left, std::int64_t right, std::int64_t top,
                       std::int64_t bottom) const noexcept;

  AlphaView texture_;
  std::int64_t width_, height_;
  Wrap wrap_x_, wrap_y_;
  std::uint8_t border_;
  /// How many opaque texels [0, x) x [0, y) holds, at x + (width + 1) y.
  std::vector<std::uint32_t> sums_;
  /// Whether texel (x, y) is opaque: bit x of the row that begins at byte bytes_ y; words are little-endian.
  std::size_t bytes_;
  std::vector<std::uint8_t> bits_;
};

}  // namespace mmverify::impl::bake::detail
