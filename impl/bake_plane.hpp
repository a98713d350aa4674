// Which texels have a property: for any rectangle, whether some have it and whether some have not.  Internal
// to impl/bake*.
//
// Texels are bits, in tiles of 8x8 of a word each; of tiles, rows of bits say which hold some and which hold
// nothing else.  A megabyte of texels takes 260 kB, which stays in a cache where their sums would not.
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
      : tiles_across_((std::size_t{width} + 7) / 8), words_((tiles_across_ + 63) / 64) {
    const std::size_t tiles_down = (std::size_t{height} + 7) / 8;
    tiles_.resize(tiles_across_ * tiles_down);
    some_.resize(words_ * tiles_down);
    some_not_.resize(words_ * tiles_down);
    bytes_.resize(tiles_across_ * height + 8);  // room for a word from the last byte of the last row
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; x += 8) {
        std::uint64_t byte = 0;
        const std::uint32_t count = width - x < 8 ? width - x : 8;
        for (std::uint32_t k = 0; k < count; ++k) byte |= std::uint64_t{has(x + k, y)} << k;
        bytes_[tiles_across_ * y + x / 8] = static_cast<std::uint8_t>(byte);
        tiles_[tiles_across_ * (y / 8) + x / 8] |= byte << (8 * (y % 8));
      }
    for (std::size_t j = 0; j < tiles_down; ++j)
      for (std::size_t i = 0; i < tiles_across_; ++i) {
        const std::uint64_t tile = tiles_[tiles_across_ * j + i],
                            real = columns(0, i + 1 < tiles_across_ ? 7 : (width - 1) % 8) &
                                   rows(0, j + 1 < tiles_down ? 7 : (height - 1) % 8),
                            bit = std::uint64_t{1} << (i % 64);
        if (tile != 0) some_[words_ * j + i / 64] |= bit;
        if (tile != real) some_not_[words_ * j + i / 64] |= bit;
      }
  }

  /// Of texel x of row y and those to its right, the lowest bits; those beyond the row's end mean nothing.
  std::uint32_t row(std::int64_t x, std::int64_t y) const noexcept {
    std::uint64_t word;
    std::memcpy(&word,
                bytes_.data() + tiles_across_ * static_cast<std::size_t>(y) + static_cast<std::size_t>(x / 8),
                sizeof word);
    return static_cast<std::uint32_t>(word >> (x % 8));
  }

  /// The bytes of row y, bit x of which is texel x's; rows are so many apart.  Four bytes from any can be
  /// read.
  const std::uint8_t* row_bytes(std::int64_t y) const noexcept {
    return bytes_.data() + tiles_across_ * static_cast<std::size_t>(y);
  }
  std::size_t row_pitch() const noexcept { return tiles_across_; }

  struct Found {
    bool some, some_not;
  };
  /// Of the texels [left, right] x [top, bottom], ends included, all within the texture.
  Found in(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    const auto l = static_cast<std::size_t>(left), r = static_cast<std::size_t>(right),
               t = static_cast<std::size_t>(top), b = static_cast<std::size_t>(bottom);
    const std::size_t first = l / 8, last = r / 8, last_row = b / 8;
    std::uint64_t first_columns = columns(l % 8, 7);
    const std::uint64_t last_columns = columns(0, r % 8);
    if (first == last) first_columns &= last_columns;
    std::uint64_t have = 0, have_not = 0;
    for (std::size_t row = t / 8; row <= last_row; ++row) {
      const std::uint64_t of_rows = rows(row == t / 8 ? t % 8 : 0, row == last_row ? b % 8 : 7);
      const std::uint64_t* const tile = tiles_.data() + tiles_across_ * row;
      const auto take = [&](std::size_t k, std::uint64_t mask) {
        have |= tile[k] & mask;
        have_not |= ~tile[k] & mask;
      };
      take(first, of_rows & first_columns);
      if (first != last) {
        take(last, of_rows & last_columns);
        if (last - first > few && of_rows == ~std::uint64_t{0})
          whole_tiles(row, first + 1, last, have, have_not);
        else
          for (std::size_t k = first + 1; k < last; ++k) take(k, of_rows);
      }
      if (have != 0 && have_not != 0) break;
    }
    return {have != 0, have_not != 0};
  }

 private:
  static constexpr std::size_t few = 4;

  static std::uint64_t columns(std::size_t from, std::size_t to) noexcept {
    return std::uint64_t{0x0101010101010101} * ((0xffu >> (7 - to)) & (0xffu << from) & 0xffu);
  }
  static std::uint64_t rows(std::size_t from, std::size_t to) noexcept {
    return (~std::uint64_t{0} << (8 * from)) & (~std::uint64_t{0} >> (56 - 8 * to));
  }
  /// Of the tiles [from, end) of a row.  Domain: from < end.
  void whole_tiles(std::size_t row, std::size_t from, std::size_t end, std::uint64_t& have,
                   std::uint64_t& have_not) const noexcept {
    for (std::size_t word = from / 64; word <= (end - 1) / 64; ++word) {
      std::uint64_t mask = ~std::uint64_t{0};
      if (word == from / 64) mask &= mask << (from % 64);
      if (word == (end - 1) / 64) mask &= ~std::uint64_t{0} >> (63 - (end - 1) % 64);
      have |= some_[words_ * row + word] & mask;
      have_not |= some_not_[words_ * row + word] & mask;
    }
  }

  std::size_t tiles_across_ = 0, words_ = 0;
  /// Tile (i, j) at i + tiles_across j; texel (x, y) of it is bit x + 8 y.
  std::vector<std::uint64_t> tiles_;
  /// The same rows by rows.
  std::vector<std::uint8_t> bytes_;
  /// Bit i of row j, words_ to a row: whether tile (i, j) has some that have it; and some that have not.
  std::vector<std::uint64_t> some_, some_not_;
};

}  // namespace mmverify::impl::bake::detail
