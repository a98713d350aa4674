// A third decoder, only for mutants: bit by bit from docs/VQ.md, without the specification's or impl's code, and with
// one slip.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The mistake of the decoder.
enum class Slip {
  none,
  bottom_left_for_all,  ///< every quadrant has the indices of BL
  halves_exchanged,     ///< the left half has the indices of the right one, and the other way round
  one_index_of_64,      ///< the vector (6, 1) has the index of (7, 1)
  low_bits_of_the_row,  ///< an index takes its lowest bit from the first index of its row
  entries_of_the_left,  ///< VQ2: R has the own entries of L
  entries_one_on,       ///< a shared or generic entry takes its last region's bit from the next entry
  turned_first,         ///< the rotation is undone before the reflections
  turn_of_the_other,    ///< BL and BR have each other's transform if TR's is 6, both reflections
};

template <class Format>
class SlippingDecoder {
 public:
  SlippingDecoder(const BlockBytes<Format>& block, Slip slip) : block_(block), slip_(slip) {}

  Map<Format> map() const {
    Map<Format> out;
    for (unsigned row = 0; row < 8; ++row)
      for (unsigned column = 0; column < 8; ++column) {
        const unsigned index = index_at(column, row), turn = turn_at(column, row);
        for (unsigned y = 0; y < side; ++y)
          for (unsigned x = 0; x < side; ++x)
            out[side * column + x + 8 * side * (side * row + y)] =
                static_cast<State>(state(index, column, row, turn, x, y));
      }
    return out;
  }

 private:
  static constexpr unsigned side = Format::side, width = side == 2 ? 3 : 4, turns = 64 * width;

  unsigned bit(unsigned at) const { return block_[at >> 3] >> (at & 7) & 1u; }
  unsigned number(unsigned at, unsigned count) const {
    unsigned value = 0;
    while (count-- > 0) value = 2 * value + bit(at + count);
    return value;
  }

  unsigned index_at(unsigned column, unsigned row) const {
    unsigned c = column, r = row;
    if (slip_ == Slip::bottom_left_for_all) c %= 4, r %= 4;
    if (slip_ == Slip::halves_exchanged) c ^= 4;
    if (slip_ == Slip::one_index_of_64 && c == 6 && r == 1) c = 7;
    unsigned index = number(width * (c + 8 * r), width);
    if (slip_ == Slip::low_bits_of_the_row) index = (index & ~1u) | bit(width * 8 * r);
    return index;
  }

  unsigned turn_at(unsigned column, unsigned row) const {
    if (column < 4 && row > 3) return 0;
    unsigned which = row > 3 ? 0 : column < 4 ? 1 : 2;
    if (slip_ == Slip::turn_of_the_other && which > 0 && number(turns, 3) == 6) which = 3 - which;
    return number(turns + 3 * which, 3);
  }

  /// The state of a region of a vector, as it lies in the map: 0 T, 1 C, 2 O.
  unsigned state(unsigned index, unsigned column, unsigned row, unsigned turn, unsigned x, unsigned y) const {
    if (index < 3) return index;
    constexpr unsigned last = side - 1;
    if (slip_ == Slip::turned_first && (turn & 1) != 0) x = std::exchange(y, last - x);
    if ((turn & 4) != 0) x = last - x;
    if ((turn & 2) != 0) y = last - y;
    if (slip_ != Slip::turned_first && (turn & 1) != 0) x = std::exchange(y, last - x);
    const unsigned book = turns + 9;
    unsigned from = 0, check = x + side * y, palette = 16, size = 17;
    if (side == 2) {
      const bool left = column < 4 || slip_ == Slip::entries_of_the_left;
      const unsigned quadrant = (row < 4 ? 2u : 0u) + (left ? 0u : 1u);
      size = 5, palette = 4;
      from = book + 5 * (index < 6 ? index - 3 : 2 * quadrant + index - 3);
    } else if (index < 8) {
      constexpr std::array<unsigned, 5> first{0, 17, 34, 51, 69};
      from = book + first[index - 3];
      if (index > 5) size = 18;
      if (index == 6) palette += x / 2;
      if (index == 7) palette += y / 2;
    } else {
      const unsigned quarter = x / 2 + 2 * (y / 2);
      size = 20;
      from = book + 87 + 20 * (index - 8);
      check = 5 * quarter + x % 2 + 2 * (y % 2);
      palette = 5 * quarter + 4;
    }
    if (slip_ == Slip::entries_one_on && index < (side == 2 ? 6u : 15u) && x == last && y == last)
      check += size;
    if (bit(from + check) != 0) return 1;
    return 2 * bit(from + palette);
  }

  const BlockBytes<Format>& block_;
  Slip slip_;
};

/// A mutant that decodes whole maps only, with a slip.
template <class Format>
auto slips(Slip slip) {
  return [slip](Functions& functions) {
    functions.codec<Format>().regions = {};
    functions.codec<Format>().decode = [slip](const BlockBytes<Format>& block) {
      return SlippingDecoder<Format>(block, slip).map();
    };
  };
}

}  // namespace mmverify::proofs::vq
