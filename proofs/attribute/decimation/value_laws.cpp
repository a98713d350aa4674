// Edges beside a neighbour of one level less: what is interpolated there, under either meaning.
#include "proofs/attribute/batches.hpp"
#include "proofs/attribute/lookup/shared_edges.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/points/point.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::side;

std::string or_nothing(const std::optional<Hats>& hats) {
  return hats ? text_of_places(*hats) : std::string("a vertex off the edge");
}

std::uint64_t digest_of_hats(const Hats& hats) {
  std::uint64_t sum = 0;
  for (const auto& [place, weight] : hats)
    sum += Tally::digest_of(place, static_cast<std::uint64_t>(std::ldexp(weight, 40)));
  return sum;
}

using WeighedPoint = std::function<WeightedVertices(Level, EdgeFlags, const DyadicPoint&)>;
std::function<void(Functions&)> placing(
    std::function<WeightedVertices(const WeighedPoint& real, Level, EdgeFlags, const DyadicPoint&)> by) {
  return [by](Functions& f) {
    f.decimation.place = [by, real = f.decimation.place](Level n, EdgeFlags flags, const DyadicPoint& p) {
      return by(real, n, flags, p);
    };
  };
}

/// The lookup of the paper's section 4.1, with the vertices adjusted as in 3.2: the micro-triangle as it was, its weights
/// by the triangle that its vertices are now, or, where that is degenerate, as they were.
WeightedVertices looked_up_as_printed(Level n, EdgeFlags flags, const DyadicPoint& p, bool remapped) {
  const MicroTriangle t = spec::attribute::vulkan_triangle(p, n);
  const Corners after = spec::attribute::snapped(t, n, flags);
  auto place = spec::attribute::place_on(after, p, n);
  if (!remapped || place.area == 0) place = spec::attribute::place_on(spec::attribute::corners_of(t), p, n);
  WeightedVertices found{after, {}};
  for (std::size_t c = 0; c < 3; ++c)
    found.weights[c] = as_number(place.shares[c]) / static_cast<double>(place.area);
  return found;
}

// ---- Neighbours

Law decimation_neighbours_law() {
  Cases<SharedEdge> cases;
  cases.count = [](Level n, const Run&) { return shared_edge_cases(n); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) { return shared_edge(n, k); };
  cases.text = [](Level n, const SharedEdge& e) { return text_of(n, e); };
  cases.read = [](Level n, const std::string& at) { return shared_edge_of_text(n, at); };
  cases.check = [](const AttributeSubject& s, Level n, const SharedEdge& e) {
    const Hats expected = along_edge(n, e.at, side(n) / 2);
    for (const bool finer : {true, false}) {
      const auto got = finer ? of_finer(s, n, e) : of_neighbour(s, n, n - 1, e);
      if (!got || *got != expected)
        return wrong(text_of_places(expected),
                     fmt::format("{}, on the side of level {}", or_nothing(got), finer ? n : n - 1));
    }
    return Finding{.answer = digest_of_hats(expected)};
  };
  Law law = on_cases(
      {.id = "attribute.decimation_neighbours",
       .says = "a flagged edge of level n and an unflagged one of level n-1 interpolate the same vertices "
               "with the same weights, the hat functions of level n-1, whichever edges meet and whatever "
               "their other flags",
       .source = cam_3,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {1, 12}, .long_run = {1, 12}, .seconds = 3},
       .domain = "3 edges and 4 sets of other flags on either side, the points k/(4N) of the edge",
       .mutants = {mutant(
           "one vertex of level 6 stays", "attribute-spec", {6, 6},
           placing([](const WeighedPoint& real, Level n, EdgeFlags flags, const DyadicPoint& p) {
             const bool there = n == 6 && p.u == spec::Fixed64::dyadic(21, 6) && p.v == spec::Fixed64(0);
             return real(n, there ? flags & ~1u : flags, p);
           }))},
       .companion = "attribute.decimation_lookup_on_floats"},
      needing({place_entry}), std::move(cases));
  law.unfit = [unfit = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (n == 0) return "there is no level below";
    return unfit(s, n);
  };
  return law;
}

// ---- Lookup

/// A point and the flags.
template <class P>
struct Lookedup {
  EdgeFlags flags;
  P point;
};

template <class Q>
Finding judged_place(const spec::Point<Q>& p, Level n, EdgeFlags flags, const WeightedVertices& place,
                     double within) {
  const Hats got = hats_of(place);
  const std::vector<Hats> expected = all_that_hold(p, n, flags);
  if (expected.empty()) return wrong("a live micro-triangle that holds the point", "none");
  for (const Hats& hats : expected)
    if (!same(hats, got, within)) return wrong(text_of(hats), text_of(got));
  return {.answer = digest_of_hats(expected.front())};
}

std::pair<EdgeFlags, std::string> flags_and_rest(const std::string& at) {
  const std::size_t comma = at.find(',');
  if (comma == std::string::npos) throw BadCase(fmt::format("'{:.60}': write flags=3,u=1/4,v=1/8", at));
  return {flags_of_text(at.substr(0, comma)), at.substr(comma + 1)};
}

Law decimated_lookup_law() {
  using Case = Lookedup<DyadicPoint>;
  Cases<Case> cases;
  cases.count = [](Level n, const Run&) { return spec::attribute::edge_flag_sets * points::cell_count(n); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    Case found{static_cast<EdgeFlags>(k % spec::attribute::edge_flag_sets), {}};
    const std::uint64_t cell = k / spec::attribute::edge_flag_sets;
    points::Cells(n).rows(cell, cell + 1,
                          [&](const points::Row& row) { found.point = points::representative(row, 0, n); });
    return found;
  };
  cases.text = [](Level n, const Case& c) {
    return fmt::format("flags={},{}", c.flags, points::case_text(points::rational(c.point), n));
  };
  cases.read = [](Level n, const std::string& at) {
    const auto [flags, rest] = flags_and_rest(at);
    const points::RationalPoint p = points::parse_point(rest);
    const spec::Rational N(spec::Integer(4) << n);
    const auto whole = [&](const spec::Rational& x) {
      if ((x * N).denominator() != 1)
        throw BadCase(
            fmt::format("'{:.60}': coordinates are k/{} at level {}", at, 4 * std::uint64_t{side(n)}, n));
      return spec::Fixed64::dyadic(static_cast<std::int64_t>((x * N).numerator()), n + 2);
    };
    if (p.u + p.v > 1) throw BadCase(fmt::format("'{:.60}': outside the triangle", at));
    return Case{flags, {whole(p.u), whole(p.v)}};
  };
  cases.check = [](const AttributeSubject& s, Level n, const Case& c) {
    return judged_place(c.point, n, c.flags, s.functions.decimation.place(n, c.flags, c.point), 0);
  };
  return on_cases(
      {.id = "attribute.decimation_lookup",
       .says = "the lookup gives the weights that the point has on every live micro-triangle that holds it; "
               "which of several it is does not matter",
       .source = "docs/ATTRIBUTE.md, \"Decimation\"; Color and Attribute Micromaps, 3.2 and 4.1, has no "
                 "lookup for it",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 9}, .seconds = 0.6},
       .domain = "the 3N^2+3N+1 representatives, 8 sets of flags",
       .mutants = {mutant(
           "no second try beside the v-corner of level 5", "attribute-spec", {5, 5},
           placing([](const WeighedPoint& real, Level n, EdgeFlags flags, const DyadicPoint& p) {
             const bool there = n == 5 && spec::Fixed64::dyadic(31, 5) < p.v;
             return there ? looked_up_as_printed(n, flags, p, true) : real(n, flags, p);
           }))},
       .companion = "attribute.decimation_lookup_on_floats"},
      needing({place_entry}), std::move(cases));
}

/// Floats near the lines of the grid and near the slanted ones that decimation brings, inside the triangle.
points::FloatPair floats_at_moved_edges(Level n, std::uint64_t seed, std::uint64_t k) {
  points::FloatPair p = points::stiff_floats(n, seed, k);
  Random random(seed, 7, k);
  if (k % 2 == 0) {
    // x + 2y, 2x + y or x - y is whole, near a base edge, but for a few ulps.
    const double N = side(n), near = static_cast<double>(random.below(1u << 24)) / (1u << 24);
    const double whole = static_cast<double>(random.below(side(n) + 1));
    double x = whole, y = near;
    switch (random.below(3)) {
      case 0: x = whole - 2 * near; break;
      case 1: x = near, y = whole - 2 * near; break;
      default: x = (N - whole) + near, y = whole - 2 * near; break;
    }
    p = {static_cast<float>(std::clamp(x / N, 0.0, 1.0)), static_cast<float>(std::clamp(y / N, 0.0, 1.0))};
    for (std::uint64_t ulps = random.below(3); ulps > 0; --ulps)
      p.u = std::nextafter(p.u, random.below(2) == 0 ? 0.0f : 1.0f);
  }
  p = {std::abs(p.u), std::min(std::abs(p.v), static_cast<float>(1 - static_cast<double>(p.u)))};
  const auto sum = [&] { return points::rational(p.u) + points::rational(p.v); };
  while (sum() > 1) p.v = std::nextafter(p.v, 0.0f);
  return p;
}

spec::Fixed256 exactly(float x) {
  // Units of 2^-150: every binary32 number is a whole number of them, 24 bits long at most.
  int e = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 24));
  const int by = e - 24 + 150;
  return spec::Fixed256::from_raw(by < 0 ? spec::Int256(m >> -by) : spec::Int256(m) << by);
}

Finding judged_floats(const AttributeSubject& s, Level n, const Lookedup<points::FloatPair>& c) {
  const spec::Point<spec::Fixed256> p{exactly(c.point.u), exactly(c.point.v)};
  return judged_place(p, n, c.flags, s.functions.decimation.place_f32(n, c.flags, c.point.u, c.point.v),
                      0x1p-24);
}

Law decimated_floats_law() {
  using Case = Lookedup<points::FloatPair>;
  Cases<Case> cases;
  cases.count = {800, 200'000};
  cases.number = [](Level n, std::uint64_t k, std::uint64_t seed) {
    return Case{static_cast<EdgeFlags>(Random(seed, 8, k).below(8)), floats_at_moved_edges(n, seed, k)};
  };
  cases.text = [](Level n, const Case& c) {
    return fmt::format("flags={},{}", c.flags,
                       points::case_text({points::rational(c.point.u), points::rational(c.point.v)}, n));
  };
  cases.read = [](Level, const std::string& at) {
    const auto [flags, rest] = flags_and_rest(at);
    const points::RationalPoint p = points::parse_point(rest);
    if (p.u + p.v > 1 || p.u < 0 || p.v < 0) throw BadCase(fmt::format("'{:.60}': outside the triangle", at));
    return Case{flags, {static_cast<float>(points::nearest(p.u)), static_cast<float>(points::nearest(p.v))}};
  };
  cases.check = judged_floats;
  const auto on_floats = [](auto by) {
    return [by](Functions& f) {
      f.decimation.place_f32 = [by, real = f.decimation.place_f32](Level n, EdgeFlags flags, float u,
                                                                   float v) {
        return by(real, n, flags, u, v);
      };
    };
  };
  return on_cases(
      {.id = "attribute.decimation_lookup_on_floats",
       .says = "at binary32 points each weight is within 2^-24 of that on the live micro-triangle that holds "
               "the very point",
       .source = "docs/ATTRIBUTE.md, \"Decimation\"",
       .method = Method::sample,
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 8}, .long_run = {0, 12}, .seconds = 0.6},
       .domain = "binary32 pairs in the triangle, few ulps from lines of the grid and from the edges that "
                 "move",
       .how = "sample, in fixed point of 150 bits",
       .mutants = {mutant("weights in 20 bits at level 7", "attribute", {7, 7},
                          on_floats([](const auto& real, Level n, EdgeFlags flags, float u, float v) {
                            WeightedVertices w = real(n, flags, u, v);
                            for (double& x : w.weights)
                              if (n == 7) x = std::round(x * 0x1p20) * 0x1p-20;
                            return w;
                          }))}},
      needing({{"binary32 point -> decimated micro-triangle",
                [](const Functions& f) { return bool{f.decimation.place_f32}; }}}),
      std::move(cases));
}

std::string text_of_pair(const std::array<Vertex, 2>& pair) {
  return text_of(pair[0]) + " and " + text_of(pair[1]);
}

/// x = (a + b) / 2; a and b are even vertices beside it on its edge where it is an odd one of a flagged edge, else x.
/// Then the edge's values at level n are linear from even vertex to even vertex: level n-1's.
bool is_mean_of(const Vertex& x, const std::array<Vertex, 2>& pair, Level n, EdgeFlags flags) {
  const auto [a, b] = pair;
  if (a.i + b.i != 2 * x.i || a.j + b.j != 2 * x.j) return false;
  const std::uint32_t N = side(n), k = N - x.i - x.j;
  const bool on_v0 = (flags & 1) != 0 && x.j == 0 && x.i % 2 == 1,
             on_w0 = (flags & 2) != 0 && k == 0 && x.j % 2 == 1,
             on_u0 = (flags & 4) != 0 && x.i == 0 && x.j % 2 == 1;
  if (n == 0 || !(on_v0 || on_w0 || on_u0)) return a == x;
  const auto apart = [](std::uint32_t p, std::uint32_t q) { return p < q ? q - p : p - q; };
  const std::uint32_t di = apart(a.i, x.i), dj = apart(a.j, x.j);
  if (on_v0) return di == 1 && dj == 0;
  if (on_u0) return di == 0 && dj == 1;
  return di == 1 && dj == 1 && a.i + a.j == N;
}

Law decimation_means_law() {
  Batches<Vertex> cases;
  for (EdgeFlags flags = 0; flags < spec::attribute::edge_flag_sets; ++flags)
    cases.settings.push_back(fmt::format("flags={}", flags));
  cases.count = spec::attribute::vertex_count;
  cases.kind = Kind::vertex;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t flags, std::span<const Vertex> at,
                   std::span<Outcome> out) {
    std::vector<std::array<Vertex, 2>> pairs(at.size());
    s.functions.decimation.averaged(n, static_cast<EdgeFlags>(flags), at, pairs);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {number(pairs[k][0]) ^ number(pairs[k][1]),
                is_mean_of(at[k], pairs[k], n, static_cast<EdgeFlags>(flags))};
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t flags, const Vertex& x) {
    std::array<Vertex, 2> pair{};
    s.functions.decimation.averaged(n, static_cast<EdgeFlags>(flags), {&x, 1}, {&pair, 1});
    return Words{text_of_pair(spec::attribute::averaged(x, n, static_cast<EdgeFlags>(flags))),
                 text_of_pair(pair)};
  };
  const auto averaging = [](auto by) {
    return spoils(
        &Functions::decimation, &Decimation::averaged,
        [by](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<std::array<Vertex, 2>> out) {
          for (std::size_t k = 0; k < at.size(); ++k) by(n, flags, at[k], out[k]);
        });
  };
  using Pair = std::array<Vertex, 2>;
  return on_batches(
      {.id = "attribute.decimation_means",
       .says =
           "in the other meaning nothing moves: an odd vertex's value on a flagged edge is the mean of its "
           "two even neighbours', so that the edge has level n-1's values; every other vertex keeps its own",
       .source = "docs/ATTRIBUTE.md, \"Decimation\"",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 14}, .seconds = 0.5},
       .domain = "the 8 sets of flags, all V(n) vertices",
       .mutants = {mutant("one even vertex of level 9 is averaged, too", "attribute", {9, 9},
                          averaging([](Level n, EdgeFlags flags, const Vertex& x, Pair& pair) {
                            if (n == 9 && flags == 5 && x == Vertex{0, 510})
                              pair = {Vertex{0, 509}, Vertex{0, 511}};
                          }))}},
      needing({averaged_entry}), std::move(cases));
}

Law mean_codes_law() {
  Cases<std::uint32_t> cases;  // a code; beside all
  cases.count = 256;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) { return static_cast<std::uint32_t>(k); };
  cases.text = [](Level, std::uint32_t x) { return fmt::format("code={}", x); };
  cases.read = [](Level, const std::string& at) {
    std::uint32_t x = 256;
    if (at.starts_with("code=") && at.size() <= 8 && at.size() > 5 &&
        at.find_first_not_of("0123456789", 5) == std::string::npos)
      x = static_cast<std::uint32_t>(std::stoul(at.substr(5)));
    if (x > 255) throw BadCase(fmt::format("'{:.60}': write code=0 to code=255", at));
    return x;
  };
  cases.check = [](const AttributeSubject& s, Level, std::uint32_t x) {
    Finding found;
    for (std::uint32_t y = 0; y < 256; ++y) {
      const auto a = static_cast<std::uint8_t>(x), b = static_cast<std::uint8_t>(y);
      const std::uint32_t mean = s.functions.decimation.mean(a, b);
      found.answer += Tally::digest_of(y, mean);
      if (2 * mean < x + y || 2 * mean > x + y + 1)
        return wrong(fmt::format("({} + {}) / 2, halves up", x, y), fmt::format("{}", mean));
    }
    return found;
  };
  const auto meaning = [](auto by) {
    return [by](Functions& f) {
      f.decimation.mean = [by](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(by(std::uint32_t{x}, std::uint32_t{y}));
      };
    };
  };
  return on_cases(
      {.id = "attribute.decimation_half_a_code",
       .says = "in 8 bits the mean is rounded, halves up: beside the neighbour of level n-1 half a code of "
               "step is left at most",
       .source = "docs/ATTRIBUTE.md, \"Decimation\"",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.seconds = 0.01},
       .at_once = "all levels",
       .domain = "the 65,536 pairs of codes",
       .mutants = {mutant("one pair", "attribute", {0, 0}, meaning([](std::uint32_t x, std::uint32_t y) {
                            return (x + y + 1) / 2 + (x == 200 && y == 13 ? 1 : 0);
                          }))}},
      needing({{"mean of two codes", [](const Functions& f) { return bool{f.decimation.mean}; }}}),
      std::move(cases));
}

}  // namespace

std::vector<Law> decimated_value_laws() {
  return {decimation_neighbours_law(), decimated_lookup_law(), decimated_floats_law(), decimation_means_law(),
          mean_codes_law()};
}

}  // namespace mmverify::proofs::attribute
