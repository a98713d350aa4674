// [release alone, night] Shared libraries of square maps and blocks: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace vq_plugin_test {

using testing::HasSubstr;

Outcome judge_vq(const std::string& name, const std::string& what) { return judged(name, what, 1); }

TEST(VqSubject, the_example_in_c_keeps_every_law_that_it_has_entry_points_for) {
  const Outcome o = judge_vq("vq_example", "vq");
  expect_said(o, 0,
              each_of("proved     ", {"vq2.region_is_map", "vq4.region_is_map", "vq2.no_other_bit",
                                      "vq4.no_other_bit", "vq2.conservative"}));
  expect_said(o, 0,
              each_of("checked    ", {"vq2.on_random_blocks", "vq4.on_random_blocks",
                                      "vq2.conservative_on_samples", "vq4.conservative_on_samples"}));
  // It does not promise vectors, fields or few substitutions.
  expect_said(
      o, 0,
      each_of("n/a        ", {"vq.vectors", "vq2.block_bits", "vq2.lossless_when_it_fits", "vq2.optimum"}));
}

TEST(WrongVq, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_vq,
      {{"vq_y_downwards", "vq2.region_is_map", "case block:", "expected decoded region"},
       {"vq_turns_the_other_way", "vq2.region_is_map", "case block:", "expected decoded region"},
       {"vq_last_region_of_br", "vq2.region_is_map", "case block:", "expected asked for region 15,0"},
       {"vq_state_3", "vq2.region_is_map", "case block:", "expected decoded region 0,0 O got 3"},
       {"vq_opaque_for_transparent", "vq2.conservative", "case map:02000000",
        "expected region 1,0 T or C got O"},
       {"vq_checks_nothing", "vq2.conservative", "case map:02000000", "expected region 0,0 O or C got T"},
       {"vq_promises_to_keep", "vq2.lossless_when_it_fits", "case map:", "expected region"}});
}

constexpr char regions[] = "vq2.region_is_map", encodes[] = "vq2.conservative",
               out_of_vq_input[] = "it wrote to its input or read past its end";

// tests/subjects/wrong_vq.cpp says what each does; the next law is judged.
TEST(MisbehavingVq, is_broken_with_the_case_and_the_run_goes_on) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge_vq, " vq4.conservative", "proved     vq4.conservative",
      {{"vq_decoder_reads_past", regions, out_of_vq_input, "at level 4 decoding block:"},
       {"vq_decoder_unwritten", regions, "left its output unwritten", "at level 4 decoding block:"},
       {"vq_region_crashes", regions, "crashed (signal ", "at level 4 looking up x=15,y=0 in block:"},
       {"vq_region_loads_at_16", regions, "threw an exception: no multiple of 16", "at level 4 looking up "},
       {"vq_encoder_overrun", encodes, "it touched memory outside its output",
        "at level 4 encoding map:02000000"},
       {"vq_encoder_counts_calls", encodes, "non-deterministic, asked again: byte 31",
        "at level 4 encoding map:02000000"},
       {"vq_encoder_throws", encodes, "threw an exception: no such map",
        "at level 4 encoding map:02000000"}});
}

TEST(VqSubject, a_decoder_or_an_encoder_may_come_alone_and_one_format_too) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string both = "vq2.region_is_map vq2.conservative";
  const Outcome decodes = judge_vq("vq_decodes_only", both), encodes = judge_vq("vq_encodes_only", both),
                vq4 = judge_vq("vq_vq4_only", both + " vq4.conservative vq4.on_random_blocks --cases 500");
  for (const Outcome* o : {&decodes, &encodes, &vq4})
    EXPECT_EQ(o->exit_code, 2) << o->out << o->err << "a law that was named is not judged";
  EXPECT_THAT(decodes.out, HasSubstr("proved     vq2.region_is_map"));
  EXPECT_THAT(decodes.out, HasSubstr("n/a        vq2.conservative"));
  EXPECT_THAT(encodes.out, HasSubstr("n/a        vq2.region_is_map"));
  EXPECT_THAT(encodes.out, HasSubstr("proved     vq2.conservative"));
  EXPECT_THAT(vq4.out, HasSubstr("n/a        vq2.region_is_map"));
  EXPECT_THAT(vq4.out, HasSubstr("proved     vq4.conservative"));
  EXPECT_THAT(vq4.out, HasSubstr("checked    vq4.on_random_blocks"));
}

TEST(VqSubject, built_before_there_were_blocks_it_has_none) {
  expect_complaint(judge_vq("vq_old_header", "vq"), 4, "all its entry points are null");
}

TEST(VqSubject, same_digest_as_ours) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto digest = [](const Outcome& o) { return o.out.substr(o.out.find("digest "), 23); };
  const std::string law = "mmverify prove vq2.region_is_map --details --quiet --no-mutants --subject ";
  const Outcome theirs = shell(law + library("vq_example") + " --threads 2"), ours = shell(law + "vq");
  EXPECT_EQ(theirs.exit_code, 0);
  EXPECT_EQ(digest(theirs), digest(ours));
}

}  // namespace vq_plugin_test
}  // namespace mmverify::tests
