// [release alone, night] Shared libraries of shapes that are cut again and again: right and wrong ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace subdivision_plugin_test {

Outcome judge_subdivision(const std::string& name, const std::string& what) { return judged(name, what); }

TEST(SubdivisionSubject, the_example_in_c_keeps_every_law_that_it_has_entry_points_for) {
  const Outcome o = judge_subdivision("subdivision_example", "subdivision --levels 2");
  expect_said(o, 0,
              each_of("proved     subdivision.",
                      {"index_is_specified", "in_one_cell", "nested", "corners_are_specified", "bijective",
                       "contiguous", "is_micromaps", "dead_ends"}));
  expect_said(o, 0, {"checked    subdivision.on_samples"});
  expect_said(o, 0, each_of("n/a        subdivision.", {"all_levels", "three_shapes", "diagonals"}));
}

TEST(SubdivisionSubject, may_have_corners_alone) {
  const Outcome o = judge_subdivision("subdivision_corners_only", "subdivision --levels 1");
  expect_said(o, 0, {"proved     subdivision.contiguous", "n/a        subdivision.nested"});
}

TEST(WrongSubdivision, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_subdivision,
      {{"subdivision_ignores_z", "subdivision.index_is_specified --levels 1", "case tetrahedron/1:"},
       {"subdivision_hilbert_is_morton", "subdivision.bijective --levels 1", "case hilbert/1:k="},
       {"subdivision_diagonal_goes_back", "subdivision.nested --levels 2", "case bisection/4:"},
       {"subdivision_turns_a_cell_of_nine", "subdivision.corners_are_specified --levels 2",
        "case triangle-9/2:k=50"}});
}

TEST(WrongSubdivision, that_crashes_is_broken_by_a_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_subdivision("subdivision_crash", "subdivision.index_is_specified --levels 2"), 1,
              {"broken     subdivision.index_is_specified", "crashed", "bisection/4:"});
}

}  // namespace subdivision_plugin_test
}  // namespace mmverify::tests
