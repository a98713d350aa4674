// How a bilinearly sampled micro-triangle is judged.  Internal to impl/bake*.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "impl/bake_base.hpp"
#include "impl/bake_codes.hpp"
#include "impl/bake_filter.hpp"
#include "impl/bake_inner_box.hpp"
#include "impl/bake_sides.hpp"
#include "impl/bake_sixteen.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class Bilinear {
 public:
  /// Coordinates' offset from those of texels.
  static constexpr double offset = 0.5;

  /// `inner`: of a micro-triangle that is not turned.
  Bilinear(const SidesOf<Texel>& sides, const ExactBase& exact, const InnerBox& inner, double delta,
           double margin) noexcept
      : sides_(sides),
        filter_(sides, delta, margin),
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

  /// The sixteen of a node, in four bytes: those that SIMD decides, and one by one those that it does not.
  std::uint32_t sixteen(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    std::optional<SixteenMarks> marks;
    if constexpr (!std::is_same_v<Texel, float>)
      if (in_vectors()) marks = asked(p, filter_.box(p), false);
    const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    const std::array<Triangle, 4> children{
        Triangle{p[0], p01, p02}, {p02, p12, p01}, {p01, p[1], p12}, {p12, p02, p[2]}};
    std::uint32_t codes = 0, left = 0xffff;
    if (marks) {
      const std::uint32_t unknowns = marks->below & marks->opaque,
                          leaning = unknowns & marks->leans_to_opaque;
      const std::uint32_t decided = marks->lacks_below | marks->lacks_opaque | (unknowns & marks->leans);
      counts.leaves += static_cast<std::uint64_t>(std::popcount(decided & ~marks->by_texels));
      codes = spread(decided & (leaning | marks->lacks_below)) | spread(decided & unknowns) << 1;
      left = ~decided & 0xffff;
    }
    for (std::uint32_t c = 0; c < 4; ++c) {
      if ((left >> (4 * c) & 15) == 0) continue;
      const Triangle& q = children[c];
      const bool is_turned = turned != (c == 1);
      const Spot q01 = middle(q[0], q[1]), q02 = middle(q[0], q[2]), q12 = middle(q[1], q[2]);
      if (!marks) {
        codes |= four(q, q01, q02, q12, is_turned, index + 4 * c, counts) << (8 * c);
        continue;
      }
      const std::array<Triangle, 4> of{
          Triangle{q[0], q01, q02}, {q02, q12, q01}, {q01, q[1], q12}, {q12, q02, q[2]}};
      for (std::uint32_t k = 4 * c; k < 4 * c + 4; ++k)
        if ((left >> k & 1) != 0)
          codes |= lone(of[k % 4], is_turned != (k % 4 == 1), index + k, *marks, k, counts) << (2 * k);
    }
    return codes;
  }

 private:
  /// The edges between the four children of a node, each asked at most once: 0 p01 p02, 1 p01 p12, 2 p02 p12.
  struct Quad {
    std::array<Marks, 3> edge{};
  };
  static constexpr std::size_t own = 3;  ///< an edge of no other child

  /// Bit k to bit 2k.
  static std::uint32_t spread(std::uint32_t x) noexcept {
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
  }

  using Box = typename BilinearFilter<Texel>::Box;

  /// Whether vectors are asked.
  bool in_vectors() const noexcept {
    return !std::is_same_v<Texel, float> && filter_.usable() && filter_.margin() == 0 &&
           sides_.pitch() <= std::size_t{1} << 20;
  }

  /// Nothing is certain where it is too large.
  SixteenMarks asked(const Triangle& p, const Box& box, bool as_one) const {
    // One more all round, for what binary32 is off.
    const std::int64_t left = box.left - 1, right = box.right + 1, top = box.top - 1, bottom = box.bottom + 1;
    const std::int64_t width = right - left + 1, height = bottom - top + 1, size = std::max(width, height);
    if (size > 256) return {};
    const auto x = static_cast<double>(left), y = static_cast<double>(top);
    const double delta = filter_.delta() + 0x1p-20 * static_cast<double>(size);
    SixteenInput in{};
    in.p0 = {static_cast<float>(p[0].x - x), static_cast<float>(p[0].y - y)};
    in.p01 = {static_cast<float>(p[1].x - p[0].x), static_cast<float>(p[1].y - p[0].y)};
    in.p02 = {static_cast<float>(p[2].x - p[0].x), static_cast<float>(p[2].y - p[0].y)};
    in.threshold = static_cast<float>(sides_.threshold);
    in.gap = static_cast<float>(sides_.gap);
    in.lean = static_cast<float>(lean_);
    in.bound = static_cast<float>(sides_.scale * (2 * delta + 0x1p-19));
    in.edge_bound = static_cast<float>(sides_.scale * (24 * delta + 0x1p-17));
    in.delta = static_cast<float>(delta);
    in.clear = std::min(sides_.clear_below, sides_.clear_opaque) > 8 * delta * sides_.scale;
    in.as_one = as_one;
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    std::array<std::uint32_t, sixteen_window> opaque_rows, visible_rows;
    const auto picture = sides_.in_one_picture(left, right, top, bottom);
    if (picture) {
      in.texels = picture->first;
      in.pitch = static_cast<std::int32_t>(sides_.pitch());
    }
    if (size > sixteen_window) {
      if (!picture) return {};
      in.bits_opaque = sides_.opaque_plane().row_bytes(picture->top);
      in.bits_visible = sides_.visible_plane().row_bytes(picture->top);
      in.bit_x = static_cast<std::int32_t>(picture->left);
      in.bit_pitch = static_cast<std::int32_t>(sides_.opaque_plane().row_pitch());
      return detail::sixteen<Texel>(in);
    }
    in.rows_opaque = opaque_rows.data();
    in.rows_visible = sides_.limits.blend ? visible_rows.data() : opaque_rows.data();
    if (picture) {
      sides_.rows(picture->left, picture->top, rows, opaque_rows.data(), visible_rows.data());
      return detail::sixteen<Texel>(in);
    }
    constexpr std::size_t pitch = sixteen_window;
    std::array<Texel, pitch * sixteen_window + 4> texels;  // 4 bytes from the last can be read
    sides_.copy(left, top, columns, rows, pitch, texels.data(), opaque_rows.data(), visible_rows.data());
    in.texels = texels.data();
    in.pitch = pitch;
    return detail::sixteen<Texel>(in);
  }

  /// Micro-triangle k of a node that was asked and left it undecided.
  unsigned lone(const Triangle& p, bool turned, std::uint32_t index, const SixteenMarks& node,
                std::uint32_t k, BakeCounts& counts) const {
    const Box box = filter_.box(p);
    const Marks all = filter_.texels(box);
    if (all != both) return settled(all);
    const Spot centroid = centroid_of(p);
    Marks marks = static_cast<Marks>((node.below >> k & 1 ? below : 0) | (node.opaque >> k & 1 ? opaque : 0));
    if (marks != both) marks = static_cast<Marks>(marks | inner_.centres(centroid, turned));
    if (marks != both) marks = by_parts(p, box);
    if ((marks & uncertain) != 0) return single(p, turned, index, counts);
    ++counts.leaves;
    if (marks != both) return settled(marks);
    if ((node.leans >> k & 1) != 0) return node.leans_to_opaque >> k & 1 ? unknown | 1 : unknown;
    return leaning(centroid, index, counts);
  }

  /// What a triangle bears, whose texels bear both marks: that of its parts, which are all of it.
  Marks by_parts(const Triangle& p, const Box& box) const {
    const std::int64_t size = std::max(box.right - box.left, box.bottom - box.top);
    if (size > 2048) return uncertain;
    if (size < sixteen_window - 3) {
      SixteenMarks marks;
      if constexpr (!std::is_same_v<Texel, float>) marks = asked(p, box, true);
      if (marks.below != 0 && marks.opaque != 0) return both;
      if (marks.lacks_below == 0xffff) return opaque;
      if (marks.lacks_opaque == 0xffff) return below;
      // One by one they lack one or the other: both are borne, by parts that lack the other.
      if ((marks.lacks_below | marks.lacks_opaque) == 0xffff) return both;
      return uncertain;
    }
    Marks seen = 0;
    const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    for (const Triangle& q : {Triangle{p[0], p01, p02}, Triangle{p02, p12, p01}, Triangle{p01, p[1], p12},
                              Triangle{p12, p02, p[2]}}) {
      const Box about = filter_.box(q);
      Marks marks = filter_.texels(about);
      if (marks == both) marks = by_parts(q, about);
      seen = static_cast<Marks>(seen | marks);
      if ((seen & both) == both) return both;
    }
    return seen;
  }

  static Spot centroid_of(const Triangle& p) noexcept {
    return {(p[0].x + p[1].x + p[2].x) * (1.0 / 3), (p[0].y + p[1].y + p[2].y) * (1.0 / 3)};
  }
  /// Of one that bears both marks.
  unsigned leaning(Spot centroid, std::uint32_t index, BakeCounts& counts) const {
    const double at = filter_.g(centroid) - lean_;
    if (std::fabs(at) > filter_.bound()) return at > 0 ? unknown | 1 : unknown;
    ++counts.exact;
    return code_of(exact_(index));
  }

  /// `edges`: which of the quad's the edges p0 p1, p1 p2, p2 p0 are.
  unsigned leaf(const Triangle& p, const std::array<double, 3>& g, bool turned, std::uint32_t index,
                Quad& quad, const std::array<std::size_t, 3>& edges, BakeCounts& counts) const {
    const Spot centroid = centroid_of(p);
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
    if (marks == both) return leaning(centroid, index, counts);
    ++counts.exact;
    return code_of(exact_(index));
  }

  /// Of a triangle whose texels bear both marks; `seen` at its corners.
  Marks judged(const Triangle& p, const std::array<double, 3>& g, const Box& box, Spot centroid, Marks seen,
               bool turned, Quad& quad, const std::array<std::size_t, 3>& edges) const {
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

  const SidesOf<Texel>& sides_;
  BilinearFilter<Texel> filter_;
  const ExactBase& exact_;
  Within inner_;
  double lean_;  ///< g where alpha begins to lean to opaque: blended, half of the way from 1 to 0
};

}  // namespace mmverify::impl::bake::detail
