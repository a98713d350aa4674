// Paint by brush: a square opacity map as a fixed number of brushes, one above the other on a ground of C.
//
// Compressed Opacity Maps, 6.1: "controlled by using brush type, size, rotation, centre position, and 'colour'"; a
// region is read "by testing for inclusion in all the 'applied brushes' in parallel".  The paper has no numbers, no
// list of shapes and no encoder.  This reading, in whole numbers alone: with (dx, dy) from the brush's centre
// region, a direction (a, b) and e its size,
//   disc            dx^2 + dy^2 <= e^2 + e
//   square, bars    (a dx + b dy)^2 <= e^2 (a^2 + b^2)  and  k^2 (a dy - b dx)^2 <= e^2 (a^2 + b^2),  k = 1, 2, 4
//   directions      (1,0) (2,1) (1,1) (1,2) (0,1) (-1,2) (-1,1) (-2,1): about every 22 degrees
// Bits of a brush on side x side regions: 2 shape, 3 direction, and log2 side each of size, x, y, then 2 colour (0 T,
// 1 C, 2 O, 3 none): 19 of 16x16, 13 brushes in 256 bits; 22 of 32x32, 23 in 512.  The first brush lies on top.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/vq/rivals/bits.hpp"
#include "bench/vq/rivals/prune.hpp"

namespace mmverify::bench::rivals {

enum class BrushShape : std::uint8_t { square, disc, half_bar, quarter_bar };

struct Brush {
  BrushShape shape = BrushShape::square;
  std::uint32_t direction = 0, size = 0, x = 0, y = 0;
  State colour = State::C;
};

/// Whether the brush covers region (x, y), inside the map or not.
bool covers(const Brush& brush, std::int32_t x, std::int32_t y);

struct Brushes {
  std::uint32_t mutations = 0;  ///< tried after the greedy painting
  std::uint64_t seed = 1;       ///< of the mutations

  /// The number of brushes that fit the budget.
  static std::uint32_t most(std::uint32_t side, std::uint32_t budget);

  /// The brushes of a map, found greedily from the top: each is the brush of T or O that gives most regions
  /// their state, and no region that is not covered yet a wrong one.  Other paintings are tried too: half the
  /// brushes or fewer of one colour on top, then brushes of C on open regions that are not of the other
  /// colour, then the other colour below.  The best painting is then mutated, one brush at a time; a mutation
  /// that makes a region wrong or loses more is taken back (Johansson's way, by which the paper was
  /// inspired).  Some O and T become C, and nothing else changes.
  /// Errors: std::invalid_argument unless the map is 16x16 or 32x32 and the budget has room for a brush.
  Bits encode(States map, std::uint32_t budget) const;
  /// The map of side x side regions.  Domain: `words` of the budget's length from encode() for such a map.
  std::vector<State> decode(Words words, std::uint32_t side) const;
  /// One region of the map.  Domain: the same; x and y below side.
  State region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const;
};

}  // namespace mmverify::bench::rivals
