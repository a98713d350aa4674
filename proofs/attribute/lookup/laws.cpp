// A point's triplet and weights, and the values between vertices: on every cell of a level's grid.
#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/lookup/grid_cases.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::times;
using spec::attribute::Corners;

const std::vector<std::string> lookup_subjects{"attribute-spec", "attribute", "attribute-single"};

std::vector<GridPoint> grid_points(std::span<const GridCase> points) {
  std::vector<GridPoint> at;
  for (const GridCase& point : points) at.push_back(point.at);
  return at;
}

/// Whether a law holds for a lookup at a point.
using OnLooked = bool (*)(VertexOrder, Level, const GridCase&, const Looked&);

/// A law on lookups, in the three orders.
Batches<GridCase> on_lookups(const char* expected, OnLooked holds) {
  Batches<GridCase> cases;
  cases.settings = settings_of(vertex_orders);
  cases.count = grid_count;
  cases.kind = Kind::interior;
  cases.check = [holds](const AttributeSubject& s, Level n, std::size_t order,
                        std::span<const GridCase> points, std::span<Outcome> out) {
    const auto found = looked_up(s, vertex_orders[order], n, grid_points(points));
    for (std::size_t k = 0; k < points.size(); ++k)
      out[k] = {found[k].triplet[0] + 3 * std::uint64_t{found[k].triplet[1]} +
                    5 * std::uint64_t{found[k].triplet[2]} +
                    static_cast<std::uint64_t>(found[k].weights[1].raw() + 7 * found[k].weights[2].raw()),
                holds(vertex_orders[order], n, points[k], found[k])};
  };
  cases.words = [expected](const AttributeSubject& s, Level n, std::size_t order, const GridCase& point) {
    return Words{expected, text_of(looked_up(s, vertex_orders[order], n, {&point.at, 1})[0])};
  };
  return cases;
}

/// The micro-triangle of a triplet, if its vertices are the corners of one.
std::optional<MicroTriangle> triangle_of_indices(VertexOrder order, Level n, const Triplet& x) {
  for (const std::uint32_t k : x)
    if (k >= vertex_count(n)) return std::nullopt;
  const Corners c{spec::attribute::vertex_at(order, x[0], n), spec::attribute::vertex_at(order, x[1], n),
                  spec::attribute::vertex_at(order, x[2], n)};
  const MicroTriangle t = spec::attribute::triangle_of(c);
  if (t.iu + t.iv + (t.upper ? 1 : 0) >= spec::side(n) || spec::attribute::corners_of(t) != c)
    return std::nullopt;
  return t;
}

template <class Change>
auto on_point_triplet(Change change) {
  return spoils(&Functions::lookup, &Lookup::triplet,
                [change](VertexOrder order, Level n, Points p, std::span<Triplet> out) {
                  for (std::size_t k = 0; k < out.size(); ++k) change(order, n, p[k], out[k]);
                });
}

bool is_at(const GridPoint& p, Level n, std::int64_t ku, std::int64_t kv) {
  return p.u == points::coordinate(ku, n) && p.v == points::coordinate(kv, n);
}

bool holds_point(VertexOrder order, Level n, const GridCase& point, const Looked& found) {
  const auto& [x, w] = found;
  if (!triangle_of_indices(order, n, x)) return false;
  Fixed64 sum(0), u(0), v(0);
  for (std::size_t c = 0; c < 3; ++c) {
    if (w[c] < Fixed64(0)) return false;
    const Vertex at = spec::attribute::vertex_at(order, x[c], n);
    sum = sum + w[c];
    u = u + times(at.i, w[c]);
    v = v + times(at.j, w[c]);
  }
  return sum == Fixed64(1) && u == times(spec::side(n), point.at.u) && v == times(spec::side(n), point.at.v);
}

Law holds_point_law() {
  return on_batches(
      {.id = "attribute.holds_point",
       .says = "a point's triplet is a micro-triangle's, the weights are none below 0, add up to 1 and give "
               "the point",
       .source = cam_4,
       .subjects = lookup_subjects,
       .tiers = {.fast = {0, 7}, .long_run = {0, 14}, .seconds = 1},
       .domain = every_point,
       .mutants = {mutant("two weights change places inside one micro-triangle of level 6", "attribute",
                          {6, 6}, on_weights([](Level n, const GridPoint& p, FixedWeights& w) {
                            if (n == 6 && is_at(p, n, 4 * 20 + 1, 4 * 30 + 1)) std::swap(w[0], w[1]);
                          }))}},
      needing({entry::point_triplet, entry::point_weights}),
      on_lookups("a micro-triangle's triplet, weights of 0 or more that add up to 1 and give the point",
                 holds_point));
}

bool reproduces(VertexOrder order, Level n, const GridCase& point, const Looked& found) {
  const std::uint32_t N = spec::side(n);
  std::array<std::uint32_t, 3> value{};
  bool at_vertex = false;
  for (std::size_t c = 0; c < 3; ++c) {
    if (found.triplet[c] >= vertex_count(n)) return false;
    const Vertex at = spec::attribute::vertex_at(order, found.triplet[c], n);
    value[c] = 7 + 3 * at.i + 5 * at.j;
    const bool here = Fixed64(at.i) == times(N, point.at.u) && Fixed64(at.j) == times(N, point.at.v);
    at_vertex = at_vertex || (here && found.weights[c] == Fixed64(1));
  }
  if (point.kind == Kind::vertex && !at_vertex) return false;
  const Fixed64 linear = Fixed64(7) + times(3 * N, point.at.u) + times(5 * N, point.at.v);
  return spec::attribute::interpolated(found.weights, value) == linear;
}

Law reproduces_law() {
  return on_batches({.id = "attribute.reproduces",
                     .says = "at a micro-vertex its own weight is 1; and values that are linear over the "
                             "triangle come out as they are",
                     .source = cam_4,
                     .subjects = lookup_subjects,
                     .tiers = {.fast = {0, 7}, .long_run = {0, 14}, .seconds = 1},
                     .domain = every_point,
                     .mutants = {mutant("at one vertex of level 7 its weight is 3/4", "attribute-spec",
                                        {7, 7}, on_weights([](Level n, const GridPoint& p, FixedWeights& w) {
                                          if (n == 7 && is_at(p, n, 4 * 50, 4 * 60))
                                            for (Fixed64& q : w)
                                              q = q == Fixed64(1) ? Fixed64::dyadic(3, 2)
                                                                  : Fixed64::dyadic(1, 3);
                                        }))}},
                    needing({entry::point_triplet, entry::point_weights}),
                    on_lookups("the value 7 + 3i + 5j, of one vertex alone where there is one", reproduces));
}

bool tie_free(VertexOrder order, Level n, const GridCase& point, const Looked& found) {
  const Blend blend = blend_of(found);
  for (const MicroTriangle& t : all_holders(n, point.at))
    if (!(blend_on(t, order, n, point.at) == blend)) return false;
  return true;
}

Law tie_free_law() {
  return on_batches(
      {.id = "attribute.tie_free",
       .says =
           "the vertices with a weight, and their weights, are the same in each closed micro-triangle that "
           "holds the point: no rule for ties is needed, and values are continuous across micro-edges",
       .source = cam_4,
       .subjects = lookup_subjects,
       .tiers = {.fast = {0, 6}, .long_run = {0, 12}, .seconds = 1},
       .domain = every_point,
       .mutants = {mutant("at one vertex of level 6 its neighbour has the weight", "attribute", {6, 6},
                          on_point_triplet([](VertexOrder order, Level n, const GridPoint& p, Triplet& x) {
                            if (n == 6 && order == VertexOrder::u_major && is_at(p, n, 4 * 31, 4 * 17))
                              ++x[0];
                          }))}},
      needing({entry::point_triplet, entry::point_weights}),
      on_lookups("the same weights in each micro-triangle that holds the point", tie_free));
}

/// Whether the two rules choose different micro-triangles: on u = i/N, 1 <= i <= N-1, but not on the hypotenuse.
bool rules_differ(Level n, const GridPoint& p) {
  const Fixed64 x = times(spec::side(n), p.u);
  return x == Fixed64(whole(x)) && Fixed64(0) < x && p.u + p.v < Fixed64(1);
}

Law face_ties_law() {
  Batches<GridCase> cases;
  cases.settings = {"faces"};
  cases.count = grid_count;
  cases.kind = Kind::interior;
  const auto both = [](const AttributeSubject& s, Level n, std::span<const GridPoint> at) {
    std::array<std::vector<MicroTriangle>, 2> found{std::vector<MicroTriangle>(at.size()),
                                                    std::vector<MicroTriangle>(at.size())};
    s.functions.lookup.holder(Ties::vulkan, n, at, found[0]);
    s.functions.lookup.holder(Ties::figure_4, n, at, found[1]);
    return found;
  };
  cases.check = [both](const AttributeSubject& s, Level n, std::size_t, std::span<const GridCase> points,
                       std::span<Outcome> out) {
    const auto found = both(s, n, grid_points(points));
    for (std::size_t k = 0; k < points.size(); ++k) {
      const MicroTriangle &a = found[0][k], &b = found[1][k];
      // Two different micro-triangles must be neighbours across the line.
      const bool beside = b.iu + 1 == a.iu;
      out[k] = {a.iu + 3 * std::uint64_t{b.iu} + 5 * std::uint64_t{a.iv} + (a.upper ? 1 : 0),
                rules_differ(n, points[k].at) ? beside : a == b};
    }
  };
  cases.words = [both](const AttributeSubject& s, Level n, std::size_t, const GridCase& point) {
    const auto found = both(s, n, {&point.at, 1});
    return Words{
        rules_differ(n, point.at) ? "the micro-triangles on both sides of the line" : "one micro-triangle",
        text_of(found[0][0]) + " and " + text_of(found[1][0])};
  };
  const auto on_holder = [](Ties of, auto change) {
    return spoils(&Functions::lookup, &Lookup::holder,
                  [of, change](Ties ties, Level n, Points p, std::span<MicroTriangle> out) {
                    for (std::size_t k = 0; k < out.size(); ++k)
                      if (ties == of) change(n, p[k], out[k]);
                  });
  };
  return on_batches(
      {.id = "attribute.face_ties",
       .says = "figure 4 and Vulkan's code give a point to different micro-triangles just on the lines u = "
               "i/N, 0 < i < N, below the hypotenuse: on N(N-1)/2 open edges and N(N-1)/2 vertices, where "
               "the value of a face differs",
       .source =
           "Color and Attribute Micromaps, figure 4; VK_EXT_opacity_micromap, appendix \"Reference Code\"",
       .subjects = {"attribute-spec"},
       .tiers = {.fast = {0, 7}, .long_run = {0, 12}, .seconds = 1},
       .domain = every_point,
       .mutants = {mutant("Vulkan's code gives one vertex of level 6 to the left", "attribute-spec", {6, 6},
                          on_holder(Ties::vulkan,
                                    [](Level n, const GridPoint& p, MicroTriangle& t) {
                                      if (n == 6 && is_at(p, n, 4 * 20, 4 * 30))
                                        t = spec::attribute::figure_4_triangle(p, n);
                                    }))}},
      needing({entry::holder}), cases);
}

}  // namespace

std::vector<Law> lookup_laws() {
  std::vector<Law> all{holds_point_law(), reproduces_law(), tie_free_law(), face_ties_law()};
  for (auto& group : {edge_lookup_laws(), remap_laws(), float_lookup_laws()})
    for (const Law& law : group) all.push_back(law);
  return all;
}

}  // namespace mmverify::proofs::attribute
