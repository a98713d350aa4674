// [release alone, night] Shared libraries that are right wherever a law asks, and wrong by what lies around a question, judged by the built
// program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace touchy_plugin_test {

using testing::HasSubstr;

struct Touchy {
  friend void PrintTo(const Touchy& t, std::ostream* out) { *out << t.name; }
  const char *name, *law, *said;
};

Outcome judge(const std::string& name, const std::string& law) {
  return shell("mmverify prove " + law + " --quiet --no-mutants --timeout 20 --threads 1 --subject " +
               library("touchy_" + name));
}

class TouchySubject : public testing::TestWithParam<Touchy> {};

TEST_P(TouchySubject, is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, said] = GetParam();
  const Outcome o = judge(name, law);
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     "));
  EXPECT_THAT(o.out, HasSubstr(said));
}

constexpr char trip[] = "tree.round_trip --levels 1..2", places[] = "attribute.order_inverse --levels 1..3",
               behind[] = "wrote behind the end of its output",
               over[] = "asked with another answer in its output: ",
               beside[] = "one of them at another level or in another format, order or mode: ";

INSTANTIATE_TEST_SUITE_P(
    Subject, TouchySubject,
    testing::Values(Touchy{"decide_writes_behind", "traverse.decision", behind},
                    Touchy{"decode_writes_behind", trip, behind},
                    Touchy{"decide_keeps_answers", "traverse.decision", over},
                    Touchy{"encode_adds_to_zero", trip, over}, Touchy{"place_keeps_j", places, over},
                    Touchy{"encode_ends_in_a_word", trip, "asked with room for "},
                    Touchy{"decode_at_13", trip, "asked with its bytes at another address: byte 0 was "},
                    Touchy{"place_descending", places, "asked in descending order: "},
                    Touchy{"place_by_twos", places, "asked by twos, every other one first: "},
                    Touchy{"decide_runs_of_256", "traverse.decision",
                           "asked in runs of more than 256 equal ones: "},
                    Touchy{"place_shares_order", "attribute.order_inverse --levels 1..4", beside},
                    Touchy{"lookup_shares_level", "tree.lookup_is_decode --levels 1..2", beside},
                    Touchy{"encode_asks_for_twice", trip, " bytes, then, with room for 1, of "}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(TouchySubjects, with_nothing_wrong_are_proved) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const char* law : {"traverse.decision", trip, places}) {
    const Outcome o = judge("nothing", law);
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  }
}

}  // namespace touchy_plugin_test
}  // namespace mmverify::tests
