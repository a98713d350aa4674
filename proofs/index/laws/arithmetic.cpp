// The laws about arithmetic: floats, fixed point, and what a representative stands for.
#include "proofs/index/laws.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

// For each of the 0x3C01 encodings of u in [0,1], the encodings of v up to the greatest number not above 1-u.
// The run counts them anew; a different number is an error.
constexpr std::uint64_t pairs_of_binary16 = 231'750'657;

const CaseCount stiff_pairs{1'000'000, 100'000'000}, rational_points{1'000, 100'000};

std::string floats(const Subject& s, Level) {
  return fmt::format("a sample of binary32 pairs near what breaks index functions{}",
                     subject_as<IndexSubject>(s).functions.arithmetic == Arithmetic::binary16
                         ? ", rounded to binary16"
                         : "");
}

Law exact_on_floats_law() {
  const auto wrong_at = [](const char* name, const char* base, Level level, float u, float v) {
    return mutant(name, base, {level, level},
                  on_floats([=](Level n, float pu, float pv, std::uint32_t answer) {
                    return n == level && pu == u && pv == v ? answer ^ 1 : answer;
                  }));
  };
  return over_samples(
      {.id = "index.exact_on_floats",
       .says = "for binary32 numbers the index is that of the exact reference for those very numbers",
       .source = vulkan,
       .subjects = {"step", "impl"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 12},
       .domain = floats,
       .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "impl", 9, 0.5f,
                            0x1.fffffep-2f)},
       .heeds = {&interiors_only},
       .knows_near = true,
       .companion = "index.exact_on_doubles",
       .dialect = "exact",
       .in_dialect = {{"published", "index.equals_published"}, {"either", "index.exact_or_published"}}},
      stiff_pairs, exact_on_floats, replay_equals_reference);
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
          .cases = 1,
          .domain = "two points",
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
  return over_samples(
      {.id = "index.cells_decide",
       .says = "every rational point inside a cell has the index of the cell's representative",
       .source = "docs/SOUNDNESS.md, \"Why cells prove all rationals\"",
       .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names",
                    "step-restarted"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 3},
       .domain = "a sample of rational points inside cells",
       .unfit = needing_exact({entry::index}),
       .mutants = {single("one interior representative of level 4", "reference", 4, 1, corner(4) - 3),
                   single("one edge's representative of level 5", "step", 5, 4 * 3 + 2, 4 * 5),
                   mutant("representatives of level 9 only", "step", {9, 9},
                          on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                            return n == 9 ? answer ^ 1 : answer;
                          }))},
       .heeds = {&interiors_only}},
      rational_points, cells_decide);
}

Law fixed_is_rational_law() {
  const auto off = [](const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv) {
    return mutant(name, base, {level, level}, on_points(only_at_point(level, ku, kv, level, 1), false));
  };
  return over_points(
      {.id = "index.fixed_is_rational",
       .says = "64-bit fixed point gives the answers of rational arithmetic, and so do rationals of 63 bits",
       .source = "docs/SOUNDNESS.md, \"No sum overflows\"",
       .subjects = {"reference", "step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names",
                    "step-restarted"},
       .tiers = {.fast = {0, 8}, .long_run = {0, 8}, .seconds = 6},
       .how = against_rationals,
       .unfit = needing_exact({entry::index}),
       .mutants = {off("one vertex of level 6", "step", 6, corner(6) / 4, corner(6) / 2),
                   mutant("one vertex of level 5, in rationals of 63 bits alone", "reference", {5, 5},
                          on_rationals(&Functions::index_at, only_at_point(5, 4 * 6, 4 * 9, 5, 1))),
                   off("one interior point of level 5", "reference", 5, 4 * 7 + 3, 4 * 9 + 3)}},
      entry::index, fixed_is_rational);
}

Law sweep_is_spec_law() {
  const auto in_rows_only = [](const char* name, Level level, std::int64_t ku, std::int64_t kv) {
    return mutant(name, "step", {level, level}, in_rows(only_at_point(level, ku, kv, level, 1)));
  };
  return over_points(
      {.id = "index.sweep_is_spec",
       .says =
           "a row of points answered at once gets the answers that the algorithm gives each of them alone",
       .source = "docs/SOUNDNESS.md, \"Rows\"",
       .subjects = {"step", "reference"},
       .tiers = {.fast = {0, 10}, .long_run = {0, 15}, .seconds = 1},
       .unfit = needing_exact({entry::index}),
       .mutants = {in_rows_only("one vertex of level 7", 7, corner(7) / 2, corner(7) / 4),
                   in_rows_only("the first cell of level 6", 6, 0, 0),
                   in_rows_only("the last cell of level 8", 8, 0, corner(8))}},
      entry::index, sweep_is_spec);
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
          .subjects = {"impl"},
          .tiers = {.fast = {0, 10}, .long_run = {0, 10}},
          .cases = pairs_of_binary16,
          .domain = "every pair of non-negative binary16 numbers of the triangle",
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
