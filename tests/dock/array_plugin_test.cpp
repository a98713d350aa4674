// [release alone, night] Shared libraries that build arrays: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace array_plugin_test {

Outcome judge_array(const std::string& name, const std::string& what) { return judged(name, what); }

// The small arrays of level 0 alone, and the laws that are quick: all of level 1 takes minutes.
TEST(ArraySubject, the_example_in_c_keeps_the_laws) {
  const Outcome o = judge_array(
      "array_example",
      "array.resolves array.formats array.special_indices array.index_range array.array_histogram "
      "array.geometry_histogram array.shares array.keeps_before --levels 0");
  expect_said(
      o, 0,
      each_of("proved     array.", {"resolves", "formats", "special_indices", "index_range",
                                    "array_histogram", "geometry_histogram", "shares", "keeps_before"}));
  expect_said(judge_array("array_example", "array.order array.on_samples array.codes --levels 0..3"), 0,
              {"proved     array.order", "checked    array.on_samples", "proved     array.codes"});
}

// Each by its own law, with the smallest array.
TEST(WrongArrays, are_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(
      judge_array,
      {{"array_merges_known", "array.resolves --levels 0",
        "case khr,u8,special,share,2-state:0,2-state:1 expected triangle 1 micro-triangle 0: O got T"},
       {"array_one_format", "array.formats --levels 0",
        "expected triangle 1: level 0, format 2 got level 0, format 1"},
       {"array_one_histogram", "array.geometry_histogram --levels 0",
        "expected 2 of level 0 format 1 got 1 of level 0 format 1"},
       {"array_base_on_special", "array.special_indices --levels 0", "expected triangle 0: special T got "},
       {"array_order_from_level_2", "array.order --levels 0..2", "level 2 case "},
       {"array_less_or_equal", "array.codes",
        "case u8,mesh,base=0,records=0 expected code 0x0 with base 0, 0 records: no record 0 got record 0"},
       {"array_minus_5_everywhere", "array.codes", "case u32,mesh,"},
       {"array_state_4", "array.codes", "got kind 255"},
       {"array_refuses_two", "array.resolves --levels 0", "got a refusal, though every index fits"},
       {"array_takes_maps_in_a_row", "array.resolves --levels 0..1",
        ", with its maps from the last to the first"},
       {"array_wants_ascending_maps", "array.resolves --levels 0",
        "got a refusal, though every index fits, with its maps from the last to the first"},
       {"array_says_more_bytes", "array.resolves --levels 0",
        "expected an answer as the header has it got "}});
}

// Batches of other sizes begin with other base triangles.
TEST(ArraySubject, that_resolves_a_batch_by_its_first_base_triangle_is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_array("array_one_base_a_batch", "array.codes_on_samples"), 1,
              {"non-deterministic, asked in batches of "});
}

TEST(BrokenArrays, are_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(judge_array, " --levels 0", "building khr,u8,special,share,2-state:0,2-state:0",
                     {{"array_crash", "array.resolves", "crashed (signal "},
                      {"array_throws", "array.resolves", "threw an exception: no second triangle"},
                      {"array_overrun", "array.resolves", "it touched memory outside its output"},
                      {"array_counts_calls", "array.resolves", "non-deterministic"}});
}

TEST(ArraySubject, one_that_resolves_alone_is_asked_for_that) {
  // A law that was named is not judged.
  expect_said(judge_array("array_resolves_only", "array.codes array.resolves --levels 0"), 2,
              {"proved     array.codes", "n/a        array.resolves"});
}

TEST(ArraySubject, built_before_there_were_arrays_it_has_none) {
  expect_complaint(judge_array("array_old_header", "array"), 4, "all its entry points are null");
}

}  // namespace array_plugin_test
}  // namespace mmverify::tests
