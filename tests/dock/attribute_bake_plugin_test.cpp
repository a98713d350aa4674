// [release alone, night] Shared libraries that bake attribute maps: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace attribute_bake_plugin_test {

using testing::HasSubstr;

Outcome judge(const std::string& name, const std::string& what) {
  return judged("attribute_bake_" + name, what, 10);
}

TEST(AttributeBaker, the_example_in_c_is_within_a_code_of_every_value) {
  const Outcome o = judge("example", "attribute --levels 0..1");
  expect_said(o, 0, each_of("checked    attribute.", {"bake_face", "bake_on_floats", "bake_edge_agrees"}));
  expect_said(
      o, 0,
      each_of("n/a        attribute.", {"order_bijective", "weights_on_floats", "face_mean_is_parent"}));
  // Segments and points, two of the family's seven triangles, are no faces to it.
  expect_said(o, 0,
              {"proved     attribute.bake_vertex", "within what it declares: linear and srgb; within 1 code",
               "declined: 2,592 of these cases"});
}

TEST(AttributeBaker, the_example_in_c_is_so_on_samples_of_higher_levels) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge("example", "attribute.bake_on_floats attribute.bake_edge_agrees --levels 4..7");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

TEST(AttributeBaker, above_the_level_that_it_declares_is_not_asked) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge("example", "attribute.bake_on_floats --levels 9"), 2, {"bakes up to level 8"});
}

// tests/subjects/wrong_attribute_bake.cpp says what each does.
TEST(WrongAttributeBaker, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge, {{"srgb_as_codes", "attribute.bake_face --levels 1", "at face "},
              {"srgb_as_codes", "attribute.bake_vertex --levels 1", "at micro-vertex i="},
              {"black_border", "attribute.bake_face --levels 0", "border"},
              {"black_border", "attribute.bake_constant --levels 0", "border"},
              {"mirror_repeats", "attribute.bake_vertex --levels 0", "mirror"},
              {"wraps_exchanged", "attribute.bake_face --levels 0", "expected "},
              {"centres_at_corners", "attribute.bake_vertex --levels 0", "bilinear"},
              {"rows_from_below", "attribute.bake_face --levels 0", "expected "},
              {"two_codes_off_at_4", "attribute.bake_on_floats --levels 2..5", "level 4 case "},
              {"coordinates_in_8_bits_at_5", "attribute.bake_on_floats --levels 2..5", "level 5 case "},
              {"exact_by_its_word", "attribute.bake_constant --levels 0", "expected "}});
}

TEST(AttributeBaker, a_code_off_is_allowed_and_counted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge("one_code_off", "attribute.bake_constant --levels 0"), 0,
              {"checked    attribute.bake_constant", "allowed: "});
}

TEST(MisbehavingAttributeBaker, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(judge, " --levels 0", "baking 2x2:",
                     {{"unwritten", "attribute.bake_vertex", "left its output unwritten"},
                      {"reads_past", "attribute.bake_vertex", "it wrote to its input or read past its end"},
                      {"overrun", "attribute.bake_vertex", "it touched memory outside its output"}});
}

TEST(AttributeBaker, is_judged_inside_what_it_declares) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge("clamps_srgb_only",
                    "attribute.bake_vertex attribute.bake_on_floats attribute.bake_constant --levels 0"),
              0, {"within what it declares: srgb; clamp; within 1 code"},
              {"n/a        attribute.bake_vertex"});
}

TEST(AttributeBaker, that_declines_what_it_does_not_declare_says_how_many) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome some = judge("declines_borders", "attribute.bake_vertex --levels 0");
  EXPECT_EQ(some.exit_code, 0) << some.out << some.err;
  // Two of the family's eight pairs of addressing modes have a border along u.
  EXPECT_THAT(some.out, HasSubstr("declined: 4,536 of these cases"));
  expect_said(judge("declines_all", "attribute.bake_vertex --levels 0"), 2,
              {"the subject supports none of the cases"});
}

TEST(AttributeBaker, may_have_vertices_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge("vertices_only", "attribute --levels 0"), 0,
              {"proved     attribute.bake_vertex", "n/a        attribute.bake_face"});
}

TEST(AttributeBaker, of_what_cannot_be_is_not_loaded) {
  expect_complaint(judge("tolerance_above_16", "attribute"), 4,
                   "its attribute_support: tolerance is above 16");
}

TEST(AttributeBaker, built_before_there_were_bakers_it_has_none) {
  expect_complaint(judge("old_header", "attribute"), 4, "all its entry points are null");
}

}  // namespace attribute_bake_plugin_test
}  // namespace mmverify::tests
