// How a bilinearly sampled micro-triangle is judged.  Internal to impl/bake*.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "impl/bake_base.hpp"
#include "impl/bake_codes.hpp"
#include "impl/bake_filter.hpp"
#include "impl/bake_inner_box.hpp"
#include "impl/bake_sides.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class Bilinear {
 public:
  /// Coordinates' offset from those of texels.
  static constexpr double offset = 0.5;

  /// `inner`: of a micro-triangle that is not turned.
  Bilinear(const SidesOf<Texel>& sides, const ExactBase& exact, const InnerBox& inner, double delta,
           double margin) noexcept
      : filter_(sides, delta, margin),
        exact_(exact),
        inner_(sides, inner, margin, delta),
        lean_(sides.limits.blend ? -0.5 * sides.gap : 0) {}

  Marks texels(const Triangle& p) const noexcept { return filter_.texels(filter_.box(p)); }

  /// One of no quad.
  unsigned single(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    Quad quad;
    return leaf(p, {filter_.g(p[0]), filter_.g(p[1]), filter_.g(p[2])}, turned, index, quad, {own, own, own},
                counts);
  }

  /// The four children of a node, in one byte; their six corners sampled once.
  unsigned four(const Triangle& p, Spot p01, Spot p02, Spot p12, bool turned, std::uint32_t index,
                BakeCounts& counts) const {
    const double g0 = filter_.g(p[0]), g1 = filter_.g(p[1]), g2 = filter_.g(p[2]), g01 = filter_.g(p01),
                 g02 = filter_.g(p02), g12 = filter_.g(p12);
    Quad quad;
    return leaf({p[0], p01, p02}, {g0, g01, g02}, turned, index, quad, {own, 0, own}, counts) |
           leaf({p02, p12, p01}, {g02, g12, g01}, !turned, index + 1, quad, {2, 1, 0}, counts) << 2 |
           leaf({p01, p[1], p12}, {g01, g1, g12}, turned, index + 2, quad, {own, own, 1}, counts) << 4 |
           leaf({p12, p02, p[2]}, {g12, g02, g2}, turned, index + 3, quad, {2, own, own}, counts) << 6;
  }

 private:
  /// The edges between the four children of a node, each asked at most once: 0 p01 p02, 1 p01 p12, 2 p02 p12.
  struct Quad {
    std::array<Marks, 3> edge{};
  };
  static constexpr std::size_t own = 3;  ///< an edge of no other child

  /// `edges`: which of the quad's the edges p0 p1, p1 p2, p2 p0 are.
  unsigned leaf(const Triangle& p, const std::array<double, 3>& g, bool turned, std::uint32_t index,
                Quad& quad, const std::array<std::size_t, 3>& edges, BakeCounts& counts) const {
    const Spot centroid{(p[0].x + p[1].x + p[2].x) * (1.0 / 3), (p[0].y + p[1].y + p[2].y) * (1.0 / 3)};
    Marks marks = filter_.usable()
                      ? static_cast<Marks>(filter_.side(g[0]) | filter_.side(g[1]) | filter_.side(g[2]))
                      : uncertain;
    if (marks != both) {
      const auto box = filter_.box(p);
      const Marks all = filter_.texels(box);
      if (all != both) return settled(all);
      if (marks != uncertain) marks = judged(p, g, box, centroid, marks, turned, quad, edges);
    }
    ++counts.leaves;
    if (marks == opaque || marks == below) return settled(marks);
    if (marks == both) {
      const double at = filter_.g(centroid) - lean_;
      if (std::fabs(at) > filter_.bound()) return at > 0 ? unknown | 1 : unknown;
    }
    ++counts.exact;
    return code_of(exact_(index));
  }

  /// Of a triangle whose texels bear both marks; `seen` at its corners.
  Marks judged(const Triangle& p, const std::array<double, 3>& g,
               const typename BilinearFilter<Texel>::Box& box, Spot centroid, Marks seen, bool turned,
               Quad& quad, const std::array<std::size_t, 3>& edges) const {
    seen = static_cast<Marks>(seen | inner_.centres(centroid, turned));
    if (seen == both) return both;
    if (filter_.margin() != 0) {
      seen = static_cast<Marks>(seen | outline(p, seen));
      if ((seen & both) == both) return both;
    }
    for (std::size_t k = 0; k < 3 && filter_.margin() == 0; ++k) {
      const std::size_t next = k == 2 ? 0 : k + 1;
      Marks marks = edges[k] == own ? Marks{0} : quad.edge[edges[k]];
      if (marks == 0) marks = filter_.edge(p[k], p[next], g[k], g[next]);
      if (edges[k] != own) quad.edge[edges[k]] = marks;
      seen = static_cast<Marks>(seen | marks);
      if ((seen & both) == both) return both;
    }
    const Marks within = filter_.centres(p, box, seen);
    if ((seen & uncertain) == 0 && (seen | within) == seen) return seen;
    return ((seen | (within & filter_.clear())) & both) == both ? both : uncertain;
  }

  /// Of the segments of the dilated triangle, until both marks are seen.
  Marks outline(const Triangle& p, Marks seen) const {
    const double m = filter_.margin();
    std::array<Spot, 12> moved;
    std::array<double, 12> g;
    for (std::size_t k = 0; k < 12; ++k) {
      const Spot at = p[k / 4];
      moved[k] = {k % 4 < 2 ? at.x - m : at.x + m, k % 4 == 0 || k % 4 == 3 ? at.y - m : at.y + m};
      g[k] = filter_.g(moved[k]);
      seen = static_cast<Marks>(seen | filter_.side(g[k]));
    }
    const auto take = [&](std::size_t from, std::size_t to) {
      if ((seen & both) != both)
        seen = static_cast<Marks>(seen | filter_.edge(moved[from], moved[to], g[from], g[to]));
    };
    for (std::size_t k = 0; k < 12; ++k) {
      take(k, k / 4 * 4 + (k + 1) % 4);
      take(k, (k + 4) % 12);
    }
    return seen;
  }

  BilinearFilter<Texel> filter_;
  const ExactBase& exact_;
  Within inner_;
  double lean_;  ///< g where alpha begins to lean to opaque: blended, half of the way from 1 to 0
};

}  // namespace mmverify::impl::bake::detail
