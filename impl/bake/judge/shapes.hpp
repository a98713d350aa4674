// The shapes of a base triangle's nodes, each made when first asked for: a triangle has few nodes of most heights.
// Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "impl/bake/plane/lines.hpp"
#include "impl/bake/plane/points.hpp"
#include "impl/bake/sixteen/bounds.hpp"
#include "impl/bake/sixteen/sixteen.hpp"
#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake::detail {

class NodeShapes {
 public:
  /// The numbers of a texture that a shape keeps.
  struct Stored {
    double threshold, gap, lean;
    double scale, clear;  ///< as in take_bounds()
  };

  /// The shapes of a triangle's nodes; none if lines are not usable.  One thread uses them.
  /// Domain: delta is the error of coordinates in binary64.
  NodeShapes(const Triangle& base, std::uint32_t level, const Lines& lines, double delta,
             const Stored& stored) noexcept
      : b_{base[1].x - base[0].x, base[1].y - base[0].y},
        c_{base[2].x - base[0].x, base[2].y - base[0].y},
        extent_(std::max(std::max({b_.x, c_.x, 0.0}) - std::min({b_.x, c_.x, 0.0}),
                         std::max({b_.y, c_.y, 0.0}) - std::min({b_.y, c_.y, 0.0}))),
        level_(level),
        lines_(lines),
        delta_(delta),
        stored_(stored) {
    if (!lines.usable) return;
    shares_ = is_shared(2);
    largest_ = 2;
    for (std::uint32_t height = 4; height <= level; ++height) {
      if (sixteen_size(extent_ * part(height)) > sixteen_window) return;
      largest_ = height;
    }
  }

  /// The largest height with shapes; 0: none.
  std::uint32_t largest() const noexcept { return largest_; }
  /// Whether four nodes of sixteen share a window.
  bool share() const noexcept { return shares_; }

  /// The shape of a node.  Reversed: its edge p0 p1 goes against the base triangle's.
  /// Domain: height 2, or 4..largest().
  const SixteenShape& operator()(std::uint32_t height, bool reversed, bool turned) const noexcept {
    const std::size_t k = 4 * height + 2 * std::size_t{reversed} + std::size_t{turned};
    if ((made_ >> k & 1) == 0) make(k);
    return rooms_[k].shape;
  }

 private:
  /// The size below which four nodes share a window.
  static constexpr double most_shared_size = 32;

  /// The length of a node over the base triangle's.
  double part(std::uint32_t height) const noexcept {
    return static_cast<double>(std::uint32_t{1} << height) / static_cast<double>(std::uint32_t{1} << level_);
  }
  bool is_shared(std::uint32_t height) const noexcept {
    return height == 2 && sixteen_size(2 * extent_ * part(height)) < most_shared_size;
  }

  void make(std::size_t k) const noexcept {
    const auto height = static_cast<std::uint32_t>(k / 4);
    const double cut = part(height),
                 size = sixteen_size(is_shared(height) ? 2 * extent_ * cut : extent_ * cut);
    const PlanePoint b{b_.x * cut, b_.y * cut}, c{c_.x * cut, c_.y * cut};
    // Not turned; turned; and both with the edge p0 p1 reversed.
    const std::array<std::array<PlanePoint, 2>, 4> of_nodes{{{b, c},
                                                             {b, {b.x - c.x, b.y - c.y}},
                                                             {{{-b.x, -b.y}, {c.x - b.x, c.y - b.y}}},
                                                             {{{-b.x, -b.y}, {-c.x, -c.y}}}}};
    const auto& [to1, to2] = of_nodes[k % 4];
    const double margin = sixteen_margin(size, delta_);
    SixteenShape& of = *std::construct_at(&rooms_[k].shape, to1, to2, lines_, k % 2 == 1, margin);
    made_ |= std::uint64_t{1} << k;
    if (height != 2) return;
    const double off = sixteen_delta(size, delta_);
    of.take_edges(to1, to2, off, margin);
    of.threshold = static_cast<float>(stored_.threshold);
    of.gap = static_cast<float>(stored_.gap);
    of.lean = static_cast<float>(stored_.lean);
    take_bounds(of, stored_.scale, stored_.clear, off);
  }

  /// Room for a shape.  Clearing all of them would take longer than to bake a small triangle.
  union Room {
    Room() noexcept {}
    SixteenShape shape;
  };
  static_assert(std::is_trivially_destructible_v<SixteenShape>);
  static_assert(4 * (max_bake_level + 1) <= 64);

  PlanePoint b_, c_;  ///< the base triangle's edges from its first corner
  double extent_;
  std::uint32_t level_;
  Lines lines_;
  double delta_;
  Stored stored_;
  std::uint32_t largest_ = 0;
  bool shares_ = false;
  mutable std::array<Room, 4 * (max_bake_level + 1)> rooms_;
  mutable std::uint64_t made_ = 0;  ///< bit k: rooms_[k] has its shape
};

}  // namespace mmverify::impl::bake::detail
