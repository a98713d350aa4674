// Shared libraries that bake: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome judge_bake(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 1 --subject " + library(name));
}

// It says so itself: what it calls O or T is so, and much that is it does not.
TEST(BakeSubject, the_example_in_c_is_conservative_and_not_tight) {
  const Outcome o = judge_bake("bake_example", "bake --levels 0..1");
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("proved     bake.conservative "));
  EXPECT_THAT(o.out, HasSubstr("checked    bake.conservative_on_samples"));
  EXPECT_THAT(o.out, HasSubstr("checked    bake.force2"));
  EXPECT_THAT(o.out, HasSubstr("refuted    bake.tight "));
  EXPECT_THAT(o.out, HasSubstr("n/a        bake.unknown_side "));
  EXPECT_THAT(o.out, Not(HasSubstr("refuted    bake.conservative")));
  EXPECT_THAT(o.out, Not(HasSubstr("broken")));
}

// -----------------------------------------------------------------------------------------------------------------

struct WrongBakeAnswer {
  friend void PrintTo(const WrongBakeAnswer& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *at, *expected;
};

class WrongBake : public testing::TestWithParam<WrongBakeAnswer> {};

TEST_P(WrongBake, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, at, expected] = GetParam();
  const Outcome o = judge_bake(name, std::string(law) + " --levels 0..1");
  expect_refuted_and_replayed(o, law);
  EXPECT_THAT(o.out, HasSubstr(std::string("case texels=u8:") + at));
  EXPECT_THAT(o.out, HasSubstr(std::string("expected ") + expected));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, WrongBake,
    testing::Values(
        WrongBakeAnswer{"bake_settles_all", "bake.conservative", "2x2:80000000", "micro-triangle 0 U"},
        WrongBakeAnswer{"bake_rows_from_below", "bake.conservative", "2x2:", "micro-triangle"},
        WrongBakeAnswer{"bake_pads_with_ones", "bake.conservative", "2x2:00000000",
                        "zeros after the last state"},
        WrongBakeAnswer{"bake_promises_the_centroid", "bake.unknown_side", "2x2:", "micro-triangle"},
        WrongBakeAnswer{"bake_all_unknown", "bake.tight", "2x2:00000000", "micro-triangle 0 T"}),
    [](const auto& info) { return std::string(info.param.name); });

struct BakeMisbehaviour {
  friend void PrintTo(const BakeMisbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *said;
};

class MisbehavingBake : public testing::TestWithParam<BakeMisbehaviour> {};

// What each does stands in tests/subjects/wrong_bake.cpp.
TEST_P(MisbehavingBake, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, said] = GetParam();
  const Outcome o = judge_bake(name, "bake.conservative --levels 1 --threads 1");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     bake.conservative"));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr("at level 1 baking texels=u8:2x2:000000ff,wrap=repeat:repeat,"));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, MisbehavingBake,
    testing::Values(BakeMisbehaviour{"bake_reads_past", "it wrote to its input or read past its end"},
                    BakeMisbehaviour{"bake_overrun", "it touched memory outside its output"},
                    BakeMisbehaviour{"bake_unwritten", "left its output unwritten"},
                    BakeMisbehaviour{"bake_counts_calls", "non-deterministic, asked again: byte 0"},
                    BakeMisbehaviour{"bake_changes_its_mind", "non-deterministic, taken, then refused"},
                    BakeMisbehaviour{"bake_throws", "threw an exception: no such texture"}),
    [](const auto& info) { return std::string(info.param.name); });

// -----------------------------------------------------------------------------------------------------------------

TEST(BakeSubject, what_it_declines_is_counted_and_never_proved) {
  const Outcome some = judge_bake("bake_declines_borders", "bake.conservative --levels 0");
  EXPECT_EQ(some.exit_code, 0) << some.out << some.err;
  EXPECT_THAT(some.out, HasSubstr("checked    bake.conservative"));
  // 9 of the 25 pairs: 9 (81 * 6 + 512 * 4).
  EXPECT_THAT(some.out, HasSubstr("declined: 22,806 of these cases"));
  const Outcome all = judge_bake("bake_declines_all", "bake.conservative --levels 0");
  EXPECT_EQ(all.exit_code, 2) << "nothing was run";
  EXPECT_THAT(all.out, HasSubstr("n/a        bake.conservative"));
}

TEST(BakeSubject, built_before_there_were_bakers_it_has_none) {
  expect_complaint(judge_bake("bake_old_header", "bake"), 4, "all its entry points are null");
}

}  // namespace
}  // namespace mmverify::tests
