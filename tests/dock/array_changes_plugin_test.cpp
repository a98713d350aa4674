// [release alone, night] Shared libraries that change arrays and keep them in files: right and wrong ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace array_changes_plugin_test {

Outcome judge_changes(const std::string& name, const std::string& what) {
  return judged("array_changes_" + name, what);
}

TEST(ArrayChanges, the_example_in_c_keeps_the_laws) {
  const Outcome o = judge_changes(
      "example",
      "array.compact array.reorder array.concatenate array.files array.malformed_files array.emulates");
  expect_said(o, 0,
              each_of("proved     array.",
                      {"compact", "reorder", "concatenate", "files", "malformed_files", "emulates"}));
  expect_said(judge_changes(
                  "example",
                  "array.emulates_on_samples array.changes_on_samples array.files_on_samples --levels 2..4"),
              0, {"9 results: 9 checked"});
}

// Each by its own law.
TEST(WrongChanges, are_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_refuted(judge_changes,
                      {{"compact_drops_nothing", "array.compact", "records got "},
                       {"compact_refuses", "array.compact", " got "},
                       {"compact_keeps_the_base", "array.compact", "base=1"},
                       {"reorder_does_nothing", "array.reorder", ": at most record 0 got "},
                       {"concatenate_leaves_the_base", "array.concatenate", " got "},
                       {"concatenate_leaves_the_offsets", "array.concatenate", " got "},
                       {"load_lets_bytes_behind_pass", "array.malformed_files", "refused got read"},
                       {"load_forgets_signs", "array.files", "expected version 2: the array got another one"},
                       {"compact_empties_level_2", "array.changes_on_samples", "expected compacted: "},
                       {"reorder_empties_level_2", "array.changes_on_samples", "expected reordered: "},
                       {"concatenate_empties_level_2", "array.changes_on_samples", "expected concatenated: "},
                       {"reorder_forgets_the_third", "array.changes_on_samples", "geometry 2 triangle "},
                       {"load_refuses_level_2", "array.files_on_samples", "is read got refused"},
                       {"emulate_by_majority", "array.emulates", "case 4-state:0111 "}});
}

TEST(ArrayChanges, that_write_beyond_their_answer_are_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_changes("compact_overruns", "array.compact"), 1,
              {"it touched memory outside its output", "compacting an array of 3 records"});
}

// The header asks for 0 for what is no array; a reader that looks no closer is as right.
TEST(ArrayChanges, a_reader_may_refuse_what_is_no_array) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge_changes("load_refuses_no_array", "array.files array.malformed_files"), 0,
              {"proved     array.malformed_files"});
}

TEST(ArrayChanges, that_are_missing_are_named) {
  const Outcome o = judge_changes("saves_alone", "array.reorder array.files array.compact");
  expect_said(o, 2, {"proved     array.reorder", "n/a        array.files", "n/a        array.compact"});
  EXPECT_THAT(o.err, testing::HasSubstr("array.files was asked for, and nothing was judged"));
}

}  // namespace array_changes_plugin_test
}  // namespace mmverify::tests
