// [release] Textures compressed in BC7 beside attribute maps: what the coder is told, how it fails, and bc7enc itself where it is
// installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>

#include "bench/scene/bc7enc.hpp"
#include "scene/write/png.hpp"
#include "subjects/program/program.hpp"
#include "tests/complaint.hpp"
#include "tests/environment.hpp"
#include "tests/folder.hpp"

namespace scene_attribute_bc7_test {

using namespace mmverify::scene;
using mmverify::bench::bc7_block;
using mmverify::bench::bc7_coder;
using mmverify::program::NoProgram;
using mmverify::program::run_program;
using mmverify::tests::Environment;
using mmverify::tests::Folder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Bc7Encoder, MissingIsSaidWithItsPackage) {
  const Folder empty;
  const Environment path("PATH", empty.path());
  EXPECT_THAT(mmverify::tests::complaint_of<NoProgram>([&] { bc7_coder({}); }),
              HasSubstr("npm install -g @gpu-tex-enc/bc"));
}

/// The complaint about an encoder that is this script, for 8 x 8 texels.
std::string complaint(const std::string& script) {
  const Folder bin, tmp;
  std::ofstream(bin / "bc7enc-linux") << "#!/bin/sh\nPATH=/usr/bin:/bin\n"
                                         "[ $# = 0 ] && echo 'bc7enc v0 - words' && exit 1\n"
                                      << script;
  std::filesystem::permissions(bin / "bc7enc-linux", std::filesystem::perms::owner_all);
  const Environment variable("TMPDIR", tmp.path()), path("PATH", bin.path().string() + ":/usr/bin:/bin");
  const std::vector<std::uint8_t> rgb(3 * 8 * 8);
  const TextureCoder coder = bc7_coder({.threads = 3});
  EXPECT_EQ(coder.name, "bc7enc v0, -u6");
  EXPECT_EQ(coder.key, "bc7");
  EXPECT_EQ(coder.format, "BC7");
  EXPECT_THAT(coder.blocks, ElementsAre(bc7_block));
  EXPECT_THAT(coder.reduced_blocks, ElementsAre(bc7_block));
  try {
    coder.compress({8, 8, rgb}, coder.blocks,
                   [](const DecodedTexture&) { ADD_FAILURE() << "nothing was compressed"; });
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::filesystem::is_empty(tmp.path()));
    return error.what();
  }
  return "none";
}

TEST(Bc7Encoder, ThatFailsIsQuotedAndLeavesNoFile) {
  EXPECT_EQ(complaint("echo 'no such' >&2; echo mode >&2; exit 7"),
            "bc7enc-linux -u6 failed, exit code 7: no such; mode");
  EXPECT_EQ(complaint("kill -9 $$"), "bc7enc-linux -u6 failed, signal 9: it said nothing");
  // 148 bytes of headers and 4 blocks of 16.
  EXPECT_EQ(complaint("exit 0"), "bc7enc-linux: a file of 212 bytes was due, and none is there");
  EXPECT_EQ(complaint("echo a >\"$4\""), "bc7enc-linux: a file of 212 bytes was due, and one of 2 came");
  EXPECT_THAT(complaint("head -c 212 /dev/zero >\"$4\"; echo a >\"$5\""), HasSubstr("decoded.png"));
}

TEST(Bc7Encoder, IsToldOfThreadsAndItsQuality) {
  EXPECT_EQ(complaint("echo \"$OMP_NUM_THREADS $*\" | sed 's|/[^ ]*/||g' >&2; exit 1"),
            "bc7enc-linux -u6 failed, exit code 1: 3 -q -u6 original.png blocks.dds decoded.png");
}

TEST(Bc7Encoder, ErrorsAreThoseThatItTellsOfItself) {
  std::optional<TextureCoder> coder;
  try {
    coder = bc7_coder({.quality = 2});
  } catch (const NoProgram& error) {
    GTEST_SKIP() << error.what();
  }
  // Sides that are no multiple of 4.
  const std::uint32_t width = 62, height = 45;
  std::vector<std::uint8_t> rgb;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::uint32_t c = 0; c < 3; ++c)
        rgb.push_back(
            static_cast<std::uint8_t>(128 + 90 * std::sin(0.31 * x + 0.2 * c * y) + (x > y ? 30 : -30)));
  std::optional<DecodedTexture> decoded;
  coder->compress({width, height, rgb}, coder->blocks, [&](const DecodedTexture& one) { decoded = one; });
  EXPECT_EQ(decoded->bytes, 16u * 16 * 12);
  double squares = 0;
  ASSERT_EQ(decoded->rgb.size(), rgb.size());
  for (std::size_t k = 0; k < rgb.size(); ++k) squares += std::pow(rgb[k] - decoded->rgb[k], 2);
  const double rmse = std::sqrt(squares / static_cast<double>(rgb.size()));
  // Its own comparison: without -q it prints the root of the mean square, to six digits.
  const Folder folder;
  const auto bytes = png(width, height, rgb);
  std::ofstream(folder / "original.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  std::string out;
  for (const char* const program : {"bc7enc", "bc7enc-linux"}) {
    try {
      out = run_program(
                {program, "-u2", folder / "original.png", folder / "blocks.dds", folder / "decoded.png"})
                .out;
      break;
    } catch (const NoProgram&) {
      continue;
    }
  }
  std::smatch told;
  ASSERT_TRUE(std::regex_search(out, told, std::regex("RGB +Max error: +[0-9]+ RMSE: ([0-9.]+)"))) << out;
  EXPECT_GT(rmse, 0);
  EXPECT_NEAR(rmse, std::stod(told[1]), 2e-6);
}

}  // namespace scene_attribute_bc7_test
