// Dialects: the binary32 codes that may be right beside exact arithmetic.
#include <cmath>

#include "proofs/index/floats/published.hpp"
#include "proofs/index/laws/groups.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr char code_sources[] =
    "VK_EXT_opacity_micromap and VK_KHR_opacity_micromap, appendix \"Reference Code\"; "
    "EXT_mesh_opacity_micromap";

std::uint64_t published_pairs(Level, const Run& run) { return run.tier == Tier::fast ? 200'000 : 20'000'000; }
/// The number of pairs, the same as that of index.exact_on_floats, which this law replaces.
std::uint64_t either_pairs(Level, const Run& run) { return run.tier == Tier::fast ? 1'000'000 : 100'000'000; }

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

Law dialect_law(const char* id, const char* dialect, const char* says, const char* domain,
                std::uint64_t (*cases)(Level, const Run&), Judge judge, Replay replay) {
  Law law{.id = id,
          .says = says,
          .source = code_sources,
          .method = Method::sample,
          .subjects = {"reference-f32"},
          .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
          .cases = cases};
  law.domain = [domain](const Subject&, Level) { return std::string(domain); };
  law.how = [](const Subject&, Level) {
    return std::string("sample, against the published code in binary32");
  };
  law.unfit = needing_binary32();
  law.divisible = true;
  law.judge = judged_by(judge);
  law.replay = replayed_by(replay);
  law.mutants = mutants_of_both();
  law.heeds = {&interiors_only};
  law.alternative = true;
  law.dialect = dialect;
  law.knows_near = true;
  return law;
}

Law equals_published_law() {
  Law law = dialect_law(
      "index.equals_published", "published",
      "for binary32 numbers the index is, bit for bit, that of the published code run in binary32, rounded "
      "to nearest and not contracted",
      "a sample of binary32 pairs near what breaks index functions", published_pairs,
      [](const IndexSubject& s, Level n, const Run& run) {
        return equals_published(s, n, run, published_pairs(n, run));
      },
      replay_equals_published);
  law.mutants.push_back(code_that_errs(
      "the sum of the fractions is exact", {4, 12}, [](Level n, float u, float v, std::uint32_t) {
        return spec::index::reference(spec::Point<double>{static_cast<double>(u), static_cast<double>(v)}, n);
      }));
  return law;
}

Law exact_or_published_law() {
  return dialect_law(
      "index.exact_or_published", "either",
      "for binary32 numbers the index is that of exact arithmetic for those very numbers, or that of the "
      "published code run in binary32",
      "a sample of binary32 pairs near what breaks index functions", either_pairs,
      [](const IndexSubject& s, Level n, const Run& run) {
        return exact_or_published(s, n, run, either_pairs(n, run));
      },
      replay_exact_or_published);
}

}  // namespace

std::vector<Law> dialect_laws() { return {equals_published_law(), exact_or_published_law()}; }

}  // namespace mmverify::proofs::index
