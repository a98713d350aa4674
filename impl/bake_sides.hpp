// A texture by what its texels say: for any rectangle of wrapped texels, whether some are not opaque and
// whether some are not transparent.  Internal to impl/bake*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "impl/bake.hpp"
#include "impl/bake_limits.hpp"
#include "impl/bake_plane.hpp"
#include "impl/bake_sampler.hpp"
#include "impl/bake_wrap.hpp"

namespace mmverify::impl::bake::detail {

// Marks here: `below`, some alpha is not opaque; `opaque`, some alpha is not transparent.  With MASK a point
// bears one of them, with BLEND at least one.  Bilinear alpha is a mean of texels, and all alphas that lack a
// mark are on one side of a limit: what no texel bears no mean of them does.

class Sides {
 public:
  virtual ~Sides() = default;

  /// Of the texels [left, right] x [top, bottom], ends included, before wrapping.
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
    for (std::int64_t j = top; j <= bottom; ++j) {
      const std::uint64_t row = opaque_.row(left, j);
      any |= limits.blend ? visible_.row(left, j) : row;
      all &= row;
      if ((any & mask) != 0 && all != mask) return both;
    }
    return static_cast<Marks>(((any & mask) != 0 ? opaque : 0) | (all != mask ? below : 0));
  }

  /// Texel (i, j), before wrapping, as it is stored.
  virtual Binary stored(std::int64_t i, std::int64_t j) const noexcept = 0;

  Limits limits;
  /// Stored numbers are multiples of 2^finest and below 2^most in size.
  int finest = 0, most = 0;
  /// They are within `scale` of 0, and of each other.
  double scale = 0;
  /// Where they begin to be opaque, rounded, or +-2 scale if it is beyond; less gap, where they cease to be
  /// transparent.
  double threshold = 0, gap = 0;
  /// How far they are from there: those that are not opaque, and those that are not transparent, at least.
  double clear_below = 0, clear_opaque = 0;

 protected:
  Sides(const Limits& l, std::uint32_t width, std::uint32_t height, Wrap x, Wrap y) noexcept
      : limits(l), width_(width), height_(height), wrap_x_(x), wrap_y_(y) {}

  std::int64_t width_, height_;
  Wrap wrap_x_, wrap_y_;
  Marks border_marks_ = 0;
  Plane opaque_, visible_;  ///< visible: not transparent; with BLEND alone

 private:
  Marks within(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    const std::uint32_t n = opaque_.count(left, right, top, bottom);
    const std::uint32_t seen = limits.blend ? visible_.count(left, right, top, bottom) : n;
    const auto area = static_cast<std::uint32_t>((right + 1 - left) * (bottom + 1 - top));
    return static_cast<Marks>((seen != 0 ? opaque : 0) | (n != area ? below : 0));
  }
  Marks wrapped_around(std::int64_t left, std::int64_t right, std::int64_t top,
                       std::int64_t bottom) const noexcept;
};

template <class Texel>
class SidesOf final : public Sides {
 public:
  /// Errors: std::invalid_argument for a texel that is not finite, naming it.
  /// Domain: 1..16384 texels a side, which outlive this; a finite border.
  SidesOf(const TexelView<Texel>& texture, const Limits& limits, Wrap x, Wrap y, Texel border);

  Binary stored(std::int64_t i, std::int64_t j) const noexcept override;

  Texel texel(std::int64_t i, std::int64_t j) const noexcept {
    const std::int64_t x = wrapped(wrap_x_, i, width_), y = wrapped(wrap_y_, j, height_);
    return x < 0 || y < 0
               ? border_
               : texture_.texels[static_cast<std::size_t>(y) * texture_.pitch + static_cast<std::size_t>(x)];
  }

  /// A type whose differences of texels are exact, or rounded once.
  using Number = std::conditional_t<std::is_same_v<Texel, float>, double, std::int32_t>;
  /// The texels (i, j), (i+1, j), (i, j+1), (i+1, j+1).
  struct Four {
    Number a, right, below, across;
  };
  Four four(std::int64_t i, std::int64_t j) const noexcept {
    if (i >= 0 && i + 1 < width_ && j >= 0 && j + 1 < height_) {
      const Texel* const p =
          texture_.texels + static_cast<std::size_t>(j) * texture_.pitch + static_cast<std::size_t>(i);
      return {p[0], p[1], p[texture_.pitch], p[texture_.pitch + 1]};
    }
    return {texel(i, j), texel(i + 1, j), texel(i, j + 1), texel(i + 1, j + 1)};
  }

 private:
  TexelView<Texel> texture_;
  Texel border_;
};

}  // namespace mmverify::impl::bake::detail
