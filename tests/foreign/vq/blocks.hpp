// Parts that both formats share: states, quadrants, bits of a block, and transforms.
#pragma once

#include <cstdint>

namespace mmverify::tests::foreign::vq {

enum State : std::uint8_t { T = 0, C = 1, O = 2 };
enum Quadrant { TL = 0, TR = 1, BL = 2, BR = 3 };

/// The quadrant of the vector (X, Y), 0 <= X, Y < 8; y counts from the bottom.
inline int quadrant_of(int X, int Y) { return (X < 4 ? 0 : 1) + (Y < 4 ? 2 : 0); }

/// `count` bits of a block from bit `first` on, least significant first.
inline unsigned bits(const std::uint8_t* block, int first, int count) {
  std::uint64_t word = 0;
  for (int byte = first / 8; byte <= (first + count - 1) / 8; ++byte)
    word |= static_cast<std::uint64_t>(block[byte]) << (8 * (byte - first / 8));
  return static_cast<unsigned>(word >> (first % 8)) & ((1u << count) - 1);
}

inline void set_bits(std::uint8_t* block, int first, int count, unsigned word) {
  for (int k = 0; k < count; ++k) {
    std::uint8_t& byte = block[(first + k) / 8];
    const unsigned bit = 1u << ((first + k) % 8);
    byte = static_cast<std::uint8_t>((word >> k & 1u) != 0 ? byte | bit : byte & ~bit);
  }
}

struct Region {
  int x, y;
};

/// The region of a stored vector of n x n that shows at `p` once the transform is applied.
///   Table 1 applies R90, then TB, then LR, to the vector; so the coordinate undoes LR, TB, R90.
inline Region stored_at(unsigned transform, Region p, int n) {
  if ((transform & 4u) != 0) p.x = n - 1 - p.x;
  if ((transform & 2u) != 0) p.y = n - 1 - p.y;
  if ((transform & 1u) != 0) p = {p.y, n - 1 - p.x};
  return p;
}

/// How a region is asked for: some faults are in one of the two ways alone.
enum class Way { whole, region };

struct Format {
  int side;    // regions along a side of the map
  int vector;  // regions along a side of a vector
  int index_bits;
  int transforms;  // the first bit of TR's
};

inline constexpr Format vq2{16, 2, 3, 192};
inline constexpr Format vq4{32, 4, 4, 256};

inline unsigned index_at(const Format& f, const std::uint8_t* block, int X, int Y) {
  return bits(block, f.index_bits * (X + 8 * Y), f.index_bits);
}

inline unsigned transform_of(const Format& f, const std::uint8_t* block, int quadrant) {
  return quadrant == TL ? 0 : bits(block, f.transforms + 3 * (quadrant - 1), 3);
}

}  // namespace mmverify::tests::foreign::vq
