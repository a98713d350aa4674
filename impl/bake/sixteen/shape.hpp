// The common geometry of nodes of sixteen of one base triangle at one level: they are one triangle, moved or turned by
// half a circle, and so are their micro-triangles and their edges.  Internal to impl/bake.
//
// It is computed in binary64, from the base triangle's sides cut to a node's, which are off by less than delta of
// impl/bake/judge/filter.hpp, and rounded once.  The errors that follow for places are in
// impl/bake/sixteen/sixteen.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "impl/bake/plane/lines.hpp"
#include "impl/bake/plane/points.hpp"

namespace mmverify::impl::bake::detail {

struct SixteenShape {
  std::array<float, 2> p01{}, p02{};  ///< x, y
  float threshold = 0, gap = 0, lean = 0, bound = 0, edge_bound = 0, beyond_bound = 0, delta = 0;
  std::array<float, 3> slope{};  ///< slopes of the lines A, B, C (impl/bake/plane/lines.hpp)
  bool ab_left = false;          ///< for micro-triangles that are turned as the node is
  bool has_flat = false;
  bool clear = false;

  /// A micro-triangle that is turned as the node is, (0, 0) (1, 0) (0, 1), or not, (1, 0) (0, 1) (1, 1), counted from
  /// (0, 0).  It has its box, grown by the margin; its rows without those beside a flat edge; and the columns where
  /// centres can be within.
  /// Lines are at row 0: `outside` is moved out by a margin and over a row, for cells; `at` is for centres.  Half a
  /// place is subtracted or added, so that floor and the number after it are the nearest whole ones; so it is in
  /// first_column and last_column.
  struct Micro {
    float left, right, top, bottom, first_row, last_row, first_column, last_column;
    std::array<float, 3> outside, at;
  };
  std::array<Micro, 2> micro{};
  /// The whole node, from its first corner, if is_small.
  Micro whole{};
  /// Whether a micro-triangle meets at most 4 rows and 4 columns of cells.
  bool is_small = false;

  /// Values by direction: (1, 0), (0, 1) and (-1, 1) from an edge's first corner.
  using OfEdges = std::array<float, 4>;
  /// Steps of an edge, and 1 / step, or 0 if the edge does not go along the axis.
  alignas(16) OfEdges dx{}, dy{}, per_x{}, per_y{};
  /// The least and the greatest dx dy / 4, and 0.
  float least_bend = 0, most_bend = 0;
  /// Boxes of edges, grown by the margin; slopes, 0 for edges that fall by less than a quarter of a texel; lines to
  /// both sides at row 0, moved out over a row, with half a place subtracted or added.
  alignas(16) OfEdges left{}, right{}, top{}, bottom{}, edge_slope{}, low{}, high{};

  SixteenShape() = default;
  /// The shape, without edges yet, of a node at p0, p0 + b, p0 + c; margin: that of its lines.
  SixteenShape(PlanePoint b, PlanePoint c, const Lines& lines, bool turned, double margin) noexcept
      : p01{static_cast<float>(b.x), static_cast<float>(b.y)},
        p02{static_cast<float>(c.x), static_cast<float>(c.y)},
        ab_left(lines.ab_left != turned),
        has_flat(lines.has_flat) {
    for (std::size_t l = 0; l < 3; ++l) slope[l] = static_cast<float>(lines.slope[l]);
    const PlanePoint across{b.x / 4, b.y / 4}, down{c.x / 4, c.y / 4},
        far{across.x + down.x, across.y + down.y};
    take_micro(micro[0], {PlanePoint{0, 0}, across, down}, lines, ab_left, margin);
    take_micro(micro[1], {across, down, far}, lines, !ab_left, margin);
    is_small = micro[0].right - micro[0].left < 2.5f && micro[0].bottom - micro[0].top < 2.5f;
    if (is_small) take_micro(whole, {PlanePoint{0, 0}, b, c}, lines, ab_left, margin);
  }
  /// Adds the edges of the same node; off: the error of its corners in binary32.
  void take_edges(PlanePoint b, PlanePoint c, double off, double margin) noexcept {
    delta = static_cast<float>(off);
    take_edge(0, {b.x / 4, b.y / 4}, off, margin);
    take_edge(1, {c.x / 4, c.y / 4}, off, margin);
    take_edge(2, {(c.x - b.x) / 4, (c.y - b.y) / 4}, off, margin);
  }

 private:
  static void take_micro(Micro& m, const Triangle& p, const Lines& lines, bool is_ab_left,
                         double margin) noexcept {
    const double low = std::min({p[0].y, p[1].y, p[2].y}), high = std::max({p[0].y, p[1].y, p[2].y}),
                 middle = std::max(std::min(p[0].y, p[1].y), std::min(std::max(p[0].y, p[1].y), p[2].y));
    const double least = std::min({p[0].x, p[1].x, p[2].x}), most = std::max({p[0].x, p[1].x, p[2].x});
    m.left = static_cast<float>(least - margin);
    m.right = static_cast<float>(most + margin);
    m.first_column = static_cast<float>(least + 0.5);
    m.last_column = static_cast<float>(most + 0.5);
    m.top = static_cast<float>(low - margin);
    m.bottom = static_cast<float>(high + margin);
    const bool above = middle - low < high - middle;
    m.first_row = static_cast<float>(lines.has_flat && above ? middle : low);
    m.last_row = static_cast<float>(lines.has_flat && !above ? middle : high);
    for (std::size_t l = 0; l < 3; ++l) {
      const double s = lines.slope[l], out = margin * (1 + std::fabs(s)) + 0.5;
      std::array<double, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = p[k].x - p[k].y * s;
      const bool is_left = is_ab_left == (l != 2);
      const double line = is_left ? std::min({at[0], at[1], at[2]}) : std::max({at[0], at[1], at[2]});
      m.outside[l] =
          static_cast<float>(is_left ? line + std::min(s, 0.0) - out : line + std::max(s, 0.0) + out);
      m.at[l] = static_cast<float>(line + 0.5);
    }
  }
  void take_edge(std::size_t e, PlanePoint to, double off, double margin) noexcept {
    const auto per = [](float d) { return d == 0 ? 0 : 1 / d; };
    dx[e] = static_cast<float>(to.x);
    dy[e] = static_cast<float>(to.y);
    per_x[e] = per(dx[e]);
    per_y[e] = per(dy[e]);
    left[e] = static_cast<float>(std::min(to.x, 0.0) - margin);
    right[e] = static_cast<float>(std::max(to.x, 0.0) + margin);
    top[e] = static_cast<float>(std::min(to.y, 0.0) - margin);
    bottom[e] = static_cast<float>(std::max(to.y, 0.0) + margin);
    // The line of a flat edge bounds nothing.
    const bool is_flat = std::fabs(to.y) < 0.25;
    const double s = is_flat ? 0 : to.x / to.y, out = is_flat ? 1e6 : 16 * off * (1 + std::fabs(s));
    edge_slope[e] = static_cast<float>(s);
    low[e] = static_cast<float>(std::min(s, 0.0) - out - 0.5);
    high[e] = static_cast<float>(std::max(s, 0.0) + out + 0.5);
    least_bend = std::min(least_bend, dx[e] * dy[e] * 0.25f);
    most_bend = std::max(most_bend, dx[e] * dy[e] * 0.25f);
  }
};

}  // namespace mmverify::impl::bake::detail
