// [memory] Programs of others: what they are given, how they end, and what they may take.
#include "subjects/program/program.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace {

using namespace mmverify::program;
using namespace std::chrono_literals;

TEST(Program, GetsItsWordsAsTheyAre) {
  const ProgramEnd end = run_program({"printf", "%s|", "$(exit 1)", "a b", "*", "';"});
  EXPECT_TRUE(end.succeeded);
  EXPECT_EQ(end.out, "$(exit 1)|a b|*|';|");
}

TEST(Program, ReadsItsInputAndSaysHowItEnds) {
  EXPECT_EQ(run_program({"cat"}, "one\ntwo").out, "one\ntwo");
  EXPECT_EQ(run_program({"cat"}).out, "");
  EXPECT_TRUE(run_program({"true"}).by_itself);
  const ProgramEnd failed = run_program({"sh", "-c", "echo why >&2; exit 3"});
  EXPECT_FALSE(failed.succeeded);
  EXPECT_TRUE(failed.by_itself);
  EXPECT_EQ(failed.how, "exit code 3");
  EXPECT_EQ(failed.errors, "why\n");
  const ProgramEnd killed = run_program({"sh", "-c", "kill -9 $$"});
  EXPECT_FALSE(killed.succeeded);
  EXPECT_FALSE(killed.by_itself);
  EXPECT_EQ(killed.how, "signal 9");
  EXPECT_THROW(run_program({"mmverify-has-no-such-program"}), NoProgram);
}

TEST(Program, IsHeardWhileItRuns) {
  std::string heard;
  std::size_t parts = 0;
  const ProgramEnd end =
      run_program({"sh", "-c", "echo one; sleep 0.3; echo two"}, {}, {}, {}, [&](const std::string& part) {
        heard += part;
        ++parts;
      });
  EXPECT_EQ(heard, "one\ntwo\n");
  EXPECT_EQ(parts, 2u);
  EXPECT_EQ(end.out, heard);
}

TEST(Program, ComplaintsComeInOneLine) {
  EXPECT_EQ(one_line("a.c:1: error\n1 error generated.\n\n"), "a.c:1: error; 1 error generated.");
  EXPECT_EQ(one_line("\n"), "it said nothing");
}

TEST(Program, IsEndedWhereItIsStopped) {
  struct Stopped {};
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(run_program({"sleep", "600"}, {}, [] { throw Stopped(); }), Stopped);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST(Program, IsEndedWhereItTakesMoreThanItMay) {
  const ProgramEnd slow = run_program({"sleep", "600"}, {}, {}, {.time = 1s});
  EXPECT_FALSE(slow.succeeded);
  EXPECT_FALSE(slow.by_itself);
  EXPECT_EQ(slow.how, "stopped after 1 s");
  // `yes` never ends by itself.
  const ProgramEnd endless = run_program({"yes"}, {}, {}, {.time = 20s, .a_file = 1 << 20});
  EXPECT_FALSE(endless.by_itself);
  EXPECT_EQ(endless.out.size(), std::size_t{1} << 20);
  // A shell that doubles a word until there is no more room.
  const ProgramEnd large = run_program({"sh", "-c", "w=xxxxxxxx; while :; do w=$w$w; done"}, {}, {},
                                       {.time = 20s, .memory = 64 << 20});
  EXPECT_FALSE(large.succeeded);
  EXPECT_NE(large.how, "stopped after 20 s");
}

}  // namespace
