// [release alone, night] Shared libraries of attribute maps: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace attribute_plugin_test {

using testing::HasSubstr;
using testing::Not;

Outcome judge_attribute(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 10 --threads 1 --subject " +
               library(name));
}

TEST(AttributeSubject, the_example_in_c_keeps_every_law_that_it_has_entry_points_for) {
  const Outcome o = judge_attribute("attribute_example", "attribute --levels 0..4");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const char* law :
       {"order_bijective", "order_inverse", "order_is_walk", "face_orders", "order_prefix_nested",
        "bird_prefix", "umajor_is_reversed_rows", "triangle_vertices", "decimation_watertight",
        "decimation_areas", "decimation_counts", "mip_drift"})
    EXPECT_THAT(o.out, HasSubstr("proved     attribute." + std::string(law)));
  for (const char* law : {"holds_point", "reproduces", "tie_free"})
    EXPECT_THAT(o.out, HasSubstr("attribute." + std::string(law)));
  for (const char* law : {"triplets_on_floats", "weights_on_floats"})
    EXPECT_THAT(o.out, HasSubstr("checked    attribute." + std::string(law)));
  // What it has no entry point for.
  for (const char* law : {"convert", "face_ties", "interpolates_rgba8", "lod_level", "bake_vertex"})
    EXPECT_THAT(o.out, HasSubstr("n/a        attribute." + std::string(law)));
  EXPECT_THAT(o.out, Not(HasSubstr("refuted")));
}

TEST(AttributeSubject, at_level_16_products_leave_32_bits_and_the_example_keeps_them) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_attribute(
      "attribute_example", "attribute.triplets_on_floats attribute.weights_on_floats --levels 14..16");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

// -----------------------------------------------------------------------------------------------------------------

struct WrongAttributeAnswer {
  friend void PrintTo(const WrongAttributeAnswer& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *levels, *at;
};

class WrongAttribute : public testing::TestWithParam<WrongAttributeAnswer> {};

TEST_P(WrongAttribute, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, levels, at] = GetParam();
  const Outcome o = judge_attribute(name, std::string("attribute.") + law + " --levels " + levels);
  expect_refuted_and_replayed(o, std::string("attribute.") + law);
  EXPECT_THAT(o.out, HasSubstr(at));
}

// What each does stands in tests/subjects/wrong_attribute.cpp, and at which level.
INSTANTIATE_TEST_SUITE_P(
    Subject, WrongAttribute,
    testing::Values(
        WrongAttributeAnswer{"attribute_bird_vertex_twice", "order_bijective", "4", "level 4 case bird:"},
        WrongAttributeAnswer{"attribute_index_beyond", "order_bijective", "4", "level 4 case "},
        WrongAttributeAnswer{"attribute_index_beyond", "order_inverse", "4", "level 4 case "},
        WrongAttributeAnswer{"attribute_w_minor_row_turned", "order_inverse", "3", "level 3 case w-minor:"},
        WrongAttributeAnswer{"attribute_curve_as_rows", "face_orders", "3", "level 3 case "},
        WrongAttributeAnswer{"attribute_half_is_2", "face_orders", "5", "level 5 case "},
        WrongAttributeAnswer{"attribute_figure_4_cycle", "triangle_vertices", "1", "level 1 case "},
        WrongAttributeAnswer{"attribute_lower_for_upper", "triangle_vertices", "3", "level 3 case "},
        WrongAttributeAnswer{"attribute_rounded_carry", "triplets_on_floats", "3", "case u="},
        WrongAttributeAnswer{"attribute_lower_weights_on_upper", "weights_on_floats", "1", "case u="},
        WrongAttributeAnswer{"attribute_lower_weights_on_upper", "holds_point", "1", "level 1 case "},
        WrongAttributeAnswer{"attribute_towards_the_middle", "decimation_watertight", "2", "level "},
        WrongAttributeAnswer{"attribute_halves_go_up", "mip_drift", "0", "case half-to-even"},
        WrongAttributeAnswer{"attribute_bird_vertex_at_12", "bird_prefix", "7", "level 7 case 5:"},
        WrongAttributeAnswer{"attribute_halves_go_up", "mip_rounding", "0", "case "},
        WrongAttributeAnswer{"lockstep_face_mip", "mip_rounding", "0", "case "},
        WrongAttributeAnswer{"lockstep_face_mip", "mip_on_samples", "0", ", G: the mean of "},
        WrongAttributeAnswer{"attribute_second_child_is_grey", "mip_on_samples", "0", ": the mean of "},
        WrongAttributeAnswer{"attribute_second_child_without_alpha_is_black", "mip_on_samples", "0",
                             ": the mean of "}),
    [](const auto& info) { return std::string(info.param.name) + "_" + info.param.law; });

struct AttributeMisbehaviour {
  friend void PrintTo(const AttributeMisbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *law, *said, *doing;
};

class MisbehavingAttribute : public testing::TestWithParam<AttributeMisbehaviour> {};

TEST_P(MisbehavingAttribute, is_broken_with_the_case_and_the_run_goes_on) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, said, doing] = GetParam();
  const Outcome o = judge_attribute(name, std::string(law) + " attribute.mip_drift --levels 0..5");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr(std::string("broken     ") + law));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr(doing));
  EXPECT_THAT(o.out, HasSubstr("proved     attribute.mip_drift")) << "the next law is judged";
}

INSTANTIATE_TEST_SUITE_P(
    Subject, MisbehavingAttribute,
    testing::Values(AttributeMisbehaviour{"attribute_crash", "attribute.order_bijective", "crashed (signal ",
                                          "at level 4 on case i=3,j=5"},
                    AttributeMisbehaviour{"attribute_unwritten", "attribute.order_bijective",
                                          "left its output unwritten", "at level 4 on case i=3,j=5"},
                    AttributeMisbehaviour{"attribute_vertex_without_level", "attribute.triangle_vertices",
                                          "with the same first number", "triplet "},
                    AttributeMisbehaviour{"attribute_weights_count_calls", "attribute.weights_on_floats",
                                          "non-deterministic, asked ", "0x1"}),
    [](const auto& info) { return std::string(info.param.name); });

// -----------------------------------------------------------------------------------------------------------------

TEST(AttributeSubject, indices_may_come_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_attribute("attribute_indices_only", "attribute --levels 0..3");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     attribute.order_bijective"));
  EXPECT_THAT(o.out, HasSubstr("n/a        attribute.order_inverse"));
  EXPECT_THAT(o.out, HasSubstr("n/a        attribute.triangle_vertices"));
}

// By itself each order is right: only who asks for two of them sees it.
TEST(AttributeSubject, that_keeps_the_first_order_it_was_asked_for_is_refuted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_attribute("attribute_order_of_before", "attribute.order_inverse --levels 0..6");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("refuted    attribute.order_inverse"));
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
