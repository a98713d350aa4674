#include "scene/plan/pairs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <tuple>
#include <unordered_map>

namespace mmverify::scene {
namespace {

using Corner = std::array<float, 5>;  ///< position and UV
using Edge = std::array<Corner, 2>;   ///< in order

struct Hash {
  std::size_t operator()(const Edge& edge) const {
    std::uint64_t hash = 0;
    for (const Corner& corner : edge)
      for (const float x : corner)
        hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash ^ hash >> 32);
  }
};

/// The use of a planned triangle with its vertices in another order.
TriangleUse reordered(const TriangleUse& use, const VertexOrder& order) {
  return {use.triangle, {use.order[order[0]], use.order[order[1]], use.order[order[2]]}};
}

class Matcher {
 public:
  explicit Matcher(const Primitive& primitive) : primitive_(primitive) {}

  /// Calls found(lower, its order, upper, its order) for each pair; returns the number of unpaired triangles.
  template <class Match>
  std::uint64_t each(Match found) {
    const std::size_t count = primitive_.triangles.size();
    std::unordered_map<Edge, std::vector<std::size_t>, Hash> open;  // triangles by their edges
    for (std::size_t t = 0; t < count; ++t)
      for (std::uint8_t k = 0; k < 3; ++k) open[edge(t, k)].push_back(t);
    std::vector<bool> taken(count, false);
    std::uint64_t left = 0;
    for (std::size_t t = 0; t < count; ++t) {
      if (taken[t]) continue;
      taken[t] = true;
      const auto [partner, side] = first_partner(t, open, taken);
      if (partner == count) {
        ++left;
        continue;
      }
      taken[partner] = true;
      pair(t, side, partner, found);
    }
    return left;
  }

 private:
  Corner corner(std::size_t t, std::size_t k) const {
    const std::uint32_t v = primitive_.triangles[t][k];
    const Position& p = primitive_.positions[v];
    const Uv& uv = primitive_.uvs[v];
    // -0 + 0 is +0: equal floats hash alike.
    return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f, uv[0] + 0.0f, uv[1] + 0.0f};
  }
  /// The edge opposite corner k.
  Edge edge(std::size_t t, std::size_t k) const {
    Edge e{corner(t, (k + 1) % 3), corner(t, (k + 2) % 3)};
    if (e[1] < e[0]) std::swap(e[0], e[1]);
    return e;
  }

  /// The first partner of triangle t, and the corner of t opposite their common edge.
  template <class Open>
  std::pair<std::size_t, std::uint8_t> first_partner(std::size_t t, Open& open,
                                                     const std::vector<bool>& taken) const {
    std::pair<std::size_t, std::uint8_t> best{taken.size(), 0};
    for (std::uint8_t k = 0; k < 3; ++k) {
      const Edge shared = edge(t, k);
      if (shared[0] == shared[1]) continue;  // a point
      auto& candidates = open[shared];
      std::erase_if(candidates, [&](std::size_t other) { return taken[other]; });
      if (!candidates.empty() && candidates.front() < best.first) best = {candidates.front(), k};
    }
    return best;
  }

  template <class Match>
  void pair(std::size_t t, std::uint8_t apex, std::size_t other, Match found) const {
    const auto next = [](std::uint8_t k, unsigned by) { return static_cast<std::uint8_t>((k + by) % 3); };
    const Edge shared = edge(t, apex);
    std::uint8_t far = 0;
    while (edge(other, far) != shared) ++far;
    const VertexOrder lower{apex, next(apex, 1), next(apex, 2)};
    // (0,1), the lower triangle's third corner, is the upper's second.
    VertexOrder upper{far, next(far, 1), next(far, 2)};
    if (corner(other, upper[1]) != corner(t, lower[2])) std::swap(upper[1], upper[2]);
    found(t, lower, other, upper);
  }

  const Primitive& primitive_;
};

}  // namespace

Pairs pairs(const Scene& scene, const Plan& plan) {
  Pairs all;
  std::map<std::tuple<std::uint32_t, VertexOrder, std::uint32_t, VertexOrder>, std::size_t> known;
  for (const PlannedPrimitive& planned : plan.primitives) {
    const Primitive& primitive = scene.primitives[planned.primitive];
    const std::uint64_t uses = scene.meshes[primitive.mesh].uses;
    auto& places = all.places.emplace_back(planned.triangles.size());
    all.unpaired += Matcher(primitive).each([&](std::size_t below, const VertexOrder& below_order,
                                                std::size_t above, const VertexOrder& above_order) {
      const TriangleUse lower = reordered(planned.triangles[below], below_order),
                        upper = reordered(planned.triangles[above], above_order);
      if (plan.triangles[lower.triangle].varies() || plan.triangles[upper.triangle].varies() ||
          plan.surfaces[planned.surface].moves()) {
        all.unpaired += 2;  // bounds do not tell what is C, and square maps are baked of textures at rest
        return;
      }
      const auto [entry, is_new] =
          known.try_emplace({lower.triangle, lower.order, upper.triangle, upper.order}, all.distinct.size());
      if (is_new) all.distinct.push_back({lower, upper, 0, 0});
      const auto number = static_cast<std::uint32_t>(entry->second);
      places[below] = {number, false, below_order};
      places[above] = {number, true, above_order};
      Pair& pair = all.distinct[entry->second];
      ++pair.unique;
      pair.placed += uses;
      ++all.unique;
    });
  }
  return all;
}

}  // namespace mmverify::scene
