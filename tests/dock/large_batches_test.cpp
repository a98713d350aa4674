// Subjects of large batches: what is wrong with one is seen across the 4096 that others are asked with.
#include <string>

#include "tests/dock/plugin.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;

Outcome judge(const std::string& kind) {
  return shell(
      "mmverify prove index.equals_reference --levels 7..8 --no-companions --details --quiet --no-mutants "
      "--threads 1 "
      "--subject " +
      library("large_batches_" + kind));
}

TEST(LargeBatches, of_a_right_subject_are_proved_and_say_where) {
  expect_said(judge("RIGHT"), 0,
              {"level 8               197,377 cases", "large_batches_RIGHT.so: machine: a test's\n",
               "large_batches_RIGHT.so: about: no colon here\n"});
}

TEST(LargeBatches, that_change_the_answer_are_non_deterministic_or_wrong) {
  const Outcome o = judge("SEES_BATCH");
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out,
              testing::AnyOf(HasSubstr("non-deterministic"), HasSubstr("refuted    index.equals_reference")));
}

TEST(LargeBatches, with_one_case_that_crashes_name_it) {
  expect_said(judge("CRASHES"), 1, {"at level 8 on case u=0x1p-1,v=0x1p-2"});
}

TEST(LargeBatches, that_leave_an_answer_unwritten_are_broken) {
  expect_said(judge("UNWRITTEN"), 1, {"left its output unwritten"});
}

TEST(LargeBatches, that_write_behind_their_output_are_broken) {
  expect_said(judge("WRITES_BEHIND"), 1, {"wrote behind the end of its output"});
}

TEST(NotHere, is_not_applicable_with_the_librarys_own_reason) {
  expect_said(judge("NOT_HERE"), 2, {"the moon is not up"});
}

}  // namespace
}  // namespace mmverify::tests
