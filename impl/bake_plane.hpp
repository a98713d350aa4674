// Which texels have a property, counted over any rectangle.  Internal to impl/bake*.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace mmverify::impl::bake::detail {

static_assert(std::endian::native == std::endian::little, "rows of bits are loaded as little-endian words");

class Plane {
 public:
  Plane() = default;

  /// `has(x, y)`: whether texel (x, y) has it.  Domain: 1..16384 a side.
  template <class Has>
  Plane(std::uint32_t width, std::uint32_t height, Has has)
      : pitch_(std::size_t{width} + 1), bytes_((std::size_t{width} + 7) / 8) {
    bits_.resize(bytes_ * height + 8);  // room for a word from the last byte of the last row
    sums_.resize(pitch_ * (std::size_t{height} + 1));
    for (std::uint32_t row = 0; row < height; ++row) {
      const std::uint32_t* const above = sums_.data() + row * pitch_;
      std::uint32_t* const here = sums_.data() + (std::size_t{row} + 1) * pitch_;
      std::uint8_t* const bits = bits_.data() + row * bytes_;
      std::uint32_t in_row = 0;
      const auto eight = [&](std::uint32_t from, std::uint32_t count) {
        unsigned byte = 0;
        for (std::uint32_t k = 0; k < count; ++k) {
          const unsigned one = has(from + k, row);
          byte |= one << k;
          in_row += one;
          here[from + k + 1] = above[from + k + 1] + in_row;
        }
        bits[from / 8] = static_cast<std::uint8_t>(byte);
      };
      const std::uint32_t whole = width / 8 * 8;
      for (std::uint32_t k = 0; k < whole; k += 8) eight(k, 8);
      if (whole < width) eight(whole, width - whole);
    }
  }

  /// How many of the texels [left, right] x [top, bottom], ends included, all within the texture.
  std::uint32_t count(std::int64_t left, std::int64_t right, std::int64_t top,
                      std::int64_t bottom) const noexcept {
    const std::uint32_t* const above = sums_.data() + static_cast<std::size_t>(top) * pitch_;
    const std::uint32_t* const under = sums_.data() + static_cast<std::size_t>(bottom + 1) * pitch_;
    return under[right + 1] - under[left] - above[right + 1] + above[left];
  }

  /// Of texel x of row y and those to its right, the lowest bits of a word: 57 at least, where there are so
  /// many in the row.
  std::uint64_t row(std::int64_t x, std::int64_t y) const noexcept {
    std::uint64_t word;
    std::memcpy(&word, bits_.data() + static_cast<std::size_t>(y) * bytes_ + static_cast<std::size_t>(x / 8),
                sizeof word);
    return word >> (x % 8);
  }

 private:
  std::size_t pitch_ = 0, bytes_ = 0;
  /// How many texels [0, x) x [0, y) have it, at x + pitch y.
  std::vector<std::uint32_t> sums_;
  /// Whether texel (x, y) has it: bit x of the row that begins at byte bytes_ y; words are little-endian.
  std::vector<std::uint8_t> bits_;
};

}  // namespace mmverify::impl::bake::detail
