// A walk of one base triangle, from the whole down the curve.  Internal to impl/bake.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "impl/bake/judge/codes.hpp"
#include "impl/bake/plane/points.hpp"
#include "impl/bake/sixteen/sixteen.hpp"
#include "impl/bake/touched.hpp"
#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake::detail {

/// Bakes a map by cutting nodes until texels settle them.  Children have the order and the corners of
/// impl/index/index.hpp.  Judge computes the marks of a triangle's texels, those of the sixteen nodes that a node is
/// cut into, and the states of micro-triangles: one, four, sixteen, or four times sixteen at once.
template <class Judge>
class Descent {
 public:
  Descent(const Judge& judge, std::uint8_t* map) noexcept : judge_(judge), map_(map) {}

  /// Level 0: one state, in the low bits of a byte.
  void single(const Triangle& p) { *map_ = static_cast<std::uint8_t>(judge_.single(p, false, 0, counts)); }

  /// Bakes a node of 4^height micro-triangles, the first of them at `index`.  Domain: height > 0.
  void node(const Triangle& p, bool turned, std::uint32_t height, std::uint32_t index) {
    const Marks all = judge_.texels(p);
    if (all != both)
      fill(all, height, index);
    else
      cut(p, turned, height, index);
  }

  /// Bakes one node of the base triangle p.
  void part(Triangle p, std::uint32_t level, const Node& one) {
    bool turned = false;
    for (std::uint32_t height = level; height > one.height;) {
      --height;
      const std::uint32_t child = one.index >> (2 * height) & 3;
      p = children(p)[child];
      turned = turned != (child == 1);
    }
    if (one.height == 0)
      single(p);
    else
      node(p, turned, one.height, one.index);
  }

  BakeCounts counts;

 private:
  void fill(Marks all, std::uint32_t height, std::uint32_t index) {
    std::memset(map_ + index / 4, all == opaque ? 0x55 : 0, std::size_t{1} << (2 * height - 2));
  }

  /// Stores the states of a node of sixteen.
  void store(std::uint32_t codes, std::uint32_t index) {
    for (std::uint32_t k = 0; k < 4; ++k) map_[index / 4 + k] = static_cast<std::uint8_t>(codes >> (8 * k));
  }

  /// Bakes those quarters of a node, nodes of sixteen, that are wanted; false if the judge does not take them together.
  bool together(const Triangle& p, bool turned, std::uint32_t index, std::uint32_t wanted) {
    std::array<std::uint32_t, 4> codes{};
    if (!judge_.sixty_four(p, turned, index, wanted, counts, codes)) return false;
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((wanted >> c & 1) != 0) store(codes[c], index + 16 * c);
    return true;
  }

  /// Bakes a node whose texels bear both marks.
  void cut(const Triangle& p, bool turned, std::uint32_t height, std::uint32_t index) {
    if (height == 2) return store(judge_.sixteen(p, turned, index, counts), index);
    if (height == 1) {
      map_[index / 4] = static_cast<std::uint8_t>(
          judge_.four(p, middle(p[0], p[1]), middle(p[0], p[2]), middle(p[1], p[2]), turned, index, counts));
      return;
    }
    if (height == 3 && together(p, turned, index, 15)) return;
    const std::uint32_t child = std::uint32_t{1} << (2 * height - 2);
    const auto sixteen = height >= 4 ? judge_.sixteen_nodes(p, turned, height, index) : SixteenNodes{};
    const std::uint32_t left = ~sixteen.of_one_mark & 0xffff;
    for (std::uint32_t k = 0; k < 16; ++k)
      if ((left >> k & 1) == 0)
        fill((sixteen.opaque >> k & 1) != 0 ? opaque : below, height - 2, index + k * (child / 4));
    const std::array<Triangle, 4> of = children(p);
    for (std::uint32_t c = 0; c < 4; ++c) {
      const bool is_turned = turned != (c == 1);
      if (sixteen.known)
        quarter(of[c], is_turned, height - 1, index + c * child, left >> (4 * c) & 15);
      else
        node(of[c], is_turned, height - 1, index + c * child);
    }
  }

  /// Bakes those children of a node that are left.
  void quarter(const Triangle& p, bool turned, std::uint32_t height, std::uint32_t index,
               std::uint32_t left) {
    if (left == 0 || (height == 3 && together(p, turned, index, left))) return;
    const std::uint32_t child = std::uint32_t{1} << (2 * height - 2);
    const std::array<Triangle, 4> of = children(p);
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((left >> c & 1) != 0) cut(of[c], turned != (c == 1), height - 1, index + c * child);
  }

  const Judge& judge_;
  std::uint8_t* map_;
};

}  // namespace mmverify::impl::bake::detail
