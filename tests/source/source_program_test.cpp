// Programs as text, and what is none.
#include <gtest/gtest.h>

#include "subjects/source/encode/encode.hpp"
#include "subjects/source/program.hpp"
#include "tests/complaint.hpp"

namespace mmverify::source {
namespace {

constexpr const char* sum_of_two = R"(input_u f32
input_v f32
fadd f32 0 1 @ mine.c:3
fptoui i32 2 @ mine.c:4
constant i32 : 7
add i32 3 4 ! 1 @ mine.c:4
constant i1 : 0
forbidden 6 division by zero, mine.c:9
result 5
)";

TEST(SourceProgram, IsItsText) {
  const Program program = read_program(sum_of_two);
  EXPECT_EQ(program.nodes.size(), 7u);
  EXPECT_EQ(program.nodes[5].flags, static_cast<unsigned>(no_unsigned_wrap));
  EXPECT_EQ(program.nodes[2].where, "mine.c:3");
  EXPECT_EQ(program.forbidden.at(0).what, "division by zero, mine.c:9");
  EXPECT_EQ(to_text(program), sum_of_two);
}

TEST(SourceProgram, WhatIsNoneIsNamed) {
  const auto why = [](const std::string& text) -> std::string {
    return mmverify::tests::complaint_of<BadProgram>([&] { read_program(text); }, "taken");
  };
  EXPECT_EQ(why("input_u f32\n"), "it has no result");
  EXPECT_EQ(why("input_u f32\nresult 0\n"), "line 2: no word's number");
  EXPECT_EQ(why("constant i32 : 1\nadd i32 0 1\nresult 0\n"), "line 2: add an operand comes later");
  EXPECT_EQ(why("constant i32 : 1\nconstant i8 : 1\nadd i32 0 1\n"),
            "line 3: add its operands are of different types");
  EXPECT_EQ(why("input_u f32\nadd f32 0 0\n"), "line 2: add an operand is of another sort");
  EXPECT_EQ(why("constant i8 : 1\nresult 0\n"), "line 2: a result of 32 bits is due");
  EXPECT_EQ(why("fly i8 : 1\n"), "line 1: no operation: fly");
  EXPECT_EQ(why("constant i65 : 1\n"), "line 1: no type: i65");
  EXPECT_EQ(why("constant i32\nresult 0\n"), "line 1: constant has another count of numbers");
  EXPECT_EQ(why("constant i32 : 1\nresult 0\nconstant i32 : 1\n"), "line 3: something after the result");
}

TEST(SourceProgram, ADivisionThatHasNoFormulaIsNamedWithItsPlace) {
  const Program program =
      read_program("input_u f32\ninput_v f32\nfdiv f32 0 1 @ mine.c:12\nfptoui i32 2\nresult 3\n");
  EXPECT_EQ(mmverify::tests::complaint_of<NotEncoded>([&] {
              encode(program, {false, 120, 120}, {false, 0, 90}, "u", "v");
            }),
            "mine.c:12: fdiv: by what is no power of two");
}

TEST(SourceProgram, WhatNeverHappensIsNoCause) {
  // A half and a quarter: below 1, no float beyond the integers, and 0 + 7 does not wrap.
  const Formula formula = encode(read_program(sum_of_two), {false, 126, 126}, {false, 125, 125}, "u", "v");
  for (const Cause& cause : formula.causes) EXPECT_EQ(cause.what.find("division"), std::string::npos);
}

}  // namespace
}  // namespace mmverify::source
