// [release alone, night] Shared libraries that build arrays: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace array_plugin_test {

using testing::HasSubstr;

Outcome judge_array(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 20 --threads 1 --subject " +
               library(name));
}

// The small arrays of level 0 alone, and the laws that are quick: all of level 1 takes minutes.
TEST(ArraySubject, the_example_in_c_keeps_the_laws) {
  const Outcome o = judge_array(
      "array_example",
      "array.resolves array.formats array.special_indices array.index_range array.array_histogram "
      "array.geometry_histogram array.shares array.keeps_before --levels 0");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const char* law : {"resolves", "formats", "special_indices", "index_range", "array_histogram",
                          "geometry_histogram", "shares", "keeps_before"})
    EXPECT_THAT(o.out, HasSubstr(std::string("proved     array.") + law));
  const Outcome others =
      judge_array("array_example", "array.order array.on_samples array.codes --levels 0..3");
  EXPECT_EQ(others.exit_code, 0) << others.out << others.err;
  EXPECT_THAT(others.out, HasSubstr("proved     array.order"));
  EXPECT_THAT(others.out, HasSubstr("checked    array.on_samples"));
  EXPECT_THAT(others.out, HasSubstr("proved     array.codes"));
}

struct WrongArray {
  friend void PrintTo(const WrongArray& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *expected;
};

class WrongArrays : public testing::TestWithParam<WrongArray> {};

// Each by its own law, with the smallest array.
TEST_P(WrongArrays, are_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, expected] = GetParam();
  const Outcome o = judge_array(name, law);
  expect_refuted_and_replayed(o, std::string(law).substr(0, std::string(law).find(' ')));
  EXPECT_THAT(o.out, HasSubstr(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, WrongArrays,
    testing::Values(
        WrongArray{
            "array_merges_known", "array.resolves --levels 0",
            "case khr,u8,special,share,2-state:0,2-state:1 expected triangle 1 micro-triangle 0: O got T"},
        WrongArray{"array_one_format", "array.formats --levels 0",
                   "expected triangle 1: level 0, format 2 got level 0, format 1"},
        WrongArray{"array_one_histogram", "array.geometry_histogram --levels 0",
                   "expected 2 of level 0 format 1 got 1 of level 0 format 1"},
        WrongArray{"array_base_on_special", "array.special_indices --levels 0",
                   "expected triangle 0: special T got "},
        WrongArray{"array_order_from_level_2", "array.order --levels 0..2", "level 2 case "},
        WrongArray{"array_less_or_equal", "array.codes",
                   "case u8,mesh,base=0,records=0 expected code 0x0 with base 0, 0 records: no record 0 got "
                   "record 0"},
        WrongArray{"array_minus_5_everywhere", "array.codes", "case u32,mesh,"},
        WrongArray{"array_state_4", "array.codes", "got kind 255"},
        WrongArray{"array_refuses_two", "array.resolves --levels 0",
                   "got a refusal, though every index fits"},
        WrongArray{"array_takes_maps_in_a_row", "array.resolves --levels 0..1",
                   ", with its maps from the last to the first"},
        WrongArray{"array_wants_ascending_maps", "array.resolves --levels 0",
                   "got a refusal, though every index fits, with its maps from the last to the first"},
        WrongArray{"array_says_more_bytes", "array.resolves --levels 0",
                   "expected an answer as the header has it got "}),
    [](const auto& info) { return std::to_string(info.index) + "_" + info.param.name; });

// Batches of other sizes begin with other base triangles.
TEST(ArraySubject, that_resolves_a_batch_by_its_first_base_triangle_is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_array("array_one_base_a_batch", "array.codes_on_samples");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("non-deterministic, asked in batches of "));
}

struct BrokenArray {
  friend void PrintTo(const BrokenArray& b, std::ostream* out) { *out << b.name; }
  const char *name, *said;
};

class BrokenArrays : public testing::TestWithParam<BrokenArray> {};

TEST_P(BrokenArrays, are_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, said] = GetParam();
  const Outcome o = judge_array(name, "array.resolves --levels 0");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     array.resolves"));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr("building khr,u8,special,share,2-state:0,2-state:0"));
}

INSTANTIATE_TEST_SUITE_P(Subject, BrokenArrays,
                         testing::Values(BrokenArray{"array_crash", "crashed (signal "},
                                         BrokenArray{"array_throws",
                                                     "threw an exception: no second triangle"},
                                         BrokenArray{"array_overrun", "it touched memory outside its output"},
                                         BrokenArray{"array_counts_calls", "non-deterministic"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ArraySubject, one_that_resolves_alone_is_asked_for_that) {
  const Outcome o = judge_array("array_resolves_only", "array.codes array.resolves --levels 0");
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err << "a law that was named is not judged";
  EXPECT_THAT(o.out, HasSubstr("proved     array.codes"));
  EXPECT_THAT(o.out, HasSubstr("n/a        array.resolves"));
}

TEST(ArraySubject, built_before_there_were_arrays_it_has_none) {
  expect_complaint(judge_array("array_old_header", "array"), 4, "all its entry points are null");
}

}  // namespace array_plugin_test
}  // namespace mmverify::tests
