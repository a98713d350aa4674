// Texels with a property: for any rectangle, whether some texel has it, and whether some has not.  Internal to
// impl/bake.
//
// Texels are bits, stored twice.  Tiles of 8x8 texels are a word each; rows of bits say which tiles have some such
// texel, and which have others.  Strips are 32 texels wide, a word a row, the rows of a strip one after another, so
// that a vector of rows is one load.  A megabyte of texels takes 270 kB, which stays in a cache where their sums would
// not.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "impl/bake/texture/bits.hpp"

namespace mmverify::impl::bake::detail {

static_assert(std::endian::native == std::endian::little, "bytes of bits are copied to little-endian words");

class Plane {
 public:
  Plane() = default;

  /// `pack(y, bytes)` sets bit x of bytes if texel (x, y) has the property; it may write bits_slack bytes beyond.
  /// Domain: 1..16384 a side.
  template <class Pack>
  Plane(std::uint32_t width, std::uint32_t height, Pack pack)
      : tiles_across_((std::size_t{width} + 7) / 8),
        words_((tiles_across_ + 63) / 64),
        strip_(std::size_t{height} + rows_beyond) {
    const std::size_t tiles_down = (std::size_t{height} + 7) / 8, strips = (std::size_t{width} + 31) / 32;
    tiles_.resize(tiles_across_ * tiles_down);
    some_.resize(words_ * tiles_down);
    some_not_.resize(words_ * tiles_down);
    strips_.resize(strip_ * (strips + 1));
    const std::size_t pitch = (tiles_across_ + 7) / 8 * 8 + bits_slack;
    std::vector<std::uint8_t> band(pitch * 8);
    for (std::size_t j = 0; j < tiles_down; ++j) {
      const std::size_t real_rows = std::min<std::size_t>(8, height - 8 * j);
      for (std::size_t k = 0; k < real_rows; ++k)
        pack(static_cast<std::uint32_t>(8 * j + k), band.data() + pitch * k);
      std::fill(band.begin() + static_cast<std::ptrdiff_t>(pitch * real_rows), band.end(), std::uint8_t{0});
      for (std::size_t i = 0; i < strips; ++i)
        for (std::size_t k = 0; k < real_rows; ++k)
          std::memcpy(&strips_[strip_ * i + 8 * j + k], band.data() + pitch * k + 4 * i, 4);
      std::uint64_t* const tile = tiles_.data() + tiles_across_ * j;
      for (std::size_t i = 0; i < tiles_across_; i += 8) {
        std::array<std::uint64_t, 8> eight;
        for (std::size_t k = 0; k < 8; ++k) std::memcpy(&eight[k], band.data() + pitch * k + i, 8);
        transpose(eight);
        std::copy_n(eight.begin(), std::min<std::size_t>(8, tiles_across_ - i), tile + i);
      }
      const std::uint64_t real = rows(0, real_rows - 1);
      for (std::size_t i = 0; i < tiles_across_; ++i) {
        const std::uint64_t all = i + 1 < tiles_across_ ? real : real & columns(0, (width - 1) % 8);
        some_[words_ * j + i / 64] |= std::uint64_t{tile[i] != 0} << (i % 64);
        some_not_[words_ * j + i / 64] |= std::uint64_t{tile[i] != all} << (i % 64);
      }
    }
  }

  /// The texels [32 k, 32 k + 32) of row y, the lowest bits first, are word y + strip k.  Bits beyond the row's end
  /// mean nothing.  One strip more can be read, and rows_beyond rows more.
  const std::uint32_t* strips() const noexcept { return strips_.data(); }
  std::size_t strip() const noexcept { return strip_; }
  static constexpr std::size_t rows_beyond = 32;

  struct BoxMarks {
    bool some, some_not;
  };
  /// Looks at the texels [left, right] x [top, bottom], ends included.  Domain: all of them are in the texture.
  BoxMarks in(std::int64_t left, std::int64_t right, std::int64_t top, std::int64_t bottom) const noexcept {
    const auto l = static_cast<std::size_t>(left), r = static_cast<std::size_t>(right),
               t = static_cast<std::size_t>(top), b = static_cast<std::size_t>(bottom);
    if (r - l < small_columns && b - t < small_rows) return in_small(l, r, t, b);
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
  /// A box that two words of each row hold, in so few rows that all are looked at sooner than tiles one by one.
  static constexpr std::size_t small_columns = 32, small_rows = 32;

  BoxMarks in_small(std::size_t l, std::size_t r, std::size_t t, std::size_t b) const noexcept {
    const std::uint64_t mask = ~std::uint64_t{0} >> (63 - (r - l)) << (l % 32);
    const auto low = static_cast<std::uint32_t>(mask), high = static_cast<std::uint32_t>(mask >> 32);
    const std::uint32_t *const word = strips_.data() + strip_ * (l / 32), *const next = word + strip_;
    std::uint32_t have = 0, have_not = 0;
    for (std::size_t row = t; row <= b; ++row) {
      have |= word[row] & low;
      have_not |= ~word[row] & low;
    }
    if (high != 0)
      for (std::size_t row = t; row <= b; ++row) {
        have |= next[row] & high;
        have_not |= ~next[row] & high;
      }
    return {have != 0, have_not != 0};
  }

  static std::uint64_t columns(std::size_t from, std::size_t to) noexcept {
    return std::uint64_t{0x0101010101010101} * ((0xffu >> (7 - to)) & (0xffu << from) & 0xffu);
  }
  static std::uint64_t rows(std::size_t from, std::size_t to) noexcept {
    return (~std::uint64_t{0} << (8 * from)) & (~std::uint64_t{0} >> (56 - 8 * to));
  }
  /// Byte i of word j becomes byte j of word i: blocks of four bytes, then of two, of one change places.
  static void transpose(std::array<std::uint64_t, 8>& words) noexcept {
    for (const auto& [step, mask] : {std::pair<std::size_t, std::uint64_t>{4, 0xffffffff},
                                     {2, 0x0000ffff0000ffff},
                                     {1, 0x00ff00ff00ff00ff}})
      for (std::size_t k = 0; k < 8; ++k) {
        if ((k & step) != 0) continue;
        const std::uint64_t changed = (words[k] >> (8 * step) ^ words[k + step]) & mask;
        words[k + step] ^= changed;
        words[k] ^= changed << (8 * step);
      }
  }
  /// Adds the tiles [from, end) of a row.  Domain: from < end.
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

  std::size_t tiles_across_ = 0, words_ = 0, strip_ = 0;
  /// Tile (i, j) is tiles_[i + tiles_across j]; texel (x, y) of it is bit x + 8 y.
  std::vector<std::uint64_t> tiles_;
  std::vector<std::uint32_t> strips_;
  /// Bit i of row j, words_ to a row: whether tile (i, j) has texels with the property; and whether it has others.
  std::vector<std::uint64_t> some_, some_not_;
};

}  // namespace mmverify::impl::bake::detail
