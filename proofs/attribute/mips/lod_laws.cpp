// Laws of the level of detail for a ray cone.
#include <cmath>
#include <limits>

#include "proofs/attribute/mips/law_parts.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/points/point.hpp"

namespace mmverify::proofs::attribute {
namespace {

constexpr char cam_442[] = "Color and Attribute Micromaps, 4.4.2, figure 8";

const Entry level_entry{"areas -> level", [](const Functions& f) { return bool{f.mips.lod_level}; }};
const Entry lod_entry{"areas -> level and blend", [](const Functions& f) { return bool{f.mips.lod}; }};

/// The areas of a cone's footprint and of a triangle.
struct Areas {
  float cone, triangle;
};

std::string text_of_areas(const Areas& a) {
  return fmt::format("cone={:a},triangle={:a}", a.cone, a.triangle);
}

float float_of(const std::string& text, const std::string& all) {
  std::size_t end = 0;
  float x = -1;
  try {
    x = std::stof(text, &end);
  } catch (const std::out_of_range&) {
    // A subnormal is no error, unlike in std::stof.
    x = std::strtof(text.c_str(), nullptr);
    end = text.size();
  } catch (const std::invalid_argument&) {
  }
  if (end != text.size() || !(x >= 0) || x > std::numeric_limits<float>::max())
    throw BadCase(fmt::format("'{:.60}': areas are finite numbers of binary32, 0 or more", all));
  return x;
}

Areas areas_of_text(const std::string& text) {
  const Groups g = groups_of(text, "cone=([^,]+),triangle=([^,]+)");
  if (!g) throw BadCase(fmt::format("'{:.60}': write cone=1,triangle=0x1.8p+3", text));
  return {float_of((*g)[1], text), float_of((*g)[2], text)};
}

/// Stiff pairs of areas: triangles a few ulps from 4^m times the cone, also for m below 0 and beyond the last level;
/// any two areas; and the ends: 0, subnormals, the largest.
Areas stiff_areas(Level n, std::uint64_t k, std::uint64_t seed) {
  Random random(seed, 21 + n, k);
  constexpr std::array<float, 8> ends{0.0f,      0x1p-149f, 0x1.8p-148f, 0x1.fffffcp-127f,
                                      0x1p-126f, 1.0f,      0x1p127f,    0x1.fffffep127f};
  if (k < ends.size() * ends.size()) return {ends[k / ends.size()], ends[k % ends.size()]};
  const auto significand = [&] {
    return 1 +
           static_cast<double>(random.below(k % 3 == 0 ? 1u << 23 : 4)) / (k % 3 == 0 ? 1 << 23 : 1 << 23);
  };
  const int e = static_cast<int>(random.between(k % 5 == 0 ? -149 : -20, 20));
  const float cone = std::max(static_cast<float>(std::ldexp(significand(), e)), 0x1p-149f);
  if (k % 7 == 0) {
    const auto power = static_cast<int>(random.between(-20, 40));
    return {cone, static_cast<float>(std::ldexp(significand(), power))};
  }
  const int m = static_cast<int>(random.between(-1, static_cast<std::int64_t>(n) + 1));
  float triangle = std::ldexp(cone, 2 * m);
  for (std::int64_t ulps = random.between(-2, 2); ulps != 0; ulps += ulps < 0 ? 1 : -1)
    triangle = std::nextafter(triangle, ulps < 0 ? 0.0f : std::numeric_limits<float>::max());
  return {cone, triangle};
}

/// The greatest m in 0..n with 4^m A_c <= A_t, or 0.  The product of a binary32 number and 4^m is exact in binary64.
Level exact_level(Level n, const Areas& a) {
  const auto cone = static_cast<double>(a.cone), triangle = static_cast<double>(a.triangle);
  for (Level m = n; m > 0; --m)
    if (std::ldexp(cone, static_cast<int>(2 * m)) <= triangle) return m;
  return 0;
}

Level level_of(const AttributeSubject& s, Level n, const Areas& a) {
  Level level = 0;
  s.functions.mips.lod_level(n, {&a.cone, 1}, {&a.triangle, 1}, {&level, 1});
  return level;
}

using Wrong = std::function<Level(Level n, float cone, float triangle, Level right)>;
std::function<void(Functions&)> levelling(Wrong by) {
  return spoils(
      &Functions::mips, &Mips::lod_level,
      [by](Level n, std::span<const float> cone, std::span<const float> triangle, std::span<Level> out) {
        for (std::size_t k = 0; k < out.size(); ++k) out[k] = by(n, cone[k], triangle[k], out[k]);
      });
}

Level clamped_level(float l, Level n) {
  return !(l > 0) ? 0 : l >= static_cast<float>(n) ? n : static_cast<Level>(l);
}

Mutant wrong_level(const char* name, Levels levels, Wrong by, const char* base = "attribute") {
  return mutant(name, base, levels, levelling(std::move(by)));
}

const Wrong first_covered = [](Level n, float cone, float triangle, Level right) {
  const bool exactly =
      std::ldexp(static_cast<double>(cone), static_cast<int>(2 * right)) >= static_cast<double>(triangle);
  return exactly ? right : std::min(right + 1, n);
};
const Wrong first_exceeded = [](Level n, float cone, float triangle, Level right) {
  return cone > triangle ? 0 : std::min(right + 1, n);
};

Law lod_level_law() {
  Cases<Areas> cases;
  cases.count = {1500, 4'000'000};
  cases.number = stiff_areas;
  cases.text = [](Level, const Areas& a) { return text_of_areas(a); };
  cases.read = [](Level, const std::string& at) { return areas_of_text(at); };
  cases.check = [](const AttributeSubject& s, Level n, const Areas& a) {
    const Level expected = exact_level(n, a), got = level_of(s, n, a);
    // Every level is right if both areas are 0.
    if (got != expected) return wrong(fmt::format("level {}", expected), fmt::format("level {}", got));
    return Finding{.answer = got};
  };
  return on_cases(
      {.id = "attribute.lod_level",
       .says = "a cone of area A_c asks a triangle of area A_t for the greatest level m in 0..n with 4^m A_c "
               "<= A_t, or 0: floor(1/2 log2(A_t/A_c)), kept in range; n where A_c is 0",
       .source = cam_442,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 12}, .long_run = {0, 16}, .seconds = 0.7},
       .domain = "pairs of binary32 areas: 0 to 2 ulps from A_t = 4^m A_c, of any size, 0, subnormals, the "
                 "largest",
       .how = "sample, products exact in binary64",
       .mutants = {wrong_level(
           "kept below n", {0, 5},
           [](Level n, float, float, Level right) { return n == 5 && right == 5 ? 4 : right; })}},
      needing({level_entry}), std::move(cases));
}

// ---- Blending

constexpr double blend_bound = 0x1p-24;

Finding blends(const AttributeSubject& s, Level n, const Areas& a) {
  const LevelOfDetail got = s.functions.mips.lod(n, a.cone, a.triangle);
  const Level level = exact_level(n, a);
  if (got.level != level) return wrong(fmt::format("level {}", level), fmt::format("level {}", got.level));
  Finding found;
  found.answer = level;
  if (level == n || !(a.cone < a.triangle)) {
    if (got.blend != 0) return wrong("no blend", fmt::format("{:a}", got.blend));
    return found;
  }
  constexpr unsigned bits = 60;
  const spec::attribute::Bounds bounds =
      spec::attribute::lod_blend(points::rational(a.cone), points::rational(a.triangle), level, bits);
  const spec::Rational unit(1, spec::Integer(1) << bits), t = points::rational(got.blend),
                                                          slack = points::rational(blend_bound);
  if (t < spec::Rational(bounds.low) * unit - slack || t > spec::Rational(bounds.high) * unit + slack ||
      !(got.blend >= 0) || !(got.blend < 1))
    return wrong(fmt::format("{} within 2^-24", std::ldexp(bounds.low.convert_to<double>(), -60)),
                 fmt::format("{}", got.blend));
  return found;
}

Law lod_blend_law() {
  Cases<Areas> cases;
  cases.count = {400, 100'000};
  cases.number = stiff_areas;
  cases.text = [](Level, const Areas& a) { return text_of_areas(a); };
  cases.read = [](Level, const std::string& at) { return areas_of_text(at); };
  cases.check = blends;
  cases.chunk = 32;
  const auto blending = [](auto by) {
    return spoils(
        &Functions::mips, &Mips::lod,
        [by](Level n, float cone, float triangle, LevelOfDetail& lod) { by(n, cone, triangle, lod); });
  };
  return on_cases(
      {.id = "attribute.lod_blend",
       .says = "the weight of level m + 1 is t = 1/2 log2(A_t / (4^m A_c)) within 2^-24, below 1; 0 at level "
               "n and where A_c >= A_t: an interpolated value is off by 2^-24 of the difference of two mips",
       .source = cam_442,
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 8}, .long_run = {0, 16}, .seconds = 0.6},
       .domain = "pairs of binary32 areas, as attribute.lod_level's",
       .how = "sample, log2 between two whole numbers of 2^-60",
       .mutants = {mutant("blends beyond the last level", "attribute", {0, 3},
                          blending([](Level n, float cone, float triangle, LevelOfDetail& lod) {
                            if (lod.level == n && cone > 0 && cone < triangle) lod.blend = 0x1p-20;
                          }))}},
      needing({lod_entry}), std::move(cases));
}

// ---- The paper

/// The bound of areas in small whole numbers: one cone, all triangles up to it.
constexpr std::uint32_t whole_areas = 130;

Law lod_words_law() {
  Cases<Areas> cases;
  cases.count = std::uint64_t{whole_areas} * 32;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) {
    return Areas{static_cast<float>(k / whole_areas + 1), static_cast<float>(k % whole_areas + 1)};
  };
  cases.text = [](Level, const Areas& a) { return fmt::format("cone={},triangle={}", a.cone, a.triangle); };
  cases.read = [](Level, const std::string& at) { return areas_of_text(at); };
  cases.check = [](const AttributeSubject& s, Level, const Areas& a) {
    constexpr Level last = 16;
    const spec::Rational cone = points::rational(a.cone), triangle = points::rational(a.triangle);
    const Level got = level_of(s, last, a);
    const auto quadrupled = [&](Level m) { return cone * spec::Rational(spec::Integer(1) << (2 * m)); };
    Finding found;
    found.answer = got;
    if (cone > triangle) {
      if (got != 0) return wrong("level 0", fmt::format("level {}", got));
      return found;
    }
    // l = 1/2 log2(A_t/A_c) lies in [m, m + 1].
    const auto brackets = [&](Level m) { return quadrupled(m) <= triangle && triangle <= quadrupled(m + 1); };
    const bool power = quadrupled(got) == triangle;
    const Level covered = spec::attribute::first_level_covered(cone, triangle),
                exceeded = spec::attribute::first_level_exceeded(cone, triangle);
    if (!brackets(got) || !(triangle < quadrupled(got + 1)))
      return wrong("a level m with 4^m A_c <= A_t < 4^(m+1) A_c", fmt::format("level {}", got));
    if (brackets(covered) != power || covered != got + (power ? 0 : 1))
      return wrong(fmt::format("the formula's level is one more but for powers of 4"),
                   fmt::format("level {}", covered));
    if (brackets(exceeded) || exceeded != got + 1)
      return wrong("the words' level is one more", fmt::format("level {}", exceeded));
    return found;
  };
  return on_cases({.id = "paper.lod_words_disagree",
                   .says = "blending levels m and m + 1 fits m = floor(1/2 log2(A_t/A_c)) alone; by the "
                           "formula, the first level with A_c >= A_t/4^m, m is one more but where A_t/A_c is "
                           "a power of 4, by the words, A_c > A_t/4^m, always",
                   .source = "Color and Attribute Micromaps, 4.4.2, (2) and (3)",
                   .subjects = {"attribute-spec", "attribute"},
                   .tiers = {.seconds = 0.4},
                   .at_once = "all levels",
                   .domain = "cones of area 1..32, triangles of 1..130",
                   .mutants = {wrong_level("the formula's level", {0, 0}, first_covered),
                               wrong_level("the words' level", {0, 0}, first_exceeded, "attribute-spec"),
                               wrong_level("log2 of the quotient, rounded", {0, 0},
                                           [](Level n, float cone, float triangle, Level) {
                                             return clamped_level(
                                                 std::round(0.5f * std::log2(triangle / cone)), n);
                                           })},
                   .general = false},
                  needing({level_entry}), std::move(cases));
}

/// Two triangles with a common edge, areas 2^a and 2^b times the cone's.
struct TwoAreas {
  std::uint32_t a, b;
};

Finding edge_jumps(const AttributeSubject& s, Level n, const TwoAreas& t) {
  const auto middle = [&](std::uint32_t power) {
    const LevelOfDetail lod = s.functions.mips.lod(n, 1, std::ldexp(1.0f, static_cast<int>(power)));
    const auto at_level = [](Level m) { return m == 0 ? 0.0 : 1.0; };
    return lod.level == n ? at_level(n)
                          : (1 - lod.blend) * at_level(lod.level) + lod.blend * at_level(lod.level + 1);
  };
  // l = power/2, and from level 1 on both triangles read 1.
  const auto expected = [&](std::uint32_t power) { return n == 0 ? 0.0 : std::min(power / 2.0, 1.0); };
  if (middle(t.a) != expected(t.a) || middle(t.b) != expected(t.b))
    return wrong(fmt::format("{} and {}", expected(t.a), expected(t.b)),
                 fmt::format("{} and {}", middle(t.a), middle(t.b)));
  return {.answer = static_cast<std::uint64_t>(2 * std::abs(expected(t.a) - expected(t.b)))};
}

TwoAreas read_two_areas(Level n, const std::string& at) {
  const Groups g = groups_of(at, "areas=2\\^(\\d{1,2}),2\\^(\\d{1,2})");
  if (!g) throw BadCase(fmt::format("'{:.60}': write areas=2^0,2^1", at));
  const TwoAreas t{static_cast<std::uint32_t>(std::stoul((*g)[1])),
                   static_cast<std::uint32_t>(std::stoul((*g)[2]))};
  if (t.a > 2 * n + 2 || t.b > 2 * n + 2)
    throw BadCase(fmt::format("'{:.60}': powers up to {} at level {}", at, 2 * n + 2, n));
  return t;
}

/// The law that values jump at an edge whose triangles have other areas.  Both triangles' maps of level n have 1 in
/// the middle of the edge and 0 at its ends.  The middle reads 1 from level 1 on, and the mean of the ends at level
/// 0.
Law lod_jumps_law() {
  Cases<TwoAreas> cases;
  cases.count = [](Level n, const Run&) -> std::uint64_t { return std::uint64_t{2 * n + 3} * (2 * n + 3); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    return TwoAreas{static_cast<std::uint32_t>(k / (2 * n + 3)), static_cast<std::uint32_t>(k % (2 * n + 3))};
  };
  cases.text = [](Level, const TwoAreas& t) { return fmt::format("areas=2^{},2^{}", t.a, t.b); };
  cases.read = read_two_areas;
  cases.check = edge_jumps;
  const auto blending = [](const char* name, Levels levels, auto by) {
    return mutant(name, "attribute-spec", levels, [by](Functions& f) {
      f.mips.lod = [by, real = f.mips.lod](Level n, float cone, float triangle) {
        return by(n, triangle / cone, real(n, cone, triangle));
      };
    });
  };
  return on_cases(
      {.id = "paper.lod_jumps_at_base_edges",
       .says = "two triangles with equal values on their common edge read different ones there when their "
               "areas differ: by half of the range for areas 1 and 2 times the cone's, though both have "
               "level 0; nowhere beyond level 1's",
       .source = "Color and Attribute Micromaps, 4.4.2, which does not say it",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 6}, .long_run = {0, 16}, .seconds = 0.1},
       .domain = "areas 2^0 to 2^(2n+2) times the cone's, the middle of the edge",
       .mutants = {blending(
                       "the nearest level alone", {1, 2},
                       [](Level n, float, LevelOfDetail lod) {
                         return LevelOfDetail{lod.blend >= 0.5 ? std::min(lod.level + 1, n) : lod.level, 0};
                       }),
                   blending("no blend at level 5", {5, 5},
                            [](Level n, float, LevelOfDetail lod) {
                              return n == 5 ? LevelOfDetail{lod.level, 0} : lod;
                            }),
                   blending("one level for all", {1, 1},
                            [](Level, float, LevelOfDetail) {
                              return LevelOfDetail{0, 0};
                            }),
                   blending("blends by A_t/A_c", {1, 3},
                            [](Level n, float quotient, LevelOfDetail lod) {
                              return lod.level < n && quotient >= 1 && quotient < 4
                                         ? LevelOfDetail{lod.level, (static_cast<double>(quotient) - 1) / 3}
                                         : lod;
                            })},
       .general = false},
      needing({lod_entry}), std::move(cases));
}

}  // namespace

std::vector<Law> lod_laws() { return {lod_level_law(), lod_blend_law()}; }

std::vector<Law> lod_paper_laws() { return {lod_words_law(), lod_jumps_law()}; }

}  // namespace mmverify::proofs::attribute
