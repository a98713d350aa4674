// [release alone, night] Shared libraries of maps and codes: right, wrong and misbehaving ones, judged by the built program.
#include <cstdlib>
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace tree_plugin_test {

using testing::HasSubstr;
using testing::Not;

Outcome judge_map(const std::string& name, const std::string& what) { return judged(name, what, 1); }
Outcome judge_tree(const std::string& name, const std::string& what, const std::string& kind = {}) {
  return shell("mmverify prove " + what +
               " --details --quiet --no-mutants --timeout 1 --threads 1 --subject " + library(name) + kind);
}

TEST(TreeSubject, the_example_in_c_is_proved_on_all_maps) {
  const Outcome o = judge_tree("tree_example",
                               "tree.round_trip tree.lookup_is_decode tree.point_is_index tree.equals_spec "
                               "tree.canonical tree.sizes --levels 0..1");
  expect_said(o, 0,
              each_of("proved     tree.", {"round_trip", "lookup_is_decode", "point_is_index", "equals_spec",
                                           "canonical", "sizes"}));
  // Its points are floats.
  expect_said(o, 0,
              {"at multiples of 1/4N", "checked    tree.point_exact_on_floats",
               "tree_example.so: checked, the weakest of its verdicts"});
}

TEST(TreeSubject, the_example_in_c_refuses_what_is_malformed) {
  expect_said(judge_tree("tree_example", "tree.malformed --levels 0..1"), 0, {"proved     tree.malformed"});
}

TEST(TreeSubject, the_example_in_c_passes_samples_of_higher_levels) {
  expect_said(judge_tree("tree_example", "tree.on_samples --levels 3..4"), 0, {"checked    tree.on_samples"});
}

TEST(WrongTree, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(judge_map,
                      {{"tree_merges_ut", "tree.round_trip --levels 0..1", "case 4-state:2"},
                       {"tree_children_reversed", "tree.lookup_is_decode --levels 0..1", "case 2-state:"},
                       {"tree_takes_all", "tree.malformed --levels 0", "case 2-state:0"},
                       {"tree_takes_all", "tree.canonical --levels 0", "case 2-state:"},
                       {"tree_refuses_its_own", "tree.round_trip --levels 1", "case 2-state:0110"},
                       {"tree_has_no_code", "tree.round_trip --levels 1", "case 2-state:0110"},
                       {"tree_has_no_code", "tree.lookup_is_decode --levels 1", "case 2-state:0110"},
                       {"tree_pads_with_ones", "tree.equals_spec --levels 1", "case 2-state:0110"},
                       {"several_keeps_padding", "micromap.force2 --levels 0", "case 4-state:"},
                       {"several_merges_ut_with_t", "micromap.down --levels 1", "case 4-state:0002"},
                       {"several_promises_opaque", "lossy.allowed --levels 1", "case 4-state:1230"}});
}

constexpr char encoding[] = "at level 1 encoding 2-state:0110",
               decoding[] = "at level 1 decoding the 2-state code 01 06",
               at_2[] = "at level 1 looking up k=2 in the 2-state code 01 06",
               at_point[] = "at level 1 looking up u=0x1p-1,v=0x1p-2 in the 2-state code 01 06",
               trip[] = "tree.round_trip", look[] = "tree.lookup_is_decode", point[] = "tree.point_is_index",
               out_of_output[] = "it touched memory outside its output",
               out_of_tree_input[] = "it wrote to its input or read past its end";

// tests/subjects/wrong_tree.cpp says what each does; the next law is judged.
TEST(MisbehavingTree, is_broken_with_the_case_and_the_run_goes_on) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge_map, " tree.sizes --levels 0..1", " tree.sizes ",
      {{"tree_crash", trip, "crashed (signal ", encoding},
       {"tree_hang", trip, "hung: no answer within 1 s", encoding},
       {"tree_hangs_on_uo", trip, "was repeated; that one may be at fault)", "at level 0 encoding 2-state:0"},
       {"tree_overrun", trip, out_of_output, encoding},
       {"tree_underrun", trip, "wrote before the start of its output", encoding},
       {"tree_exits", trip, "called exit(0)", encoding},
       {"tree_throws", trip, "threw an exception: no such map", encoding},
       {"tree_rounds", trip, "left the rounding or flush mode changed", encoding},
       {"tree_counts_calls", trip, "non-deterministic, asked again: byte 1 was 6, then 7", encoding},
       {"tree_sees_room", trip, "non-deterministic, a code of 2 bytes, then, with room for 2, of 3",
        encoding},
       {"tree_sees_threads", trip, "non-deterministic, asked from two threads at once", encoding},
       {"tree_writes_input", trip, out_of_tree_input, encoding},
       {"tree_unwritten", trip, "left its output unwritten", encoding},
       {"tree_asks_too_much", trip, "asked for 1073741824 bytes, more than 33554432", encoding},
       {"tree_reads_past", trip, out_of_tree_input, decoding},
       {"tree_writes_code", trip, out_of_tree_input, decoding},
       {"tree_unwritten_map", trip, "left its output unwritten", decoding},
       {"tree_changes_its_mind", trip, "non-deterministic, refused, then taken", decoding},
       {"tree_lookup_crashes", look, "crashed (signal ", at_2},
       {"tree_lookup_unwritten", look, "left its output unwritten", at_2},
       {"tree_lookup_reads_past", look, out_of_tree_input, at_2},
       {"tree_point_throws", point, "threw an exception: no such point", at_point},
       {"several_reads_past_map", "micromap.up", out_of_tree_input, "at level 1 one level up from 4-state:"},
       {"several_loads_at_16", "micromap.force2", "threw an exception: no multiple of 16",
        "at level 1 force-2-state of 4-state:"},
       {"several_keeps_without_format", "micromap.down",
        "asked after the same bytes in another format, order or mode: byte 0 was 2, then 1",
        "at level 1 one level down from 4-state:"},
       {"several_leaves_unwritten", "micromap.packing", "left its output unwritten",
        "at level 1 unpacking 2-state:0110"}});
}

TEST(Several, a_map_kept_without_its_level_is_caught) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_tree("several_keeps_without_level", "micromap.force2 --levels 2"), 1,
              {"broken     micromap.force2", "asked after level 1: byte 1 was "});
}

// Codes that differ in their middle alone are asked in turn, at one address.
TEST(TreeSubject, a_code_known_by_its_address_and_ends_is_caught) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_tree("tree_keeps_by_ends", "tree.on_samples --levels 4 --no-companions"), 1,
              {"broken     tree.on_samples", "non-deterministic"});
}

// The specification does what is missing, and is not judged for it.
TEST(TreeSubject, an_encoder_alone_is_judged_by_the_specifications_decoder) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  // A law that was named is not judged.
  expect_said(
      judge_tree("tree_encodes_only", "tree.round_trip tree.malformed tree.lookup_is_decode --levels 0..1"),
      2, {"proved     tree.round_trip", "n/a        tree.malformed", "n/a        tree.lookup_is_decode"});
}

TEST(TreeSubject, a_decoder_alone_gets_the_specifications_codes) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  // A law that was named is not judged.
  expect_said(judge_tree("tree_decodes_only", "tree.round_trip tree.canonical tree.equals_spec --levels 0"),
              2, {"proved     tree.round_trip", "n/a        tree.equals_spec"});
}

TEST(TreeSubject, a_lookup_alone_decodes_point_by_point) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_tree("tree_points_only", "tree.round_trip tree.point_is_index --levels 0..1"), 0,
              {"proved     tree.round_trip", "proved     tree.point_is_index"});
}

TEST(TreeSubject, half_of_a_codec_of_its_own_is_exit_4) {
  expect_complaint(judge_tree("tree_foreign_decoder", "tree"), 4, "it decodes trees and has no tree_encode");
  expect_complaint(judge_tree("tree_foreign_encoder", "tree"), 4,
                   "nothing leads from the codes of tree_encode back to the map");
}

const std::string one_law_a_topic = "index.in_range tree.round_trip micromap.packing --levels 0..1";

TEST(Several, a_library_of_three_topics_is_three_subjects) {
  const Outcome o = judge_tree("several_nothing", one_law_a_topic);
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  const std::string file = library("several_nothing");
  EXPECT_THAT(o.out, HasSubstr("subject " + file + ": "));
  EXPECT_THAT(o.out, HasSubstr("subject " + file + ":tree: proved"));
  EXPECT_THAT(o.out, HasSubstr("subject " + file + ":micromap: proved"));
  EXPECT_THAT(o.out, Not(HasSubstr("n/a")));
}

TEST(Several, micromaps_that_are_right_are_proved) {
  const Outcome o = judge_tree("several_nothing", "micromap lossy --levels 0..1", ":micromap");
  expect_said(o, 0,
              each_of("proved     ", {"micromap.packing", "micromap.force2", "micromap.up", "micromap.down",
                                      "micromap.down_up", "micromap.modes", "lossy.allowed"}));
  expect_said(o, 0, {"n/a        micromap.validate"});
}

TEST(Several, one_of_them_can_be_named) {
  const Outcome o = judge_tree("several_nothing", one_law_a_topic, ":tree");
  EXPECT_THAT(o.out, HasSubstr("proved     tree.round_trip"));
  EXPECT_THAT(o.out, Not(HasSubstr("proved     micromap.packing")));
  expect_complaint(judge_tree("tree_example", "tree.round_trip", ":micromap"), 2,
                   "no entry point of topic micromap");
}

TEST(Several, one_that_was_built_before_there_were_trees_is_judged_as_before) {
  // A law that was named is not judged.
  expect_said(judge_tree("several_old_header", one_law_a_topic), 2,
              {"proved     index.in_range", "n/a        tree.round_trip"}, {".so:tree"});
}

TEST(Several, same_digest_for_any_number_of_threads_and_as_ours) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto digest = [](const Outcome& o) { return o.out.substr(o.out.find("digest "), 23); };
  const std::string law = "mmverify prove tree.equals_spec --details --quiet --levels 1 --subject ";
  const Outcome one = shell(law + library("tree_example") + " --threads 1");
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(digest(one), digest(shell(law + library("tree_example") + " --threads 2")));
  EXPECT_EQ(digest(one), digest(shell(law + "tree-stream")));
}

}  // namespace tree_plugin_test
}  // namespace mmverify::tests
