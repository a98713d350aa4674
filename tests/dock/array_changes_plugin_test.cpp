// [release alone, night] Shared libraries that change arrays and keep them in files: right and wrong ones, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace array_changes_plugin_test {

using testing::HasSubstr;

Outcome judge_changes(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 20 --threads 1 --subject " +
               library("array_changes_" + name));
}

TEST(ArrayChanges, the_example_in_c_keeps_the_laws) {
  const Outcome o = judge_changes(
      "example",
      "array.compact array.reorder array.concatenate array.files array.malformed_files array.emulates");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  for (const char* law : {"compact", "reorder", "concatenate", "files", "malformed_files", "emulates"})
    EXPECT_THAT(o.out, HasSubstr(std::string("proved     array.") + law));
  const Outcome samples = judge_changes(
      "example", "array.emulates_on_samples array.changes_on_samples array.files_on_samples --levels 2..4");
  EXPECT_EQ(samples.exit_code, 0) << samples.out << samples.err;
  EXPECT_THAT(samples.out, HasSubstr("9 results: 9 checked"));
}

struct WrongChange {
  friend void PrintTo(const WrongChange& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *expected;
};

class WrongChanges : public testing::TestWithParam<WrongChange> {};

// Each by its own law.
TEST_P(WrongChanges, are_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, expected] = GetParam();
  const Outcome o = judge_changes(name, law);
  expect_refuted_and_replayed(o, law);
  EXPECT_THAT(o.out, HasSubstr(expected));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, WrongChanges,
    testing::Values(
        WrongChange{"compact_drops_nothing", "array.compact", "records got "},
        WrongChange{"compact_refuses", "array.compact", " got "},
        WrongChange{"compact_keeps_the_base", "array.compact", "base=1"},
        WrongChange{"reorder_does_nothing", "array.reorder", ": at most record 0 got "},
        WrongChange{"concatenate_leaves_the_base", "array.concatenate", " got "},
        WrongChange{"concatenate_leaves_the_offsets", "array.concatenate", " got "},
        WrongChange{"load_lets_bytes_behind_pass", "array.malformed_files", "refused got read"},
        WrongChange{"load_forgets_signs", "array.files", "expected version 2: the array got another one"},
        WrongChange{"compact_empties_level_2", "array.changes_on_samples", "expected compacted: "},
        WrongChange{"reorder_empties_level_2", "array.changes_on_samples", "expected reordered: "},
        WrongChange{"concatenate_empties_level_2", "array.changes_on_samples", "expected concatenated: "},
        WrongChange{"reorder_forgets_the_third", "array.changes_on_samples", "geometry 2 triangle "},
        WrongChange{"load_refuses_level_2", "array.files_on_samples", "is read got refused"},
        WrongChange{"emulate_by_majority", "array.emulates", "case 4-state:0111 "}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(ArrayChanges, that_write_beyond_their_answer_are_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_changes("compact_overruns", "array.compact");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("it touched memory outside its output"));
  EXPECT_THAT(o.out, HasSubstr("compacting an array of 3 records"));
}

// The header asks for 0 for what is no array; a reader that looks no closer is as right.
TEST(ArrayChanges, a_reader_may_refuse_what_is_no_array) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome o = judge_changes("load_refuses_no_array", "array.files array.malformed_files");
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     array.malformed_files"));
}

TEST(ArrayChanges, that_are_missing_are_named) {
  const Outcome o = judge_changes("saves_alone", "array.reorder array.files array.compact");
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_THAT(o.err, HasSubstr("array.files was asked for, and nothing was judged"));
  EXPECT_THAT(o.out, HasSubstr("proved     array.reorder"));
  EXPECT_THAT(o.out, HasSubstr("n/a        array.files"));
  EXPECT_THAT(o.out, HasSubstr("n/a        array.compact"));
}

}  // namespace array_changes_plugin_test
}  // namespace mmverify::tests
