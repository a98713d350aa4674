// [release alone, night] Shared libraries that keep an answer without one argument of its question, or get a vector's tail or a neighbour wrong:
// right wherever a law asks, judged by the built program.
#include <string>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace forgetful_plugin_test {

constexpr char in_a_number[] = "asked after one that differs in one number: ",
               in_a_format[] = "asked after the same in another format, order or mode: ",
               as_another[] = "in another format", in_9[] = "asked in a batch of 9: ";

TEST(ForgetfulSubject, is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto judge = [](const std::string& name, const std::string& what) {
    return judged("forgetful_" + name, what);
  };
  expect_each_broken(judge, "", "",
                     {{"decide_without_flag_1024", "traverse.decision", in_a_number},
                      {"blend_without_operation", "traverse.blend", in_a_format},
                      {"encode_without_format", "tree.round_trip --levels 1", as_another},
                      {"decode_without_format", "tree.round_trip --levels 1", as_another},
                      {"lookup_without_format", "tree.lookup_is_decode --levels 1", as_another},
                      {"vertex_without_order", "attribute.order_bijective --levels 1", in_a_format},
                      {"decide_tail_of_16", "traverse.decision", in_9},
                      {"lookup_tail_of_16", "tree.lookup_is_decode --levels 1", in_9},
                      {"mip_tail_of_4", "attribute.mip_rounding", "asked in a batch of 6: "},
                      {"mip_after_13", "attribute.mip_rounding",
                       "asked with other codes, each alone and then after each other one"}});
}

}  // namespace forgetful_plugin_test
}  // namespace mmverify::tests
