// Lookups on the base triangle's edges: what makes values continuous from one triangle to the next.
#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/lookup/grid_cases.hpp"

namespace mmverify::proofs::attribute {

/// A point of a base edge at t / (4N) from the edge's first corner; edges w-u, u-v, v-w as 0, 1, 2.
struct EdgePoint {
  std::uint32_t edge, t;
};

namespace {

constexpr std::array edge_names{"w-u", "u-v", "v-w"};

std::uint64_t edge_points(Level n) { return 3 * (4 * std::uint64_t{spec::side(n)} + 1); }

GridPoint point_of(const EdgePoint& p, Level n) {
  const auto t = static_cast<std::int64_t>(p.t), back = 4 * static_cast<std::int64_t>(spec::side(n)) - t;
  const std::int64_t u = p.edge == 0 ? t : p.edge == 1 ? back : 0;
  const std::int64_t v = p.edge == 0 ? 0 : p.edge == 1 ? t : back;
  return {points::coordinate(u, n), points::coordinate(v, n)};
}

/// Micro-vertex k of the edge, from its first corner on.
Vertex vertex_on(std::uint32_t edge, std::uint32_t k, Level n) {
  const std::uint32_t N = spec::side(n);
  return edge == 0 ? Vertex{k, 0} : edge == 1 ? Vertex{N - k, k} : Vertex{0, N - k};
}

/// The edge's own hat functions: vertices floor(t/4) and the next, at weights 1 - f and f, f = t/4 - floor(t/4).
Blend hats(const EdgePoint& p, VertexOrder order, Level n) {
  Blend blend;
  const Fixed64 f = Fixed64::dyadic(p.t % 4, 2);
  blend.add(spec::attribute::vertex_index(order, vertex_on(p.edge, p.t / 4, n), n), Fixed64(1) - f);
  if (p.t % 4 != 0) blend.add(spec::attribute::vertex_index(order, vertex_on(p.edge, p.t / 4 + 1, n), n), f);
  return blend;
}

std::vector<GridPoint> points_on(std::span<const EdgePoint> of, Level n) {
  std::vector<GridPoint> at;
  for (const EdgePoint& p : of) at.push_back(point_of(p, n));
  return at;
}

}  // namespace

void fill(Level n, std::uint64_t first, std::span<EdgePoint> out) {
  const std::uint64_t each = 4 * std::uint64_t{spec::side(n)} + 1;
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = {static_cast<std::uint32_t>((first + k) / each), static_cast<std::uint32_t>((first + k) % each)};
}
std::string text_of(const EdgePoint& p) { return fmt::format("{},t={}", edge_names[p.edge], p.t); }
void read(Level n, const std::string& text, EdgePoint& p) {
  for (std::uint64_t k = 0; k < edge_points(n); ++k) {
    fill(n, k, {&p, 1});
    if (text_of(p) == text) return;
  }
  throw BadCase(fmt::format("'{:.60}': write w-u,t=1 for the point 1/{} along an edge w-u, u-v or v-w", text,
                            4 * std::uint64_t{spec::side(n)}));
}
Kind kind_of(const EdgePoint& p, Kind) { return p.t % 4 == 0 ? Kind::vertex : Kind::edge; }

std::vector<Law> edge_lookup_laws() {
  Batches<EdgePoint> cases;
  cases.settings = settings_of(vertex_orders);
  cases.count = edge_points;
  cases.kind = Kind::edge;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t order, std::span<const EdgePoint> of,
                   std::span<Outcome> out) {
    const auto found = looked_up(s, vertex_orders[order], n, points_on(of, n));
    for (std::size_t k = 0; k < of.size(); ++k)
      out[k] = {found[k].triplet[0], blend_of(found[k]) == hats(of[k], vertex_orders[order], n)};
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t order, const EdgePoint& p) {
    const GridPoint at = point_of(p, n);
    const Vertex a = vertex_on(p.edge, p.t / 4, n);
    return Words{fmt::format("vertex {} at {}/4 and the next on the edge at the rest, no other",
                             spec::attribute::vertex_index(vertex_orders[order], a, n), 4 - p.t % 4),
                 text_of(looked_up(s, vertex_orders[order], n, {&at, 1})[0])};
  };
  const auto on_weights_at = [](Level level, std::int64_t ku, std::int64_t kv, auto change) {
    return spoils(&Functions::lookup, &Lookup::weights, [=](Level n, Points p, std::span<FixedWeights> out) {
      for (std::size_t k = 0; k < out.size(); ++k)
        if (n == level && p[k].u == points::coordinate(ku, n) && p[k].v == points::coordinate(kv, n))
          change(out[k]);
    });
  };
  return {on_batches(
      {.id = "attribute.on_edge",
       .says = "on a base edge only its own vertices have a weight, that of the edge's hat functions: two "
               "triangles of one level that share an edge and its values agree along it",
       .source = "Color and Attribute Micromaps, 3.2 and 4.1",
       .subjects = {"attribute-spec", "attribute", "attribute-single"},
       .tiers = {.fast = {0, 12}, .long_run = {0, 16}, .seconds = 0.5},
       .domain = "the base edges' micro-vertices, and three points between each two, in 3 orders",
       .mutants = {mutant("on the hypotenuse of level 11 one point keeps weight at the base", "attribute",
                          {11, 11},
                          on_weights_at(11, 4 * 1000 + 3, 4 * 1047 + 1,
                                        [](FixedWeights& w) {
                                          w = {Fixed64::dyadic(1, 2), w[1] - Fixed64::dyadic(1, 2), w[2]};
                                        }))}},
      needing({entry::point_triplet, entry::point_weights}), cases)};
}

}  // namespace mmverify::proofs::attribute
