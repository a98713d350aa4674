// [release alone, night] Shared libraries that bake attribute maps: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace attribute_bake_plugin_test {

using testing::HasSubstr;
using testing::Not;

Outcome judge(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 10 --threads 1 --subject " +
               library("attribute_bake_" + name));
}

TEST(AttributeBaker, the_example_in_c_is_within_a_code_of_every_value) {
  const Outcome o = judge("example", "attribute --levels 0..1");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     attribute.bake_vertex"));
  for (const char* law : {"bake_face", "bake_on_floats", "bake_edge_agrees"})
    EXPECT_THAT(o.out, HasSubstr("checked    attribute." + std::string(law)));
  EXPECT_THAT(o.out, HasSubstr("within what it declares: linear and srgb; within 1 code"));
  // Segments and points, two of the family's seven triangles, are no faces to it.
  EXPECT_THAT(o.out, HasSubstr("declined: 2,592 of these cases"));
  for (const char* law : {"order_bijective", "weights_on_floats", "face_mean_is_parent"})
    EXPECT_THAT(o.out, HasSubstr("n/a        attribute." + std::string(law)));
}

TEST(AttributeBaker, the_example_in_c_is_so_on_samples_of_higher_levels) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge("example", "attribute.bake_on_floats attribute.bake_edge_agrees --levels 4..7");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
}

TEST(AttributeBaker, above_the_level_that_it_declares_is_not_asked) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge("example", "attribute.bake_on_floats --levels 9");
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("bakes up to level 8"));
}

// ---------------------------------------------------------------------------------------------------------------------

struct WrongBaker {
  friend void PrintTo(const WrongBaker& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *levels, *at;
};

class WrongAttributeBaker : public testing::TestWithParam<WrongBaker> {};

TEST_P(WrongAttributeBaker, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, levels, at] = GetParam();
  const Outcome o = judge(name, std::string("attribute.") + law + " --levels " + levels);
  expect_refuted_and_replayed(o, std::string("attribute.") + law);
  EXPECT_THAT(o.out, HasSubstr(at));
}

// What each does stands in tests/subjects/wrong_attribute_bake.cpp.
INSTANTIATE_TEST_SUITE_P(
    Subject, WrongAttributeBaker,
    testing::Values(WrongBaker{"srgb_as_codes", "bake_face", "1", "at face "},
                    WrongBaker{"srgb_as_codes", "bake_vertex", "1", "at micro-vertex i="},
                    WrongBaker{"black_border", "bake_face", "0", "border"},
                    WrongBaker{"black_border", "bake_constant", "0", "border"},
                    WrongBaker{"mirror_repeats", "bake_vertex", "0", "mirror"},
                    WrongBaker{"wraps_exchanged", "bake_face", "0", "expected "},
                    WrongBaker{"centres_at_corners", "bake_vertex", "0", "bilinear"},
                    WrongBaker{"rows_from_below", "bake_face", "0", "expected "},
                    WrongBaker{"two_codes_off_at_4", "bake_on_floats", "2..5", "level 4 case "},
                    WrongBaker{"coordinates_in_8_bits_at_5", "bake_on_floats", "2..5", "level 5 case "},
                    WrongBaker{"exact_by_its_word", "bake_constant", "0", "expected "}),
    [](const auto& info) { return std::string(info.param.name) + "_" + info.param.law; });

TEST(AttributeBaker, a_code_off_is_allowed_and_counted) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge("one_code_off", "attribute.bake_constant --levels 0");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("checked    attribute.bake_constant"));
  EXPECT_THAT(o.out, HasSubstr("allowed: "));
}

struct Misbehaviour {
  friend void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *levels, *said;
};

class MisbehavingAttributeBaker : public testing::TestWithParam<Misbehaviour> {};

TEST_P(MisbehavingAttributeBaker, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, levels, said] = GetParam();
  const Outcome o = judge(name, std::string("attribute.bake_vertex --levels ") + levels);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     attribute.bake_vertex"));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr("baking 2x2:"));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, MisbehavingAttributeBaker,
    testing::Values(Misbehaviour{"unwritten", "0", "left its output unwritten"},
                    Misbehaviour{"reads_past", "0", "it wrote to its input or read past its end"},
                    Misbehaviour{"overrun", "0", "it touched memory outside its output"}),
    [](const auto& info) { return std::string(info.param.name); });

// ---------------------------------------------------------------------------------------------------------------------

TEST(AttributeBaker, is_judged_inside_what_it_declares) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o =
      judge("clamps_srgb_only",
            "attribute.bake_vertex attribute.bake_on_floats attribute.bake_constant --levels 0");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("within what it declares: srgb; clamp; within 1 code"));
  EXPECT_THAT(o.out, Not(HasSubstr("n/a        attribute.bake_vertex")));
}

TEST(AttributeBaker, that_declines_what_it_does_not_declare_says_how_many) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome some = judge("declines_borders", "attribute.bake_vertex --levels 0");
  EXPECT_EQ(some.exit_code, 0) << some.out << some.err;
  // Two of the family's eight pairs of addressing modes have a border along u.
  EXPECT_THAT(some.out, HasSubstr("declined: 4,536 of these cases"));
  const Outcome all = judge("declines_all", "attribute.bake_vertex --levels 0");
  EXPECT_EQ(all.exit_code, 2) << all.out << all.err;
  EXPECT_THAT(all.out, HasSubstr("the subject supports none of the cases"));
}

TEST(AttributeBaker, may_have_vertices_alone) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge("vertices_only", "attribute --levels 0");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     attribute.bake_vertex"));
  EXPECT_THAT(o.out, HasSubstr("n/a        attribute.bake_face"));
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
