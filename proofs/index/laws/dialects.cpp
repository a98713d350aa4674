// Dialects: the binary32 codes that may be right beside exact arithmetic.
#include <cmath>

#include "proofs/index/floats/published.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr char code_sources[] =
    "VK_EXT_opacity_micromap and VK_KHR_opacity_micromap, appendix \"Reference Code\"; "
    "EXT_mesh_opacity_micromap";

/// Exact subjects promise more, and the code has no numbers of other formats.
Unfit needing_binary32() {
  return [fits = needing({entry::index})](const Subject& subject, Level n) -> std::optional<std::string> {
    if (const auto why = fits(subject, n)) return why;
    if (subject_as<IndexSubject>(subject).functions.arithmetic != Arithmetic::binary32)
      return subject.name() + " does not compute in binary32";
    return std::nullopt;
  };
}

/// A mutant of the reference in binary32 with changed answers on floats.
Mutant code_that_errs(const char* name, Levels levels,
                      std::function<std::uint32_t(Level, float, float, std::uint32_t)> change) {
  return mutant(name, "reference-f32", levels, on_floats(std::move(change)));
}

/// A mutant that gives the published code's answers on other numbers.
Mutant code_on_others(const char* name, Levels levels, float (*other)(float)) {
  return code_that_errs(name, levels, [other](Level n, float u, float v, std::uint32_t) {
    return published(n, other(u), other(v));
  });
}

std::vector<Mutant> mutants_of_both() {
  return {code_that_errs("one pair of level 9, an ulp under the hypotenuse", {9, 9},
                         [](Level n, float u, float v, std::uint32_t answer) {
                           return n == 9 && u == 0.5f && v == 0x1.fffffep-2f ? answer ^ 1 : answer;
                         }),
          code_on_others("each number is rounded to 22 bits", {3, 12},
                         [](float x) { return std::ldexp(std::nearbyint(std::ldexp(x, 22)), -22); }),
          code_on_others("subnormal numbers become 2^-6", {8, 12},
                         [](float x) { return x > 0 && x < 0x1p-126f ? 0x1p-6f : x; })};
}

Law dialect_law(const char* id, const char* dialect, const char* says, const CaseCount& pairs,
                SampleJudge judge, Replay replay) {
  return over_samples({.id = id,
                       .says = says,
                       .source = code_sources,
                       .subjects = {"reference-f32"},
                       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
                       .domain = "a sample of binary32 pairs near what breaks index functions",
                       .how = "sample, against the published code in binary32",
                       .unfit = needing_binary32(),
                       .mutants = mutants_of_both(),
                       .heeds = {&interiors_only},
                       .knows_near = true,
                       .dialect = dialect,
                       .alternative = true},
                      pairs, judge, replay);
}

Law equals_published_law() {
  return dialect_law(
      "index.equals_published", "published",
      "for binary32 numbers the index is, bit for bit, that of the published code run in binary32, rounded "
      "to nearest and not contracted",
      {200'000, 20'000'000}, equals_published, replay_equals_published);
}

/// The law has as many pairs as index.exact_on_floats, which it replaces.
Law exact_or_published_law() {
  return dialect_law(
      "index.exact_or_published", "either",
      "for binary32 numbers the index is that of exact arithmetic for those very numbers, or that of the "
      "published code run in binary32",
      {1'000'000, 100'000'000}, exact_or_published, replay_exact_or_published);
}

}  // namespace

std::vector<Law> dialect_laws() { return {equals_published_law(), exact_or_published_law()}; }

}  // namespace mmverify::proofs::index
