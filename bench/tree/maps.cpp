#include "bench/tree/maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/textures/leaves.hpp"
#include "impl/index/index.hpp"

namespace mmverify::bench {
namespace {

using impl::tree::Format;
using impl::tree::Level;

struct Painter {
  const Leaves& leaves;
  Level n;
  std::uint32_t b;
  std::vector<std::uint8_t>& map;

  void put(std::uint64_t k, std::uint32_t state) {
    const std::uint64_t bit = k * b;
    map[bit / 8] = static_cast<std::uint8_t>(map[bit / 8] | state << (bit % 8));
  }

  void node(Level d, std::uint32_t k, const Leaves::Near& above) {
    const double side = std::ldexp(1.0, -static_cast<int>(d));
    std::array<LeafPoint, 3> corner{};
    LeafPoint centre{0, 0};
    const impl::index::Corners on_grid = impl::index::corners(k, d);
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = {on_grid[c].i * side, on_grid[c].j * side};
      centre.x += corner[c].x / 3;
      centre.y += corner[c].y / 3;
    }
    // No corner is farther than sqrt(5)/3 sides from the centre.
    const double radius = 0.7454 * side;
    const Leaves::Near near = leaves.near(above, centre, radius);
    const double at_centre = leaves(near, centre);
    const std::uint32_t state = at_centre < 0;
    const bool one_side = std::abs(at_centre) > leaves.slope() * radius;
    if (one_side) {
      const std::uint64_t run = std::uint64_t{1} << (2 * (n - d));
      if (state == 0) return;
      if (run * b < 8)
        for (std::uint64_t j = 0; j < run; ++j) put(k * run + j, 1);
      else
        std::fill_n(map.begin() + static_cast<std::ptrdiff_t>(k * run * b / 8), run * b / 8,
                    static_cast<std::uint8_t>(b == 1 ? 0xff : 0x55));
      return;
    }
    if (d < n) {
      for (std::uint32_t c = 0; c < 4; ++c) node(d + 1, 4 * k + c, near);
      return;
    }
    bool crossed = false;
    if (b == 2)
      for (const LeafPoint& p : corner) crossed = crossed || (leaves(near, p) < 0) != (state != 0);
    put(k, state + (crossed ? 2 : 0));
  }
};

}  // namespace

std::vector<std::uint8_t> leaf_map(Level level, Format bits, std::uint64_t seed) {
  const Leaves leaves(seed, 20, 99);
  const auto b = static_cast<std::uint32_t>(bits);
  std::vector<std::uint8_t> map(static_cast<std::size_t>(((std::uint64_t{b} << (2 * level)) + 7) / 8));
  Painter{leaves, level, b, map}.node(0, 0, leaves.all());
  return map;
}

}  // namespace mmverify::bench
