// [release alone, night] Shared libraries that decide what becomes of a candidate, and blend hits: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace traverse_plugin_test {

Outcome judge_traverse(const std::string& name, const std::string& what) { return judged(name, what); }

TEST(TraverseSubject, the_example_in_c_keeps_every_law) {
  const Outcome o = judge_traverse("traverse_example", "traverse");
  expect_said(o, 0,
              each_of("proved     traverse.",
                      {"decision", "ignored_is_final", "two_state_never_calls_a_shader",
                       "micromap_replaces_flag", "last_flag_wins", "apis_agree", "lossy_is_conservative",
                       "lossy_shows", "lossy_decides_no_more", "blend", "blend_order_free",
                       "blend_duplicates", "blend_before_closest"}));
  expect_said(o, 0, {"n/a        traverse.undefined_is_named"});
}

TEST(WrongTraverse, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_traverse,
      {{"traverse_instance_after_ray", "traverse.last_flag_wins",
        "instance=force-opaque,ray=no-opaque expected non-opaque got opaque"},
       {"traverse_khr_query_forgets_2_state", "traverse.apis_agree",
        "special:UT,not-opaque,instance=none,ray=2-state expected ignored in ext-query got non-opaque in "
        "khr-query"},
       {"traverse_opaque_fills_holes", "traverse.ignored_is_final", "expected ignored got opaque"},
       {"traverse_outcome_3", "traverse.decision", "expected ignored got outcome 3"},
       {"traverse_blend_truncates", "traverse.blend", "case multiply,"},
       {"traverse_blend_wraps", "traverse.blend_duplicates", "case add,"},
       {"lockstep_blend", "traverse.blend", "case max,"},
       {"lockstep_blend", "traverse.blend_on_samples", ", by "},
       {"traverse_blend_guesses_b_of_the_value", "traverse.blend_on_samples", ", by "},
       {"traverse_blend_knows_no_b_without_r", "traverse.blend_on_samples", ", by "},
       {"traverse_hits_guess_g_of_the_payload", "traverse.blend_many_on_samples", "case "}});
}

// One case each: the whole law is 233,820 questions.
TEST(TraverseSubject, hits_that_an_accepted_one_hides_are_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto replay = [](const char* name, const char* hits) {
    return shell(std::string("mmverify replay traverse.blend_before_closest --level 0 --case max,") + hits +
                 ",once,rising,neutral --subject " + library(name));
  };
  for (const char* hits : {"B2A1", "B1A1", "A1B2"})
    EXPECT_EQ(replay("traverse_example", hits).exit_code, 0) << hits;
  expect_said(replay("traverse_hits_as_met", "B2A1"), 1, {"expected 0 0 0 0 got 70 71 72 73"});
  EXPECT_EQ(replay("traverse_hits_as_met", "A1B2").exit_code, 0);
  expect_said(replay("traverse_hits_beside_blend", "B1A1"), 1, {"expected 0 0 0 0 got 20 21 22 23"});
  EXPECT_EQ(replay("traverse_hits_beside_blend", "B2A1").exit_code, 0);
}

// All combinations of an API are one batch, those with the same flags beside each other.
TEST(TraverseSubject, candidates_that_are_mixed_up_in_a_batch_are_seen) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_traverse("traverse_geometry_of_the_first_of_four", "traverse.decision"), 1,
              {"non-deterministic, asked "});
}

TEST(MisbehavingTraverse, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(judge_traverse, "", "",
                     {{"traverse_crash", "traverse.decision", "crashed (signal ",
                       "special:UT,not-opaque,instance=2-state,ray="},
                      {"traverse_throws", "traverse.decision", "threw an exception: no such state",
                       "special:UT,not-opaque,instance=2-state,ray="},
                      {"traverse_unwritten", "traverse.decision", "left its output unwritten",
                       "special:UT,not-opaque,instance=2-state,ray="},
                      {"traverse_counts_calls", "traverse.decision", "non-deterministic",
                       "special:UT,not-opaque,instance=2-state,ray="},
                      {"traverse_blend_crash", "traverse.blend_duplicates", "crashed (signal ",
                       "max of payload 9 227 81 225 and 200 12 147 3"},
                      {"traverse_blend_unwritten", "traverse.blend_duplicates", "left its output unwritten",
                       "max of payload 9 227 81 225 and 200 12 147 3"},
                      {"traverse_blend_chains", "traverse.blend", "non-deterministic", "asked "},
                      {"traverse_hits_throw", "traverse.blend_before_closest",
                       "threw an exception: no third hit", "blending by max into 0 0 0 0, "},
                      {"traverse_hits_unwritten", "traverse.blend_before_closest",
                       "left its output unwritten", "blending by max into 0 0 0 0, "}});
}

// All that a library with the one entry point is asked, a sample of whole words among it: no word is better than `checked`.
TEST(TraverseSubject, that_blends_is_no_more_than_checked) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_traverse("traverse_example", "traverse.blend traverse.blend_on_samples"), 0,
              {"checked, the weakest of its verdicts"});
}

TEST(TraverseSubject, built_before_there_were_decisions_it_has_none) {
  expect_complaint(judge_traverse("traverse_old_header", "traverse"), 4, "all its entry points are null");
}

}  // namespace traverse_plugin_test
}  // namespace mmverify::tests
