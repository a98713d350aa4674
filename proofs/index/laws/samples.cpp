// The laws on samples of every level: what the sweeps of the fast tier do not reach.
#include "proofs/index/laws.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

const CaseCount samples{8'192, 1'000'000};

Law on_samples_law() {
  return over_samples(
      {.id = "index.on_samples",
       .says =
           "index, corners in any order, row-order index and row-order corners are the specification's, at "
           "every level",
       .source = "VK_EXT_opacity_micromap; Color and Attribute Micromaps, 4.1, figure 4",
       .subjects = {"reference", "step", "w-minor", "impl"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 1},
       .domain = "a sample of the 4^n indices, and the seven cells of their micro-triangles",
       .unfit = [](const Subject& subject, Level n) -> std::optional<std::string> {
         for (const Entry e : {entry::index, entry::corners, entry::row_index, entry::row_corners})
           if (!needing({e})(subject, n)) return std::nullopt;
         return needing({entry::index})(subject, n);
       },
       .mutants = {mutant(
           "lines u = i/N belong to their -u side from level 12 on", "reference", {11, 12},
           on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
             if (n < 12 || !on_u_line(p, n) || p.u == Fixed64(0)) return answer;
             return spec::index::reference(GridPoint{Fixed64::from_raw(p.u.raw() - 1), p.v}, n);
           }))}},
      samples, on_samples, replay_on_samples);
}

Law corners_on_samples_law() {
  return over_samples(
      {.id = "index.corners_on_samples",
       .says = "the corners of an index are those of the specification, in the order that a subject declares "
               "where it declares one, at every level",
       .source = succinct_4_3,
       .subjects = {"impl"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 0.3},
       .domain = "a sample of the 4^n indices",
       .unfit = needing({entry::corners}),
       .mutants = {mutant("the last digit of level 14 is not looked at", "impl", {14, 14},
                          on_indices([](Level n, std::uint32_t k, Corners c) {
                            return n == 14 ? spec::index::corners(k & ~3u, n) : c;
                          }))}},
      samples, corners_on_samples, replay_corners_on_samples);
}

}  // namespace

std::vector<Law> sample_laws() { return {on_samples_law(), corners_on_samples_law()}; }

namespace {

const CaseCount pairs{200'000, 20'000'000};
/// Few words hold them, so that each costs some times as much.
const CaseCount double_pairs{50'000, 5'000'000};

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
  return over_samples(
      {.id = "index.row_exact_on_floats",
       .says =
           "for binary32 numbers the row-order index is that of figure 4 in exact arithmetic for those very "
           "numbers",
       .source = attribute_4,
       .subjects = {"w-minor", "impl"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
       .domain = "a sample of binary32 pairs near what breaks row order",
       .unfit = needing({entry::row_index}),
       .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "impl", 9, 0.5f,
                            0x1.fffffep-2f)},
       .heeds = {&interiors_only}},
      pairs, row_exact_on_floats, replay_row_order);
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
  return over_samples(
      {.id = "index.exact_on_doubles",
       .says = "for binary64 numbers the index is that of the exact reference for those very numbers",
       .source = vulkan,
       .subjects = {"step"},
       .tiers = {.fast = {0, 16}, .long_run = {0, 16}, .seconds = 2},
       .domain = "a sample of binary64 pairs near what breaks index functions",
       .unfit = needing_doubles(),
       .mutants = {wrong_at("one pair of level 9, an ulp under the hypotenuse", "step", 9, 0.5,
                            0x1.fffffffffffffp-2)},
       .heeds = {&interiors_only}},
      double_pairs, exact_on_doubles, replay_equals_reference);
}

}  // namespace

std::vector<Law> float_laws() { return {exact_on_doubles_law(), row_exact_on_floats_law()}; }

}  // namespace mmverify::proofs::index
