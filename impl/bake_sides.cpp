#include "impl/bake_sides.hpp"

#include <bit>
#include <cmath>
#include <numeric>

namespace mmverify::impl::bake::detail {

static_assert(std::endian::native == std::endian::little, "rows of bits are loaded as little-endian words");

Sides::Sides(const AlphaView& texture, Cutoff cutoff, Wrap x, Wrap y, std::uint8_t border)
    : texture_(texture),
      width_(texture.width),
      height_(texture.height),
      wrap_x_(x),
      wrap_y_(y),
      border_(border) {
  const std::int64_t n = 255 * std::int64_t{cutoff.numerator}, d = cutoff.denominator;
  const std::int64_t common = std::gcd(n, d);
  limit = n / common;
  unit = d / common;
  least_opaque = static_cast<std::int32_t>(std::min<std::int64_t>(256, (n + d - 1) / d));
  threshold = static_cast<double>(limit) / static_cast<double>(unit);
  clearance = std::fabs(threshold - std::round(threshold));

  const std::size_t pitch = std::size_t{texture.width} + 1;
  // Room for a word from the last byte of the last row.
  bytes_ = (std::size_t{texture.width} + 7) / 8;
  bits_.resize(bytes_ * texture.height + 8);
  sums_.resize(pitch * (std::size_t{texture.height} + 1));
  for (std::uint32_t row = 0; row < texture.height; ++row) {
    const std::uint8_t* const texels = texture.texels + row * texture.pitch;
    const std::uint32_t* const above = sums_.data() + row * pitch;
    std::uint32_t* const here = sums_.data() + (std::size_t{row} + 1) * pitch;
    std::uint8_t* const bits = bits_.data() + row * bytes_;
    std::uint32_t in_row = 0;
    const auto eight = [&](std::uint32_t from, std::uint32_t count) {
      unsigned byte = 0;
      for (std::uint32_t k = 0; k < count; ++k) {
        const unsigned is_opaque = texels[from + k] >= least_opaque;
        byte |= is_opaque << k;
        in_row += is_opaque;
        here[from + k + 1] = above[from + k + 1] + in_row;
      }
      bits[from / 8] = static_cast<std::uint8_t>(byte);
    };
    const std::uint32_t whole = texture.width / 8 * 8;
    for (std::uint32_t k = 0; k < whole; k += 8) eight(k, 8);
    if (whole < texture.width) eight(whole, texture.width - whole);
  }
}

Marks Sides::wrapped_around(std::int64_t left, std::int64_t right, std::int64_t top,
                            std::int64_t bottom) const noexcept {
  const Runs across = runs(wrap_x_, left, right, width_), down = runs(wrap_y_, top, bottom, height_);
  Marks marks = 0;
  if (across.border || down.border) marks = border_ >= least_opaque ? opaque : below;
  for (int j = 0; j < down.count; ++j)
    for (int i = 0; i < across.count; ++i)
      marks = static_cast<Marks>(marks | within(across.from[i], across.to[i], down.from[j], down.to[j]));
  return marks;
}

}  // namespace mmverify::impl::bake::detail
