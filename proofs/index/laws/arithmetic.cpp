// The laws about arithmetic: floats, fixed point, and what a representative stands for.
#include <fmt/format.h>

#include "proofs/index/judges/false_claims.hpp"
#include "proofs/index/laws/groups.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

// For each of the 0x3C01 encodings of u in [0,1], the encodings of v up to the greatest number not above 1-u.
// The run counts them anew; a different number is an error.
constexpr std::uint64_t pairs_of_binary16 = 231'750'657;

std::uint64_t hard_pairs(Level, const Run& run) { return run.tier == Tier::fast ? 1'000'000 : 100'000'000; }
std::uint64_t rational_points(Level, const Run& run) { return run.tier == Tier::fast ? 1'000 : 100'000; }

std::string floats(const Subject& s, Level) {
  return fmt::format("a sample of binary32 pairs near what breaks index functions{}",
                     subject_as<IndexSubject>(s).functions.arithmetic == Arithmetic::binary16
                         ? ", rounded to binary16"
                         : "");
}
std::string rationals(const Subject&, Level) { return "a sample of rational points inside cells"; }

Law exact_on_floats_law() {
  const auto wrong_at = [](const char* name, const char* base, Level level, float u, float v) {
    return mutant(name, base, {level, level},
                  on_floats([=](Level n, float pu, float pv, std::uint32_t answer) {
                    return n == level && pu == u && pv == v ? answer ^ 1 : answer;
                  }));
  };
  return {.id = "index.exact_on_floats",
          .says = "for binary32 numbers the index is that of the exact reference for those very numbers",
          .source = vulkan,
          .method = Method::sample,
          .subjects = {"step", "impl"},
          .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 12},
          .cases = hard_pairs,
          .domain = floats,
          .how = by_sample,
          .unfit = needing({entry::index}),
          .divisible = true,
          .judge =
              [](const Subject& s, Level n, const Run& run) {
                return exact_on_floats(subject_as<IndexSubject>(s), n, run, hard_pairs(n, run));
              },
          .replay = replayed_by(replay_equals_reference),
          .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "impl", 9, 0.5f,
                               0x1.fffffep-2f)},
          .heeds = {&interiors_only},
          .knows_near = true,
          .companion = "index.exact_on_doubles",
          .dialect = "exact",
          .in_dialect = {{"published", "index.equals_published"}, {"either", "index.exact_or_published"}}};
}

Law floats_err_law() {
  const auto right_at_7 = [](const char* name, const char* base) {
    return mutant(name, base, {7, 7}, on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
                    return n == 7 ? spec::index::reference(p, n) : answer;
                  }));
  };
  return {.id = "index.rounded_arithmetic_errs",
          .says =
              "neither algorithm is exact in binary16, binary32 or binary64: each misplaces one of two given "
              "points",
          .source = "docs/ERRATA.md, \"In rounded arithmetic\"",
          .method = Method::witness,
          .subjects = {"reference-f16", "reference-f32", "reference-f64", "step-f16", "step-f32", "step-f64"},
          .tiers = {.fast = {1, 10}, .long_run = {1, 10}, .seconds = 0.1},
          .cases = [](Level, const Run&) -> std::uint64_t { return 1; },
          .domain = [](const Subject&, Level) { return std::string("two points"); },
          .how = by_witness,
          .unfit = [fits = needing({entry::index})](const Subject& s, Level n) -> std::optional<std::string> {
            if (n < 1 || n > 10) return "the two points are stated for levels 1 to 10";
            return fits(s, n);
          },
          .judge = judged_by(floats_err),
          .mutants = {right_at_7("binary16 with a guard at level 7", "reference-f16"),
                      {"impl, which compares without a sum", built_in("impl"), {1, 1}},
                      {"exact arithmetic", built_in("reference"), {5, 5}}},
          .general = false};
}

Law cells_decide_law() {
  return {
      .id = "index.cells_decide",
      .says = "every rational point inside a cell has the index of the cell's representative",
      .source = "docs/SOUNDNESS.md, \"Why cells prove all rationals\"",
      .method = Method::sample,
      .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names"},
      .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 3},
      .cases = rational_points,
      .domain = rationals,
      .how = by_sample,
      .unfit = needing_exact({entry::index}),
      .divisible = true,
      .judge =
          [](const Subject& s, Level n, const Run& run) {
            return cells_decide(subject_as<IndexSubject>(s), n, run, rational_points(n, run));
          },
      .mutants = {single("one interior representative of level 4", "reference", 4, 1, corner(4) - 3),
                  single("one edge's representative of level 5", "step", 5, 4 * 3 + 2, 4 * 5),
                  mutant("representatives of level 9 only", "step", {9, 9},
                         on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                           return n == 9 ? answer ^ 1 : answer;
                         }))},
      .heeds = {&interiors_only}};
}

Law fixed_is_rational_law() {
  const auto off = [](const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv) {
    return mutant(name, base, {level, level}, on_points(only_at_point(level, ku, kv, level, 1), false));
  };
  return {
      .id = "index.fixed_is_rational",
      .says = "64-bit fixed point gives the answers of rational arithmetic, and so do rationals of 63 bits",
      .source = "docs/SOUNDNESS.md, \"No sum overflows\"",
      .method = Method::exhaustive,
      .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names"},
      .tiers = {.fast = {0, 8}, .long_run = {0, 8}, .seconds = 6},
      .cases = all_cells,
      .domain = points,
      .how = against_rationals,
      .unfit = needing_exact({entry::index}),
      .divisible = true,
      .judge = judged_by(fixed_is_rational),
      .mutants = {off("one vertex of level 6", "step", 6, corner(6) / 4, corner(6) / 2),
                  mutant("one vertex of level 5, in rationals of 63 bits alone", "reference", {5, 5},
                         on_rationals(&Functions::index_at, only_at_point(5, 4 * 6, 4 * 9, 5, 1))),
                  off("one interior point of level 5", "reference", 5, 4 * 7 + 3, 4 * 9 + 3),
                  mutant("a fraction bit is lost from level 4 on", "reference", {0, 5},
                         on_points(
                             [](Level n, const GridPoint& p, std::uint32_t answer) {
                               if (n < 4) return answer;
                               const auto even = [n](const Fixed64& q) {
                                 const std::int64_t lost = std::int64_t{1}
                                                           << (Fixed64::fraction_bits - n - 1);
                                 return Fixed64::from_raw(q.raw() & ~lost);
                               };
                               return spec::index::reference(GridPoint{even(p.u), even(p.v)}, n);
                             },
                             false))},
      .heeds = {&interiors_only}};
}

Law sweep_is_spec_law() {
  const auto in_rows_only = [](const char* name, Level level, std::int64_t ku, std::int64_t kv,
                               const char* base = "step") {
    return mutant(name, base, {level, level}, in_rows(only_at_point(level, ku, kv, level, 1)));
  };
  return {
      .id = "index.sweep_is_spec",
      .says = "a row of points answered at once gets the answers that the algorithm gives each of them alone",
      .source = "docs/SOUNDNESS.md, \"Rows\"",
      .method = Method::exhaustive,
      .subjects = {"step", "reference"},
      .tiers = {.fast = {0, 10}, .long_run = {0, 15}, .seconds = 1},
      .cases = all_cells,
      .domain = points,
      .how = in_fixed_point,
      .unfit = needing_exact({entry::index}),
      .divisible = true,
      .judge = judged_by(sweep_is_spec),
      .mutants = {in_rows_only("one vertex of level 7", 7, corner(7) / 2, corner(7) / 4),
                  in_rows_only("the first cell of level 6", 6, 0, 0),
                  in_rows_only("the last cell of level 8", 8, 0, corner(8)),
                  in_rows_only("one edge of level 9 in the reference", 9, 6, 4, "reference")},
      .heeds = {&interiors_only}};
}

Law exact_on_binary16_law() {
  const auto wrong_at = [](const char* name, Level level, float u, float v) {
    return mutant(name, "impl", {level, level},
                  on_floats([=](Level n, float pu, float pv, std::uint32_t answer) {
                    return n == level && pu == u && pv == v ? answer ^ 1 : answer;
                  }));
  };
  return {.id = "index.exact_on_binary16",
          .says = "for binary16 numbers the index is that of the exact reference for those very numbers",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"impl"},
          .tiers = {.fast = {0, 10}, .long_run = {0, 10}},
          .cases = [](Level, const Run&) { return pairs_of_binary16; },
          .domain =
              [](const Subject&, Level) {
                return std::string("every pair of non-negative binary16 numbers of the triangle");
              },
          .how = in_fixed_point,
          .unfit = needing({entry::index}),
          .divisible = true,
          .judge = judged_by(exact_on_binary16),
          .replay = replayed_by(replay_equals_reference),
          .mutants = {wrong_at("the least subnormal pair, at level 5", 5, 0x1p-24f, 0x1p-24f),
                      wrong_at("fractions that add up to 1 only by rounding, at level 4", 4, 0x1.ffcp-5f,
                               0x1p-16f),
                      wrong_at("the v-corner, at level 9", 9, 0.0f, 1.0f)},
          .long_only = true,
          .companion = "index.exact_on_floats"};
}

}  // namespace

std::vector<Law> arithmetic_laws() {
  return {exact_on_floats_law(), exact_on_binary16_law(), floats_err_law(),
          cells_decide_law(),    fixed_is_rational_law(), sweep_is_spec_law()};
}

}  // namespace mmverify::proofs::index
