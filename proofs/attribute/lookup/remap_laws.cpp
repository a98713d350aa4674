// Laws of the three exact remaps, of remapping in steps, and of lookups that cannot be made of steps.
#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/lookup/grid_cases.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::attribute::vulkan_triangle;
using spec::attribute::weights_by_pattern;
using spec::attribute::within;

/// The weights by the pattern and by another remap, on the micro-triangle that holds the point or on another one.
struct TwoRemaps {
  RationalWeights pattern, other;
};

const std::vector<std::string> remap_settings{"two", "cramer", "two-outside", "cramer-outside"};

TwoRemaps two_remaps(const AttributeSubject& s, Level n, std::size_t setting, const GridPoint& at) {
  MicroTriangle t = vulkan_triangle(at, n);
  // The settings with a micro-triangle outside take the last upper one of its row, or the triangle's w-corner.
  if (setting >= 2)
    t = t.iu + t.iv == 0 || n == 0 ? MicroTriangle{0, 0, false} : MicroTriangle{t.iu + t.iv - 1, 0, true};
  const RationalPoint p = points::rational(at);
  const Remap way = setting % 2 == 0 ? Remap::two : Remap::cramer;
  return {s.functions.lookup.remap(Remap::pattern, n, t, p), s.functions.lookup.remap(way, n, t, p)};
}

std::string words_of(const RationalWeights& w) {
  const auto word = [](const spec::Rational& q) {
    return fmt::format("{}/{}", q.numerator().str(), q.denominator().str());
  };
  return fmt::format("{} {} {}", word(w[0]), word(w[1]), word(w[2]));
}

Law remaps_agree_law() {
  Batches<GridCase> cases;
  cases.settings = remap_settings;
  cases.count = grid_count;
  cases.kind = Kind::interior;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t setting, std::span<const GridCase> points,
                   std::span<Outcome> out) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TwoRemaps w = two_remaps(s, n, setting, points[k].at);
      const auto quarters = static_cast<std::int64_t>((w.other[1] * spec::Integer(4)).numerator());
      out[k] = {static_cast<std::uint64_t>(quarters), w.pattern == w.other};
    }
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t setting, const GridCase& point) {
    const TwoRemaps w = two_remaps(s, n, setting, point.at);
    return Words{words_of(w.pattern), words_of(w.other)};
  };
  const auto on_remap = [](Remap of, auto change) {
    return spoils(
        &Functions::lookup, &Lookup::remap,
        [of, change](Remap way, Level n, const MicroTriangle& t, const RationalPoint& p, RationalWeights& w) {
          if (way == of) change(n, t, p, w);
        });
  };
  return on_batches(
      {.id = "attribute.remaps_agree",
       .says = "the 3x3 system by Cramer's rule, two of its equations, and the uniform pattern give the same "
               "weights, in the point's micro-triangle and in others",
       .source = "Color and Attribute Micromaps, 4.1, items 1 to 4, and what it omits",
       .subjects = {"attribute-spec"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 8}, .seconds = 0.5},
       .domain = every_point,
       .mutants = {mutant(
           "Cramer's determinant is 4^-(n-1) at the last micro-triangle of level 4", "attribute-spec", {4, 4},
           on_remap(Remap::cramer,
                    [](Level n, const MicroTriangle& t, const RationalPoint&, RationalWeights& w) {
                      if (n == 4 && t == MicroTriangle{0, 15, false})
                        for (spec::Rational& q : w) q /= spec::Integer(4);
                    }))}},
      needing({entry::remap}), cases);
}

/// The level a of the first step: 1, half of n, or n - 1.
Level split_of(std::size_t setting, Level n) {
  if (n == 0) return 0;
  return setting == 0 ? 1 : setting == 1 ? n / 2 : n - 1;
}

/// A lookup in two steps: the point's micro-triangle and weights at level a, then the point within it at level b. The
/// triplet has vertices of level a+b.
Looked in_two_steps(const AttributeSubject& s, Level a, Level b, const GridPoint& at) {
  const auto order = VertexOrder::u_major;
  const auto corners = [&](Level n, const Looked& found) {
    return spec::attribute::Corners{spec::attribute::vertex_at(order, found.triplet[0], n),
                                    spec::attribute::vertex_at(order, found.triplet[1], n),
                                    spec::attribute::vertex_at(order, found.triplet[2], n)};
  };
  const Looked outer = looked_up(s, order, a, {&at, 1})[0];
  const MicroTriangle t = spec::attribute::triangle_of(corners(a, outer));
  const GridPoint inside = within(outer.weights);
  Looked inner = looked_up(s, order, b, {&inside, 1})[0];
  const auto c = corners(b, inner);
  for (std::size_t k = 0; k < 3; ++k)
    inner.triplet[k] = static_cast<std::uint32_t>(
        spec::attribute::vertex_index(order, spec::attribute::vertex_within(t, c[k], b), a + b));
  return inner;
}

Law remap_composes_law() {
  Batches<GridCase> cases;
  cases.settings = {"1+rest", "half", "rest+1"};
  cases.count = grid_count;
  cases.kind = Kind::interior;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t setting, std::span<const GridCase> points,
                   std::span<Outcome> out) {
    const Level a = split_of(setting, n);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Looked steps = in_two_steps(s, a, n - a, points[k].at);
      const Looked once = looked_up(s, VertexOrder::u_major, n, {&points[k].at, 1})[0];
      out[k] = {steps.triplet[0] + 3 * std::uint64_t{steps.triplet[1]}, blend_of(steps) == blend_of(once)};
    }
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t setting, const GridCase& point) {
    const Level a = split_of(setting, n);
    return Words{text_of(looked_up(s, VertexOrder::u_major, n, {&point.at, 1})[0]),
                 text_of(in_two_steps(s, a, n - a, point.at))};
  };
  return on_batches(
      {.id = "attribute.remap_composes",
       .says =
           "remapping to a level a and from there b levels on gives the vertices and weights of level a+b",
       .source = cam_4,
       .subjects = {"attribute-spec"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 12}, .seconds = 0.5},
       .domain = every_point,
       .mutants = {mutant(
           "level 2 is a 2^-28 off in one micro-triangle", "attribute-spec", {5, 5},
           on_weights([](Level n, const GridPoint& p, FixedWeights& w) {
             if (n == 2 && vulkan_triangle(p, n) == MicroTriangle{1, 1, true} && Fixed64::from_raw(4) < w[1])
               w = {w[0] + Fixed64::from_raw(4), w[1] - Fixed64::from_raw(4), w[2]};
           }))}},
      needing({entry::point_triplet, entry::point_weights}), cases);
}

/// Points at which the steps go wrong, from level 2 on.  These are ties inside the middle triangle of level 1, which
/// is turned so that ties go the other way, and the vertices of its edge u+v = 1/2 that are no corners.
bool turned_tie(const GridCase& point) {
  const Fixed64 half = Fixed64::dyadic(1, 1), &u = point.at.u, &v = point.at.v;
  const bool left = u < half && v < half;
  return left &&
         ((point.kind != Kind::interior && half < u + v) || (point.kind == Kind::vertex && u + v == half));
}

/// The micro-triangle found in two steps, of level 1 and level n-1.
MicroTriangle by_recursion(const AttributeSubject& s, Level n, const GridPoint& at) {
  MicroTriangle outer{}, inner{};
  s.functions.lookup.holder(Ties::vulkan, 1, {&at, 1}, {&outer, 1});
  const GridPoint inside = within(weights_by_pattern(at, outer, 1));
  s.functions.lookup.holder(Ties::vulkan, n - 1, {&inside, 1}, {&inner, 1});
  spec::attribute::Corners c = spec::attribute::corners_of(inner);
  for (Vertex& corner : c) corner = spec::attribute::vertex_within(outer, corner, n - 1);
  return spec::attribute::triangle_of(c);
}

Law tie_recursion_law() {
  Batches<GridCase> cases;
  cases.settings = {"faces"};
  cases.count = grid_count;
  cases.kind = Kind::interior;
  const auto pair = [](const AttributeSubject& s, Level n, const GridPoint& at) {
    std::pair<MicroTriangle, MicroTriangle> found;
    s.functions.lookup.holder(Ties::vulkan, n, {&at, 1}, {&found.first, 1});
    found.second = n == 0 ? found.first : by_recursion(s, n, at);
    return found;
  };
  cases.check = [pair](const AttributeSubject& s, Level n, std::size_t, std::span<const GridCase> points,
                       std::span<Outcome> out) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto [once, steps] = pair(s, n, points[k].at);
      out[k] = {steps.iu + 3 * std::uint64_t{steps.iv} + (steps.upper ? 1 : 0),
                (once == steps) != (n >= 2 && turned_tie(points[k]))};
    }
  };
  cases.words = [pair](const AttributeSubject& s, Level n, std::size_t, const GridCase& point) {
    const auto [once, steps] = pair(s, n, point.at);
    return Words{(turned_tie(point) && n >= 2 ? "another than " : "") + text_of(once), text_of(steps)};
  };
  const auto on_holder_at = [](auto change) {
    return spoils(&Functions::lookup, &Lookup::holder,
                  [change](Ties, Level n, Points p, std::span<MicroTriangle> out) {
                    for (std::size_t k = 0; k < out.size(); ++k) change(n, p[k], out[k]);
                  });
  };
  return on_batches(
      {.id = "attribute.tie_recursion_false",
       .says = "taking level 1, remapping and taking level n-1 is not level n: ties inside the middle "
               "triangle go the other way, M(M-1)/2 vertices and 3M(M-1)/2 edges, M = N/2; the first is "
               "(1/4, 1/4) at level 2",
       .source =
           "Color and Attribute Micromaps, 4.1 and 4.4; VK_EXT_opacity_micromap, appendix \"Reference Code\"",
       .subjects = {"attribute-spec"},
       .tiers = {.fast = {0, 6}, .long_run = {0, 12}, .seconds = 0.5},
       .domain = every_point,
       .mutants = {mutant("level 5's ties on one edge inside the middle go the steps' way", "attribute-spec",
                          {5, 5}, on_holder_at([](Level n, const GridPoint& p, MicroTriangle& t) {
                            if (n == 5 && p.u == points::coordinate(4 * 10, 5) &&
                                p.v == points::coordinate(4 * 12 + 2, 5))
                              t = {9, 12, true};
                          }))}},
      needing({entry::holder}), cases);
}

}  // namespace

std::vector<Law> remap_laws() { return {remaps_agree_law(), remap_composes_law(), tie_recursion_law()}; }

}  // namespace mmverify::proofs::attribute
