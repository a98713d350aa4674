// [release alone, night] Shared libraries that keep an answer without one argument of its question, or get a vector's tail or a neighbour wrong:
// right wherever a law asks, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace forgetful_plugin_test {

using testing::HasSubstr;

struct Forgetful {
  friend void PrintTo(const Forgetful& f, std::ostream* out) { *out << f.name; }
  const char *name, *law, *said;
};

class ForgetfulSubject : public testing::TestWithParam<Forgetful> {};

TEST_P(ForgetfulSubject, is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto& [name, law, said] = GetParam();
  const Outcome o = shell(std::string("mmverify prove ") + law +
                          " --quiet --no-mutants --timeout 20 --threads 1 --subject " +
                          library(std::string("forgetful_") + name));
  EXPECT_EQ(o.exit_code, 1) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     "));
  EXPECT_THAT(o.out, HasSubstr(said));
}

constexpr char in_a_number[] = "asked after one that differs in one number: ",
               in_a_format[] = "asked after the same in another format, order or mode: ",
               as_another[] = "in another format", in_9[] = "asked in a batch of 9: ";

INSTANTIATE_TEST_SUITE_P(
    Subject, ForgetfulSubject,
    testing::Values(Forgetful{"decide_without_flag_1024", "traverse.decision", in_a_number},
                    Forgetful{"blend_without_operation", "traverse.blend", in_a_format},
                    Forgetful{"encode_without_format", "tree.round_trip --levels 1", as_another},
                    Forgetful{"decode_without_format", "tree.round_trip --levels 1", as_another},
                    Forgetful{"lookup_without_format", "tree.lookup_is_decode --levels 1", as_another},
                    Forgetful{"vertex_without_order", "attribute.order_bijective --levels 1", in_a_format},
                    Forgetful{"decide_tail_of_16", "traverse.decision", in_9},
                    Forgetful{"lookup_tail_of_16", "tree.lookup_is_decode --levels 1", in_9},
                    Forgetful{"mip_tail_of_4", "attribute.mip_rounding", "asked in a batch of 6: "},
                    Forgetful{"mip_after_13", "attribute.mip_rounding",
                              "asked with other codes, each alone and then after each other one"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace forgetful_plugin_test
}  // namespace mmverify::tests
