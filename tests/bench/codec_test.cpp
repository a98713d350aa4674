// [release alone] bench/codec: what the rounds call and count, and the figures of the table.
#include <gtest/gtest.h>

#include <string>

#include "bench/codec/tables.hpp"

namespace {

using namespace mmverify::bench;

/// Work for about `turns` steps of arithmetic that no compiler leaves out.
void spin(int turns) {
  volatile unsigned x = 1;
  for (int k = 0; k < turns; ++k) x = x * 1664525u + 1013904223u;
}

TEST(Codec, ALongerWorkHasALargerRatioAndAMissingOneHasNone) {
  int encoded = 0;
  CodecCase of{.of = "leaves", .level = 3, .maps = 2, .micro_triangles = 128, .lookups = 10};
  of.theirs = {.encode = [&] { ++encoded, spin(4'000'000); },
               .look_up = [] { spin(1000); },
               .bits = [] { return 256.0; },
               .changed = [] { return std::uint64_t{3}; }};
  of.ours = {.encode = [] { spin(400'000); }, .decode = [] { spin(1000); }, .bits = [] { return 64.0; }};
  const CodecRow row = measured_codec(of, 3);
  EXPECT_GE(encoded, 4);  // once to warm the caches, and in each round
  EXPECT_EQ(row.theirs.bits, 2);
  EXPECT_EQ(row.ours.bits, 0.5);
  EXPECT_EQ(row.theirs.changed, 3u);
  EXPECT_EQ(row.ours.changed, 0u);
  EXPECT_GT(row.encode_ratio, 2);  // ten times the work
  EXPECT_GE(row.theirs.encode.median, row.theirs.encode.least);
  EXPECT_LE(row.theirs.encode.median, row.theirs.encode.most);
  EXPECT_EQ(row.theirs.decode.median, 0);
  EXPECT_EQ(row.decode_ratio, 0);
  EXPECT_EQ(row.ours.look_up.median, 0);
  EXPECT_EQ(row.look_up_ratio, 0);
}

TEST(Codec, AColumnThatNoRowFillsIsLeftOut) {
  CodecRow row{.of = {.of = "square"}};
  row.theirs.bits = row.ours.bits = 1;
  row.theirs.encode = row.ours.encode = {2, 1, 3};
  row.encode_ratio = 1;
  const Result result = codec_tables({row}, {"mine.so", "ours", 5});
  std::string names;
  for (const Column& column : result.tables.back().columns) names += column.key.name + " ";
  EXPECT_EQ(names,
            "maps states count bits_theirs bits_ours changed_theirs changed_ours encode_theirs_ns "
            "encode_theirs_least_ns encode_theirs_most_ns encode_ours_ns encode_ratio ");
}

}  // namespace
