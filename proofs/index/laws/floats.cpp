// The laws on floats beside index.exact_on_floats: row order's, and binary64's.
#include "proofs/index/laws/groups.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

std::uint64_t pairs(Level, const Run& run) { return run.tier == Tier::fast ? 200'000 : 20'000'000; }
/// Few words hold them, so that each costs some times as much.
std::uint64_t double_pairs(Level, const Run& run) { return run.tier == Tier::fast ? 50'000 : 5'000'000; }

/// One pair of one level is taken for the micro-triangle beside its own.
template <class F>
Mutant wrong_at(const char* name, const char* base, Level level, F u, F v) {
  const auto once = [=](Level n, F pu, F pv, std::uint32_t answer) {
    return n == level && pu == u && pv == v ? answer ^ 1 : answer;
  };
  Change change;
  if constexpr (sizeof(F) == sizeof(float))
    change = on_floats(once);
  else
    change = on_doubles(once);
  return mutant(name, base, {level, level}, change);
}

Law row_exact_on_floats_law() {
  return {
      .id = "index.row_exact_on_floats",
      .says =
          "for binary32 numbers the row-order index is that of figure 4 in exact arithmetic for those very "
          "numbers",
      .source = attribute_4,
      .method = Method::sample,
      .subjects = {"w-minor", "impl"},
      .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
      .cases = pairs,
      .domain = [](const Subject&,
                   Level) { return std::string("a sample of binary32 pairs near what breaks row order"); },
      .how = by_sample,
      .unfit = needing({entry::row_index}),
      .divisible = true,
      .judge =
          [](const Subject& s, Level n, const Run& run) {
            return row_exact_on_floats(subject_as<IndexSubject>(s), n, run, pairs(n, run));
          },
      .replay = replayed_by(replay_row_order),
      .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "impl", 9, 0.5f,
                           0x1.fffffep-2f)},
      .heeds = {&interiors_only}};
}

Unfit needing_doubles() {
  return [fits = needing({entry::index})](const Subject& subject, Level n) -> std::optional<std::string> {
    if (const auto why = fits(subject, n)) return why;
    const IndexSubject& s = subject_as<IndexSubject>(subject);
    if (s.takes_doubles()) return std::nullopt;
    return s.name() + " takes no binary64 numbers";
  };
}

Law exact_on_doubles_law() {
  return {.id = "index.exact_on_doubles",
          .says = "for binary64 numbers the index is that of the exact reference for those very numbers",
          .source = vulkan,
          .method = Method::sample,
          .subjects = {"step"},
          .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
          .cases = double_pairs,
          .domain =
              [](const Subject&, Level) {
                return std::string("a sample of binary64 pairs near what breaks index functions");
              },
          .how = by_sample,
          .unfit = needing_doubles(),
          .divisible = true,
          .judge =
              [](const Subject& s, Level n, const Run& run) {
                return exact_on_doubles(subject_as<IndexSubject>(s), n, run, double_pairs(n, run));
              },
          .replay = replayed_by(replay_equals_reference),
          .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "step", 9, 0.5,
                               0x1.fffffffffffffp-2)},
          .heeds = {&interiors_only}};
}

}  // namespace

std::vector<Law> float_laws() { return {exact_on_doubles_law(), row_exact_on_floats_law()}; }

}  // namespace mmverify::proofs::index
