#include "bench/vq/rivals/brushes.hpp"

#include <bit>
#include <stdexcept>

#include "bench/vq/rivals/painter.hpp"

namespace mmverify::bench::rivals {
namespace {

constexpr std::uint32_t no_brush = 3;

std::uint32_t coordinate_bits(std::uint32_t side) {
  return static_cast<std::uint32_t>(std::countr_zero(side));
}
std::uint32_t brush_bits(std::uint32_t side) { return 2 + 3 + 3 * coordinate_bits(side) + 2; }

/// The colour of brush k.  It is the last field, so that no_brush is seen first.
std::uint32_t colour_of(Words words, std::uint32_t side, std::uint32_t k) {
  return field(words, (k + 1) * brush_bits(side) - 2, 2);
}

Brush brush_of(Words words, std::uint32_t side, std::uint32_t k) {
  const std::uint32_t b = coordinate_bits(side), low = (1u << b) - 1;
  const std::uint32_t code = field(words, k * brush_bits(side), brush_bits(side));
  return {static_cast<BrushShape>(code & 3),
          code >> 2 & 7,
          code >> 5 & low,
          code >> (5 + b) & low,
          code >> (5 + 2 * b) & low,
          static_cast<State>(code >> (5 + 3 * b) & 3)};
}

std::uint32_t brushes_in(Words words, std::uint32_t side) {
  return Brushes::most(side, static_cast<std::uint32_t>(64 * words.size()));
}

}  // namespace

bool covers(const Brush& brush, std::int32_t x, std::int32_t y) {
  constexpr std::int32_t directions[8][2] = {{1, 0}, {2, 1},  {1, 1},  {1, 2},
                                             {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}};
  const std::int32_t dx = x - static_cast<std::int32_t>(brush.x), dy = y - static_cast<std::int32_t>(brush.y),
                     e = static_cast<std::int32_t>(brush.size);
  if (brush.shape == BrushShape::disc) return dx * dx + dy * dy <= e * e + e;
  const auto [a, b] = directions[brush.direction];
  const std::int32_t along = a * dx + b * dy, across = a * dy - b * dx, most = e * e * (a * a + b * b),
                     k = brush.shape == BrushShape::square     ? 1
                         : brush.shape == BrushShape::half_bar ? 2
                                                               : 4;
  return along * along <= most && k * k * across * across <= most;
}

std::uint32_t Brushes::most(std::uint32_t side, std::uint32_t budget) { return budget / brush_bits(side); }

Bits Brushes::encode(States map, std::uint32_t budget) const {
  const std::uint32_t side = checked_side(map, 2);
  if ((side != 16 && side != 32) || most(side, budget) == 0)
    throw std::invalid_argument("vq rivals: brushes paint 16x16 or 32x32 regions, in bits for one at least");
  Painter painter(map, side);
  std::vector<Brush> painting = painter.greedy(most(side, budget));
  if (mutations > 0) painting = painter.mutated(painting, most(side, budget), mutations, seed);
  Bits bits;
  const std::uint32_t b = coordinate_bits(side);
  for (std::uint32_t k = 0; k < most(side, budget); ++k) {
    const bool there = k < painting.size();
    const Brush brush = there ? painting[k] : Brush{};
    bits.put(static_cast<std::uint32_t>(brush.shape), 2);
    bits.put(brush.direction, 3);
    bits.put(brush.size, b);
    bits.put(brush.x, b);
    bits.put(brush.y, b);
    bits.put(there ? static_cast<std::uint32_t>(brush.colour) : no_brush, 2);
  }
  return bits;
}

std::vector<State> Brushes::decode(Words words, std::uint32_t side) const {
  std::vector<State> map(std::size_t{side} * side, State::C);
  for (std::uint32_t k = brushes_in(words, side); k-- > 0;) {
    if (colour_of(words, side, k) == no_brush) continue;
    const Brush brush = brush_of(words, side, k);
    for (std::uint32_t at = 0; at < side * side; ++at)
      if (covers(brush, static_cast<std::int32_t>(at % side), static_cast<std::int32_t>(at / side)))
        map[at] = brush.colour;
  }
  return map;
}

State Brushes::region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const {
  for (std::uint32_t k = 0; k < brushes_in(words, side); ++k) {
    if (colour_of(words, side, k) == no_brush) continue;
    const Brush brush = brush_of(words, side, k);
    if (covers(brush, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y))) return brush.colour;
  }
  return State::C;
}

}  // namespace mmverify::bench::rivals
