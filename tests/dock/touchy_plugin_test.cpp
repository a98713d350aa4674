// [release alone, night] Shared libraries that are right wherever a law asks, and wrong by what lies around a question, judged by the built
// program.
#include <clocale>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

#include "tests/dock/plugin.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace touchy_plugin_test {

using testing::HasSubstr;

Outcome judge(const std::string& name, const std::string& law) { return judged("touchy_" + name, law); }

constexpr char decision[] = "traverse.decision", trip[] = "tree.round_trip --levels 1..2",
               places[] = "attribute.order_inverse --levels 1..3",
               behind[] = "wrote behind the end of its output",
               over[] = "asked with another answer in its output: ",
               beside[] = "one of them at another level or in another format, order or mode: ";

TEST(TouchySubject, is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge, "", "",
      {{"decide_writes_behind", "traverse.decision", behind},
       {"decode_writes_behind", trip, behind},
       {"decide_keeps_answers", "traverse.decision", over},
       {"encode_adds_to_zero", trip, over},
       {"place_keeps_j", places, over},
       {"encode_ends_in_a_word", trip, "asked with room for "},
       {"decode_at_13", trip, "asked with its bytes at another address: byte 0 was "},
       {"place_descending", places, "asked in descending order: "},
       {"place_by_twos", places, "asked by twos, every other one first: "},
       {"decide_runs_of_256", "traverse.decision", "asked in runs of more than 256 equal ones: "},
       {"place_shares_order", "attribute.order_inverse --levels 1..4", beside},
       {"lookup_shares_level", "tree.lookup_is_decode --levels 1..2", beside},
       {"encode_asks_for_twice", trip, " bytes, then, with room for 1, of "}});
}

TEST(CarelessSubject, is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_each_broken(
      judge, "", "",
      {{"decide_errno_range", decision, "asked while errno is ERANGE: "},
       {"decide_errno_invalid", decision, "asked while errno is EINVAL: "},
       {"decide_flags", decision, "asked while all floating-point exceptions are flagged: "},
       {"decide_deep_stack", decision, "asked with garbage in 1 MiB of the stack: "},
       {"decide_shallow_stack", decision, "asked with garbage in "},
       {"decide_signals", decision, "left the signal mask changed"},
       {"decide_changes_struct", decision, "its mmverify_subject_t changed in its field traverse_decide"},
       {"decide_takes_struct_back", decision, "its mmverify_subject_t "},
       {"decide_another_time", decision,
        "mmverify_subject_v1 was called again, and its mmverify_subject_t changed in its field "
        "traverse_decide"},
       {"decide_for_2", decision, "asked from 20 threads at once: "},
       {"decide_for_19", decision, "asked from 20 threads at once: "},
       {"decide_below_4_gib", decision, "asked with its memory below "},
       {"decide_one_array", decision, "asked with one array for inputs that are equal: "},
       {"decimate_one_array", "attribute.decimation_watertight --levels 1..2",
        "asked with one array for inputs that are equal: "},
       {"decode_reads_on", trip, "it touched the memory of an earlier call"},
       {"decode_below_2_gib", trip, "asked with its memory below 2 GiB: "},
       {"decode_errno", trip, "asked while errno is ERANGE: "},
       {"encode_above_64_kib", trip, "asked with room for 65536 bytes: "},
       {"encode_above_1_mib", trip, "asked with room for 1572864 bytes: "}});
}

#if defined(__x86_64__)
TEST(CarelessSubject, is_broken_on_x86) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  constexpr char in_registers[] = "left values in the x87 or MMX registers";
  expect_each_broken(judge, "", "",
                     {{"decide_x87", decision, in_registers},
                      {"decide_mmx", decision, in_registers},
                      {"decide_wide", decision, "asked with garbage in the upper halves of registers: "}});
}
#endif

TEST(CarelessSubject, of_one_locale_is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const locale_t utf_8 = newlocale(LC_ALL_MASK, "C.UTF-8", nullptr);
  if (utf_8 == nullptr) GTEST_SKIP() << "the system has no locale C.UTF-8";
  freelocale(utf_8);
  EXPECT_THAT(judge("decide_characters", decision).out, HasSubstr("asked in the locale C.UTF-8: "));
}

TEST(CarelessSubject, that_writes_whole_words_is_broken) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "two threads never meet on one processor";
  for (const auto& [name, law] : {std::pair{"decide_writes_words", decision}, {"decode_writes_words", trip}})
    EXPECT_THAT(judge(name, law).out, HasSubstr("its output over what another thread wrote there meanwhile"))
        << name;
}

TEST(TouchySubjects, with_nothing_wrong_are_proved) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const char* law : {"traverse.decision", trip, places}) {
    const Outcome o = judge("nothing", law);
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  }
}

}  // namespace touchy_plugin_test
}  // namespace mmverify::tests
