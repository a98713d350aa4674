// Laws that refute the paper's claims on lookups.
#include <cmath>

#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/lookup/grid_cases.hpp"
#include "proofs/points/exact_float.hpp"

namespace mmverify::proofs::attribute {
namespace {

/// A point of binary32 numbers.
struct Witness {
  float u, v;
};

/// The point below level 14 has no special place.  At level 14 it is the centre of the first micro-triangle, column
/// by column, whose determinant is 0 in binary32: the lower one of square (3493, 9613).
Witness cramer_witness(Level n) {
  if (n < 14) return {0.1f, 0.2f};
  return {3493.25f / 16384, 9613.25f / 16384};
}

/// 2^24 times the greatest error of a weight; infinite if a weight is no number.
double cramer_error(const AttributeSubject& s, Level n, const Witness& p) {
  const RationalPoint at{points::rational(p.u), points::rational(p.v)};
  const RationalWeights exact =
      spec::attribute::weights_by_pattern(at, spec::attribute::vulkan_triangle(at, n), n);
  FloatWeights got{};
  s.functions.lookup.weights_of_floats(n, {{&p.u, 1}, {&p.v, 1}}, {&got, 1});
  double greatest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(got[c])) return HUGE_VAL;
    const spec::Rational error = abs(points::rational(got[c]) - exact[c]) * spec::Integer(1 << 24);
    greatest = std::max(greatest, points::nearest(error));
  }
  return greatest;
}

Finding cramer_loses(const AttributeSubject& s, Level n, const Witness& p) {
  const double error = cramer_error(s, n, p), four_to_n = std::ldexp(1.0, static_cast<int>(2 * n));
  const bool dead = n >= 14;
  if (dead ? std::isinf(error) : four_to_n / 128 <= error && error <= four_to_n / 4)
    return Finding{static_cast<std::uint64_t>(dead ? 0 : error)};
  return wrong(
      dead ? "no number" : fmt::format("{:g} to {:g} times 2^-24 off", four_to_n / 128, four_to_n / 4),
      fmt::format("{:g} times 2^-24 off", error));
}

Law cramer_law() {
  Cases<Witness> cases;
  cases.count = 1;
  cases.number = [](Level n, std::uint64_t, std::uint64_t) { return cramer_witness(n); };
  cases.text = [](Level, const Witness& p) { return fmt::format("u={:a},v={:a}", p.u, p.v); };
  cases.read = [](Level n, const std::string& at) {
    const Witness p = cramer_witness(n);
    if (at != fmt::format("u={:a},v={:a}", p.u, p.v))
      throw BadCase(fmt::format("'{:.60}': the witness is u={:a},v={:a}", at, p.u, p.v));
    return p;
  };
  cases.check = cramer_loses;
  const auto other = [](auto weights_of) {
    return [weights_of](Functions& f) {
      f.lookup.weights_of_floats = [weights_of](Level n, FloatPoints p, std::span<FloatWeights> out) {
        for (std::size_t k = 0; k < out.size(); ++k) {
          const RationalPoint at{points::rational(p.u[k]), points::rational(p.v[k])};
          out[k] = weights_of(n, p.u[k], p.v[k], spec::attribute::vulkan_triangle(at, n));
        }
      };
    };
  };
  return on_cases<Witness>(
      {.id = "paper.cramer_in_binary32",
       .says = "Cramer's rule on the 3x3 system, the paper's general approach, loses two bits a level in "
               "binary32: at (0.1, 0.2) weights are 4^n 2^-31 to 4^n 2^-26 off; at level 14 a determinant is "
               "0, at (3493.25, 9613.25)/2^14",
       .source = "Color and Attribute Micromaps, 4.1, items 1 to 4",
       .method = Method::witness,
       .subjects = {"attribute-cramer-f32"},
       .tiers = {.fast = {4, 14}, .long_run = {4, 14}, .seconds = 0.1},
       .domain = "one point",
       .mutants = {mutant("two of the equations", "attribute-cramer-f32", {4, 6},
                          other([](Level n, float u, float v, const MicroTriangle& t) {
                            return spec::attribute::weights_by_two(spec::Point<float>{u, v},
                                                                   spec::attribute::corners_of(t), n);
                          })),
                   mutant("the uniform pattern", "attribute-cramer-f32", {13, 14},
                          other([](Level n, float u, float v, const MicroTriangle& t) {
                            return spec::attribute::weights_by_pattern(spec::Point<float>{u, v}, t, n);
                          })),
                   mutant("Cramer's rule in binary64", "attribute-cramer-f32", {14, 14},
                          other([](Level n, float u, float v, const MicroTriangle& t) {
                            const auto w = spec::attribute::weights_by_cramer(
                                spec::Point<double>{double{u}, double{v}}, spec::attribute::corners_of(t), n);
                            return FloatWeights{static_cast<float>(w[0]), static_cast<float>(w[1]),
                                                static_cast<float>(w[2])};
                          }))},
       .general = false},
      needing({entry::float_weights}), cases);
}

/// Nine times the squared distance of a micro-vertex from a face's centroid, in units of 1/N, in the base triangle with
/// corners w (0, 0), u (1, 0), v (2, 1).
std::int64_t distance(const spec::attribute::Corners& face, const Vertex& at) {
  std::int64_t a = 3 * std::int64_t{at.i}, b = 3 * std::int64_t{at.j};
  for (const Vertex& c : face) {
    a -= c.i;
    b -= c.j;
  }
  const std::int64_t x = a + 2 * b, y = b;
  return x * x + y * y;
}

/// A vertex nearer to the centroid than one of the three.
std::optional<Vertex> nearer(Level n, const spec::attribute::Corners& three,
                             const spec::attribute::Corners& face) {
  std::int64_t farthest = 0;
  for (const Vertex& c : three) farthest = std::max(farthest, distance(face, c));
  std::vector<Vertex> all(vertex_count(n));
  fill(n, 0, std::span(all));
  for (const Vertex& at : all)
    if (std::find(three.begin(), three.end(), at) == three.end() && distance(face, at) < farthest) return at;
  return std::nullopt;
}

std::optional<Vertex> nearer_than_triplet(const AttributeSubject& s, Level n, const MicroTriangle& t) {
  const std::uint32_t face = indices_of(s, FaceOrder::curve, n, {&t, 1})[0];
  Triplet x{};
  s.functions.orders.triplet(FaceOrder::curve, VertexOrder::w_minor, n, {&face, 1}, {&x, 1});
  spec::attribute::Corners three;
  for (std::size_t c = 0; c < 3; ++c) three[c] = spec::attribute::w_minor_vertex(x[c]);
  return nearer(n, three, spec::attribute::corners_of(t));
}

/// The v-corner's centroid has no nearer vertex than its own.
bool is_exception(Level n, const MicroTriangle& t) { return t == MicroTriangle{0, spec::side(n) - 1, false}; }

std::function<void(Functions&)> on_triplet_of(Level level, std::uint32_t of_face, Triplet instead) {
  return spoils(
      &Functions::orders, &Orders::triplet,
      [=](FaceOrder, VertexOrder, Level n, std::span<const std::uint32_t> face, std::span<Triplet> out) {
        for (std::size_t k = 0; k < out.size(); ++k)
          if (n == level && face[k] == of_face) out[k] = instead;
      });
}

Law not_closest_law() {
  Batches<MicroTriangle> cases;
  cases.settings = {"centroid"};
  cases.count = face_count;
  cases.kind = Kind::interior;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t, std::span<const MicroTriangle> at,
                   std::span<Outcome> out) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto found = nearer_than_triplet(s, n, at[k]);
      out[k] = {found ? found->i + 3 * std::uint64_t{found->j} + 1 : 0,
                found.has_value() != is_exception(n, at[k])};
    }
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t, const MicroTriangle& at) {
    const auto found = nearer_than_triplet(s, n, at);
    return Words{is_exception(n, at) ? "no vertex nearer than the triplet's"
                                     : "a vertex nearer than one of the triplet's",
                 found ? text_of(*found) : "none"};
  };
  return on_batches(
      {.id = "paper.triplet_is_not_closest",
       .says = "figure 4's triplet is that of the micro-triangle, not \"the closest\": on the triangle "
               "(0,0), (1,0), (2,1) all centroids but the v-corner's have a vertex nearer than one of their "
               "three, 3 of 4 at level 1",
       .source = "Color and Attribute Micromaps, 4.1: \"the closest triplet of micro-vertices\"",
       .subjects = {"attribute-spec"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 0.2},
       .domain = "the centroids of the 4^n faces",
       // The nearest vertices of face 0 of level 1, at the w-corner, are (0,0), (1,0) and (2,0), W-minor's 0, 1 and
       // 3.
       .mutants = {mutant("the nearest three at the w-corner of level 1", "attribute-spec", {1, 1},
                          on_triplet_of(1, 0, {0, 1, 3})),
                   mutant("the v-corner's three are others", "attribute-spec", {2, 2},
                          on_triplet_of(2, 15, {9, 13, 12})),
                   mutant("the v-corner's three are others, at level 4", "attribute-spec", {4, 4},
                          on_triplet_of(4, 255, {135, 151, 150})),
                   mutant("the nearest three in level 1's middle", "attribute-spec", {1, 1},
                          on_triplet_of(1, 1, {4, 2, 3}))},
       .general = false},
      needing({entry::face_index, entry::triplet}), cases);
}

}  // namespace

std::vector<Law> lookup_paper_laws() { return {cramer_law(), not_closest_law()}; }

}  // namespace mmverify::proofs::attribute
