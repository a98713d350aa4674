// Baking: the state of a micro-triangle, from the base triangle's texture coordinates and the alpha mode.
//
// Source: glTF 2.0, "Alpha Coverage"; VK_KHR_opacity_micromap; the order of micro-triangles is that of
// spec/index/index.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>

#include "spec/bake/range.hpp"
#include "spec/index/index.hpp"
#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::bake {

// ---- Alpha modes

/// MASK: alpha >= cutoff is opaque, less is transparent.
template <class Q>
struct Mask {
  Q cutoff;
  bool opaque(const Q& alpha) const { return alpha >= cutoff; }
  bool transparent(const Q& alpha) const { return alpha < cutoff; }
  /// Whether an unknown state is UO instead of UT.
  bool rather_opaque(const Q& alpha) const { return alpha >= cutoff; }
  /// Whether numbers just above alpha are opaque, and numbers just below it transparent.
  bool opaque_above(const Q& alpha) const { return alpha >= cutoff; }
  bool transparent_below(const Q& alpha) const { return alpha <= cutoff; }
};

/// MASK of engines that draw alpha > cutoff only.
template <class Q>
struct MaskAbove {
  Q cutoff;
  bool opaque(const Q& alpha) const { return alpha > cutoff; }
  bool transparent(const Q& alpha) const { return alpha <= cutoff; }
  bool rather_opaque(const Q& alpha) const { return alpha > cutoff; }
  bool opaque_above(const Q& alpha) const { return alpha >= cutoff; }
  bool transparent_below(const Q& alpha) const { return alpha <= cutoff; }
};

/// BLEND: alpha >= 1 is opaque, alpha <= 0 transparent; between, alpha is a share.
template <class Q>
struct Blend {
  bool opaque(const Q& alpha) const { return alpha >= 1; }
  bool transparent(const Q& alpha) const { return alpha <= 0; }
  bool rather_opaque(const Q& alpha) const { return alpha + alpha >= 1; }
  bool opaque_above(const Q& alpha) const { return alpha >= 1; }
  bool transparent_below(const Q& alpha) const { return alpha <= 0; }
};

/// The state of a range: O if all of it is opaque, T if all of it is transparent, else C.
template <class Q, class Mode>
State state_in(const Mode& mode, const Range<Q>& alpha) {
  return mode.opaque(alpha.least) ? State::O : mode.transparent(alpha.greatest) ? State::T : State::C;
}

/// The state that serves two textures, either of which may be sampled: O if both are O, T if both are T, else C.
constexpr State merged(State a, State b) { return a == b ? a : State::C; }

/// The state of a range without areas of 0.  If alpha varies on a part of a cell, it meets its least and its greatest
/// on an area of 0 only.
/// Domain: the range of such a part, which has an area itself.
template <class Q, class Mode>
State open_state_in(const Mode& mode, const Range<Q>& alpha) {
  const bool varies = alpha.least < alpha.greatest;
  if (mode.opaque(alpha.least) || (varies && mode.opaque_above(alpha.least))) return State::O;
  if (mode.transparent(alpha.greatest) || (varies && mode.transparent_below(alpha.greatest))) return State::T;
  return State::C;
}

/// The contact rule: a micro-triangle is closed, with its edges and corners, or open: touching in an area of 0 is
/// nothing.
enum class Contact : std::uint8_t { closed, open };

/// The state of a closed polygon.
template <class Q, class Texel, class Mode>
State closed_state(const TextureOf<Texel>& t, const Polygon<Q>& polygon, const Mode& mode) {
  const auto in = [&](const Range<Q>& alpha) { return state_in(mode, alpha); };
  return in(range(t, polygon, [&](const Range<Q>& some) { return in(some) == State::C; }));
}

/// The state of an open polygon with an area, nearest filtering: that of all texels that it meets in an area.
template <class Q, class Texel, class Mode>
State open_nearest(const TextureOf<Texel>& t, const Polygon<Q>& polygon, const Mode& mode) {
  std::optional<State> all;
  const auto take = [&](const Range<Q>& texels) {
    const State here = state_in(mode, texels);
    all = all ? merged(*all, here) : here;
  };
  for_each_box<Q>(
      t, polygon,
      [&](const BoxTexels<Texel>& texels, const BoxPart<Q>& one, bool) {
        if (all == State::C || !has_area(one.part)) return true;
        const Range<Q> bound = range<Q>(t, texels);
        if (state_in(mode, bound) != State::C) {
          take(bound);
          return true;
        }
        if (one.box.columns.size() == 1 || one.box.rows.size() == 1) {
          take(open_strip(t, one, one.box.rows.size() == 1));
          return true;
        }
        const TexturePoint<Q> middle = centroid(one.part);
        for (const TexelAt<Texel>& at : {texels.least, texels.greatest})
          if (has_centre(t, one.part, middle, at)) take(Range<Q>(texel<Q>(t, at.i, at.j)));
        return all == State::C;
      },
      // Squares of one texel, of a state that is neither O nor T.
      [&](std::int64_t i, std::int64_t j, const Polygon<Q>&) { take(Range<Q>(texel<Q>(t, i, j))); });
  return all.value();
}

/// The state of an open polygon, from each cell, or texel, that it meets in an area above 0.  One without area is
/// closed.
template <class Q, class Texel, class Mode>
State open_state(const TextureOf<Texel>& t, const Polygon<Q>& polygon, const Mode& mode) {
  if (!has_area(polygon)) return closed_state(t, polygon, mode);
  if (t.filter == Filter::nearest) return open_nearest(t, polygon, mode);
  // Alpha is continuous: it is on an area near an extreme what it is just above or below it.
  const auto mixed = [&](const Range<Q>& alpha) {
    return !mode.opaque_above(alpha.least) && !mode.transparent_below(alpha.greatest);
  };
  if (mixed(range(t, polygon, mixed))) return State::C;
  std::optional<State> all;
  const auto take = [&all](State here) { all = all ? merged(*all, here) : here; };
  for_each_box<Q>(
      t, polygon,
      [&](const BoxTexels<Texel>& texels, const BoxPart<Q>& one, bool) {
        if (all == State::C || !has_area(one.part)) return true;
        const State closed = state_in(mode, range<Q>(t, texels));
        if (closed != State::C) take(closed);  // what holds on the closed box holds on its inside
        return closed != State::C;
      },
      [&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) {
        if (has_area(part)) take(open_state_in(mode, range_in_square(t, i, j, part)));
      });
  return all.value();
}

// ---- Micro-triangles

/// Texture coordinates (u, v) of a base triangle's vertices; any three points, in any order.
template <class Q>
using BaseTriangle = std::array<TexturePoint<Q>, 3>;

template <class Q>
TexturePoint<Q> place(Binary32 u, Binary32 v) {
  return {number<Q>(u), number<Q>(v)};
}

/// The corners of micro-triangle `index` at level n, in texels: the micro-vertex (i/N, j/N) lies at
///   P + i/N (Q - P) + j/N (R - P),   times (width, height)
/// for the base triangle PQR.  Domain: n in 0..16, index in [0, 4^n).
template <class Q>
Polygon<Q> micro_triangle(const BaseTriangle<Q>& uv, Level n, std::uint32_t index, std::uint32_t width,
                          std::uint32_t height) {
  Polygon<Q> polygon;
  for (const index::Vertex& vertex : index::corners(index, n)) {
    const Q i = fraction<Q>(vertex.i, side(n)), j = fraction<Q>(vertex.j, side(n));
    const auto along = [&](Q TexturePoint<Q>::*axis) {
      return uv[0].*axis + i * (uv[1].*axis - uv[0].*axis) + j * (uv[2].*axis - uv[0].*axis);
    };
    polygon.push_back({along(&TexturePoint<Q>::x) * Q(width), along(&TexturePoint<Q>::y) * Q(height)});
  }
  return polygon;
}

/// The state of a micro-triangle: O or T if it is so in every mip level that may be sampled; else UO or UT, as alpha at
/// its centroid is rather opaque or not in the first mip level, the largest.
/// Mips: in the order of sampling.  2-state maps hold micromap::force2 of this.
/// Contact: whether touching in an area of 0 counts.
/// Margin: in texels of each mip level; O or T must hold on all of the dilated micro-triangle.
/// Travel: each vertex of `uv` may be anywhere within travel.x of its u and within travel.y of its v; O or T must hold
/// wherever all three are.  A point of the micro-triangle is a mean of the vertices and moves no farther; and it moves as
/// far where all vertices move alike.  So the points met are the sum with [-travel.x, travel.x] x [-travel.y, travel.y].
/// Errors: std::invalid_argument without mips, or for a margin or travel below 0.
template <class Q, class Texel, class Mode>
micromap::State micro_state(std::span<const TextureOf<Texel>> mips, const BaseTriangle<Q>& uv, Level n,
                            std::uint32_t index, const Mode& mode, const Q& margin = Q(0),
                            Contact contact = Contact::closed, const TexturePoint<Q>& travel = {Q(0), Q(0)}) {
  if (mips.empty()) throw std::invalid_argument("bake: no mip level");
  const auto in = [&](const TextureOf<Texel>& t) { return micro_triangle(uv, n, index, t.width, t.height); };
  const auto state = [&](const TextureOf<Texel>& t) {
    const Polygon<Q> polygon =
        dilated(in(t), Q(margin + travel.x * Q(t.width)), Q(margin + travel.y * Q(t.height)));
    return contact == Contact::open ? open_state(t, polygon, mode) : closed_state(t, polygon, mode);
  };
  State all = state(mips[0]);
  for (const TextureOf<Texel>& t : mips.subspan(1)) {
    if (all == State::C) break;  // C stays C
    all = merged(all, state(t));
  }
  if (all == State::O) return micromap::State::O;
  if (all == State::T) return micromap::State::T;
  return mode.rather_opaque(alpha(mips[0], centroid(in(mips[0])))) ? micromap::State::UO
                                                                   : micromap::State::UT;
}

/// The state for one texture without mips.
template <class Q, class Texel, class Mode>
micromap::State micro_state(const TextureOf<Texel>& texture, const BaseTriangle<Q>& uv, Level n,
                            std::uint32_t index, const Mode& mode, const Q& margin = Q(0)) {
  return micro_state(std::span<const TextureOf<Texel>>(&texture, 1), uv, n, index, mode, margin);
}

}  // namespace mmverify::spec::bake
