// Shared libraries that are right wherever a law asks, and wrong by what lies around a question, judged by the built
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

constexpr char trip[] = "tree.round_trip --levels 1..2", behind[] = "wrote behind the end of its output";

INSTANTIATE_TEST_SUITE_P(Subject, TouchySubject,
                         testing::Values(Touchy{"decide_writes_behind", "traverse.decision", behind},
                                         Touchy{"decode_writes_behind", trip, behind}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TouchySubjects, with_nothing_wrong_are_proved) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const char* law : {"traverse.decision", trip, "attribute.order_inverse --levels 1..3"}) {
    const Outcome o = judge("nothing", law);
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  }
}

}  // namespace touchy_plugin_test
}  // namespace mmverify::tests
