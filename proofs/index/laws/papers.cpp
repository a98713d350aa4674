// The papers' claims: the true ones as they stand, of the false ones that they are false, and where.
#include "proofs/index/laws.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

Law step_claim_law(Law law) {
  law.id = "paper.step_equals_reference";
  law.mutants.push_back(single("the v-corner of level 6, the last cell", "step", 6, 0, corner(6)));
  law.says =
      "Algorithm 4 as printed equals the reference, which the paper proved up to level 15 and not at 16";
  law.source = succinct_4_3;
  law.subjects = {"step"};
  law.tiers.fast = {0, 10};
  law.tiers.long_run = {0, 16};
  law.tiers.seconds = 3;
  law.general = false;
  law.companion = {};
  law.knows_near = false;
  return law;
}

Law differs_law(const char* id, const char* says, const char* source, const char* reading,
                std::vector<Difference> stated) {
  const auto repaired = [&](Level level) {
    const Difference& last = stated.back();
    const GridPoint where{coordinate(last.ku, last.from_level), coordinate(last.kv, last.from_level)};
    return mutant("right at its simplest wrong point of level 6", reading, {level, level},
                  on_points([=](Level n, const GridPoint& p, std::uint32_t answer) {
                    return n == level && p.u == where.u && p.v == where.v ? spec::index::reference(p, n)
                                                                          : answer;
                  }));
  };
  return {.id = id,
          .says = says,
          .source = source,
          .subjects = {reading},
          .tiers = {.fast = {0, 7}, .long_run = {0, 8}, .seconds = 1},
          .cases = all_cells,
          .domain = points,
          .how = in_rationals_then_fixed_point,
          .unfit = needing({entry::index}),
          .judge = [stated](
                       const Subject& s, Level n,
                       const Run& run) { return differs_first(subject_as<IndexSubject>(s), n, run, stated); },
          .mutants = {repaired(6),
                      {"the reading without its difference", built_in("step"), {0, 2}},
                      single("one more wrong vertex, at level 1", reading, 1, 4, 0)},
          .general = false,
          .heeds = {&interiors_only, &in_fixed_point_alone},
          .mutants_with = {&in_fixed_point_alone}};
}

Law prose_law() {
  return {.id = "paper.vulkan_prose_differs",
          .says =
              "read to the letter, Vulkan's prose differs from its reference code on the 2^n + 1 vertices of "
              "the hypotenuse of each level from 1 on, at level 0 on one, and nowhere else",
          .source =
              "VK_EXT_opacity_micromap and VK_KHR_opacity_micromap: section \"Ray Opacity Micromap\", and "
              "appendix \"Reference Code\"",
          .subjects = {"vulkan-prose"},
          .tiers = {.fast = {0, 7}, .long_run = {0, 12}, .seconds = 1},
          .cases = all_cells,
          .domain = points,
          .how = in_rationals_then_fixed_point,
          .unfit = needing({entry::index}),
          .judge = judged_by(differs_on_hypotenuse),
          .mutants = {{"the reference code itself", built_in("reference"), {1, 3}},
                      single("one vertex inside level 6 is wrong, too", "vulkan-prose", 6, 4 * 20, 4 * 30),
                      single("the v-corner of level 4 is right", "vulkan-prose", 4, 0, 4 * 16, 255),
                      mutant("edges of level 5 are wrong in the place of vertices", "vulkan-prose", {5, 5},
                             on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
                               return n == 5 && p.u + p.v == Fixed64(1) ? answer ^ 1 : answer;
                             }))},
          .general = false,
          .heeds = {&in_fixed_point_alone},
          .mutants_with = {&in_fixed_point_alone}};
}

Law row_holds_point_law() {
  return over_points(
      {.id = "paper.w_minor_holds_point",
       .says = "the micro-triangle that figure 4 gives holds the point, on every line of the grid",
       .source = attribute_4,
       .subjects = {"w-minor"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 14}, .seconds = 1},
       .mutants = {single("one point inside a micro-triangle of level 7", "w-minor", 7, 4 * 20 + 1,
                          4 * 30 + 1)},
       .companion = "index.row_exact_on_floats"},
      entry::row_index, row_holds_point, replay_row_holds_point);
}

Law binary32_root_law() {
  constexpr std::uint32_t first_wrong = 4097 * 4097 - 2;
  return {.id = "paper.w_minor_binary32_root_errs",
          .says = "figure 4's row of an index, rooted in binary32, is right below 4097^2-2 and wrong there",
          .source = attribute_4,
          .subjects = {"w-minor-f32"},
          .tiers = {.fast = {10, 13}, .long_run = {0, 16}, .seconds = 3},
          .cases = all_triangles,
          .domain = "the 4^n indices",
          .how = "exhaustive",
          .unfit = needing({entry::row_corners}),
          .judge = judged_by(binary32_root_errs),
          .mutants = {{"the root in binary64", built_in("w-minor-f64"), {13, 13}},
                      mutant("one more wrong index, at level 8", "w-minor-f32", {8, 8},
                             on_indices([](Level n, std::uint32_t k, Corners c) {
                               return n == 8 && k == 40'000 ? spec::index::w_minor_corners(k + 1) : c;
                             })),
                      mutant("right at the first wrong index", "w-minor-f32", {13, 13},
                             on_indices([](Level, std::uint32_t k, Corners c) {
                               return k == first_wrong ? spec::index::w_minor_corners(k) : c;
                             }))},
          .general = false};
}

}  // namespace

std::vector<Law> paper_laws(const Law& equals_reference) {
  return {
      step_claim_law(equals_reference),
      differs_law(
          "paper.appendix_middle_differs",
          "with the middle triangle's coordinates in Appendix A's order, Algorithm 4 is not the reference",
          succinct_a, "step-appendix-middle", {{2, 6, 2, 7, 4}, {3, 8, 8, 20, 23}}),
      differs_law("paper.appendix_ties_differ",
                  "with the R test's exception on u = 1/2, as Appendix A's prose has it, Algorithm 4 is not "
                  "the reference",
                  succinct_a, "step-appendix-ties", {{2, 6, 6, 6, 5}}),
      differs_law(
          "paper.appendix_names_differ",
          "with the coordinates that Appendix A gives under L, R and T, Algorithm 4 is not the reference",
          succinct_a, "step-appendix-names", {{2, 0, 8, 14, 15}}),
      differs_law(
          "paper.restarted_step_differs",
          "with step(u, v) called anew at each node, as Algorithm 3 prints it, every digit is the first",
          succinct_4_2, "step-restarted", {{2, 8, 0, 8, 10}}),
      prose_law(),
      row_holds_point_law(),
      binary32_root_law()};
}

}  // namespace mmverify::proofs::index
