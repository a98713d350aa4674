// One base triangle, from the whole down the curve.  Internal to impl/bake*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "impl/bake_codes.hpp"
#include "impl/bake_spot.hpp"
#include "impl/bake_triangles.hpp"

namespace mmverify::impl::bake::detail {

/// Children in the order and with the corners of impl/index.hpp.
/// Judge: what texels bear about a triangle, and the states of single micro-triangles and of four.
template <class Judge>
class Descent {
 public:
  Descent(const Judge& judge, std::uint8_t* map) noexcept : judge_(judge), map_(map) {}

  /// Level 0: one state, in the low bits of a byte.
  void single(const Triangle& p) { *map_ = static_cast<std::uint8_t>(judge_.single(p, false, 0, counts)); }

  /// A node of 4^height micro-triangles, the first of them at `index`.  Domain: height > 0.
  void node(const Triangle& p, bool turned, std::uint32_t height, std::uint32_t index) {
    const Marks all = judge_.texels(p);
    if (all != both) {
      std::memset(map_ + index / 4, all == opaque ? 0x55 : 0, std::size_t{1} << (2 * height - 2));
      return;
    }
    if (height == 2) {
      const std::uint32_t codes = judge_.sixteen(p, turned, index, counts);
      for (std::uint32_t k = 0; k < 4; ++k) map_[index / 4 + k] = static_cast<std::uint8_t>(codes >> (8 * k));
      return;
    }
    const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    if (height == 1) {
      map_[index / 4] = static_cast<std::uint8_t>(judge_.four(p, p01, p02, p12, turned, index, counts));
      return;
    }
    const std::uint32_t child = std::uint32_t{1} << (2 * height - 2);
    node({p[0], p01, p02}, turned, height - 1, index);
    node({p02, p12, p01}, !turned, height - 1, index + child);
    node({p01, p[1], p12}, turned, height - 1, index + 2 * child);
    node({p12, p02, p[2]}, turned, height - 1, index + 3 * child);
  }

  BakeCounts counts;

 private:
  const Judge& judge_;
  std::uint8_t* map_;
};

}  // namespace mmverify::impl::bake::detail
