// [release alone, night] Shared libraries that bake: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace bake_plugin_test {

using testing::HasSubstr;

Outcome judge_bake(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --details --quiet --no-mutants --timeout 1 --subject " +
               library(name));
}

// It says so itself: what it calls O or T is so, and much that is it does not.
TEST(BakeSubject, the_example_in_c_is_conservative_and_not_tight) {
  expect_said(judge_bake("bake_example", "bake --levels 1"), 1,
              {"proved     bake.conservative ", "checked    bake.conservative_on_samples",
               "checked    bake.force2", "refuted    bake.tight ", "n/a        bake.unknown_side "},
              {"refuted    bake.conservative", "broken"});
}

TEST(WrongBake, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(judge_bake, {{"bake_settles_all", "bake.conservative --levels 0",
                                    "case texels=u8:2x2:80000000", "expected micro-triangle 0 U"},
                                   {"bake_rows_from_below", "bake.conservative --levels 0",
                                    "case texels=u8:2x2:", "expected micro-triangle"},
                                   {"bake_pads_with_ones", "bake.conservative --levels 0",
                                    "case texels=u8:2x2:00000000", "expected zeros after the last state"},
                                   {"bake_promises_the_centroid", "bake.unknown_side --levels 0",
                                    "case texels=u8:2x2:", "expected micro-triangle"},
                                   {"bake_all_unknown", "bake.tight --levels 0",
                                    "case texels=u8:2x2:00000000", "expected micro-triangle 0 T"}});
}

// tests/subjects/wrong_bake.cpp says what each does.  Its first case is within the first of 16 shares.
TEST(MisbehavingBake, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge_bake, " --levels 1 --threads 1 --shard 1/16",
      "at level 1 baking texels=u8:2x2:000000ff,wrap=repeat:repeat,",
      {{"bake_reads_past", "bake.conservative", "it wrote to its input or read past its end"},
       {"bake_overrun", "bake.conservative", "it touched memory outside its output"},
       {"bake_unwritten", "bake.conservative", "left its output unwritten"},
       {"bake_counts_calls", "bake.conservative", "non-deterministic, asked again: byte 0"},
       {"bake_changes_its_mind", "bake.conservative", "non-deterministic, taken, then refused"},
       {"bake_throws", "bake.conservative", "threw an exception: no such texture"}});
}

// Whether the dock or the law sees it first hangs on how many questions a worker was asked before.
TEST(BakeSubject, a_texture_known_by_its_first_row_is_caught) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const char* threads : {"1", "2"}) {
    const Outcome o = judge_bake("bake_keeps_by_first_row",
                                 std::string("bake.asked_in_turn --levels 3..5 --threads ") + threads);
    EXPECT_EQ(o.exit_code, 1) << o.err;
    EXPECT_THAT(o.out, testing::AnyOf(HasSubstr("broken     bake.asked_in_turn"),
                                      HasSubstr("refuted    bake.asked_in_turn")));
  }
}

// The example promises to be conservative and no more: laws that compare its maps take an unknown beside O or T.
TEST(BakeSubject, who_is_only_conservative_is_refuted_by_tight_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_bake(
      "bake_example", "bake.shift bake.order bake.nested bake.cutoff bake.asked_in_turn --levels 0..5");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

// The law goes on after them, and the case that is named does not depend on who was first.
TEST(BakeSubject, cases_on_which_it_crashes_are_counted_and_the_others_judged) {
  std::string first;
  for (const auto& [threads, levels] : {std::pair("1", "0..1"), std::pair("4", "1..2")}) {
    const Outcome o = judge_bake("bake_crashes_on_some", std::string("bake.conservative --levels ") + levels +
                                                             " --threads " + threads);
    EXPECT_EQ(o.exit_code, 1) << o.err;
    EXPECT_THAT(o.out, HasSubstr("broken     bake.conservative"));
    // One texture, five pairs of addressing, six triangles.
    EXPECT_THAT(o.out, HasSubstr("level 1: no answer to 30 of 63,350 cases; the others are judged"));
    EXPECT_THAT(o.out, std::string(levels) == "0..1"
                           ? HasSubstr("proved     bake.conservative")
                           : HasSubstr("level 2: no answer to 30 of 63,350 cases; the others are judged"));
    const std::string named = o.out.substr(o.out.find("  crashed (signal 6"), 300);
    EXPECT_EQ(first.empty() ? named : first, named) << threads;
    first = named;
  }
  const Outcome wrong = judge_bake("bake_crashes_and_is_wrong", "bake.conservative --levels 1");
  EXPECT_THAT(wrong.out, HasSubstr("refuted"));
}

TEST(BakeSubject, what_it_declines_is_counted_and_never_proved) {
  const Outcome some = judge_bake("bake_declines_borders", "bake.conservative --levels 0");
  EXPECT_EQ(some.exit_code, 0) << some.out << some.err;
  EXPECT_THAT(some.out, HasSubstr("checked    bake.conservative"));
  // 9 of the 25 pairs: 9 (81 * 6 + 512 * 4).
  EXPECT_THAT(some.out, HasSubstr("declined: 22,806 of these cases"));
  // Nothing was run.
  expect_said(judge_bake("bake_declines_all", "bake.conservative --levels 0"), 2,
              {"n/a        bake.conservative"});
}

// Clamp, cutoffs of binary32 above which alpha is opaque, coordinates in [0, 1].
TEST(DeclaredBaker, is_asked_inside_what_it_declares_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(
      judge_bake("bake_declares_nothing", "bake --levels 1"), 0,
      {"proved     bake.conservative ", "proved     bake.tight ", "proved     bake.unknown_side ",
       "checked    bake.order ", "coordinates in [0, 1]", "it declares no margins", "it declares no BLEND"},
      {"declined"});
}

TEST(DeclaredBaker, gets_as_many_cases_as_are_wanted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_bake("bake_declares_nothing", "bake.order --levels 0..3 --cases 2000"), 0, {"500 cases"},
              {"declined"});
}

TEST(DeclaredBaker, that_says_nothing_and_declines_most_is_not_called_checked) {
  // Nothing was judged.
  expect_said(
      judge_bake("bake_declares_says_nothing", "bake.conservative --levels 0"), 2,
      {"n/a        bake.conservative", "of 63350 cases, more than half; it should declare what it supports"});
}

TEST(DeclaredBaker, is_held_to_its_own_rules) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  // The baker calls alpha equal to the cutoff opaque, but declares opaque=above.
  const Outcome cutoff = judge_bake("bake_declares_meets_the_cutoff", "bake.conservative --levels 0");
  expect_refuted_and_replayed(cutoff, "bake.conservative");
  EXPECT_THAT(cutoff.out, HasSubstr("opaque=above"));
  // A cutoff off by half of what weights of 8 bits may be off.
  expect_said(judge_bake("bake_declares_cutoff_half_a_slack_off", "bake.conservative bake.tight --levels 0"),
              0, {"weights of 8 bits"});
  // Unknowns of one side, and one of them on the other.
  EXPECT_EQ(judge_bake("bake_declares_all_unknowns_opaque", "bake.unknown_side --levels 0").exit_code, 0);
  expect_refuted_and_replayed(
      judge_bake("bake_declares_one_unknown_transparent", "bake.unknown_side --levels 1"),
      "bake.unknown_side");
}

TEST(DeclaredBaker, of_what_cannot_be_is_not_loaded) {
  expect_complaint(judge_bake("bake_declares_upside_down", "bake"), 4,
                   "its bake_support: uv_min is not below uv_max");
}

TEST(BakeSubject, built_before_there_were_bakers_it_has_none) {
  expect_complaint(judge_bake("bake_old_header", "bake"), 4, "all its entry points are null");
}

}  // namespace bake_plugin_test
}  // namespace mmverify::tests
