// The laws of topic index: those of the curve and of row order here, with the list of all.
#include "proofs/index/laws.hpp"

#include "proofs/index/binary32/law.hpp"
#include "proofs/index/diagnosis.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/judges/corner_order.hpp"
#include "proofs/index/laws/groups.hpp"
#include "proofs/index/laws/named_corner_order.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/options.hpp"

namespace mmverify::proofs::index {
namespace {

/// Subjects that are wrong on cells, and one that is wrong on Boost.Rational alone.
std::vector<Mutant> wrong_in_rationals() {
  std::vector<Mutant> mutants = wrong_on_cells("step");
  mutants.push_back(
      mutant("one edge of level 4, on Boost.Rational alone", "step", {4, 4},
             on_rationals(&Functions::index_on_boost, only_at_point(4, 4 * 3 + 2, 4 * 5, 4, 1))));
  return mutants;
}

Law equals_reference_law() {
  return {.id = "index.equals_reference",
          .topic = "index",
          .says = "the subject's index is that of the Vulkan reference",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"step", "reference-wide", "impl"},
          .fast = {0, 11},
          .long_run = {0, 16},
          .fast_seconds = 5,
          .cases = all_cells,
          .domain = points,
          .how = in_rationals_then_fixed_point,
          .unfit = needing({entry::index}),
          .divisible = true,
          .judge = judged_by(equals_reference),
          .replay = replayed_by(replay_equals_reference),
          .mutants = wrong_in_rationals(),
          .diagnose =
              [](const Subject& s, const std::vector<Result>& results) {
                return diagnose(subject_as<IndexSubject>(s), results);
              },
          .heeds = {&interiors_only, &in_fixed_point_alone},
          .knows_near = true,
          .companion = "index.exact_on_floats"};
}

Law in_range_law() {
  return {.id = "index.in_range",
          .topic = "index",
          .says = "the index is below 4^n",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 10},
          .long_run = {0, 15},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({entry::index}),
          .divisible = true,
          .judge = judged_by(in_range),
          .replay = replayed_by(replay_in_range),
          .mutants = {single("one vertex of level 7 leaves the range", "reference", 7, corner(7) / 2,
                             corner(7) / 4, 1u << 14),
                      single("the v-corner of level 5 is 4^5", "step", 5, 0, corner(5), 1u << 10),
                      mutant("the hypotenuse of level 6 has a row of its own", "reference", {0, 6},
                             on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
                               return n == 6 && p.u + p.v == Fixed64(1) ? answer + (1u << 12) : answer;
                             }))},
          .heeds = {&interiors_only},
          .companion = "index.exact_on_floats"};
}

Law bijective_law() {
  return {.id = "index.bijective",
          .topic = "index",
          .says = "each index below 4^n belongs to exactly one micro-triangle",
          .source = vulkan,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 10},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_triangles,
          .domain = triangles,
          .how = in_fixed_point,
          .unfit = needing({entry::index}),
          .judge = judged_by(bijective),
          .replay = replayed_by(replay_bijective),
          .mutants = {single("one micro-triangle of level 7 takes its sibling's index", "reference", 7,
                             4 * 20 + 1, 4 * 30 + 1),
                      single("the last micro-triangle of level 5 leaves the range", "step", 5, 1,
                             corner(5) - 3, 1u << 10),
                      mutant("child 3 is taken for child 2 at level 6", "reference", {0, 6},
                             on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                               return n == 6 && answer % 4 == 3 ? answer - 1 : answer;
                             }))},
          .companion = "index.exact_on_floats"};
}

Law nested_law() {
  return {.id = "index.nested",
          .topic = "index",
          .says = "the index at level n+1, divided by 4, is the index at level n, ties included",
          .source = "Succinct Opacity Micromaps, 4.3; Algorithm 3 needs it",
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = next_cells,
          .domain = next_points,
          .how = in_fixed_point,
          .unfit = needing({entry::index}, 1),
          .divisible = true,
          .judge = judged_by(nested),
          .replay = replayed_by(replay_nested),
          .mutants = {single("one vertex of level 7 falls into the next parent", "step", 7, corner(7) / 2,
                             corner(7) / 4, 4),
                      single("one edge of level 6 falls into the next parent", "reference", 6,
                             corner(6) / 4 + 2, corner(6) / 4, 4),
                      mutant("order of the first digit changes from level 6 on", "reference", {0, 7},
                             on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                               return n >= 6 ? answer ^ (2u << (2 * n - 2)) : answer;
                             }))},
          .heeds = {&interiors_only},
          .companion = "index.exact_on_floats"};
}

Law contiguous_law() {
  return {
      .id = "index.contiguous",
      .topic = "index",
      .says =
          "each micro-triangle touches those that come before and after it: across an edge, or, where the "
          "highest differing digit steps from 2 to 3, in one vertex only",
      .source = "Succinct Opacity Micromaps, figure 2",
      .method = Method::exhaustive,
      .subjects = {"reference", "step", "impl"},
      .fast = {0, 9},
      .long_run = {0, 12},
      .fast_seconds = 1,
      .cases = all_triangles,
      .domain = triangles,
      .how = in_fixed_point,
      .unfit = needing({entry::index}),
      .divisible = true,
      .judge = judged_by(contiguous),
      .replay = replayed_by(replay_contiguous),
      .mutants = {mutant("two neighbours of level 7 change places", "reference", {7, 7},
                         on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                           return n == 7 && (answer == 8000 || answer == 8001) ? answer ^ 1 : answer;
                         })),
                  single("one micro-triangle of level 6 is one ahead", "step", 6, 4 * 11 + 3, 4 * 13 + 3, 1),
                  mutant("children 0 and 2 change places below level 4", "reference", {0, 6},
                         on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                           return n > 4 && answer % 2 == 0 ? answer ^ 2 : answer;
                         })),
                  mutant("every micro-triangle of level 5 is the last", "step", {0, 5},
                         on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                           return n == 5 ? (1u << 10) - 1 : answer;
                         }))},
      .companion = "index.exact_on_floats"};
}

Law inverse_law() {
  return {.id = "index.inverse",
          .topic = "index",
          .says = "the corners of an index span a micro-triangle, and the points inside it have that index",
          .source = succinct_4_3,
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({entry::index, entry::corners}),
          .divisible = true,
          .judge = judged_by(inverse),
          .replay = replayed_by(replay_inverse),
          .mutants = {mutant("one corner of one index of level 7 is off", "impl", {7, 7},
                             on_indices([](Level n, std::uint32_t k, Corners c) {
                               if (n == 7 && k == 9999) ++c[1].i;
                               return c;
                             })),
                      mutant("the last index of level 5 gets the corners of the one before", "reference",
                             {0, 5}, on_indices([](Level n, std::uint32_t k, Corners c) {
                               return n == 5 && k == 1023 ? spec::index::corners(1022, 5) : c;
                             })),
                      mutant("the index of one micro-triangle of level 6 is off", "step", {6, 6},
                             on_points([](Level n, const GridPoint&, std::uint32_t answer) {
                               return n == 6 && answer == 1234 ? answer + 1 : answer;
                             }))},
          .companion = "index.exact_on_floats"};
}

Law corners_law() {
  return {.id = "index.corners",
          .topic = "index",
          .says = "the corners of an index are those of the specification, in any order",
          .source = succinct_4_3,
          .method = Method::exhaustive,
          .subjects = {"impl"},
          .fast = {0, 10},
          .long_run = {0, 16},
          .fast_seconds = 0.5,
          .cases = all_triangles,
          .domain = indices,
          .how = exhaustively,
          .unfit = needing({entry::corners}),
          .divisible = true,
          .judge = judged_by(corners_as_sets),
          .replay = replayed_by(replay_corners_as_sets),
          .mutants = {
              mutant("one corner of one index of level 7 is off", "impl", {7, 7},
                     on_indices([](Level n, std::uint32_t k, Corners c) {
                       if (n == 7 && k == 7777) ++c[1].i;
                       return c;
                     })),
              mutant("one corner of the last index of level 6 is another one of it", "impl", {6, 6},
                     on_indices([](Level n, std::uint32_t k, Corners c) {
                       if (n == 6 && k == 4095) c[2] = c[0];
                       return c;
                     })),
              mutant("u and v change places", "impl", {0, 3}, on_indices([](Level, std::uint32_t, Corners c) {
                       for (auto& vertex : c) std::swap(vertex.i, vertex.j);
                       return c;
                     }))}};
}

Law corner_order_law() {
  return {
      .id = "index.corner_order",
      .topic = "index",
      .says =
          "corners come in the order that the subject declares: of the children 0, 2 and 3 that touch them, "
          "or the base and a step from there along u and along v",
      .source = "Succinct Opacity Micromaps, 4.3; OptiX, optixMicromapIndexToBaseBarycentrics",
      .method = Method::exhaustive,
      .subjects = {"impl"},
      .fast = {0, 10},
      .long_run = {0, 16},
      .fast_seconds = 0.5,
      .cases = all_triangles,
      .domain = indices,
      .how = exhaustively,
      .unfit = declares_no_order,
      .divisible = true,
      .judge = judged_by(corners_in_order),
      .replay = replayed_by(replay_corners_in_order),
      .mutants = {swapped_corners("two corners of one index of level 7 change places", "impl", 7, 7777),
                  swapped_corners("two corners of the last index of level 6 change places", "impl", 6, 4095),
                  mutant("the base comes first, then +u, then +v", "impl", {0, 3},
                         on_indices([](Level n, std::uint32_t k, Corners) {
                           return corners_in(CornerOrder::base_u_v, k, n);
                         }))},
      .diagnose = diagnose_corner_order};
}

Law rounding_law() {
  return {.id = "index.rounding",
          .topic = "index",
          .says =
              "a point of a grid line belongs to the micro-triangle on its +u, +v side; on the hypotenuse to "
              "that on its -u side, at the v-corner to the last",
          .source = "Succinct Opacity Micromaps, Appendix A (3): rounds globally away from w",
          .method = Method::exhaustive,
          .subjects = {"reference", "step", "impl"},
          .fast = {0, 9},
          .long_run = {0, 14},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({entry::index}),
          .divisible = true,
          .judge = judged_by(rounding),
          .replay = replayed_by(replay_rounding),
          .mutants = inconsistent_on_cells("reference"),
          .heeds = {&interiors_only},
          .companion = "index.exact_on_floats"};
}

Law row_order_law() {
  return {.id = "index.row_order",
          .topic = "index",
          .says = "the subject's row-order index is that of figure 4 in exact arithmetic",
          .source = attribute_4,
          .method = Method::exhaustive,
          .subjects = {"impl"},
          .fast = {0, 10},
          .long_run = {0, 16},
          .fast_seconds = 1,
          .cases = all_cells,
          .domain = points,
          .how = in_fixed_point,
          .unfit = needing({entry::row_index}),
          .divisible = true,
          .judge = judged_by(row_order),
          .replay = replayed_by(replay_row_order),
          .mutants = {single("one vertex of level 7", "impl", 7, corner(7) / 2, corner(7) / 4),
                      single("the u-corner of level 5", "impl", 5, corner(5), 0, 2),
                      mutant("the hypotenuse of level 6 falls into the next column", "impl", {0, 6},
                             on_points([](Level n, const GridPoint& p, std::uint32_t answer) {
                               return n == 6 && p.u + p.v == Fixed64(1) ? answer ^ 1 : answer;
                             }))},
          .heeds = {&interiors_only},
          .companion = "index.row_exact_on_floats"};
}

Law row_corners_law() {
  return {
      .id = "index.row_corners",
      .topic = "index",
      .says =
          "the corners of a row-order index are those of figure 4 with a root in whole numbers, in any order",
      .source = attribute_4,
      .method = Method::exhaustive,
      .subjects = {"impl", "w-minor-f64"},
      .fast = {0, 11},
      .long_run = {0, 16},
      .fast_seconds = 1,
      .cases = all_triangles,
      .domain = indices,
      .how = exhaustively,
      .unfit = needing({entry::row_corners}),
      .divisible = true,
      .judge = judged_by(row_corners),
      .replay = replayed_by(replay_row_corners),
      .mutants = {{"the root in binary32", built_in("w-minor-f32"), {13, 13}},
                  mutant("one corner of one index of level 7 is a column off", "impl", {7, 7},
                         on_indices([](Level n, std::uint32_t k, Corners c) {
                           if (n == 7 && k == 127 * 127) ++c[0].j;
                           return c;
                         })),
                  mutant("the last index of a row goes to the next", "w-minor", {0, 6},
                         on_indices([](Level n, std::uint32_t k, Corners c) {
                           return n == 6 && k == 50 * 50 - 1 ? spec::index::w_minor_corners(k + 1) : c;
                         }))}};
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
