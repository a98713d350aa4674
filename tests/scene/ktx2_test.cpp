// scene/: pictures in KTX2.
#include "scene/read/ktx2/ktx2.hpp"

#include <boost/crc.hpp>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "scene/plan/plan.hpp"
#include "scene/read/folder.hpp"
#include "scene/read/image.hpp"
#include "scene/read/ktx2/prefix_code.hpp"
#include "scene/read/ktx2/uastc.hpp"
#include "tests/complaint.hpp"
#include "tests/scene/loaded_scene.hpp"

#ifdef MMVERIFY_HAS_ZSTD
#include <zstd.h>
#endif

namespace scene_ktx2_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::ElementsAre;
using testing::HasSubstr;

Image alpha_of(const std::string& bytes) {
  Image image;
  decode_alpha(as_bytes(bytes), image, "f", "image 0");
  return image;
}

ColourImage colour_of(const std::string& bytes) {
  ColourImage image;
  decode_colour(as_bytes(bytes), image, "f", "image 0");
  return image;
}

std::string complaint_of_picture(const std::string& bytes) {
  return complaint_of<BadScene>([&] { alpha_of(bytes); });
}

std::uint32_t crc_of(std::span<const std::uint8_t> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string made(const std::string& name) {
  return read_bytes(std::filesystem::path(MMVERIFY_MADE_FILES) / (name + ".ktx2"));
}

// Places of words in the header.
constexpr std::size_t format_at = 12, width_at = 20, height_at = 24, depth_at = 28, layers_at = 32,
                      faces_at = 36, levels_at = 40, scheme_at = 44, descriptor_at = 48, global_at = 64,
                      level_0_at = 80, descriptor_begin = 104;
constexpr std::uint32_t rgba8 = 37, linear = 1, srgb = 2;

std::string with_word(std::string file, std::size_t at, std::uint32_t word) {
  return file.replace(at, 4, little_endian(word));
}

std::string entry(const std::string& key, const std::string& value) {
  std::string text = key + '\0' + value + '\0';
  const auto length = static_cast<std::uint32_t>(text.size());
  text.resize((text.size() + 3) / 4 * 4, '\0');
  return little_endian(length) + text;
}

struct Ktx2Parts {
  std::uint32_t scheme = 0, uncompressed = 0;
  std::uint32_t model = 1, transfer = linear, flags = 0;  ///< of the descriptor
  unsigned channel = 0;
  std::string keys = "";
};

/// A KTX2 of one level.
std::string ktx2(std::uint32_t width, std::uint32_t height, std::uint32_t format, const std::string& level,
                 const Ktx2Parts& parts = {}) {
  const std::string descriptor =
      little_endian(44) + little_endian(0) + little_endian(2 | 40u << 16) +
      little_endian(parts.model | 1u << 8 | parts.transfer << 16 | parts.flags << 24) +
      std::string(12, '\0') + little_endian(127u << 16 | parts.channel << 24) + std::string(8, '\0') +
      little_endian(0xffffffff);
  const auto keys_begin = static_cast<std::uint32_t>(descriptor_begin + descriptor.size()),
             keys_size = static_cast<std::uint32_t>(parts.keys.size()),
             size = static_cast<std::uint32_t>(level.size());
  std::string file = "\xabKTX 20\xbb\r\n\x1a\n";
  for (const std::uint32_t word : {format,
                                   1u,
                                   width,
                                   height,
                                   0u,
                                   0u,
                                   1u,
                                   1u,
                                   parts.scheme,
                                   static_cast<std::uint32_t>(descriptor_begin),
                                   static_cast<std::uint32_t>(descriptor.size()),
                                   keys_size == 0 ? 0 : keys_begin,
                                   keys_size,
                                   0u,
                                   0u,
                                   0u,
                                   0u,
                                   keys_begin + keys_size,
                                   0u,
                                   size,
                                   0u,
                                   parts.uncompressed == 0 ? size : parts.uncompressed,
                                   0u})
    file += little_endian(word);
  return file + descriptor + parts.keys + level;
}

std::string uastc(std::uint32_t width, std::uint32_t height, const std::string& blocks,
                  std::uint32_t transfer = linear) {
  return ktx2(width, height, 0, blocks, {.model = 166, .transfer = transfer, .channel = 3});
}

// ---- Texels as they are, and the blocks of a DDS

TEST(SceneKtx2, PlainTexels) {
  using Rgba = std::vector<std::uint8_t>;
  const struct {
    std::uint32_t unorm, srgb;
    const char* level;
    Rgba due;
  } cases[] = {{9, 15, "\1\2", {1, 0, 0, 255, 2, 0, 0, 255}},
               {16, 22, "\1\2\3\4", {1, 2, 0, 255, 3, 4, 0, 255}},
               {23, 29, "\1\2\3\4\5\6", {1, 2, 3, 255, 4, 5, 6, 255}},
               {30, 36, "\1\2\3\4\5\6", {3, 2, 1, 255, 6, 5, 4, 255}},
               {37, 43, "\1\2\3\4\5\6\7\x08", {1, 2, 3, 4, 5, 6, 7, 8}},
               {44, 50, "\1\2\3\4\5\6\7\x08", {3, 2, 1, 4, 7, 6, 5, 8}},
               {51, 57, "\1\2\3\4\5\6\7\x08", {1, 2, 3, 4, 5, 6, 7, 8}}};
  for (const auto& [unorm, srgb_format, level, due] : cases)
    for (const std::uint32_t format : {unorm, srgb_format}) {
      const std::string file = ktx2(2, 1, format, level);
      EXPECT_EQ(colour_of(file).rgba, due) << format;
      EXPECT_THAT(alpha8(alpha_of(file)), ElementsAre(due[3], due[7])) << format;
      EXPECT_EQ(alpha_of(file).width, 2u);
    }
}

// The same blocks as a DDS of these DXGI formats; BC1 without alpha, of which a DDS knows none, is opaque.
TEST(SceneKtx2, BlocksHaveTheAlphaThatADdsHas) {
  std::string block;
  for (unsigned k = 0; k < 16; ++k) block += static_cast<char>(0x40 | 37 * k);
  const auto dds = [&](std::uint32_t dxgi, const std::string& data) {
    return "DDS " + little_endian(124) + little_endian(0x1007) + little_endian(4) + little_endian(4) +
           std::string(56, '\0') + little_endian(32) + little_endian(4) + "DX10" + std::string(40, '\0') +
           little_endian(dxgi) + little_endian(3) + little_endian(0) + little_endian(1) + little_endian(0) +
           data;
  };
  const struct {
    std::uint32_t format, dxgi;
    std::size_t size;
  } cases[] = {{133, 71, 8},  {135, 74, 16}, {137, 77, 16}, {139, 80, 8},
               {141, 83, 16}, {143, 95, 16}, {145, 98, 16}};
  for (const auto& [format, dxgi, size] : cases)
    for (const std::uint32_t number : {format, format + 1}) {
      const std::string file = ktx2(4, 4, number, block.substr(0, size));
      EXPECT_EQ(alpha_of(file).alpha, alpha_of(dds(dxgi, block.substr(0, size))).alpha) << number;
      EXPECT_THAT(complaint_of<UnreadExtension>([&] { colour_of(file); }),
                  HasSubstr("the colours of a KTX2 of BC1 to BC7 are not read here"));
    }
  const std::string transparent = "\1" + std::string(3, '\0') + std::string(4, '\xff');
  EXPECT_EQ(alpha8(alpha_of(ktx2(4, 4, 133, transparent))), std::vector<std::uint8_t>(16, 255));
  const std::string punched = std::string(4, '\0') + std::string(4, '\xff');
  EXPECT_EQ(alpha8(alpha_of(ktx2(4, 4, 133, punched))), std::vector<std::uint8_t>(16, 0));
  EXPECT_EQ(alpha8(alpha_of(ktx2(4, 4, 131, punched))), std::vector<std::uint8_t>(16, 255));
}

// A flag says that alpha multiplies the colours: alpha stays, the colours are refused.
TEST(SceneKtx2, PremultipliedAlphaStays) {
  const std::string file = ktx2(2, 1, rgba8, "\1\2\3\4\5\6\7\x08", {.flags = 1});
  EXPECT_THAT(alpha8(alpha_of(file)), ElementsAre(4, 8));
  EXPECT_THAT(complaint_of<UnreadExtension>([&] { colour_of(file); }),
              HasSubstr("where alpha multiplies them"));
}

// ---- UASTC

struct UastcCase {
  unsigned code, bits, patterns;
  std::uint32_t linear_crc, srgb_crc;
};

/// Codes and patterns are those of the specification's tables.  Digests are the output of scripts/ktx2/pictures.mjs:
/// what Basis Universal's decoder (npm ktx2-encoder 0.6.0) makes of 1024 blocks, and astcenc 4.2 of the same blocks as
/// sRGB.
constexpr UastcCase uastc_cases[] = {
    {0x01, 4, 0, 0x467ad6e7, 0x119ac6bd},  {0x35, 6, 0, 0x909fa851, 0x3b1b8f74},
    {0x1D, 5, 30, 0x5e57076d, 0x66cf8ab6}, {0x03, 5, 11, 0xc585b27b, 0xdfe6bac4},
    {0x13, 5, 30, 0xb13614f4, 0xae806240}, {0x0B, 5, 0, 0xa5533856, 0x29783eec},
    {0x1B, 5, 0, 0xf23884e2, 0x85235ffc},  {0x07, 5, 19, 0xf86b5dac, 0x1b757954},
    {0x17, 5, 0, 0x37498b29, 0x37498b29},  {0x0F, 5, 30, 0xe6c28b60, 0x303dac15},
    {0x02, 3, 0, 0xd7307bb2, 0x74a4a96c},  {0x00, 2, 0, 0xefc2a08c, 0x8d0d7309},
    {0x06, 3, 0, 0x8cfc096a, 0x95e4b794},  {0x1F, 5, 0, 0x70a9c302, 0x70a9c302},
    {0x0D, 5, 0, 0xd45ce3cf, 0x90ddcd7d},  {0x05, 7, 0, 0xc16c0104, 0x5495bdb2},
    {0x15, 6, 30, 0xa26524e1, 0x6796fb2d}, {0x25, 6, 0, 0x12398812, 0xb14b0225},
    {0x09, 4, 0, 0x0fec3a61, 0x5213e9b7}};

struct UastcBits {
  std::string block;

  void put(unsigned at, unsigned count, unsigned field) {
    for (unsigned k = 0; k < count; ++k) {
      char& byte = block[(at + k) / 8];
      const unsigned bit = 1u << ((at + k) % 8);
      byte = static_cast<char>((static_cast<unsigned char>(byte) & ~bit) | (field >> k & 1u) * bit);
    }
  }
};

bool has_alpha(unsigned mode) { return mode >= 9 && mode <= 17; }
/// The first bit of ETC2's table, or of the pattern in a mode without alpha.
unsigned after_hints(unsigned mode) { return uastc_cases[mode].bits + (mode >= 10 && mode <= 12 ? 9 : 15); }

/// A valid block: the mode's code, a multiplier for ETC2 that is not 0, and pattern k.
std::string uastc_block(unsigned mode, unsigned k, std::uint64_t low, std::uint64_t high) {
  UastcBits bits{little_endian(static_cast<std::uint32_t>(low)) +
                 little_endian(static_cast<std::uint32_t>(low >> 32)) +
                 little_endian(static_cast<std::uint32_t>(high)) +
                 little_endian(static_cast<std::uint32_t>(high >> 32))};
  const UastcCase& its = uastc_cases[mode];
  bits.put(0, its.bits, its.code);
  if (has_alpha(mode)) bits.put(after_hints(mode) + 4, 1, 1);
  if (its.patterns > 0)
    bits.put(after_hints(mode) + (has_alpha(mode) ? 8 : 0), mode == 3 ? 4 : 5, k % its.patterns);
  return bits.block;
}

TEST(SceneKtx2, EveryUastcModeIsThatOfAnotherDecoder) {
  std::uint64_t state = 1;
  const auto next = [&state] {
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return state * 0x2545F4914F6CDD1D;
  };
  for (unsigned mode = 0; mode < std::size(uastc_cases); ++mode) {
    std::string blocks;
    for (unsigned k = 0; k < 1024; ++k) {
      const std::uint64_t low = next(), high = next();
      blocks += uastc_block(mode, k, low, high);
    }
    EXPECT_EQ(crc_of(colour_of(uastc(128, 128, blocks)).rgba), uastc_cases[mode].linear_crc) << mode;
    EXPECT_EQ(crc_of(colour_of(uastc(128, 128, blocks, srgb)).rgba), uastc_cases[mode].srgb_crc) << mode;
  }
}

// A block made by hand: mode 18, black to white, the weights 0 and 31 of 31.
TEST(SceneKtx2, UastcByHand) {
  UastcBits bits{std::string(16, '\0')};
  bits.put(0, 4, 0x09);
  for (unsigned channel = 0; channel < 3; ++channel) bits.put(19 + 10 * channel + 5, 5, 31);
  bits.put(49 + 4, 5, 31);      // texel 1; texel 0 has one bit less
  bits.put(49 + 4 + 5, 5, 15);  // texel 2: 30 of 64, (30 * 65535 + 32) / 64 = 120 * 256
  const RgbaTexels texels = texels_of_uastc(as_bytes(bits.block), false);
  EXPECT_THAT(texels[0], ElementsAre(0, 0, 0, 255));
  EXPECT_THAT(texels[1], ElementsAre(255, 255, 255, 255));
  EXPECT_THAT(texels[2], ElementsAre(120, 120, 120, 255));
}

// The specification's error colour: a reserved mode, patterns beyond the tables, a multiplier of 0.
TEST(SceneKtx2, InvalidUastcBlocksAreTheErrorColour) {
  const auto expect_error = [](const std::string& block, const char* why) {
    for (const auto& texel : texels_of_uastc(as_bytes(block), false))
      EXPECT_THAT(texel, ElementsAre(255, 0, 255, 255)) << why;
  };
  expect_error("\x45" + std::string(15, '\1'), "mode 19");
  for (unsigned mode = 0; mode < std::size(uastc_cases); ++mode) {
    UastcBits bits{uastc_block(mode, 0, 0, 0)};
    const unsigned pattern_at = after_hints(mode) + (has_alpha(mode) ? 8 : 0), width = mode == 3 ? 4 : 5;
    for (unsigned pattern = uastc_cases[mode].patterns; pattern != 0 && pattern < 1u << width; ++pattern) {
      bits.put(pattern_at, width, pattern);
      expect_error(bits.block, "a pattern");
    }
    if (!has_alpha(mode)) continue;
    bits.put(pattern_at, width, 0);
    EXPECT_NE(texels_of_uastc(as_bytes(bits.block), false)[0][0], 255);
    bits.put(after_hints(mode) + 4, 4, 0);
    expect_error(bits.block, "a multiplier");
  }
}

// ---- ETC1S

// The files and the digests are the output of scripts/ktx2/pictures.mjs: Basis Universal (npm ktx2-encoder 0.6.0)
// encoded them, and its decoder made the texels.
const struct {
  const char* name;
  std::uint32_t width, height, crc;
} etc1s_files[] = {{"etc1s_leaf", 64, 64, 0x5390748b},  {"etc1s_grey", 21, 10, 0xd401f2fa},
                   {"etc1s_wide", 300, 9, 0x277380dd},  {"etc1s_opaque", 37, 22, 0xce232d5e},
                   {"etc1s_flat", 160, 96, 0x4baea51f}, {"etc1s_noise", 13, 7, 0xfa07ae64}};

TEST(SceneKtx2, Etc1sIsThatOfAnotherDecoder) {
  for (const auto& [name, width, height, crc] : etc1s_files) {
    const ColourImage image = colour_of(made(name));
    EXPECT_EQ(image.width, width) << name;
    EXPECT_EQ(image.height, height) << name;
    EXPECT_EQ(crc_of(image.rgba), crc) << name;
    const std::vector<std::uint8_t> alpha = alpha8(alpha_of(made(name)));
    for (std::size_t k = 0; k < alpha.size(); ++k) ASSERT_EQ(alpha[k], image.rgba[4 * k + 3]) << name << k;
  }
}

std::vector<unsigned char> bytes_of_bits(const std::string& bits) {
  std::vector<unsigned char> bytes((bits.size() + 7) / 8);
  for (std::size_t k = 0; k < bits.size(); ++k)
    if (bits[k] == '1') bytes[k / 8] = static_cast<unsigned char>(bytes[k / 8] | 1 << k % 8);
  return bytes;
}

// The example of RFC 1951, 3.2.2: the symbols A to H.
TEST(SceneKtx2, PrefixCodeOfTheRfc) {
  const std::uint8_t lengths[] = {3, 3, 3, 3, 3, 2, 4, 4};
  const PrefixCode code(lengths);
  const auto bytes = bytes_of_bits(
      "010011100101110"
      "00"
      "1110"
      "1111");
  LowBits bits(bytes);
  for (std::uint32_t symbol = 0; symbol < 8; ++symbol) EXPECT_EQ(code.take(bits), symbol);
}

TEST(SceneKtx2, BadPrefixCodesAreNamed) {
  const std::uint8_t full[] = {1, 1, 1}, lone[] = {1}, deep[] = {16, 1, 2, 2};
  const auto refused = [](auto call) { return complaint_of<DamagedPicture>(call); };
  EXPECT_THAT(refused([&] { PrefixCode code(full); }), HasSubstr("more codes than its lengths allow"));
  EXPECT_THAT(refused([&] { PrefixCode code(deep); }), HasSubstr("more codes than its lengths allow"));
  const auto take = [&](const PrefixCode& code, const std::string& text) {
    return refused([&] {
      const auto bytes = bytes_of_bits(text);
      LowBits bits(bytes);
      code.take(bits);
    });
  };
  EXPECT_EQ(take(PrefixCode(lone), "0"), "none");
  EXPECT_THAT(take(PrefixCode(lone), "1"), HasSubstr("bits end early"));
  EXPECT_THAT(take(PrefixCode(lone), std::string(16, '1')), HasSubstr("no Huffman code"));
  const auto read = [&](const std::string& text) {
    return refused([&] {
      const auto bytes = bytes_of_bits(text + std::string(64, '0'));
      LowBits bits(bytes);
      take_prefix_code(bits);
    });
  };
  const std::string one_symbol = "10000000000000", two_symbols = "01000000000000";
  EXPECT_THAT(read(one_symbol + "00000"), HasSubstr("0 lengths of lengths"));
  EXPECT_THAT(read(one_symbol + "01101"), HasSubstr("22 lengths of lengths"));
  // Lengths of lengths come in the order 17, 18, 19, ...: 19 alone has a code, 0.
  EXPECT_THAT(read(one_symbol + "11000"
                                "000000100"
                                "0"),
              HasSubstr("repeats a length before the first one"));
  // 17 alone: three zeros at least, for two symbols.
  EXPECT_THAT(read(two_symbols + "10000"
                                 "100"
                                 "0"),
              HasSubstr("2 symbols has lengths for 3"));
}

// ---- Zstandard

#ifdef MMVERIFY_HAS_ZSTD

std::string zstd(const std::string& bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 19));
  return out;
}

TEST(SceneKtx2, ZstandardIsUndone) {
  std::string level;
  for (unsigned k = 0; k < 64 * 64 * 4; ++k) level += static_cast<char>(k * k >> 7);
  const auto size = static_cast<std::uint32_t>(level.size());
  const std::string packed = zstd(level),
                    file = ktx2(64, 64, rgba8, packed, {.scheme = 2, .uncompressed = size});
  EXPECT_EQ(colour_of(file).rgba, colour_of(ktx2(64, 64, rgba8, level)).rgba);
  const std::string block = uastc_block(10, 0, 0x0123456789abcdef, 0x1122334455667788);
  EXPECT_EQ(
      colour_of(ktx2(4, 4, 0, zstd(block), {.scheme = 2, .uncompressed = 16, .model = 166, .channel = 3}))
          .rgba,
      colour_of(uastc(4, 4, block)).rgba);
  // Two frames, and one that is skipped.
  const std::string skipped = "\x50\x2a\x4d\x18" + little_endian(3) + "any",
                    two = zstd(level.substr(0, 100)) + skipped + zstd(level.substr(100));
  EXPECT_EQ(colour_of(ktx2(64, 64, rgba8, two, {.scheme = 2, .uncompressed = size})).rgba,
            colour_of(file).rgba);
  for (std::size_t cut = 1; cut < packed.size(); cut += 7)
    EXPECT_THAT(complaint_of_picture(ktx2(64, 64, rgba8, packed.substr(0, packed.size() - cut),
                                          {.scheme = 2, .uncompressed = size})),
                HasSubstr("damaged KTX2: "));
  // More and fewer bytes than the picture has.
  for (const std::string& other : {level + "x", level.substr(1)})
    EXPECT_THAT(complaint_of_picture(ktx2(64, 64, rgba8, zstd(other), {.scheme = 2, .uncompressed = size})),
                HasSubstr("damaged KTX2: "));
  EXPECT_THAT(complaint_of_picture(ktx2(64, 64, rgba8, packed, {.scheme = 2, .uncompressed = size + 1})),
              HasSubstr("has 16384 bytes, the index says 16385"));
}

// A gigabyte is not asked for where so few bytes cannot have it.
TEST(SceneKtx2, SmallFilesDoNotClaimGigabytes) {
  const std::string file =
      ktx2(16384, 16384, rgba8, zstd(std::string(1 << 16, '\0')), {.scheme = 2, .uncompressed = 1u << 30});
  EXPECT_THAT(complaint_of_picture(file), HasSubstr("level 0 has 1073741824 bytes, which cannot be in"));
}

#else

TEST(SceneKtx2, ZstandardIsNamed) {
  EXPECT_THAT(complaint_of_picture(ktx2(2, 1, rgba8, "any", {.scheme = 2, .uncompressed = 8})),
              HasSubstr("built without Zstandard (Debian: libzstd-dev)"));
}

#endif

// ---- ZLIB

/// A ZLIB of one stored block.  Source: RFC 1950, 2.2 and 8.2; RFC 1951, 3.2.4.
std::string zlib(const std::string& bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return "\x78\x01\x01" + little_endian(size | (~size & 0xffff) << 16) + bytes + big_endian(b << 16 | a);
}

TEST(SceneKtx2, ZlibIsUndone) {
  std::string level;
  for (unsigned k = 0; k < 16 * 16 * 4; ++k) level += static_cast<char>(k * k >> 7);
  const auto size = static_cast<std::uint32_t>(level.size());
  const std::string packed = zlib(level);
  const auto file = [&](const std::string& code, std::uint32_t uncompressed) {
    return ktx2(16, 16, rgba8, code, {.scheme = 3, .uncompressed = uncompressed});
  };
  EXPECT_EQ(colour_of(file(packed, size)).rgba, colour_of(ktx2(16, 16, rgba8, level)).rgba);
  // Python's zlib.compress(bytes(range(16)), 9), with a block of fixed codes.
  const std::string sixteen(
      "\x78\xda\x63\x60\x64\x62\x66\x61\x65\x63\xe7\xe0\xe4\xe2\xe6\xe1\xe5\xe3\x07\x00"
      "\x02\xb8\x00\x79",
      24);
  EXPECT_THAT(alpha8(alpha_of(ktx2(2, 2, rgba8, sixteen, {.scheme = 3, .uncompressed = 16}))),
              ElementsAre(3, 7, 11, 15));
  for (std::size_t cut = 1; cut < packed.size(); cut += 97)
    EXPECT_THAT(complaint_of_picture(file(packed.substr(0, packed.size() - cut), size)),
                HasSubstr("damaged KTX2: "))
        << cut;
  for (const std::string& other : {level + "x", level.substr(1)})
    EXPECT_THAT(complaint_of_picture(file(zlib(other), size)), HasSubstr("damaged KTX2: "));
  std::string spoilt = packed;
  spoilt[99] ^= 1;
  EXPECT_THAT(complaint_of_picture(file(spoilt, size)), HasSubstr("another Adler-32 than its bytes"));
  EXPECT_THAT(
      complaint_of_picture(ktx2(16384, 16384, rgba8, packed, {.scheme = 3, .uncompressed = 1u << 30})),
      HasSubstr("which cannot be in"));
}

// ---- Words and floats

TEST(SceneKtx2, WordsAndFloatsAreAsTheyAre) {
  const std::vector<std::uint16_t> words{1, 2, 3, 0xabcd, 5, 6, 7, 65535};
  const std::string file = ktx2(2, 1, 91, bytes_of(words));
  EXPECT_THAT(alpha16(alpha_of(file)), ElementsAre(0xabcd, 65535));
  EXPECT_THAT(complaint_of<UnreadExtension>([&] { colour_of(file); }),
              HasSubstr("the colours of a KTX2 of 16 or 32 bits a channel are not read here"));
  // 1/3 as binary16, 1365/4096, and the least subnormal.
  const std::vector<std::uint16_t> halves{0, 0, 0, 0x3555, 0, 0, 0, 0x8001};
  EXPECT_THAT(std::get<2>(alpha_of(ktx2(2, 1, 97, bytes_of(halves))).alpha),
              ElementsAre(1365.0f / 4096, -0x1p-24f));
  const std::vector<float> singles{0, 0, 0, 0.1f, 0, 0, 0, 2};
  EXPECT_THAT(std::get<2>(alpha_of(ktx2(2, 1, 109, bytes_of(singles))).alpha), ElementsAre(0.1f, 2.0f));
  // Fewer channels are opaque.
  for (const auto& [format, size] : {std::pair{70u, 2u}, {77u, 4u}, {84u, 6u}})
    EXPECT_THAT(alpha16(alpha_of(ktx2(1, 1, format, std::string(size, '\1')))), ElementsAre(65535));
  for (const auto& [format, size] :
       {std::pair{76u, 2u}, {83u, 4u}, {90u, 6u}, {100u, 4u}, {103u, 8u}, {106u, 12u}})
    EXPECT_THAT(std::get<2>(alpha_of(ktx2(1, 1, format, std::string(size, '\1'))).alpha), ElementsAre(1.0f));
  const std::vector<std::uint16_t> infinite{0, 0, 0, 0x7c00};
  EXPECT_THAT(complaint_of_picture(ktx2(1, 1, 97, bytes_of(infinite))),
              HasSubstr("damaged KTX2: the alpha of texel 0 is not finite"));
}

// ---- Refused files

TEST(SceneKtx2, WhatIsNotReadIsNamed) {
  const std::string good = ktx2(2, 1, rgba8, "\1\2\3\4\5\6\7\x08");
  const auto unread = [](const std::string& file) {
    const auto why = why_unread(as_bytes(file), PictureUse::alpha);
    EXPECT_EQ(complaint_of<UnreadExtension>([&] { alpha_of(file); }), "f: image 0: " + why.value_or("?"));
    return why.value_or("none");
  };
  EXPECT_EQ(why_unread(as_bytes(good), PictureUse::alpha), std::nullopt);
  EXPECT_EQ(unread(with_word(good, format_at, 98)), "a KTX2 of Vulkan's format 98 is not read here");
  for (const auto& [format, name] : {std::pair{147u, "ETC2"},
                                     {156u, "EAC"},
                                     {157u, "ASTC"},
                                     {184u, "ASTC"},
                                     {1000054000u, "PVRTC"},
                                     {1000066013u, "ASTC of HDR"}})
    EXPECT_EQ(unread(with_word(good, format_at, format)),
              std::string("a KTX2 of ") + name + " (Vulkan's format " + std::to_string(format) +
                  "; UASTC is read: toktx --encode uastc OUT.ktx2 "
                  "IN.png) is not read here");
  EXPECT_EQ(unread(with_word(good, depth_at, 1)), "a KTX2 of a volume is not read here");
  EXPECT_EQ(unread(with_word(good, layers_at, 1)), "a KTX2 of an array is not read here");
  EXPECT_EQ(unread(with_word(good, faces_at, 6)), "a KTX2 of a cube is not read here");
  EXPECT_EQ(unread(with_word(good, scheme_at, 4)), "a KTX2 with the supercompression 4 is not read here");
  EXPECT_EQ(unread(with_word(good, scheme_at, 0x10000)),
            "a KTX2 with a vendor's supercompression 65536 is not read here");
  // Two components that are no colour and alpha; the colour model ASTC.
  EXPECT_EQ(unread(ktx2(4, 4, 0, std::string(16, '\0'), {.model = 166, .channel = 5})),
            "a KTX2 of the colour model 166 with the channels 5 is not read here");
  EXPECT_EQ(unread(ktx2(4, 4, 0, std::string(16, '\0'), {.model = 162})),
            "a KTX2 of the colour model 162 with the channels 0 is not read here");
  const std::string rgba_rd =
      entry("KTXwriter", "any") + entry("KTXswizzle", "rgba") + entry("KTXorientation", "rd");
  EXPECT_EQ(complaint_of_picture(ktx2(1, 1, rgba8, "abcd", {.keys = rgba_rd})), "none");
  EXPECT_EQ(unread(ktx2(1, 1, rgba8, "abcd", {.keys = entry("KTXswizzle", "rrr1")})),
            "a KTX2 with another KTXswizzle than 'rgba' is not read here");
  EXPECT_EQ(unread(ktx2(1, 1, rgba8, "abcd", {.keys = entry("KTXorientation", "ru")})),
            "a KTX2 with another KTXorientation than 'rd' is not read here");
}

TEST(SceneKtx2, DamageIsNamed) {
  const std::string good = ktx2(2, 1, rgba8, "\1\2\3\4\5\6\7\x08");
  const auto damage = [](const std::string& file) {
    const std::string what = complaint_of_picture(file), start = "f: image 0: a damaged KTX2: ";
    return what.starts_with(start) ? what.substr(start.size()) : what;
  };
  EXPECT_EQ(damage(good), "none");
  for (const std::size_t at : {width_at, height_at}) {
    EXPECT_THAT(damage(with_word(good, at, 0)), HasSubstr("1 to 16384 a side are read"));
    EXPECT_THAT(damage(with_word(good, at, 16385)), HasSubstr("1 to 16384 a side are read"));
    EXPECT_THAT(damage(with_word(good, at, 0xffffffff)), HasSubstr("1 to 16384 a side are read"));
  }
  EXPECT_THAT(damage(with_word(good, width_at, 3)),
              HasSubstr("level 0 of 3 x 1 texels has 12 bytes, the index says 8"));
  EXPECT_EQ(damage(with_word(good, levels_at, 3)), "3 levels of 2 x 1 texels");
  EXPECT_EQ(damage(with_word(good, levels_at, 0xffffffff)), "4294967295 levels of 2 x 1 texels");
  EXPECT_THAT(damage(with_word(good, levels_at, 2)), HasSubstr("level 1 lies at bytes 44 and has"));
  EXPECT_THAT(damage(with_word(good, level_0_at, 149)),
              HasSubstr("level 0 lies at bytes 149 and has 8, the file has 156"));
  EXPECT_THAT(damage(with_word(good, level_0_at + 4, 1)), HasSubstr("level 0 lies at bytes 4294967444"));
  EXPECT_THAT(damage(with_word(good, level_0_at + 12, 0xffffffff)), HasSubstr("level 0 lies at bytes 148"));
  EXPECT_EQ(damage(with_word(good, level_0_at, 147)), "level 0 overlaps the data format descriptor");
  EXPECT_EQ(damage(with_word(good, level_0_at, 0)), "level 0 overlaps the index");
  EXPECT_THAT(damage(with_word(good, level_0_at + 8, 7)), HasSubstr("level 0 has 8 bytes, there are 7"));
  EXPECT_EQ(damage(with_word(good, descriptor_at + 4, 0)), "no whole data format descriptor");
  EXPECT_EQ(damage(with_word(good, descriptor_begin + 8, 2 | 44u << 16)),
            "its data format descriptor has 44 bytes, and a block of 44");
  EXPECT_THAT(damage(with_word(good, scheme_at, 1)), HasSubstr("BasisLZ of other data than ETC1S"));
  EXPECT_EQ(damage(ktx2(1, 1, rgba8, "abcd", {.keys = little_endian(1)})),
            "its key/value data end within an entry");
  // The levels of a mipmap that share bytes.
  const std::string leaf = made("etc1s_leaf");
  std::string shared = leaf;
  shared.replace(level_0_at + 24, 8, leaf.substr(level_0_at, 8));
  EXPECT_THAT(damage(shared), HasSubstr("overlaps level "));
}

TEST(SceneKtx2, DamageOfBasisLzIsNamed) {
  const std::string good = made("etc1s_opaque");
  const auto begin = static_cast<std::size_t>(static_cast<unsigned char>(good[global_at]) |
                                              static_cast<unsigned char>(good[global_at + 1]) << 8);
  const auto damage = [&](std::size_t at, std::uint32_t word) {
    return complaint_of_picture(with_word(good, begin + at, word));
  };
  EXPECT_THAT(damage(4, 1), HasSubstr("the parts of the supercompression global data have"));
  EXPECT_THAT(damage(8, 0xffffffff), HasSubstr("the parts of the supercompression global data have"));
  EXPECT_THAT(damage(20, 2), HasSubstr("a P-frame of no video"));
  EXPECT_THAT(damage(24, 0xffffff), HasSubstr("the slice of colours lies at bytes 16777215 of level 0"));
  EXPECT_THAT(damage(28, 0), HasSubstr("the slice of colours has no bytes"));
  EXPECT_THAT(damage(28, 1), HasSubstr("the slice of colours: its bits end early; truncated file?"));
  EXPECT_THAT(damage(36, 1), HasSubstr("a slice of alpha that the data format descriptor lacks"));
  // More endpoints than there are bits; none at all; one selector.
  EXPECT_THAT(damage(0, 0xffffffff), HasSubstr("the endpoint codebook: "));
  EXPECT_THAT(damage(0, 0), HasSubstr("the codebooks have 0 and 0"));
  EXPECT_THAT(complaint_of_picture(with_word(good, global_at + 8, 10)),
              HasSubstr("have at least 40 bytes, there are 10"));
}

// Every file, cut at every byte.
TEST(SceneKtx2, CutFilesAreRefused) {
  std::vector<std::string> files{ktx2(2, 1, rgba8, "abcdefgh"), uastc(4, 4, std::string(16, '\0')),
                                 ktx2(4, 4, 137, std::string(16, '\0'))};
  for (const auto& file : etc1s_files) files.push_back(made(file.name));
  for (const std::string& file : files) {
    EXPECT_EQ(complaint_of_picture(file), "none");
    for (std::size_t size = 0; size < file.size(); ++size)
      ASSERT_NE(complaint_of_picture(file.substr(0, size)), "none") << size;
  }
}

// Every byte of small files, changed: the result is a picture or an error.
TEST(SceneKtx2, ChangedBytesAreReadOrRefused) {
  std::size_t read = 0, refused = 0;
  for (const char* name : {"etc1s_noise", "etc1s_grey"}) {
    const std::string good = made(name);
    for (std::size_t at = 12; at < good.size(); ++at)
      for (const unsigned change : {0x01u, 0x10u, 0x80u, 0xffu}) {
        std::string file = good;
        file[at] = static_cast<char>(static_cast<unsigned char>(file[at]) ^ change);
        const std::string what = complaint_of<BadScene>([&] {
          const Image image = alpha_of(file);
          EXPECT_EQ(alpha8(image).size(), std::size_t{image.width} * image.height);
        });
        ++(what == "none" ? read : refused);
        EXPECT_TRUE(what == "none" || what.starts_with("f: image 0: ")) << what;
      }
  }
  EXPECT_GT(read, 100u);
  EXPECT_GT(refused, 100u);
}

// ---- glTF, and pictures of another decoder

TEST(SceneKtx2, TheTextureOfAGltfIsJudged) {
  GltfFile file = with_image(small_png());
  file.add("images", {{"bufferView", file.add_view(made("etc1s_leaf"))}, {"mimeType", "image/ktx2"}});
  file.json["textures"][0]["extensions"]["KHR_texture_basisu"] = {{"source", 1}};
  file.json["extensionsUsed"] = {"KHR_texture_basisu"};
  const Scene scene = load_glb(file);
  EXPECT_EQ(scene.materials[0].texture->image, 1u);
  EXPECT_EQ(alpha8(scene.images[1]), alpha8(alpha_of(made("etc1s_leaf"))));
  EXPECT_THAT(scene.notes,
              ElementsAre("texture 0: image 1 of KHR_texture_basisu is judged; not judged: the fallback "
                          "image 0"));
  // Without a fallback, and required.
  file.json["textures"][0].erase("source");
  file.json["extensionsRequired"] = {"KHR_texture_basisu"};
  const Scene alone = load_glb(file);
  EXPECT_TRUE(alone.images[1].decoded());
  EXPECT_TRUE(plan(alone).left_out.empty());
}

TEST(SceneKtx2, AFolderMayHoldSome) {
  const Folder folder;
  GltfFile::write(folder / "a.KTX2", made("etc1s_noise"));
  const Scene scene = load_textures(folder.path().string());
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(alpha8(scene.images[0]), alpha8(alpha_of(made("etc1s_noise"))));
  EXPECT_TRUE(scene.notes.empty());
}

// Pictures and texels that scripts/ktx2/pictures.mjs wrote into a folder.
TEST(SceneKtx2, PicturesAreThoseOfAnotherDecoder) {
  const char* const folder = std::getenv("MMVERIFY_KTX2_PICTURES");
  if (folder == nullptr)
    GTEST_SKIP() << "MMVERIFY_KTX2_PICTURES is not set: tests/outside/ktx2_test.sh runs it";
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ktx2") continue;
    const std::string due = read_bytes(std::filesystem::path(entry.path()).replace_extension(".rgba"));
    const ColourImage image = colour_of(read_bytes(entry.path()));
    EXPECT_TRUE(due.size() == image.rgba.size() &&
                std::memcmp(due.data(), image.rgba.data(), due.size()) == 0)
        << entry.path();
    ++pictures;
  }
  EXPECT_GT(pictures, 50u);
}

}  // namespace scene_ktx2_test
