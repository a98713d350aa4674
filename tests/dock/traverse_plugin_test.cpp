// [release alone, night] Shared libraries that decide what becomes of a candidate, and blend hits: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace traverse_plugin_test {

using testing::HasSubstr;

Outcome judge_traverse(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 20 --threads 1 --subject " +
               library(name));
}

TEST(TraverseSubject, the_example_in_c_keeps_every_law) {
  const Outcome o = judge_traverse("traverse_example", "traverse");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const char* law :
       {"decision", "ignored_is_final", "two_state_never_calls_a_shader", "micromap_replaces_flag",
        "last_flag_wins", "apis_agree", "lossy_is_conservative", "lossy_shows", "lossy_decides_no_more",
        "blend", "blend_order_free", "blend_duplicates", "blend_before_closest"})
    EXPECT_THAT(o.out, HasSubstr(std::string("proved     traverse.") + law));
  EXPECT_THAT(o.out, HasSubstr("n/a        traverse.undefined_is_named"));
}

struct WrongDecision {
  friend void PrintTo(const WrongDecision& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *expected;
};

class WrongTraverse : public testing::TestWithParam<WrongDecision> {};

TEST_P(WrongTraverse, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, expected] = GetParam();
  const Outcome o = judge_traverse(name, law);
  expect_refuted_and_replayed(o, law);
  EXPECT_THAT(o.out, HasSubstr(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, WrongTraverse,
    testing::Values(
        WrongDecision{"traverse_instance_after_ray", "traverse.last_flag_wins",
                      "instance=force-opaque,ray=no-opaque expected non-opaque got opaque"},
        WrongDecision{"traverse_khr_query_forgets_2_state", "traverse.apis_agree",
                      "special:UT,not-opaque,instance=none,ray=2-state expected ignored in ext-query got "
                      "non-opaque in khr-query"},
        WrongDecision{"traverse_opaque_fills_holes", "traverse.ignored_is_final",
                      "expected ignored got opaque"},
        WrongDecision{"traverse_outcome_3", "traverse.decision", "expected ignored got outcome 3"},
        WrongDecision{"traverse_blend_truncates", "traverse.blend", "case multiply,"},
        WrongDecision{"traverse_blend_wraps", "traverse.blend_duplicates", "case add,"},
        WrongDecision{"lockstep_blend", "traverse.blend", "case max,"},
        WrongDecision{"lockstep_blend", "traverse.blend_on_samples", ", by "},
        WrongDecision{"traverse_blend_guesses_b_of_the_value", "traverse.blend_on_samples", ", by "},
        WrongDecision{"traverse_blend_knows_no_b_without_r", "traverse.blend_on_samples", ", by "},
        WrongDecision{"traverse_hits_guess_g_of_the_payload", "traverse.blend_many_on_samples", "case "}),
    [](const auto& info) { return std::to_string(info.index) + "_" + info.param.name; });

// One case each: the whole law is 233,820 questions.
TEST(TraverseSubject, hits_that_an_accepted_one_hides_are_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto replay = [](const char* name, const char* hits) {
    return shell(std::string("mmverify replay traverse.blend_before_closest --level 0 --case max,") + hits +
                 ",once,rising,neutral --subject " + library(name));
  };
  for (const char* hits : {"B2A1", "B1A1", "A1B2"})
    EXPECT_EQ(replay("traverse_example", hits).exit_code, 0) << hits;
  const Outcome met = replay("traverse_hits_as_met", "B2A1");
  EXPECT_EQ(met.exit_code, 1) << met.out << met.err;
  EXPECT_THAT(met.out, HasSubstr("expected 0 0 0 0 got 70 71 72 73"));
  EXPECT_EQ(replay("traverse_hits_as_met", "A1B2").exit_code, 0);
  const Outcome beside = replay("traverse_hits_beside_blend", "B1A1");
  EXPECT_EQ(beside.exit_code, 1) << beside.out << beside.err;
  EXPECT_THAT(beside.out, HasSubstr("expected 0 0 0 0 got 20 21 22 23"));
  EXPECT_EQ(replay("traverse_hits_beside_blend", "B2A1").exit_code, 0);
}

struct TraverseMisbehaviour {
  friend void PrintTo(const TraverseMisbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *said;
};

class MisbehavingTraverse : public testing::TestWithParam<TraverseMisbehaviour> {};

TEST_P(MisbehavingTraverse, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, said] = GetParam();
  const Outcome o = judge_traverse(name, "traverse.decision");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     traverse.decision"));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr("special:UT,not-opaque,instance=2-state,ray="));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, MisbehavingTraverse,
    testing::Values(TraverseMisbehaviour{"traverse_crash", "crashed (signal "},
                    TraverseMisbehaviour{"traverse_throws", "threw an exception: no such state"},
                    TraverseMisbehaviour{"traverse_unwritten", "left its output unwritten"},
                    TraverseMisbehaviour{"traverse_counts_calls", "non-deterministic"}),
    [](const auto& info) { return std::string(info.param.name); });

// All combinations of an API are one batch, those with the same flags beside each other.
TEST(TraverseSubject, candidates_that_are_mixed_up_in_a_batch_are_seen) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_traverse("traverse_geometry_of_the_first_of_four", "traverse.decision");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("non-deterministic, asked "));
}

struct BrokenBlend {
  friend void PrintTo(const BrokenBlend& b, std::ostream* out) { *out << b.name; }
  const char *name, *law, *said, *place;
};

class BrokenBlends : public testing::TestWithParam<BrokenBlend> {};

TEST_P(BrokenBlends, are_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, said, place] = GetParam();
  const Outcome o = judge_traverse(name, law);
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr(std::string("broken     ") + law));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr(place));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, BrokenBlends,
    testing::Values(BrokenBlend{"traverse_blend_crash", "traverse.blend_duplicates", "crashed (signal ",
                                "max of payload 9 227 81 225 and 200 12 147 3"},
                    BrokenBlend{"traverse_blend_unwritten", "traverse.blend_duplicates",
                                "left its output unwritten", "max of payload 9 227 81 225 and 200 12 147 3"},
                    BrokenBlend{"traverse_blend_chains", "traverse.blend", "non-deterministic", "asked "},
                    BrokenBlend{"traverse_hits_throw", "traverse.blend_before_closest",
                                "threw an exception: no third hit", "blending by max into 0 0 0 0, "},
                    BrokenBlend{"traverse_hits_unwritten", "traverse.blend_before_closest",
                                "left its output unwritten", "blending by max into 0 0 0 0, "}),
    [](const auto& info) { return std::string(info.param.name); });

// All that a library with the one entry point is asked, a sample of whole words among it: no word is better than `checked`.
TEST(TraverseSubject, that_blends_is_no_more_than_checked) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_traverse("traverse_example", "traverse.blend traverse.blend_on_samples");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("checked, the weakest of its verdicts"));
}

TEST(TraverseSubject, built_before_there_were_decisions_it_has_none) {
  expect_complaint(judge_traverse("traverse_old_header", "traverse"), 4, "all its entry points are null");
}

}  // namespace traverse_plugin_test
}  // namespace mmverify::tests
