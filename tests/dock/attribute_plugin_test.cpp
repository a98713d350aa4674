// [release alone, night] Shared libraries of attribute maps: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace attribute_plugin_test {

Outcome judge_attribute(const std::string& name, const std::string& what) { return judged(name, what, 10); }

TEST(AttributeSubject, the_example_in_c_keeps_every_law_that_it_has_entry_points_for) {
  const Outcome o = judge_attribute("attribute_example", "attribute --levels 0..4");
  expect_said(o, 0,
              each_of("proved     attribute.",
                      {"order_bijective", "order_inverse", "order_is_walk", "face_orders",
                       "order_prefix_nested", "bird_prefix", "umajor_is_reversed_rows", "triangle_vertices",
                       "decimation_watertight", "decimation_areas", "decimation_counts", "mip_drift"}));
  expect_said(o, 0, each_of("attribute.", {"holds_point", "reproduces", "tie_free"}));
  expect_said(o, 0, each_of("checked    attribute.", {"triplets_on_floats", "weights_on_floats"}));
  // It has no entry points for these.
  expect_said(o, 0,
              each_of("n/a        attribute.",
                      {"convert", "face_ties", "interpolates_rgba8", "lod_level", "bake_vertex"}));
  expect_said(o, 0, {}, {"refuted"});
}

TEST(AttributeSubject, at_level_16_products_leave_32_bits_and_the_example_keeps_them) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_attribute(
      "attribute_example", "attribute.triplets_on_floats attribute.weights_on_floats --levels 14..16");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

// tests/subjects/wrong_attribute.cpp says what each does, and at which level.
TEST(WrongAttribute, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_attribute,
      {{"attribute_bird_vertex_twice", "attribute.order_bijective --levels 4", "level 4 case bird:"},
       {"attribute_index_beyond", "attribute.order_bijective --levels 4", "level 4 case "},
       {"attribute_index_beyond", "attribute.order_inverse --levels 4", "level 4 case "},
       {"attribute_w_minor_row_turned", "attribute.order_inverse --levels 3", "level 3 case w-minor:"},
       {"attribute_curve_as_rows", "attribute.face_orders --levels 3", "level 3 case "},
       {"attribute_half_is_2", "attribute.face_orders --levels 5", "level 5 case "},
       {"attribute_figure_4_cycle", "attribute.triangle_vertices --levels 1", "level 1 case "},
       {"attribute_lower_for_upper", "attribute.triangle_vertices --levels 3", "level 3 case "},
       {"attribute_rounded_carry", "attribute.triplets_on_floats --levels 3", "case u="},
       {"attribute_lower_weights_on_upper", "attribute.weights_on_floats --levels 1", "case u="},
       {"attribute_lower_weights_on_upper", "attribute.holds_point --levels 1", "level 1 case "},
       {"attribute_towards_the_middle", "attribute.decimation_watertight --levels 2", "level "},
       {"attribute_halves_go_up", "attribute.mip_drift --levels 0", "case half-to-even"},
       {"attribute_bird_vertex_at_12", "attribute.bird_prefix --levels 7", "level 7 case 5:"},
       {"attribute_halves_go_up", "attribute.mip_rounding --levels 0", "case "},
       {"lockstep_face_mip", "attribute.mip_rounding --levels 0", "case "},
       {"lockstep_face_mip", "attribute.mip_on_samples --levels 0", ", G: the mean of "},
       {"attribute_second_child_is_grey", "attribute.mip_on_samples --levels 0", ": the mean of "},
       {"attribute_second_child_without_alpha_is_black", "attribute.mip_on_samples --levels 0",
        ": the mean of "}});
}

// The next law is judged.
TEST(MisbehavingAttribute, is_broken_with_the_case_and_the_run_goes_on) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge_attribute, " attribute.mip_drift --levels 0..5", "proved     attribute.mip_drift",
      {{"attribute_crash", "attribute.order_bijective", "crashed (signal ", "at level 4 on case i=3,j=5"},
       {"attribute_unwritten", "attribute.order_bijective", "left its output unwritten",
        "at level 4 on case i=3,j=5"},
       {"attribute_vertex_without_level", "attribute.triangle_vertices", "with the same first number",
        "triplet "},
       {"attribute_weights_count_calls", "attribute.weights_on_floats", "non-deterministic, asked ", "0x1"}});
}

TEST(AttributeSubject, indices_may_come_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_attribute("attribute_indices_only", "attribute --levels 0..3"), 0,
              {"proved     attribute.order_bijective", "n/a        attribute.order_inverse",
               "n/a        attribute.triangle_vertices"});
}

// Each order is right alone; a law sees the fault only if it asks for two orders.
TEST(AttributeSubject, that_keeps_the_first_order_it_was_asked_for_is_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_attribute("attribute_order_of_before", "attribute.order_inverse --levels 0..6"), 1,
              {"refuted    attribute.order_inverse"});
}

TEST(AttributeSubject, built_before_there_were_attribute_maps_it_has_none) {
  expect_complaint(judge_attribute("attribute_old_header", "attribute"), 4, "all its entry points are null");
}

TEST(AttributeSubject, same_digest_as_ours) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string laws =
      "mmverify prove attribute.order_bijective attribute.face_orders --levels 6 --quiet --no-mutants --json "
      "- --subject ";
  const auto digests = [](const Outcome& o) {
    std::string found;
    for (std::size_t at = 0; (at = o.out.find("\"digest\"", at)) != std::string::npos; ++at)
      found += o.out.substr(at, 32);
    return found;
  };
  const Outcome theirs = shell(laws + library("attribute_example")), ours = shell(laws + "attribute");
  EXPECT_EQ(digests(theirs), digests(ours));
  EXPECT_FALSE(digests(ours).empty());
}

}  // namespace attribute_plugin_test
}  // namespace mmverify::tests
