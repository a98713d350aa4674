// The laws of topic index: those of the curve and of row order here, with the list of all.
#include "proofs/index/laws.hpp"

#include "proofs/index/binary32/law.hpp"
#include "proofs/index/diagnosis.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

Law equals_reference_law() {
  return over_points({.id = "index.equals_reference",
                      .says = "the subject's index is that of the Vulkan reference",
                      .source = vulkan,
                      .subjects = {"step", "reference-wide", "impl"},
                      .tiers = {.fast = {0, 11}, .long_run = {0, 16}, .seconds = 5},
                      .how = in_rationals_then_fixed_point,
                      .mutants = {single("one vertex of level 7", "step", 7, corner(7) / 2, corner(7) / 4),
                                  mutant("one edge of level 4, on Boost.Rational alone", "step", {4, 4},
                                         on_rationals(&Functions::index_on_boost,
                                                      only_at_point(4, 4 * 3 + 2, 4 * 5, 4, 1)))},
                      .diagnose =
                          [](const Subject& s, const std::vector<Result>& results) {
                            return diagnose(subject_as<IndexSubject>(s), results);
                          },
                      .heeds = {&interiors_only, &in_fixed_point_alone},
                      .knows_near = true,
                      .companion = "index.exact_on_floats"},
                     entry::index, equals_reference, replay_equals_reference);
}

Law in_range_law() {
  return over_points({.id = "index.in_range",
                      .says = "the index is below 4^n",
                      .source = vulkan,
                      .subjects = {"reference", "step", "impl"},
                      .tiers = {.fast = {0, 10}, .long_run = {0, 15}, .seconds = 1},
                      .mutants = {single("one vertex of level 7 leaves the range", "reference", 7,
                                         corner(7) / 2, corner(7) / 4, 1u << 14)},
                      .companion = "index.exact_on_floats"},
                     entry::index, in_range, replay_in_range);
}

Law bijective_law() {
  return {.id = "index.bijective",
          .says = "each index below 4^n belongs to exactly one micro-triangle",
          .source = vulkan,
          .subjects = {"reference", "step", "impl"},
          .tiers = {.fast = {0, 10}, .long_run = {0, 14}, .seconds = 1},
          .cases = all_triangles,
          .domain = triangles,
          .how = in_fixed_point,
          .unfit = needing({entry::index}),
          .judge = judged_by(bijective),
          .replay = replayed_by(replay_bijective),
          .mutants = {single("one micro-triangle of level 7 takes its sibling's index", "reference", 7,
                             4 * 20 + 1, 4 * 30 + 1)},
          .companion = "index.exact_on_floats"};
}

Law nested_law() {
  return over_points({.id = "index.nested",
                      .says = "the index at level n+1, divided by 4, is the index at level n, ties included",
                      .source = "Succinct Opacity Micromaps, 4.3; Algorithm 3 needs it",
                      .subjects = {"reference", "step", "impl"},
                      .tiers = {.fast = {0, 9}, .long_run = {0, 14}, .seconds = 1},
                      .cases = next_cells,
                      .domain = next_points,
                      .unfit = needing({entry::index}, 1),
                      .mutants = {single("one vertex of level 7 falls into the next parent", "step", 7,
                                         corner(7) / 2, corner(7) / 4, 4)},
                      .companion = "index.exact_on_floats"},
                     entry::index, nested, replay_nested);
}

Law contiguous_law() {
  return {
      .id = "index.contiguous",
      .says =
          "each micro-triangle touches those that come before and after it: across an edge, or, where the "
          "highest differing digit steps from 2 to 3, in one vertex only",
      .source = "Succinct Opacity Micromaps, figure 2",
      .subjects = {"reference", "step", "impl"},
      .tiers = {.fast = {0, 9}, .long_run = {0, 12}, .seconds = 1},
      .cases = all_triangles,
      .domain = triangles,
      .how = in_fixed_point,
      .unfit = needing({entry::index}),
      .divisible = true,
      .judge = judged_by(contiguous),
      .replay = replayed_by(replay_contiguous),
      .mutants = {single("one micro-triangle of level 6 is one ahead", "step", 6, 4 * 11 + 3, 4 * 13 + 3, 1)},
      .companion = "index.exact_on_floats"};
}

Law inverse_law() {
  return over_indices(
      {.id = "index.inverse",
       .says = "the corners of an index span a micro-triangle, and the points inside it have that index",
       .source = succinct_4_3,
       .subjects = {"reference", "step", "impl"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 14}, .seconds = 1},
       .unfit = needing({entry::index, entry::corners}),
       .mutants = {mutant("one corner of one index of level 7 is off", "impl", {7, 7},
                          on_indices([](Level n, std::uint32_t k, Corners c) {
                            if (n == 7 && k == 9999) ++c[1].i;
                            return c;
                          }))},
       .companion = "index.exact_on_floats"},
      inverse, replay_inverse);
}

Law corners_law() {
  return over_indices({.id = "index.corners",
                       .says = "the corners of an index are those of the specification, in any order",
                       .source = succinct_4_3,
                       .subjects = {"impl"},
                       .tiers = {.fast = {0, 10}, .long_run = {0, 16}, .seconds = 0.5},
                       .unfit = needing({entry::corners}),
                       .mutants = {mutant("one corner of one index of level 7 is off", "impl", {7, 7},
                                          on_indices([](Level n, std::uint32_t k, Corners c) {
                                            if (n == 7 && k == 7777) ++c[1].i;
                                            return c;
                                          }))}},
                      corners_as_sets, replay_corners_as_sets);
}

Law corner_order_law() {
  return over_indices(
      {.id = "index.corner_order",
       .says = "corners come in the order that the subject declares: of the children 0, 2 and 3 that touch "
               "them, or the base and a step from there along u and along v",
       .source = "Succinct Opacity Micromaps, 4.3; OptiX, optixMicromapIndexToBaseBarycentrics",
       .subjects = {"impl"},
       .tiers = {.fast = {0, 10}, .long_run = {0, 16}, .seconds = 0.5},
       .unfit = declares_no_order,
       .mutants = {swapped_corners("two corners of one index of level 7 change places", "impl", 7, 7777)},
       .diagnose = diagnose_corner_order},
      corners_in_order, replay_corners_in_order);
}

Law rounding_law() {
  return over_points(
      {.id = "index.rounding",
       .says =
           "a point of a grid line belongs to the micro-triangle on its +u, +v side; on the hypotenuse to "
           "that on its -u side, at the v-corner to the last",
       .source = "Succinct Opacity Micromaps, Appendix A (3): rounds globally away from w",
       .subjects = {"reference", "step", "impl"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 14}, .seconds = 1},
       .mutants = {single("one vertex of level 7", "reference", 7, corner(7) / 2, corner(7) / 4)},
       .companion = "index.exact_on_floats"},
      entry::index, rounding, replay_rounding);
}

Law row_order_law() {
  return over_points({.id = "index.row_order",
                      .says = "the subject's row-order index is that of figure 4 in exact arithmetic",
                      .source = attribute_4,
                      .subjects = {"impl"},
                      .tiers = {.fast = {0, 10}, .long_run = {0, 16}, .seconds = 1},
                      .mutants = {single("one vertex of level 7", "impl", 7, corner(7) / 2, corner(7) / 4)},
                      .companion = "index.row_exact_on_floats"},
                     entry::row_index, row_order, replay_row_order);
}

Law row_corners_law() {
  return over_indices({.id = "index.row_corners",
                       .says = "the corners of a row-order index are those of figure 4 with a root in whole "
                               "numbers, in any order",
                       .source = attribute_4,
                       .subjects = {"impl", "w-minor-f64"},
                       .tiers = {.fast = {0, 11}, .long_run = {0, 16}, .seconds = 1},
                       .unfit = needing({entry::row_corners}),
                       .mutants = {mutant("one corner of one index of level 7 is a column off", "impl",
                                          {7, 7}, on_indices([](Level n, std::uint32_t k, Corners c) {
                                            if (n == 7 && k == 127 * 127) ++c[0].j;
                                            return c;
                                          }))}},
                      row_corners, replay_row_corners);
}

}  // namespace

std::vector<Law> laws() {
  std::vector<Law> all{equals_reference_law(), in_range_law(),     bijective_law(),
                       nested_law(),           contiguous_law(),   inverse_law(),
                       corners_law(),          corner_order_law(), rounding_law()};
  for (const auto& group :
       {induction::laws(), std::vector{binary32::law(), binary32::row_law(), binary32::published_law()},
        wide_laws(), arithmetic_laws(), std::vector{row_order_law(), row_corners_law()}, float_laws(),
        dialect_laws(), sample_laws(), paper_laws(equals_reference_law())})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::index
