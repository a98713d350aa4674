// A map as roots and residuals: each level's values as differences from a prediction by the level below, in integers,
// and back without loss.
//
//   faces      four children a, b, c, d, numbers 4k..4k+3 of the curve, become their parent and three differences
//   vertices   a vertex that level m adds halves an edge of level m-1: the difference from the mean of its two ends
//
// Both come in triples, one for each micro-triangle of level m-1 (faces), or for each that stands upright (vertices),
// in the order of the curve.  The parent takes the fourth child's place, and the lower levels' vertices begin the Bird
// order: nothing is stored besides.
// Source: ours; Color and Attribute Micromaps, 7, asks for compression and has none.  The steps on pairs are the S
// transform (Said, Pearlman 1993).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spec/attribute/order.hpp"

namespace mmverify::spec::attribute {

/// The places of a map's values: micro-triangles along the curve, or micro-vertices in the Bird order.
enum class MapAt : std::uint32_t { faces, vertices };

/// floor(x / 2) and ceil(x / 2), of negative numbers as well.
constexpr std::int32_t half_down(std::int32_t x) { return (x - (x % 2 != 0 && x < 0 ? 1 : 0)) / 2; }
constexpr std::int32_t half_up(std::int32_t x) { return half_down(x + 1); }

/// T(m), the triples that level m adds: 4^(m-1) of faces, M(M+1)/2 of vertices, M = 2^(m-1).  Domain: m in 1..16.
constexpr std::uint64_t triples_of(MapAt at, Level m) {
  const std::uint64_t M = side(m - 1);
  return at == MapAt::faces ? face_count(m - 1) : M * (M + 1) / 2;
}

/// The number of values that no level predicts: those of level 0.
constexpr std::uint64_t roots_of(MapAt at) { return at == MapAt::faces ? 1 : 3; }

/// The number of values, roots + 3 (T(1) + ... + T(n)) = 4^n or V(n).  Domain: n in 0..16.
constexpr std::uint64_t values_of(MapAt at, Level n) {
  return at == MapAt::faces ? face_count(n) : vertex_count(n);
}

/// A parent and the residuals of its four children.
struct Family {
  std::int32_t parent;
  std::array<std::int32_t, 3> residuals;
  friend constexpr bool operator==(const Family&, const Family&) = default;
};

/// The family of four children: s = floor((a+b)/2), t = floor((c+d)/2); parent ceil((s+t)/2), residuals a-b, c-d, s-t.
/// The parent lies within half a code of (a+b+c+d)/4, for the two roundings go apart.  Domain: codes 0..255.
constexpr Family family_of(const std::array<std::int32_t, 4>& children) {
  const auto [a, b, c, d] = children;
  const std::int32_t s = half_down(a + b), t = half_down(c + d);
  return {half_up(s + t), {a - b, c - d, s - t}};
}

/// The children of a family.  a+b is 2s or 2s+1, and the parity of a-b tells which: b = s - floor((a-b)/2), and so on.
/// Domain: any numbers below 2^28; for a family that family_of() does not give, children may be no codes.
constexpr std::array<std::int32_t, 4> children_of(const Family& family) {
  const auto [ab, cd, st] = family.residuals;
  const std::int32_t t = family.parent - half_up(st), s = t + st;
  const std::int32_t b = s - half_down(ab), d = t - half_down(cd);
  return {b + ab, b, d + cd, d};
}

/// The ends of the edge that a vertex halves, on the grid of the level that adds it.
/// Domain: i or j odd.  Source: as the Bird order (order.hpp).
constexpr std::array<Vertex, 2> halved_edge(const Vertex& x) {
  if (x.i % 2 == 0) return {Vertex{x.i, x.j - 1}, Vertex{x.i, x.j + 1}};
  if (x.j % 2 == 0) return {Vertex{x.i - 1, x.j}, Vertex{x.i + 1, x.j}};
  return {Vertex{x.i + 1, x.j - 1}, Vertex{x.i - 1, x.j + 1}};
}

/// The prediction of a vertex between p and q: floor((p+q+1)/2).
constexpr std::int32_t predicted(std::int32_t p, std::int32_t q) { return half_up(p + q); }

/// One channel of a map: roots, then the residuals of levels 1, 2, ..., n, triple by triple.
struct Residuals {
  std::vector<std::int32_t> roots, levels;
  friend bool operator==(const Residuals&, const Residuals&) = default;
};

/// The first triple of level m: T(1) + ... + T(m-1).
constexpr std::uint64_t triples_before(MapAt at, Level m) {
  return (values_of(at, m - 1) - roots_of(at)) / 3;
}

/// The residuals of a map.  Domain: values_of(at, n) numbers in the order of the kind; n in 0..12.
inline Residuals residuals_of(MapAt at, Level n, std::span<const std::int32_t> values) {
  Residuals r;
  r.levels.resize(static_cast<std::size_t>(values_of(at, n) - roots_of(at)));
  std::vector<std::int32_t> level(values.begin(), values.end());
  for (Level m = n; m > 0; --m) {
    std::size_t to = static_cast<std::size_t>(3 * triples_before(at, m));
    const auto put = [&](std::int32_t residual) { r.levels[to++] = residual; };
    if (at == MapAt::faces) {
      std::vector<std::int32_t> parents;
      for (std::size_t k = 0; 4 * k < level.size(); ++k) {
        const Family f = family_of({level[4 * k], level[4 * k + 1], level[4 * k + 2], level[4 * k + 3]});
        parents.push_back(f.parent);
        for (const std::int32_t residual : f.residuals) put(residual);
      }
      level = parents;
    } else {
      for (std::uint64_t x = vertex_count(m - 1); x < vertex_count(m); ++x) {
        const auto ends = halved_edge(vertex_at(VertexOrder::bird, x, m));
        const auto value = [&](const Vertex& at_end) {
          return level[static_cast<std::size_t>(vertex_index(VertexOrder::bird, at_end, m))];
        };
        put(level[static_cast<std::size_t>(x)] - predicted(value(ends[0]), value(ends[1])));
      }
      level.resize(static_cast<std::size_t>(vertex_count(m - 1)));
    }
  }
  r.roots = level;
  return r;
}

/// The values of residuals; they may be no codes if the residuals are those of no map.
inline std::vector<std::int32_t> values_from(MapAt at, Level n, const Residuals& r) {
  std::vector<std::int32_t> level = r.roots;
  for (Level m = 1; m <= n; ++m) {
    std::size_t from = static_cast<std::size_t>(3 * triples_before(at, m));
    const auto next = [&] { return r.levels[from++]; };
    if (at == MapAt::faces) {
      std::vector<std::int32_t> children;
      for (const std::int32_t parent : level) {
        const std::int32_t ab = next(), cd = next(), st = next();
        for (const std::int32_t child : children_of({parent, {ab, cd, st}})) children.push_back(child);
      }
      level = children;
    } else {
      for (std::uint64_t x = vertex_count(m - 1); x < vertex_count(m); ++x) {
        const auto ends = halved_edge(vertex_at(VertexOrder::bird, x, m));
        const auto value = [&](const Vertex& at_end) {
          return level[static_cast<std::size_t>(vertex_index(VertexOrder::bird, at_end, m))];
        };
        level.push_back(predicted(value(ends[0]), value(ends[1])) + next());
      }
    }
  }
  return level;
}

}  // namespace mmverify::spec::attribute
