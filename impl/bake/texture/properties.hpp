// A texture's marks: for any rectangle of wrapped texels, whether some are not opaque, and some not transparent.
// Internal to impl/bake.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "impl/bake/bake.hpp"
#include "impl/bake/marks.hpp"
#include "impl/bake/texture/limits.hpp"
#include "impl/bake/texture/plane.hpp"
#include "impl/bake/texture/rows.hpp"
#include "impl/bake/texture/wrap.hpp"

namespace mmverify::impl::bake::detail {

// Marks here: `below`, some alpha is not opaque; `opaque`, some alpha is not transparent.  With MASK a point bears one
// of them, with BLEND at least one.  Bilinear alpha is a mean of texels.  If no texel bears a mark, all of them lie on
// one side of its limit, and so does their mean: no mean bears it.

class TextureProperties {
 public:
  virtual ~TextureProperties() = default;

  /// The marks of the texels [left, right] x [top, bottom], ends included, before wrapping.
  Marks of(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    if (left >= 0 && right < width_ && top >= 0 && bottom < height_) return within(left, right, top, bottom);
    return wrapped_around(left, right, top, bottom);
  }

  /// Whether the texels [left, right] x [top, bottom], before wrapping, hold one of the box.
  bool meets(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom,
             const Box& box) const noexcept;

  Extent across() const noexcept { return extent(wrap_x_, width_); }
  Extent down() const noexcept { return extent(wrap_y_, height_); }
  /// Columns that mean the same texels as [left, right]; ranges with the same texels often give the same columns.
  Columns columns(std::int64_t left, std::int64_t right) const noexcept {
    if (left > right) return {};
    const Extent e = across();
    if (!e.ends() && right - left + 1 >= e.period) return {0, width_ - 1};
    return {std::clamp(left, e.first, e.last), std::clamp(right, e.first, e.last)};
  }

  /// The stored number of texel (i, j), before wrapping.
  virtual Binary stored(std::int64_t i, std::int64_t j) const noexcept = 0;

  Limits limits;
  /// Stored numbers are multiples of 2^finest and below 2^most in size.
  int finest = 0, most = 0;
  /// Stored numbers are within `scale` of 0, and of each other.
  double scale = 0;
  /// A stored number is opaque from `threshold` on, and transparent up to threshold - gap.  The threshold is rounded;
  /// beyond +-2 scale it is +-2 scale.
  double threshold = 0, gap = 0;
  /// The least distances from there: of numbers that are not opaque, and of numbers that are not transparent.
  double clear_below = 0, clear_opaque = 0;

 protected:
  TextureProperties(const Limits& l, std::uint32_t width, std::uint32_t height, Wrap x, Wrap y) noexcept
      : limits(l), width_(width), height_(height), wrap_x_(x), wrap_y_(y) {}

  std::int64_t width_, height_;
  Wrap wrap_x_, wrap_y_;
  Marks border_marks_ = 0;
  Plane opaque_, visible_;  ///< visible: not transparent; with BLEND alone

 private:
  Marks within(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    const Plane::BoxMarks found = opaque_.in(left, right, top, bottom);
    const bool seen = limits.blend ? visible_.in(left, right, top, bottom).some : found.some;
    return static_cast<Marks>((seen ? opaque : 0) | (found.some_not ? below : 0));
  }
  Marks wrapped_around(std::int64_t left, std::int64_t right, std::int64_t top,
                       std::int64_t bottom) const noexcept;
};

template <class Texel>
class TexturePropertiesOf final : public TextureProperties {
 public:
  /// Errors: std::invalid_argument for a texel that is not finite, naming it.
  /// Domain: 1..16384 texels a side, which outlive this; a finite border.
  TexturePropertiesOf(const TexelView<Texel>& texture, const Limits& limits, Wrap x, Wrap y, Texel border);

  Binary stored(std::int64_t i, std::int64_t j) const noexcept override;

  Texel texel(std::int64_t i, std::int64_t j) const noexcept {
    const std::int64_t x = wrapped(wrap_x_, i, width_), y = wrapped(wrap_y_, j, height_);
    return x < 0 || y < 0
               ? border_
               : texture_.texels[static_cast<std::size_t>(y) * texture_.pitch + static_cast<std::size_t>(x)];
  }

  /// A type in which differences of texels are exact, or rounded once.
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

  /// The place in the picture of texel (left, top), if the texels [left, right] x [top, bottom] lie in one picture as
  /// they are.
  struct InPicture {
    std::int64_t left, top;
  };
  std::optional<InPicture> place_in_one_picture(std::int64_t left, std::int64_t right, std::int64_t top,
                                                std::int64_t bottom) const noexcept {
    const auto moved = [](Wrap wrap, std::int64_t at, std::int64_t n) {
      return wrap == Wrap::repeat && (at < 0 || at >= n) ? modulo(at, n) : at;
    };
    const std::int64_t x = moved(wrap_x_, left, width_), y = moved(wrap_y_, top, height_);
    if (x < 0 || x + (right - left) >= width_ || y < 0 || y + (bottom - top) >= height_) return std::nullopt;
    return InPicture{x, y};
  }
  /// The same with a pointer to that texel.  Four bytes from each of the texels can be read.
  struct InOnePicture {
    const Texel* first;
    std::int64_t left, top;  ///< its place in the picture
  };
  std::optional<InOnePicture> in_one_picture(std::int64_t left, std::int64_t right, std::int64_t top,
                                             std::int64_t bottom) const noexcept {
    const auto place = place_in_one_picture(left, right, top, bottom);
    if (!place) return std::nullopt;
    constexpr std::size_t beyond = 4 / sizeof(Texel) - 1;
    const auto at = [this](std::int64_t i, std::int64_t j) {
      return static_cast<std::size_t>(j) * texture_.pitch + static_cast<std::size_t>(i);
    };
    if (at(place->left + (right - left), place->top + (bottom - top)) + beyond > at(width_ - 1, height_ - 1))
      return std::nullopt;
    return InOnePicture{texture_.texels + at(place->left, place->top), place->left, place->top};
  }
  std::size_t pitch() const noexcept { return texture_.pitch; }
  /// Copies the texels [left, left + width) x [top, top + height), before wrapping, to rows of `pitch`, and their bits.
  /// Domain: width and height at most 32.
  void copy(std::int64_t left, std::int64_t top, std::size_t width, std::size_t height, std::size_t pitch,
            Texel* to, std::uint32_t* opaque_rows, std::uint32_t* visible_rows) const noexcept;
  const Plane& opaque_plane() const noexcept { return opaque_; }
  const Plane& visible_plane() const noexcept { return limits.blend ? visible_ : opaque_; }

 private:
  void measure(bool visible);
  /// The plane of the texels that are at least `from`.
  template <class From>
  Plane plane(From from) const;

  TexelView<Texel> texture_;
  Texel border_;
  std::conditional_t<std::is_same_v<Texel, float>, float, std::int32_t>
      least_opaque_;  ///< or one more than any texel
};

}  // namespace mmverify::impl::bake::detail
