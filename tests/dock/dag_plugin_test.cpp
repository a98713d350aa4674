// [release alone, night] Shared libraries of a scene's maps: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace dag_plugin_test {

using testing::HasSubstr;
using testing::Not;

Outcome judge_dag(const std::string& name, const std::string& what) { return judged(name, what, 1); }

TEST(DagSubject, the_example_in_c_keeps_every_law_that_it_has_entry_points_for) {
  const Outcome o = judge_dag("dag_example", "dag --levels 3");
  expect_said(o, 0, each_of("proved     ", {"dag.round_trip", "dag.lookup_is_decode"}));
  expect_said(o, 0, each_of("checked    ", {"dag.on_samples", "dag.many_maps", "dag.damaged_codes"}));
  // Its codes are not docs/DAG.md's.
  expect_said(o, 0,
              each_of("n/a        ",
                      {"dag.equals_spec", "dag.canonical", "dag.append", "dag.bound", "dag.malformed"}));
}

TEST(DagSubject, maps_are_decoded_by_lookups_where_nothing_else_does) {
  expect_said(judge_dag("dag_looks_up_only", "dag.round_trip --levels 3"), 0, {"proved     dag.round_trip"});
}

TEST(WrongDag, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_dag,
      {{"dag_merges_near", "dag.round_trip --levels 3", "expected map 1 index 63 state 0"},
       {"dag_forgets_the_second", "dag.round_trip --levels 0", "expected 2 maps got 1"},
       {"dag_padding_set", "dag.round_trip --levels 0", "expected map 0 padding bits 0"},
       {"dag_looks_in_the_first", "dag.lookup_is_decode --levels 3", "expected map 1 index 63 state 0"},
       {"dag_answers_no_scene", "dag.damaged_codes --levels 2", "expected "},
       {"dag_promises_the_container", "dag.canonical --levels 0", "expected "}});
}

// The scene has just over 65,536 maps, so some numbers exceed 16 bits; a busy machine takes long to encode it.
TEST(DagSubject, that_takes_one_of_many_maps_for_another_is_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const char* name : {"dag_looks_for_257_in_the_first", "dag_numbers_of_16_bits"}) {
    const Outcome o = shell(
        "mmverify prove dag.many_maps --levels 0 --details --quiet --no-mutants --timeout 20 --threads 1 "
        "--subject " +
        library(name));
    expect_refuted_and_replayed(o, "dag.many_maps");
    EXPECT_THAT(o.out,
                HasSubstr(std::string(name) == "dag_numbers_of_16_bits" ? "map 655" : "map 256 index "));
  }
}

TEST(DagSubject, what_it_does_in_place_of_an_answer_is_told_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Outcome o = judge_dag("dag_encoder_throws", "dag.round_trip --levels 3");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out,
              HasSubstr("threw an exception: level 3 at level 3 encoding the 2-state scene of levels 3, 3"));
  o = judge_dag("dag_encoder_counts_calls", "dag.round_trip --levels 1");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("non-deterministic"));
  o = judge_dag("dag_lookup_crashes", "dag.lookup_is_decode --levels 4");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("looking up map=0,k=255"));
}

// The decoder has a form of its own, so the container's laws do not ask it.
TEST(DagSubject, a_decoder_that_does_not_come_back_from_a_damaged_code_is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_dag("dag_decoder_reads_past_its_code", "dag.damaged_codes --levels 1"), 1,
              {"broken     dag.damaged_codes", "crashed (signal "});
}

TEST(DagSubject, a_decoder_whose_answer_goes_by_the_code_before_is_seen) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  EXPECT_EQ(judge_dag("dag_answers_by_the_last_code", "dag.damaged_codes --levels 1").exit_code, 1);
}

TEST(DagSubject, a_library_that_leads_nowhere_is_refused) {
  Outcome o = judge_dag("dag_decodes_only", "dag");
  EXPECT_EQ(o.exit_code, 4);
  EXPECT_THAT(o.err, HasSubstr("no dag_encode"));
  o = judge_dag("dag_encodes_only", "dag");
  EXPECT_EQ(o.exit_code, 4);
  EXPECT_THAT(o.err, HasSubstr("add dag_decode or dag_lookup"));
}

TEST(DagSubject, a_header_from_before_the_topic_has_none_of_it) {
  const Outcome o = judge_dag("dag_old_header", "dag");
  EXPECT_NE(o.exit_code, 0);
  EXPECT_THAT(o.out + o.err, Not(HasSubstr("proved     dag")));
}

}  // namespace dag_plugin_test
}  // namespace mmverify::tests
