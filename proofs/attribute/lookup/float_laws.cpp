// Lookups of binary32 numbers: the triplet exactly, weights within 2^-24, RGBA8 values within rounding.
#include <cmath>

#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/lookup/grid_cases.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/points/exact_float.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace mmverify::proofs::attribute {

/// A pair of binary32 numbers inside the closed triangle.
struct FloatCase {
  float u, v;
};

namespace {

bool inside(const FloatCase& p) {
  return points::on_exact(p.u, p.v, [](const auto& q) {
    using Q = std::decay_t<decltype(q.u)>;
    return !(q.u < Q(0)) && !(q.v < Q(0)) && !(Q(1) < q.u + q.v);
  });
}

/// Stiff floats of topic index; a pair an ulp beyond the hypotenuse becomes its middle, where a tie is.
FloatCase float_case(Level n, std::uint64_t k, std::uint64_t seed) {
  const points::FloatPair hard = points::stiff_floats(n, seed, k);
  const FloatCase p{hard.u, hard.v};
  return inside(p) ? p : FloatCase{0.5f, 0.5f};
}

Cases<FloatCase> on_floats(std::uint64_t fast, std::uint64_t long_run) {
  Cases<FloatCase> cases;
  cases.count = [fast, long_run](Level, const Run& run) {
    return std::max(run.cases, run.tier == Tier::fast ? fast : long_run);
  };
  cases.number = float_case;
  cases.text = [](Level, const FloatCase& p) { return fmt::format("u={:a},v={:a}", p.u, p.v); };
  cases.read = [](Level, const std::string& at) {
    const RationalPoint p = points::parse_point(at);
    const FloatCase found{static_cast<float>(points::nearest(p.u)), static_cast<float>(points::nearest(p.v))};
    if (points::rational(found.u) != p.u || points::rational(found.v) != p.v)
      throw BadCase(fmt::format("'{:.60}': not a pair of binary32 numbers", at));
    if (!inside(found)) throw BadCase(fmt::format("'{:.60}' lies outside the triangle", at));
    return found;
  };
  cases.chunk = 4096;
  return cases;
}

/// A point at some place of a batch of other points: an implementation that takes eight or sixteen points at a time
/// has another path for few.
class Among {
 public:
  explicit Among(const FloatCase& p)
      : at_((std::bit_cast<std::uint32_t>(p.u) * 0x9e3779b1u ^
             std::bit_cast<std::uint32_t>(p.v) * 0x85ebca6bu) %
            size) {
    for (std::size_t k = 0; k < size; ++k) {
      const float share = static_cast<float>(k) / 32;
      u_[k] = share;
      v_[k] = 0.25f - share / 4;
    }
    u_[at_] = p.u;
    v_[at_] = p.v;
  }
  FloatPoints points() const { return {u_, v_}; }
  /// The answer of `ask(points, answers)` for the point.
  template <class Answer, class Ask>
  Answer answer(Ask ask) const {
    std::array<Answer, size> all{};
    ask(points(), std::span<Answer>(all));
    return all[at_];
  }

 private:
  static constexpr std::size_t size = 19;
  std::size_t at_;
  std::array<float, size> u_{}, v_{};
};

MicroTriangle exact_holder(Level n, const FloatCase& p) {
  return points::on_exact(p.u, p.v, [n](const auto& q) { return spec::attribute::vulkan_triangle(q, n); });
}

RationalWeights exact_weights(Level n, const MicroTriangle& t, const FloatCase& p) {
  return spec::attribute::weights_by_pattern(RationalPoint{points::rational(p.u), points::rational(p.v)}, t,
                                             n);
}

Triplet exact_triplet(VertexOrder order, Level n, const MicroTriangle& t) {
  const auto x = spec::attribute::triplet(order, t, n);
  return {static_cast<std::uint32_t>(x[0]), static_cast<std::uint32_t>(x[1]),
          static_cast<std::uint32_t>(x[2])};
}

std::string float_points(const Subject&, Level) {
  return "binary32 pairs near grid lines, diagonals and corners";
}

Law triplets_law() {
  Cases<FloatCase> cases = on_floats(10'000, 1'000'000);
  cases.check = [](const AttributeSubject& s, Level n, const FloatCase& p) {
    const MicroTriangle t = exact_holder(n, p);
    Finding finding;
    for (const VertexOrder order : vertex_orders) {
      const auto got = Among(p).answer<Triplet>([&](FloatPoints points, std::span<Triplet> out) {
        s.functions.lookup.triplet_of_floats(order, n, points, out);
      });
      finding.answer = 31 * finding.answer + got[0] + 3 * std::uint64_t{got[1]} + 5 * std::uint64_t{got[2]};
      if (const Triplet want = exact_triplet(order, n, t); got != want)
        return wrong(fmt::format("{} in {}", text_of(want), name_of(order)), text_of(got));
    }
    return finding;
  };
  const auto on_triplet_of_floats = [](auto change) {
    return spoils(&Functions::lookup, &Lookup::triplet_of_floats,
                  [change](VertexOrder order, Level n, FloatPoints p, std::span<Triplet> out) {
                    for (std::size_t k = 0; k < out.size(); ++k)
                      change(order, n, FloatCase{p.u[k], p.v[k]}, out[k]);
                  });
  };
  return on_cases<FloatCase>(
      {.id = "attribute.triplets_on_floats",
       .says = "the triplet of a pair of binary32 numbers is that of the exact numbers, in each order, ties "
               "included",
       .source = cam_4,
       .method = Method::sample,
       .subjects = {"attribute", "attribute-single"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 1},
       .domain = float_points,
       .mutants = {mutant(
           "a point on u = 1/2 is rounded to the left at level 9", "attribute", {9, 9},
           on_triplet_of_floats([](VertexOrder order, Level n, const FloatCase& p, Triplet& x) {
             if (n == 9 && p.u == 0.5f && p.v > 0 && p.v < 0.25f)
               x = exact_triplet(order, n, exact_holder(n, {std::nextafter(p.u, 0.0f), p.v}));
           }))}},
      needing({entry::float_triplet}), cases);
}

/// 2^24 times the greatest error of a weight.
double greatest_error(const RationalWeights& exact, const FloatWeights& got) {
  spec::Rational greatest{spec::Integer(0)};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(got[c])) return HUGE_VAL;
    greatest = std::max(greatest, abs(points::rational(got[c]) - exact[c]));
  }
  return points::nearest(greatest * spec::Integer(1 << 24));
}

Law weights_law() {
  Cases<FloatCase> cases = on_floats(2'000, 300'000);
  cases.check = [](const AttributeSubject& s, Level n, const FloatCase& p) {
    const RationalWeights exact = exact_weights(n, exact_holder(n, p), p);
    const auto got = Among(p).answer<FloatWeights>([&](FloatPoints points, std::span<FloatWeights> out) {
      s.functions.lookup.weights_of_floats(n, points, out);
    });
    const double error = greatest_error(exact, got);
    const bool none_negative = got[0] >= 0 && got[1] >= 0 && got[2] >= 0;
    Finding finding{std::bit_cast<std::uint32_t>(got[0]) +
                    3 * std::uint64_t{std::bit_cast<std::uint32_t>(got[1])}};
    if (error <= 1 && none_negative) return finding;
    return wrong(fmt::format("{:.9g} {:.9g} {:.9g}, each within 2^-24 and none below 0",
                             points::nearest(exact[0]), points::nearest(exact[1]), points::nearest(exact[2])),
                 fmt::format("{:.9g} {:.9g} {:.9g}, {:.3g} times 2^-24 off", got[0], got[1], got[2], error));
  };
  const auto on_weights_of_floats = [](auto change) {
    return spoils(&Functions::lookup, &Lookup::weights_of_floats,
                  [change](Level n, FloatPoints p, std::span<FloatWeights> out) {
                    for (std::size_t k = 0; k < out.size(); ++k) change(n, FloatCase{p.u[k], p.v[k]}, out[k]);
                  });
  };
  return on_cases<FloatCase>(
      {.id = "attribute.weights_on_floats",
       .says =
           "weights by the pattern are within 2^-24 of the exact ones at every level, and none is below 0",
       .source = "Color and Attribute Micromaps, 4.1, which omits it",
       .method = Method::sample,
       .subjects = {"attribute", "attribute-single"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 1},
       .domain = float_points,
       .mutants = {mutant("Cramer's rule at level 4", "attribute", {4, 4},
                          on_weights_of_floats([](Level n, const FloatCase& p, FloatWeights& w) {
                            if (n == 4)
                              w = spec::attribute::weights_by_cramer(
                                  spec::Point<float>{p.u, p.v},
                                  spec::attribute::corners_of(exact_holder(n, p)), n);
                          }))}},
      needing({entry::float_weights}), cases);
}

/// The value of a vertex in the map of the law; neighbours differ much in every channel.
std::uint32_t colour(const Vertex& at) {
  Random random(0, at.i, at.j);
  return static_cast<std::uint32_t>(random.next());
}

/// The map of colour() in an order.
const std::vector<std::uint32_t>& colour_map(VertexOrder order, Level n) {
  static std::mutex mutex;
  static std::map<std::pair<VertexOrder, Level>, std::vector<std::uint32_t>> made;
  const std::lock_guard lock(mutex);
  auto& map = made[{order, n}];
  if (map.empty())
    for (std::uint64_t x = 0; x < vertex_count(n); ++x)
      map.push_back(colour(spec::attribute::vertex_at(order, x, n)));
  return map;
}

Law rgba8_law() {
  Cases<FloatCase> cases = on_floats(1'000, 100'000);
  cases.check = [](const AttributeSubject& s, Level n, const FloatCase& p) {
    const MicroTriangle t = exact_holder(n, p);
    const RationalWeights w = exact_weights(n, t, p);
    const auto corners = spec::attribute::corners_of(t);
    std::array<spec::Rational, 4> exact;
    for (unsigned channel = 0; channel < 4; ++channel) {
      const auto of = [&](std::size_t c) { return colour(corners[c]) >> (8 * channel) & 0xff; };
      exact[channel] = spec::attribute::interpolated(w, {of(0), of(1), of(2)});
    }
    // Half a code, and 2^-13 for the errors of weights and sum.
    const spec::Rational most(spec::Integer(4097), spec::Integer(8192));
    Finding finding;
    for (const VertexOrder order : vertex_orders) {
      const auto got = Among(p).answer<std::uint32_t>([&](FloatPoints points, std::span<std::uint32_t> out) {
        s.functions.lookup.rgba8(order, n, colour_map(order, n), points, out);
      });
      finding.answer = got;
      for (unsigned channel = 0; channel < 4; ++channel) {
        const std::uint32_t code = got >> (8 * channel) & 0xff;
        if (abs(spec::Rational(spec::Integer(code)) - exact[channel]) <= most) continue;
        return wrong(fmt::format("channel {} in {}: {:.6f} rounded", channel, name_of(order),
                                 points::nearest(exact[channel])),
                     fmt::format("{}", code));
      }
    }
    return finding;
  };
  const auto on_rgba8 = [](auto change) {
    return spoils(&Functions::lookup, &Lookup::rgba8,
                  [change](VertexOrder order, Level n, std::span<const std::uint32_t>, FloatPoints p,
                           std::span<std::uint32_t> out) {
                    for (std::size_t k = 0; k < out.size(); ++k)
                      out[k] = change(order, n, FloatCase{p.u[k], p.v[k]}, out[k]);
                  });
  };
  return on_cases<FloatCase>(
      {.id = "attribute.interpolates_rgba8",
       .says = "each channel of an RGBA8 value is within 1/2 + 2^-13 of the exact mean of its vertices' by "
               "the weights",
       .source = cam_4,
       .method = Method::sample,
       .subjects = {"attribute", "attribute-single"},
       .tiers = {.fast = {0, 8}, .long_run = {0, 10}, .seconds = 1},
       .domain = float_points,
       .mutants = {mutant("red and blue change places at one level", "attribute", {5, 5},
                          on_rgba8([](VertexOrder, Level n, const FloatCase&, std::uint32_t got) {
                            if (n != 5) return got;
                            return (got & 0xff00ff00u) | (got >> 16 & 0xff) | (got & 0xff) << 16;
                          }))}},
      needing({entry::rgba8}), cases);
}

}  // namespace

std::vector<Law> float_lookup_laws() { return {triplets_law(), weights_law(), rgba8_law()}; }

}  // namespace mmverify::proofs::attribute
