#include "impl/bake/texture/properties.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace mmverify::impl::bake::detail {
namespace {

/// The stored numbers of a type of texel, in their order.
template <class Texel>
struct Kind {
  static constexpr std::int64_t first = 0, last = std::numeric_limits<Texel>::max();
  static std::int32_t number(std::int64_t k) noexcept { return static_cast<std::int32_t>(k); }
  static Binary stored(std::int64_t k) noexcept { return {k, 0}; }
};
/// Floats are ordered so that k and -k have one size and two signs.
template <>
struct Kind<float> {
  static constexpr std::int64_t last = 0x7f7fffff;  // check-magic: 0x7f7fffff == bits32(0x1.fffffep127)
  static constexpr std::int64_t first = -last;
  static float number(std::int64_t k) noexcept {
    const auto size = std::bit_cast<float>(static_cast<std::uint32_t>(k < 0 ? -k : k));
    return k < 0 ? -size : size;
  }
  static Binary stored(std::int64_t k) noexcept { return binary(number(k)); }
};

/// The least opaque stored number; one more than the last if none is opaque.  Heights rise with the number.
template <class Texel>
auto least_opaque(const Limits& limits) {
  constexpr int finest = -149;  // check-magic: 149 == 126 + 23
  const Height<AnyHeight> height(limits.opaque, finest);
  std::int64_t low = Kind<Texel>::first, high = Kind<Texel>::last + 1;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (height(Kind<Texel>::stored(middle)).negative())
      low = middle + 1;
    else
      high = middle;
  }
  return Kind<Texel>::number(low);
}

/// The stored number at which opaque begins, rounded; infinite if the slope is 0.
double threshold_of(const Limit& l) noexcept {
  double slope = 1;
  for (const Binary& b : l.slope) slope *= rounded(b);
  const double limit = rounded(l.limit);
  if (slope == 0) return limit > 0 ? HUGE_VAL : -HUGE_VAL;
  return limit / slope;
}

}  // namespace

template <class Texel>
TexturePropertiesOf<Texel>::TexturePropertiesOf(const TexelView<Texel>& texture, const Limits& l, Wrap x,
                                                Wrap y, Texel border)
    : TextureProperties(l, texture.width, texture.height, x, y), texture_(texture), border_(border) {
  const auto least = least_opaque_ = least_opaque<Texel>(limits);
  const bool visible = !limits.zero;
  threshold = threshold_of(limits.opaque);
  measure(visible);
  threshold = std::clamp(threshold, -2 * scale, 2 * scale);
  gap = limits.blend && visible ? threshold : 0;

  opaque_ = plane(least);
  if (limits.blend) {
    // Visible texels are at least the least number above 0.
    if constexpr (std::is_same_v<Texel, float>)
      visible_ = plane(visible ? std::numeric_limits<float>::denorm_min() : HUGE_VALF);
    else
      visible_ = plane(visible ? 1 : std::int32_t{std::numeric_limits<Texel>::max()} + 1);
  }
  const bool border_opaque = border >= least;
  border_marks_ = static_cast<Marks>((border_opaque ? 0 : below) |
                                     ((limits.blend ? visible && border > 0 : border_opaque) ? opaque : 0));
}

/// Sets what bounds the stored numbers, and their distances from the threshold, which is not limited yet.
template <class Texel>
void TexturePropertiesOf<Texel>::measure(bool visible) {
  const auto least = least_opaque_;
  if constexpr (std::is_same_v<Texel, float>) {
    double size = 0;
    clear_below = clear_opaque = HUGE_VAL;
    finest = 127;
    most = -149;
    const auto take = [&](float r) {
      size = std::max(size, std::fabs(double{r}));
      if (!(r >= least)) clear_below = std::min(clear_below, threshold - double{r});
      if (limits.blend ? visible && r > 0 : r >= least)
        clear_opaque = std::min(clear_opaque, double{r} - (limits.blend ? 0 : threshold));
      const Binary b = binary(r);
      if (b.m == 0) return;
      finest = std::min(finest, b.e);
      most = std::max(most, b.e + bits(b.m));
    };
    for (std::uint32_t j = 0; j < texture_.height; ++j)
      for (std::uint32_t i = 0; i < texture_.width; ++i) {
        const float r = texture_.texels[j * texture_.pitch + i];
        if (!std::isfinite(r))
          throw std::invalid_argument("bake: texel (" + std::to_string(i) + ", " + std::to_string(j) +
                                      ") is not finite");
        take(r);
      }
    take(border_);
    if (size == 0) finest = most = 0;
    scale = 2 * size;
  } else {
    scale = std::numeric_limits<Texel>::max();
    most = std::numeric_limits<Texel>::digits;
    clear_below = threshold - (least - 1);
    clear_opaque = limits.blend ? 1 : least - threshold;
  }
}

template <class Texel>
template <class From>
Plane TexturePropertiesOf<Texel>::plane(From from) const {
  return Plane(texture_.width, texture_.height, [&](std::uint32_t j, std::uint8_t* bytes) {
    const Texel* const row = texture_.texels + j * texture_.pitch;
    if constexpr (std::is_same_v<Texel, float>) {
      std::fill_n(bytes, (texture_.width + 7) / 8, std::uint8_t{0});
      for (std::uint32_t i = 0; i < texture_.width; ++i)
        bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | (row[i] >= from) << (i % 8));
    } else {
      at_least(row, texture_.width, from, bytes);
    }
  });
}

template <class Texel>
void TexturePropertiesOf<Texel>::copy(std::int64_t left, std::int64_t top, std::size_t width,
                                      std::size_t height, std::size_t pitch, Texel* to,
                                      std::uint32_t* opaque_rows,
                                      std::uint32_t* visible_rows) const noexcept {
  std::array<std::int64_t, 32> columns;
  for (std::size_t i = 0; i < width; ++i)
    columns[i] = wrapped(wrap_x_, left + static_cast<std::int64_t>(i), width_);
  for (std::size_t j = 0; j < height; ++j, to += pitch) {
    const std::int64_t y = wrapped(wrap_y_, top + static_cast<std::int64_t>(j), height_);
    const Texel* const row = y < 0 ? nullptr : texture_.texels + static_cast<std::size_t>(y) * texture_.pitch;
    std::uint32_t are_opaque = 0, are_visible = 0;
    for (std::size_t i = 0; i < width; ++i) {
      const Texel r = row == nullptr || columns[i] < 0 ? border_ : row[columns[i]];
      to[i] = r;
      are_opaque |= std::uint32_t{r >= least_opaque_} << i;
      are_visible |= std::uint32_t{r > 0 && !limits.zero} << i;
    }
    opaque_rows[j] = are_opaque;
    visible_rows[j] = limits.blend ? are_visible : are_opaque;
  }
}

template <class Texel>
Binary TexturePropertiesOf<Texel>::stored(std::int64_t i, std::int64_t j) const noexcept {
  const Texel r = texel(i, j);
  if constexpr (std::is_same_v<Texel, float>)
    return binary(r);
  else
    return {r, 0};
}

template class TexturePropertiesOf<std::uint8_t>;
template class TexturePropertiesOf<std::uint16_t>;
template class TexturePropertiesOf<float>;

bool TextureProperties::meets(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom,
                              const Box& box) const noexcept {
  const auto some = [](const Runs& texels, std::int64_t first, std::int64_t count) {
    for (int k = 0; k < texels.count; ++k)
      if (texels.from[k] < first + count && texels.to[k] >= first) return count != 0;
    return false;
  };
  return some(runs(wrap_x_, left, right, width_), box.x, box.width) &&
         some(runs(wrap_y_, top, bottom, height_), box.y, box.height);
}

Marks TextureProperties::wrapped_around(std::int64_t left, std::int64_t right, std::int64_t top,
                                        std::int64_t bottom) const noexcept {
  const Runs across = runs(wrap_x_, left, right, width_), down = runs(wrap_y_, top, bottom, height_);
  Marks marks = across.border || down.border ? border_marks_ : Marks{0};
  for (int j = 0; j < down.count; ++j)
    for (int i = 0; i < across.count; ++i)
      marks = static_cast<Marks>(marks | within(across.from[i], across.to[i], down.from[j], down.to[j]));
  return marks;
}

}  // namespace mmverify::impl::bake::detail
