// [release] Textures compressed beside attribute maps: bytes at equal error, what a coder is given and held to, and astcenc itself
// where it is installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

#include "bench/scene/astcenc.hpp"
#include "scene/attribute/equal_error.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/attribute/reduced_texture.hpp"
#include "scene/write/png.hpp"
#include "subjects/program/program.hpp"
#include "tests/complaint.hpp"
#include "tests/environment.hpp"
#include "tests/folder.hpp"

namespace scene_attribute_astc_test {

using namespace mmverify::scene;
using mmverify::bench::astc_blocks;
using mmverify::bench::astc_coder;
using mmverify::bench::reduced_astc_blocks;
using mmverify::program::NoProgram;
using mmverify::program::ProgramEnd;
using mmverify::program::run_program;
using mmverify::tests::Environment;
using mmverify::tests::Folder;
using testing::ElementsAre;
using testing::HasSubstr;

// ---- Bytes at an error

TEST(BytesAtEqualError, LieOnALineOfLogarithms) {
  const std::vector<BytesAndError> sizes{{800, 1}, {200, 4}, {100, 64}};
  const auto bytes = [&](double error) {
    const BytesAtError at = bytes_at_error(sizes, error);
    EXPECT_EQ(at.where, AmongSizes::within) << error;
    return at.bytes;
  };
  EXPECT_DOUBLE_EQ(bytes(1), 800);
  EXPECT_DOUBLE_EQ(bytes(4), 200);
  EXPECT_DOUBLE_EQ(bytes(64), 100);
  EXPECT_DOUBLE_EQ(bytes(2), 400);                  // half way in both logarithms
  EXPECT_DOUBLE_EQ(bytes(16), 200 / std::sqrt(2));  // 16 is half way from 4 to 64
  EXPECT_NEAR(bytes(3.999999), 200, 0.001);         // continuous at a size
  EXPECT_EQ(bytes_at_error(sizes, 0.999).where, AmongSizes::finest_is_farther);
  EXPECT_EQ(bytes_at_error(sizes, 64.001).where, AmongSizes::coarsest_is_closer);
}

TEST(BytesAtEqualError, AreTheFewestWhereErrorsGoUpAndDown) {
  // Errors cross 3 between 800 and 400, and again between 200 and 100.
  const std::vector<BytesAndError> sizes{{800, 1}, {400, 9}, {200, 1}, {100, 9}};
  EXPECT_DOUBLE_EQ(bytes_at_error(sizes, 3).bytes, 200 / std::sqrt(2));
}

TEST(BytesAtEqualError, OfNoErrorAreThoseOfTheSizeThatHasNone) {
  const std::vector<BytesAndError> sizes{{800, 0}, {400, 0}, {200, 2}};
  EXPECT_EQ(bytes_at_error(sizes, 0).bytes, 400);
  EXPECT_EQ(bytes_at_error(sizes, 1).bytes, 400);
  EXPECT_EQ(bytes_at_error(std::vector<BytesAndError>{{8, 0}, {4, 0}}, 0).bytes, 4);
}

TEST(BytesAtEqualError, AreRefusedOfWhatIsNoListOfSizes) {
  using Sizes = std::vector<BytesAndError>;
  EXPECT_THROW(bytes_at_error(Sizes{}, 1), std::invalid_argument);
  EXPECT_THROW(bytes_at_error(Sizes{{1, 1}, {2, 2}}, 1), std::invalid_argument);
  EXPECT_THROW(bytes_at_error(Sizes{{2, 1}, {0, 2}}, 1), std::invalid_argument);
  EXPECT_THROW(bytes_at_error(Sizes{{2, -1}}, 1), std::invalid_argument);
  EXPECT_THROW(bytes_at_error(Sizes{{2, 1}}, std::nan("")), std::invalid_argument);
}

// ---- Coders

constexpr AttributeSet base_color = set_of(Attribute::base_color);

template <class Code>
ColourImage drawn(std::uint32_t width, std::uint32_t height, Code code) {
  ColourImage image{"drawn", width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::uint32_t c = 0; c < 4; ++c)
        image.rgba.push_back(c == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(code(x, y, c)));
  return image;
}

/// Two triangles; `shown`: of the image's width, from the left.
AttributeScene square_scene(std::vector<ColourImage> images, AttributeSet set = base_color, float shown = 1) {
  AttributeScene scene;
  scene.file = "square";
  Sampler clamped;
  clamped.wrap_u = clamped.wrap_v = Wrap::clamp_to_edge;
  for (std::size_t k = 0; k < images.size(); ++k) {
    scene.textures.push_back({set, k, clamped});
    scene.primitives.push_back(
        {0, k, {{0, 1, 2}, {2, 1, 3}}, {{k, {{0, 0}, {shown, 0}, {0, 1}, {shown, 1}}}}});
  }
  scene.images = std::move(images);
  scene.triangles = 2 * scene.primitives.size();
  return scene;
}

/// Tells of one size of blocks, of 2x2 texels, and of what `change` makes of each code; at lower resolutions too, where
/// that is asked for.
template <class Change>
TextureCoder changing(Change change, bool reduced = false) {
  return {"changing",
          {{2, 2}},
          reduced ? std::vector<BlockSize>{{2, 2}} : std::vector<BlockSize>{},
          [change](const TexturePixels& pixels, std::span<const BlockSize> blocks, const auto& made) {
            DecodedTexture decoded{blocks[0], 16 * blocks[0].blocks_of(pixels.width, pixels.height), {}};
            for (std::size_t k = 0; k < pixels.rgb.size(); ++k)
              decoded.rgb.push_back(static_cast<std::uint8_t>(change(k, pixels)));
            made(decoded);
          }};
}

std::vector<CompressedTextures> compressed(const AttributeScene& scene, const TextureCoder& coder,
                                           Averaging averaging = Averaging::meaning) {
  return measure(scene, {.first = 0, .last = 0, .averaging = averaging, .texture_coder = coder})
      .sets.at(0)
      .compressed;
}

TEST(CompressedTexture, IsMeasuredOverTheTexelsThatTrianglesShow) {
  // 8 x 4 texels, of which the left half is shown: there codes come back by 3 too large, elsewhere by 100.
  const auto scene = square_scene({drawn(8, 4, [](auto, auto, auto) { return 80; })}, base_color, 0.5f);
  const auto coder = changing(
      [](std::size_t k, const TexturePixels& pixels) { return pixels.rgb[k] + (k / 3 % 8 < 4 ? 3 : 100); });
  const std::vector<CompressedTextures> all = compressed(scene, coder);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].block, (BlockSize{2, 2}));
  EXPECT_EQ(all[0].bytes, 8u * 16);
  EXPECT_EQ(all[0].shown_bytes, 4u * 16);
  EXPECT_DOUBLE_EQ(all[0].error.rmse.value(), 3);
  EXPECT_GT(all[0].error.flip.value(), 0);
}

TEST(CompressedTexture, HasTheErrorOfMapsThatShowTheSame) {
  // Faces of level 0 show a colour a triangle; whoever shows one in the place of both has that of all, by RMSE and FLIP.
  const auto scene = square_scene({drawn(4, 4, [](auto x, auto y, auto c) { return 40 * x + 9 * y + c; })});
  std::vector<std::uint8_t> faces;
  AttributeOptions options{.first = 1, .last = 1};
  options.picture = [&](const AttributePicture& picture) { faces = picture.faces; };
  options.texture_coder = changing([&](std::size_t k, const TexturePixels&) { return faces.at(k); });
  const AttributeSetFigures set = measure(scene, options).sets.at(0);
  ASSERT_EQ(set.levels.at(0).kind, MapKind::faces);
  EXPECT_GT(set.levels[0].error.rmse.value(), 1);
  EXPECT_EQ(set.compressed.at(0).error.rmse, set.levels[0].error.rmse);
  EXPECT_EQ(set.compressed.at(0).error.flip, set.levels[0].error.flip);
}

TEST(CompressedTexture, OfAllImagesOfASetIsOneSum) {
  const auto flat = [](std::uint32_t side) { return drawn(side, side, [](auto, auto, auto) { return 80; }); };
  const auto coder = changing(
      [](std::size_t k, const TexturePixels& pixels) { return pixels.rgb[k] + (pixels.width == 4 ? 5 : 0); });
  const auto all = compressed(square_scene({flat(4), flat(2)}), coder);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].bytes, 5u * 16);
  EXPECT_DOUBLE_EQ(all[0].error.rmse.value(), std::sqrt(25 * 16 / 20.0));  // 16 of 20 texels are 5 off
}

TEST(CompressedTexture, IsGivenAndHeldToTheChannelsInUse) {
  const auto scene = square_scene({drawn(4, 4, [](auto, auto, auto c) { return 90 + c; })},
                                  set_of(Attribute::metallic_roughness));
  const auto coder = changing([](std::size_t k, const TexturePixels& pixels) {
    EXPECT_EQ(pixels.rgb[k], k % 3 == 0 ? 0 : 90 + k % 3);
    EXPECT_EQ(pixels.meaning, mmverify::impl::attribute::Meaning::linear);
    return k % 3 == 0 ? 200 : k % 3 == 1 ? pixels.rgb[k] + 6 : pixels.rgb[k];
  });
  const auto all = compressed(scene, coder);
  EXPECT_DOUBLE_EQ(all.at(0).error.rmse.value(), std::sqrt(36 / 2.0));
  EXPECT_FALSE(all.at(0).error.flip.has_value());
}

TEST(CompressedTexture, OfNormalsIsOneUnitLong) {
  using mmverify::impl::attribute::Meaning;
  // Codes of (0, 0, 1/2): a direction half as long as it should be.
  const auto scene = square_scene({drawn(2, 2, [](auto, auto, auto c) { return c == 2 ? 191 : 128; })},
                                  set_of(Attribute::normal));
  const auto coder = [](Meaning due, int z) {
    return changing([due, z](std::size_t k, const TexturePixels& pixels) -> int {
      EXPECT_EQ(pixels.meaning, due);
      return k % 3 == 2 ? z : 128;
    });
  };
  // The decoded normal is made one unit long as well, so half the length is no error.
  EXPECT_EQ(compressed(scene, coder(Meaning::normal, 191)).at(0).error.rmse, 0);
  EXPECT_EQ(compressed(scene, coder(Meaning::linear, 191), Averaging::codes).at(0).error.rmse, 0);
  EXPECT_GT(compressed(scene, coder(Meaning::linear, 255), Averaging::codes).at(0).error.rmse.value(), 30);
}

TEST(CompressedTexture, IsReducedBeforeAndSampledAfter) {
  // A grating of two codes a texel wide, and beyond the reach of a sampler: at 1/2 all is their mean.
  const auto scene = square_scene({drawn(64, 64, [](auto x, auto, auto) { return x % 2 == 0 ? 100 : 140; })});
  const auto same = [](std::size_t k, const TexturePixels& pixels) { return pixels.rgb[k]; };
  const auto all = compressed(scene, changing(same, true), Averaging::codes);
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::uint32_t factor = 1u << k;
    EXPECT_EQ(all[k].reduced, factor);
    EXPECT_EQ(all[k].bytes, 16u * (32 / factor) * (32 / factor));
    EXPECT_EQ(all[k].shown_bytes, all[k].bytes);
    EXPECT_DOUBLE_EQ(all[k].error.rmse.value(), k == 0 ? 0 : 20);
  }
}

TEST(CompressedTexture, IsRefusedWhereTheCoderTellsOfOtherSizes) {
  const auto flat = square_scene({drawn(4, 4, [](auto, auto, auto) { return 80; })});
  const auto telling = [&](const std::vector<DecodedTexture>& told) {
    return TextureCoder{"other", {{2, 2}}, {}, [told](const auto&, const auto&, const auto& made) {
                          for (const DecodedTexture& one : told) made(one);
                        }};
  };
  const std::vector<std::uint8_t> rgb(48, 80);
  EXPECT_NO_THROW(compressed(flat, telling({{{2, 2}, 64, rgb}})));
  EXPECT_THROW(compressed(flat, telling({})), std::invalid_argument);
  EXPECT_THROW(compressed(flat, telling({{{4, 2}, 64, rgb}})), std::invalid_argument);
  EXPECT_THROW(compressed(flat, telling({{{2, 2}, 64, {80, 80, 80}}})), std::invalid_argument);
  EXPECT_THROW(compressed(flat, telling({{{2, 2}, 64, rgb}, {{2, 2}, 64, rgb}})), std::invalid_argument);
}

// ---- Lower resolutions

TEST(ReducedTexture, IsTheMeanOfBlocksAndOfWhatIsLeftAtBorders) {
  const CodeMeaning codes(base_color, Averaging::codes);
  // Five texels in a row and two rows; red is x, green y.
  RgbTexels texels{5, 2, {}};
  for (std::uint8_t y = 0; y < 2; ++y)
    for (std::uint8_t x = 0; x < 5; ++x)
      texels.rgb.insert(texels.rgb.end(),
                        {static_cast<std::uint8_t>(10 * x), static_cast<std::uint8_t>(40 * y), 7});
  const RgbTexels small = reduced(texels, 2, codes);
  EXPECT_EQ(small.width, 3u);
  EXPECT_EQ(small.height, 1u);
  EXPECT_THAT(small.rgb, ElementsAre(5, 20, 7, 25, 20, 7, 40, 20, 7));
  // Light averages differ from codes: half of white is code 188.
  const CodeMeaning light(base_color, Averaging::meaning);
  EXPECT_THAT(reduced({2, 1, {0, 0, 0, 255, 255, 255}}, 2, light).rgb, ElementsAre(188, 188, 188));
}

TEST(ReducedTexture, IsSampledBilinearlyAndClamped) {
  const CodeMeaning codes(base_color, Averaging::codes);
  // Centres of 8 texels over 2: (x + 1/2) / 4 - 1/2 = -3/8, -1/8, 1/8, 3/8, 5/8, 7/8, 9/8, 11/8.
  const std::vector<std::uint8_t> wide = enlarged({2, 1, {0, 0, 0, 80, 80, 80}}, 4, 8, 1, codes);
  std::vector<int> red;
  for (std::size_t k = 0; k < wide.size(); k += 3) red.push_back(wide[k]);
  EXPECT_THAT(red, ElementsAre(0, 0, 10, 30, 50, 70, 80, 80));
  // Down as across.
  const std::vector<std::uint8_t> high = enlarged({1, 2, {0, 0, 0, 80, 80, 80}}, 4, 1, 8, codes);
  EXPECT_EQ(high, wide);
}

// ---- astcenc

#define SKIP_WITHOUT_ASTCENC()                                                     \
  try {                                                                            \
    astc_coder({});                                                                \
  } catch (const NoProgram&) {                                                     \
    GTEST_SKIP() << "there is no astcenc; the Debian package of that name has it"; \
  }

/// Waves and a wedge: nothing that a block of any size holds exactly.
ColourImage waves(std::uint32_t width, std::uint32_t height) {
  return drawn(width, height, [](auto x, auto y, auto c) {
    return 128 + 90 * std::sin(0.31 * x + 0.2 * c * y) + (x > y ? 30 : -30);
  });
}

TEST(AstcEncoder, MissingIsSaidWithItsPackage) {
  const Folder empty;
  const Environment path("PATH", empty.path());
  EXPECT_EQ(mmverify::tests::complaint_of<NoProgram>([&] { astc_coder({}); }),
            "--astc needs astcenc, which is not here: install the Debian package astcenc");
}

/// A program astcenc that is this script, on a PATH of its own; what it leaves in the folder of temporary files.
class FalseEncoder {
 public:
  explicit FalseEncoder(const std::string& script, const std::string& name = "astcenc") {
    std::ofstream(bin_ / name)
        << "#!/bin/sh\nPATH=/usr/bin:/bin\n[ \"$1\" = -version ] && echo 'astcenc v0' && exit\n"
        << script;
    std::filesystem::permissions(bin_ / name, std::filesystem::perms::owner_all);
  }
  /// The complaint about this encoder when it compresses 8 x 8 texels.
  std::string complaint() const {
    const Environment tmp("TMPDIR", tmp_.path()), path("PATH", bin_.path().string());
    const std::vector<std::uint8_t> rgb(3 * 8 * 8);
    const TextureCoder coder = astc_coder({.threads = 3});
    EXPECT_EQ(coder.name, "astcenc v0, -thorough");
    try {
      coder.compress({8, 8, rgb}, coder.blocks,
                     [](const DecodedTexture&) { ADD_FAILURE() << "nothing was compressed"; });
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::filesystem::is_empty(tmp_.path()));
      return error.what();
    }
    return "none";
  }

 private:
  Folder bin_, tmp_;
};

TEST(AstcEncoder, ThatFailsIsQuotedAndLeavesNoFile) {
  EXPECT_EQ(FalseEncoder("echo 'no such' >&2; echo mode >&2; exit 7").complaint(),
            "astcenc -cl failed, exit code 7: no such; mode");
  EXPECT_EQ(FalseEncoder("echo half >\"$3\"; kill -9 $$").complaint(),
            "astcenc -cl failed, signal 9: it said nothing");
  EXPECT_EQ(FalseEncoder("exit 0").complaint(), "astcenc: a file of 80 bytes was due, and none is there");
  EXPECT_EQ(FalseEncoder("echo a >\"$3\"").complaint(),
            "astcenc: a file of 80 bytes was due, and one of 2 came");
  // Blocks of the right size, and no picture.
  EXPECT_THAT(FalseEncoder("[ $1 = -cl ] && head -c 80 /dev/zero >\"$3\" || echo a >\"$3\"").complaint(),
              HasSubstr("decoded.png"));
}

TEST(AstcEncoder, IsFoundByItsInstructionSetAndToldOfThreads) {
  const FalseEncoder encoder("echo \"$*\" | sed 's|/[^ ]*/||g' >&2; exit 1", "astcenc-sse2");
  EXPECT_EQ(encoder.complaint(),
            "astcenc-sse2 -cl failed, exit code 1: -cl original.png blocks.astc 4x4 -thorough -silent -j 3");
}

TEST(AstcEncoder, ErrorsAreThoseThatItTellsOfItself) {
  SKIP_WITHOUT_ASTCENC();
  // Sides that are no multiple of most blocks; every texel is shown.
  const std::uint32_t width = 64, height = 44;
  const auto scene = square_scene({waves(width, height)});
  const auto all = compressed(scene, astc_coder({.quality = "-fast"}));
  ASSERT_EQ(all.size(), std::size(astc_blocks) + 5 * std::size(reduced_astc_blocks));
  const Folder folder;
  const std::string original = folder / "original.png";
  std::vector<std::uint8_t> rgb;
  for (std::size_t k = 0; k < scene.images[0].rgba.size(); ++k)
    if (k % 4 != 3) rgb.push_back(scene.images[0].rgba[k]);
  const auto bytes = png(width, height, rgb);
  std::ofstream(original, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  for (std::size_t k = 0; k < std::size(astc_blocks); ++k) {
    EXPECT_EQ(all[k].block, astc_blocks[k]);
    const std::uint32_t w = astc_blocks[k].width, h = astc_blocks[k].height;
    EXPECT_EQ(all[k].bytes, 16u * ((width + w - 1) / w) * ((height + h - 1) / h));
    EXPECT_EQ(all[k].shown_bytes, all[k].bytes);
    // Its own comparison: a peak ratio in dB, to four digits.
    const ProgramEnd end =
        run_program({"astcenc", "-ts", original, folder / "decoded.png", all[k].block.name(), "-fast"});
    std::smatch ratio;
    ASSERT_TRUE(std::regex_search(end.out, ratio, std::regex("PSNR \\(LDR-RGB\\): +([0-9.]+) dB")))
        << end.out;
    EXPECT_NEAR(20 * std::log10(255 / all[k].error.rmse.value()), std::stod(ratio[1]), 0.0002);
    if (k > 0) {
      EXPECT_LT(all[k].bytes, all[k - 1].bytes);
      EXPECT_GT(all[k].error.rmse, all[k - 1].error.rmse.value());
      EXPECT_GT(all[k].error.flip, all[k - 1].error.flip);
    }
  }
}

TEST(AstcEncoder, BringsNormalsBackWithTheirThirdCoordinate) {
  SKIP_WITHOUT_ASTCENC();
  // Directions within 45 degrees of the surface's own, z from 0.7 to 1.
  const auto scene = square_scene({drawn(48, 48,
                                         [](auto x, auto y, auto c) {
                                           const double a = 0.5 * std::sin(0.1 * x),
                                                        b = 0.5 * std::cos(0.13 * y);
                                           const double n[] = {a, b, std::sqrt(1 - a * a - b * b)};
                                           return std::lround(255 * (n[c] + 1) / 2);
                                         })},
                                  set_of(Attribute::normal));
  const auto all = compressed(scene, astc_coder({.quality = "-fast"}));
  ASSERT_GT(all.size(), std::size(astc_blocks));
  // A z that is lost is about 110 codes off, and so the root of the mean square over 60.
  EXPECT_LT(all.front().error.rmse.value(), 1.5);
  EXPECT_LT(all[std::size(astc_blocks) - 1].error.rmse.value(), 20);
}

TEST(AstcEncoder, StoppedLeavesNoFile) {
  SKIP_WITHOUT_ASTCENC();
  struct Stopped {};
  const Folder tmp;
  const Environment variable("TMPDIR", tmp.path());
  const TextureCoder coder = astc_coder({});
  const std::vector<std::uint8_t> rgb(3 * 16 * 16, 77);
  int sizes = 0;
  EXPECT_THROW(coder.compress({16, 16, rgb}, coder.blocks,
                              [&](const DecodedTexture& decoded) {
                                EXPECT_EQ(decoded.rgb, rgb);  // one colour is held exactly
                                EXPECT_FALSE(std::filesystem::is_empty(tmp.path()));
                                if (++sizes == 2) throw Stopped();
                              }),
               Stopped);
  EXPECT_TRUE(std::filesystem::is_empty(tmp.path()));
}

// Base colours of a real texture of 2048^2, quickly compressed; what a triangle shows is 64.7 % of it.
TEST(AstcEncoder, OfTheAvocadoReachesTheErrorsOfItsMaps) {
  SKIP_WITHOUT_ASTCENC();
  const std::string file = MMVERIFY_SCENES "/avocado/Avocado.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  AttributeScene scene = load_attributes(file);
  for (AttributePrimitive& primitive : scene.primitives)
    std::erase_if(primitive.uses, [&](const AttributeUse& use) {
      return !has(scene.textures[use.texture].set, Attribute::base_color);
    });
  std::erase_if(scene.textures, [](const auto& texture) { return !has(texture.set, Attribute::base_color); });
  ASSERT_EQ(scene.textures.size(), 1u);
  const AttributeSetFigures set =
      measure(scene,
              {.first = 4, .last = 4, .packed = true, .texture_coder = astc_coder({.quality = "-fast"})})
          .sets.at(0);
  ASSERT_EQ(set.compressed.size(), std::size(astc_blocks) + 5 * std::size(reduced_astc_blocks));
  std::vector<BytesAndError> sizes;
  for (const CompressedTextures& one : set.compressed) {
    // A block on a border counts whole though only a part of it is shown: larger blocks add more.
    const auto along = [&](std::uint32_t side) { return std::ceil(2048.0 / (side * one.reduced)); };
    EXPECT_EQ(static_cast<double>(one.bytes), 16 * along(one.block.width) * along(one.block.height));
    const double shown = static_cast<double>(one.shown_bytes) / static_cast<double>(one.bytes);
    EXPECT_GT(shown, 0.647);
    if (one.reduced == 1) {
      EXPECT_LT(shown, 0.75);
    }
    if (!sizes.empty()) {
      EXPECT_GT(one.error.flip.value(), sizes.back().error);
    }
    sizes.push_back({static_cast<double>(one.bytes), one.error.flip.value()});
  }
  // At its own error a size takes its own bytes; the maps' errors are among those of the sizes.
  for (const BytesAndError& size : sizes)
    EXPECT_DOUBLE_EQ(bytes_at_error(sizes, size.error).bytes, size.bytes);
  for (const MapsAtLevel& maps : set.levels)
    EXPECT_EQ(bytes_at_error(sizes, maps.error.flip.value()).where, AmongSizes::within);
}

}  // namespace scene_attribute_astc_test
