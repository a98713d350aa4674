// [release] A wrong index in characters: the places of both micro-triangles, by the layout of level 1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "proofs/index/in_characters.hpp"

namespace mmverify::tests {
namespace index_characters_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Lines = std::vector<std::string>;

Lines drawn(const std::string& law, proofs::Level n, const std::string& expected, const std::string& got) {
  proofs::Result result;
  result.law = law;
  result.level = n;
  proofs::Counterexample c;
  c.expected = expected;
  c.got = got;
  return proofs::index::in_characters(result, c);
}

// The curve visits the w-corner's triangle, the middle one, the u-corner's and the v-corner's; rows from the w-corner
// have the w-corner's, then the u-corner's, the middle one and the v-corner's.
TEST(IndexInCharacters, ShowsBothPlaces) {
  EXPECT_THAT(drawn("index.equals_reference", 1, "0", "1"),
              ElementsAre("       ^", "      EG^", HasSubstr("E: 0")));
  EXPECT_THAT(drawn("index.equals_reference", 1, "2", "3"),
              ElementsAre("       G", "      ^vE", HasSubstr("G: 3")));
  EXPECT_THAT(drawn("index.row_order", 1, "2", "0"), ElementsAre("       ^", "      GE^", HasSubstr("E: 2")));
  EXPECT_THAT(drawn("index.equals_reference", 0, "0", "7"),
              ElementsAre("      E", HasSubstr("no index of this level")));
}

// At level 16 the curve ends in the v-corner's triangle, 4^16 - 1; the w-corner's is far from it.
TEST(IndexInCharacters, ShowsAPartOfAFineLevel) {
  const Lines lines = drawn("index.exact_on_floats", 16, "4294967295", "0");
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines.front(), "          E");
  EXPECT_THAT(lines.back(), HasSubstr("G: 0 returned, outside of this part"));
}

TEST(IndexInCharacters, IsForIndicesAlone) {
  EXPECT_THAT(drawn("index.corners", 1, "0", "1"), IsEmpty());
  EXPECT_THAT(drawn("index.equals_reference", 1, "(0,0)", "1"), IsEmpty());
  EXPECT_THAT(drawn("index.equals_reference", 1, "4", "1"), IsEmpty());
}

}  // namespace
}  // namespace index_characters_test
}  // namespace mmverify::tests
