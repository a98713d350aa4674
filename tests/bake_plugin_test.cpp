// Shared libraries that bake: right, wrong and misbehaving ones, judged by the built program.
#include <string>

#include "tests/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome judge(const std::string& name, const std::string& what) {
  return shell("mmverify prove " + what + " --quiet --no-mutants --timeout 1 --subject " + library(name));
}

// It says so itself: what it calls O or T is so, and much that is it does not.
TEST(BakeSubject, the_example_in_c_is_conservative_and_not_tight) {
  const Outcome o = judge("bake_example", "bake --levels 0..1");
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

struct WrongAnswer {
  friend void PrintTo(const WrongAnswer& w, std::ostream* out) { *out << w.name; }
  const char *name, *law, *at, *expected;
};

class Wrong : public testing::TestWithParam<WrongAnswer> {};

TEST_P(Wrong, is_refuted_and_replayed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, at, expected] = GetParam();
  const Outcome o = judge(name, std::string(law) + " --levels 0..1");
  expect_refuted_and_replayed(o, law);
  EXPECT_THAT(o.out, HasSubstr(std::string("case texels=u8:") + at));
  EXPECT_THAT(o.out, HasSubstr(std::string("expected ") + expected));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, Wrong,
    testing::Values(
        WrongAnswer{"bake_settles_all", "bake.conservative", "2x2:80000000", "micro-triangle 0 U"},
        WrongAnswer{"bake_rows_from_below", "bake.conservative", "2x2:", "micro-triangle"},
        WrongAnswer{"bake_pads_with_ones", "bake.conservative", "2x2:00000000", "zeros after the last state"},
        WrongAnswer{"bake_promises_the_centroid", "bake.unknown_side", "2x2:", "micro-triangle"},
        WrongAnswer{"bake_all_unknown", "bake.tight", "2x2:00000000", "micro-triangle 0 T"}),
    [](const auto& info) { return std::string(info.param.name); });

struct Misbehaviour {
  friend void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *said;
};

class Misbehaving : public testing::TestWithParam<Misbehaviour> {};

// What each does stands in tests/subjects/wrong_bake.cpp.
TEST_P(Misbehaving, is_broken_with_the_case) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, said] = GetParam();
  const Outcome o = judge(name, "bake.conservative --levels 1 --threads 1");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     bake.conservative"));
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr("at level 1 baking texels=u8:2x2:000000ff,wrap=repeat:repeat,"));
}

INSTANTIATE_TEST_SUITE_P(
    Subject, Misbehaving,
    testing::Values(Misbehaviour{"bake_reads_past", "it wrote to its input or read past its end"},
                    Misbehaviour{"bake_overrun", "it touched memory outside its output"},
                    Misbehaviour{"bake_unwritten", "left its output unwritten"},
                    Misbehaviour{"bake_counts_calls", "non-deterministic, asked again: byte 0"},
                    Misbehaviour{"bake_changes_its_mind", "non-deterministic, taken, then refused"},
                    Misbehaviour{"bake_throws", "threw an exception: no such texture"}),
    [](const auto& info) { return std::string(info.param.name); });

// -----------------------------------------------------------------------------------------------------------------

TEST(BakeSubject, what_it_declines_is_counted_and_never_proved) {
  const Outcome some = judge("bake_declines_borders", "bake.conservative --levels 0");
  EXPECT_EQ(some.exit_code, 0) << some.out << some.err;
  EXPECT_THAT(some.out, HasSubstr("checked    bake.conservative"));
  // 9 of the 25 pairs: 9 (81 * 6 + 512 * 4).
  EXPECT_THAT(some.out, HasSubstr("declined: 22,806 of these cases"));
  const Outcome all = judge("bake_declines_all", "bake.conservative --levels 0");
  EXPECT_EQ(all.exit_code, 2) << "nothing was run";
  EXPECT_THAT(all.out, HasSubstr("n/a        bake.conservative"));
}

TEST(BakeSubject, built_before_there_were_bakers_it_has_none) {
  expect_complaint(judge("bake_old_header", "bake"), 4, "all its entry points are null");
}

}  // namespace
}  // namespace mmverify::tests
