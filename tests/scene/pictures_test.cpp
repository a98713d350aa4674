// scene/: pictures besides PNG and JPEG, and which image of a texture is judged.
#include <boost/crc.hpp>

#include "impl/bake/blocks/bc.hpp"
#include "impl/bake/blocks/bc7.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/dds.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "spec/rational.hpp"
#include "tests/complaint.hpp"
#include "tests/scene/loaded_scene.hpp"

#ifdef MMVERIFY_HAS_WEBP
#include <webp/encode.h>
#endif
#ifdef MMVERIFY_HAS_AVIF
#include <avif/avif.h>
#endif
#ifdef MMVERIFY_HAS_OPENEXR
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#endif

namespace scene_pictures_test {

using namespace mmverify::impl::bake::blocks;
using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::ElementsAre;
using testing::HasSubstr;

Image alpha_of(const std::string& bytes) {
  Image image;
  decode_alpha(as_bytes(bytes), image, "f", "image 0");
  return image;
}

std::string complaint_of_picture(const std::string& bytes) {
  return complaint_of<BadScene>([&] { alpha_of(bytes); });
}

// ---- DDS

/// A DDS of one level: `pixel_format` from its size on, or a code of four letters.
std::string dds(std::uint32_t width, std::uint32_t height, const std::string& code, const std::string& data,
                std::uint32_t dxgi = 0) {
  const std::string header = "DDS " + little_endian(124) + little_endian(0x1007) + little_endian(height) +
                             little_endian(width) + std::string(56, '\0') + little_endian(32) +
                             little_endian(4) + code + std::string(40, '\0');
  const std::string more = code == "DX10" ? little_endian(dxgi) + little_endian(3) + little_endian(0) +
                                                little_endian(1) + little_endian(0)
                                          : "";
  return header + more + data;
}

/// A BC3 block of two ends and codes k, k+1, ... of its 16 texels, modulo 8.
std::string bc3_block(unsigned a0, unsigned a1, unsigned k) {
  std::uint64_t codes = 0;
  for (unsigned texel = 0; texel < 16; ++texel) codes |= std::uint64_t{(k + texel) % 8} << (3 * texel);
  std::string block{static_cast<char>(a0), static_cast<char>(a1)};
  for (int byte = 0; byte < 6; ++byte) block += static_cast<char>(codes >> (8 * byte));
  return block + std::string(8, '\0');
}

/// The alpha that a code stands for, in the letters of the specification.
mmverify::spec::Rational alpha_of_code(int a0, int a1, unsigned code) {
  using mmverify::spec::Rational;
  const Rational first = Rational(a0) / 255, second = Rational(a1) / 255;
  if (code == 0) return first;
  if (code == 1) return second;
  if (a0 > a1)
    return (Rational(8 - static_cast<int>(code)) * first + Rational(static_cast<int>(code) - 1) * second) / 7;
  if (code == 6) return Rational(0);
  if (code == 7) return Rational(1);
  return (Rational(6 - static_cast<int>(code)) * first + Rational(static_cast<int>(code) - 1) * second) / 5;
}

// All pairs of ends, all codes: the nearest of 65535 to the specification's rational.
TEST(ScenePictures, AlphaOfBc3IsTheNearest) {
  using mmverify::spec::Rational;
  std::size_t cases = 0;
  for (unsigned a0 = 0; a0 < 256; ++a0)
    for (unsigned a1 = 0; a1 < 256; ++a1) {
      const std::string block = bc3_block(a0, a1, a0 + a1);
      const auto alpha = alpha_of_bc3(as_bytes(block));
      for (unsigned texel = 0; texel < 8; ++texel, ++cases) {
        const unsigned code = (a0 + a1 + texel) % 8;
        // The rational times 65535 has the denominator 5 or 7: no tie.
        const Rational due = alpha_of_code(static_cast<int>(a0), static_cast<int>(a1), code) * 65535;
        const Rational apart = due - Rational(static_cast<int>(alpha[texel]));
        ASSERT_TRUE(apart * 2 < Rational(1) && apart * 2 > Rational(-1)) << a0 << ' ' << a1 << ' ' << code;
        ASSERT_EQ(alpha[texel], alpha[texel + 8]);
      }
    }
  EXPECT_EQ(cases, 256u * 256u * 8u);
}

TEST(ScenePictures, Bc1IsTransparentByItsThirdCode) {
  // Codes 0, 1, 2, 3 in each row.
  const std::string codes(4, '\xe4'), low_first = std::string("\1\0\2\0", 4),
                                      high_first = std::string("\2\0\1\0", 4),
                                      equal = std::string("\2\0\2\0", 4);
  for (const auto& [ends, due] : {std::pair{low_first, 0}, {high_first, 255}, {equal, 0}}) {
    const Image image = alpha_of(dds(4, 4, "DXT1", ends + codes));
    for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(alpha8(image)[k], k % 4 == 3 ? due : 255) << k;
  }
}

TEST(ScenePictures, Bc2HasFourBits) {
  std::string block;
  for (int k = 0; k < 8; ++k) block += static_cast<char>(2 * k | (2 * k + 1) << 4);
  const Image image = alpha_of(dds(4, 4, "DXT3", block + std::string(8, '\0')));
  for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(alpha8(image)[k], 17 * k);
}

// Sides that are no multiples of four: blocks stand row by row, and what lies outside is dropped.
TEST(ScenePictures, BlocksAtTheEdges) {
  std::string data;
  for (unsigned block = 0; block < 4; ++block) {
    std::string alpha;
    for (int k = 0; k < 8; ++k) alpha += static_cast<char>(0x11 * (block + 1));
    data += alpha + std::string(8, '\0');
  }
  const Image image = alpha_of(dds(5, 6, "DX10", data, 74));
  ASSERT_EQ(alpha8(image).size(), 30u);
  for (std::size_t y = 0; y < 6; ++y)
    for (std::size_t x = 0; x < 5; ++x) EXPECT_EQ(alpha8(image)[x + 5 * y], 17 * (1 + x / 4 + 2 * (y / 4)));
}

TEST(ScenePictures, DdsWithoutBlocksOrWithoutAlpha) {
  EXPECT_THAT(alpha8(alpha_of(dds(2, 1, "DX10", "abc\5def\x7f", 28))), ElementsAre(5, 127));
  EXPECT_THAT(alpha8(alpha_of(dds(2, 1, "DX10", "abc\5def\x7f", 88))), ElementsAre(255, 255));
  EXPECT_THAT(alpha8(alpha_of(dds(1, 2, "ATI1", std::string(8, '\0')))), ElementsAre(255, 255));
  EXPECT_THAT(alpha8(alpha_of(dds(1, 2, "BC5U", std::string(16, '\0')))), ElementsAre(255, 255));
  std::string masks = dds(2, 1, std::string(4, '\0'), "abc\5def\x7f");
  const auto put = [&](std::size_t at, std::uint32_t word) { masks.replace(at, 4, little_endian(word)); };
  put(80, 0x41);
  put(88, 32);
  put(104, 0xff000000);
  EXPECT_THAT(alpha8(alpha_of(masks)), ElementsAre(5, 127));
  put(80, 0x40);
  EXPECT_THAT(alpha8(alpha_of(masks)), ElementsAre(255, 255));
  put(80, 0x41);
  put(104, 0xff);
  EXPECT_THAT(complaint_of_picture(masks), HasSubstr("a DDS of these masks is not read here"));
}

// 16,384 random blocks, all modes and partitions among them: the checksum is that of what Pillow 9.4 made of them.
TEST(ScenePictures, AlphaOfBc7IsThatOfAnotherDecoder) {
  std::uint64_t state = 0x9E3779B97F4A7C15;
  const auto next = [&state] {
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return state * 0x2545F4914F6CDD1D;
  };
  boost::crc_32_type crc;
  for (unsigned k = 0; k < 16384; ++k) {
    const std::uint64_t words[] = {next(), next()};
    unsigned char block[16];
    std::memcpy(block, words, 16);
    const unsigned mode = k % 8, others = block[0];
    block[0] = static_cast<unsigned char>((others >> (mode + 1) << (mode + 1)) | 1u << mode);
    const auto alpha = alpha_of_bc7(block);
    crc.process_bytes(alpha.data(), alpha.size());
  }
  EXPECT_EQ(crc.checksum(), 0x287c02a9u);
  // The reserved mode is nothing at all.
  const unsigned char reserved[16] = {0, 255, 255};
  EXPECT_EQ(alpha_of_bc7(reserved), (std::array<std::uint8_t, 16>{}));
  // A file with a block of mode 6, both ends 127 and a parity of 1.
  const std::string opaque = std::string("\x40\0\0\0\0\0\xfe\xff\1\0\0\0\0\0\0\0", 16);
  EXPECT_EQ(alpha8(alpha_of(dds(4, 4, "DX10", opaque, 98))), std::vector<std::uint8_t>(16, 255));
}

TEST(ScenePictures, DdsThatIsRefused) {
  const std::string good = dds(4, 4, "DXT5", bc3_block(1, 2, 0));
  EXPECT_EQ(complaint_of_picture(good), "none");
  EXPECT_THAT(complaint_of_picture(good.substr(0, good.size() - 1)),
              HasSubstr("has 16 bytes of them, there are 15"));
  EXPECT_THAT(complaint_of_picture(good.substr(0, 100)), HasSubstr("without a whole header"));
  EXPECT_THAT(complaint_of_picture(dds(0, 4, "DXT5", "")), HasSubstr("a DDS of 0 x 4 texels"));
  EXPECT_THAT(complaint_of_picture(dds(16385, 4, "DXT5", "")), HasSubstr("1 to 16384 a side"));
  EXPECT_THAT(complaint_of_picture(dds(4, 4, "DX10", std::string(16, '\0'), 2)),
              HasSubstr("a DDS of DXGI format 2 is not read here"));
  EXPECT_THAT(complaint_of_picture(dds(4, 4, "ABCD", std::string(16, '\0'))), HasSubstr("format 'ABCD'"));
  std::string cube = good;
  cube.replace(112, 4, little_endian(0x200));
  EXPECT_THAT(complaint_of_picture(cube), HasSubstr("a cube or a volume"));
}

// ---- TGA

std::string tga(char type, std::uint8_t width, std::uint8_t height, char bits, const std::string& data) {
  std::string header(18, '\0');
  header[2] = type;
  header[12] = static_cast<char>(width);
  header[14] = static_cast<char>(height);
  header[16] = bits;
  header[17] = 0x28;  // from the top, 8 bits of alpha
  return header + data;
}

TEST(ScenePictures, TargaPlainAndInRuns) {
  EXPECT_THAT(alpha8(alpha_of(tga(2, 2, 1, 32, "abc\5def\x7f"))), ElementsAre(5, 127));
  // A run of three, then two texels as they are.
  EXPECT_THAT(alpha8(alpha_of(tga(10, 5, 1, 32,
                                  "\x82"
                                  "abc\5\1def\x7fghi\x10"))),
              ElementsAre(5, 5, 5, 127, 16));
  EXPECT_THAT(alpha8(alpha_of(tga(2, 2, 1, 24, "abcdef"))), ElementsAre(255, 255));
  // The decoder would take what is missing for black.
  EXPECT_THAT(complaint_of_picture(tga(2, 2, 1, 32, "abc\5def")),
              HasSubstr("a TGA that ends before its 2 texels"));
  EXPECT_THAT(complaint_of_picture(tga(10, 5, 1, 32,
                                       "\x82"
                                       "abc\5\1def\x7f")),
              HasSubstr("ends before its 5 texels"));
}

TEST(ScenePictures, WhatIsNoTarga) {
  const std::string good = tga(2, 2, 1, 32, "abc\5def\x7f");
  for (const auto& [at, byte] :
       {std::pair<std::size_t, char>{2, 4}, {2, 0}, {1, 1}, {16, 31}, {12, 0}, {14, 0}, {17, '\x80'}}) {
    std::string other = good;
    other[at] = byte;
    EXPECT_THAT(complaint_of_picture(other), HasSubstr("no picture that is read here")) << at;
  }
}

// ---- WebP and AVIF

#ifdef MMVERIFY_HAS_WEBP

std::string webp(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::uint8_t* out = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &out);
  const std::string bytes(reinterpret_cast<const char*>(out), size);
  WebPFree(out);
  return bytes;
}

TEST(ScenePictures, WebpOfEveryAlpha) {
  std::vector<std::uint8_t> rgba, due;
  for (unsigned k = 0; k < 256; ++k) {
    const auto alpha = static_cast<std::uint8_t>(k);
    rgba.insert(rgba.end(), {static_cast<std::uint8_t>(7 * k), 3, 9, alpha});
    due.push_back(alpha);
  }
  const std::string good = webp(16, 16, rgba);
  EXPECT_EQ(alpha8(alpha_of(good)), due);
  EXPECT_EQ(alpha8(load_glb(with_image(good)).images[0]), due);
  for (std::size_t size = 20; size < good.size(); size += 7)
    EXPECT_THAT(complaint_of_picture(good.substr(0, size)), HasSubstr("truncated file?")) << size;
  for (std::size_t k = 3; k < rgba.size(); k += 4) rgba[k] = 255;
  EXPECT_EQ(alpha8(alpha_of(webp(16, 16, rgba))), std::vector<std::uint8_t>(256, 255));
}

#endif

#ifdef MMVERIFY_HAS_AVIF

/// A lossless AVIF whose alphas are 16 codes of `depth` bits, the last one the greatest.
std::string avif(unsigned depth, bool mirrored = false) {
  avifImage* const image = avifImageCreate(16, 1, depth, AVIF_PIXEL_FORMAT_YUV400);
  avifImageAllocatePlanes(image, AVIF_PLANES_ALL);
  for (std::uint32_t k = 0; k < 16; ++k) {
    const unsigned code = ((1u << depth) - 1) * k / 15;
    for (std::uint8_t* plane : {image->yuvPlanes[0], image->alphaPlane}) {
      const auto word = static_cast<std::uint16_t>(code);
      if (depth == 8)
        plane[k] = static_cast<std::uint8_t>(code);
      else
        std::memcpy(plane + 2 * k, &word, 2);
    }
  }
  if (mirrored) image->transformFlags |= AVIF_TRANSFORM_IMIR;
  avifEncoder* const encoder = avifEncoderCreate();
  encoder->minQuantizer = encoder->maxQuantizer = encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = 0;
  avifRWData out = AVIF_DATA_EMPTY;
  EXPECT_EQ(avifEncoderWrite(encoder, image, &out), AVIF_RESULT_OK);
  const std::string bytes(reinterpret_cast<const char*>(out.data), out.size);
  avifRWDataFree(&out);
  avifEncoderDestroy(encoder);
  avifImageDestroy(image);
  return bytes;
}

TEST(ScenePictures, AvifOfEightTenAndTwelveBits) {
  const Image eight = alpha_of(avif(8));
  for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(alpha8(eight)[k], 255 * k / 15);
  for (const unsigned depth : {10u, 12u}) {
    const std::uint64_t greatest = (1u << depth) - 1;
    const Image image = alpha_of(avif(depth));
    for (std::uint64_t k = 0; k < 16; ++k)
      EXPECT_EQ(alpha16(image)[k], (2 * 65535 * (greatest * k / 15) + greatest) / (2 * greatest))
          << depth << ' ' << k;
  }
  EXPECT_EQ(load_glb(with_image(avif(8))).images[0].width, 16u);
  EXPECT_THAT(complaint_of_picture(avif(8, true)), HasSubstr("turned, mirrored or cropped"));
  const std::string good = avif(8);
  EXPECT_THAT(complaint_of_picture(good.substr(0, good.size() - 4)), HasSubstr("truncated file?"));
}

#endif

#ifdef MMVERIFY_HAS_OPENEXR

/// Bytes in memory that OpenEXR's writer fills.
class ExrBytes : public Imf::OStream {
 public:
  ExrBytes() : OStream("bytes") {}
  void write(const char from[], int count) override {
    bytes.resize(std::max(bytes.size(), at_ + static_cast<std::size_t>(count)));
    std::copy_n(from, count, bytes.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ += static_cast<std::size_t>(count);
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t to) override { at_ = to; }
  std::string bytes;

 private:
  std::size_t at_ = 0;
};

/// An OpenEXR whose data window has these corners, with one channel of numbers, rows from the top.
template <class Number>
std::string openexr(const std::vector<Number>& numbers, Imf::PixelType type, Imf::Compression compression,
                    const Imath::Box2i& window, const char* channel = "A",
                    const Imath::Box2i* display = nullptr) {
  Imf::Header header(display == nullptr ? window : *display, window);
  header.compression() = compression;
  header.channels().insert(channel, Imf::Channel(type));
  ExrBytes to;
  {
    Imf::OutputFile file(to, header, 0);
    const auto across = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    const std::ptrdiff_t first = window.min.x + window.min.y * static_cast<std::ptrdiff_t>(across);
    Imf::FrameBuffer from;
    from.insert(channel,
                Imf::Slice(type, reinterpret_cast<char*>(const_cast<Number*>(numbers.data() - first)),
                           sizeof(Number), sizeof(Number) * across));
    file.setFrameBuffer(from);
    file.writePixels(window.max.y - window.min.y + 1);
  }
  return to.bytes;
}

const Imath::Box2i six_texels({-5, 7}, {-3, 8});  ///< 3 x 2

TEST(ScenePictures, OpenExrIsReadAsItIs) {
  const std::vector<float> floats{0.1f, 1, -0.25f, 0x1p-30f, 1.5f, 1.0f / 3};
  const std::vector<std::uint16_t> halves{0x3c00, 0x0001, 0x3555, 0x8000, 0x4000, 0x03ff};
  const std::vector<std::uint32_t> wholes{0, 1, 2, 7, 1 << 24, 1 << 30};
  for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                             Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
    const Image image = alpha_of(openexr(floats, Imf::FLOAT, compression, six_texels));
    EXPECT_EQ(image.width, 3u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.bits(), 32);
    EXPECT_EQ(std::get<2>(image.alpha), floats) << compression;
    // 1, 2^-24, 1365/4096, -0, 2, 1023 2^-24.
    EXPECT_EQ(std::get<2>(alpha_of(openexr(halves, Imf::HALF, compression, six_texels)).alpha),
              (std::vector<float>{1, 0x1p-24f, 1365.0f / 4096, 0, 2, 1023 * 0x1p-24f}));
    EXPECT_EQ(std::get<2>(alpha_of(openexr(wholes, Imf::UINT, compression, six_texels)).alpha),
              (std::vector<float>{0, 1, 2, 7, 0x1p24f, 0x1p30f}));
  }
  EXPECT_EQ(std::get<2>(alpha_of(openexr(floats, Imf::FLOAT, Imf::NO_COMPRESSION, six_texels, "R")).alpha),
            std::vector<float>(6, 1))
      << "a picture without alpha is opaque";
}

TEST(ScenePictures, OpenExrThatIsRefused) {
  const std::vector<float> floats{0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_THAT(complaint_of_picture(openexr(floats, Imf::FLOAT, Imf::NO_COMPRESSION, six_texels)),
              HasSubstr("the alpha of texel 5 is not finite"));
  const std::string good = openexr(std::vector<float>(6), Imf::FLOAT, Imf::ZIP_COMPRESSION, six_texels);
  EXPECT_EQ(complaint_of_picture(good), "none");
  for (std::size_t size = 4; size < good.size(); size += 11)
    EXPECT_THAT(complaint_of_picture(good.substr(0, size)), HasSubstr("truncated file?")) << size;
  for (const char flags : {'\x08', '\x10'}) {
    std::string other = good;
    other[5] = flags;
    EXPECT_THAT(complaint_of_picture(other),
                HasSubstr("of several parts, or of deep data, is not read here"));
  }
  const Imath::Box2i wider({-5, 7}, {-2, 8});
  EXPECT_THAT(complaint_of_picture(
                  openexr(std::vector<float>(6), Imf::FLOAT, Imf::NO_COMPRESSION, six_texels, "A", &wider)),
              HasSubstr("whose data window is not its display window"));
  EXPECT_EQ(why_unread(as_bytes(good), PictureUse::colour), "the colours of an OpenEXR are not read here");
}

#endif

TEST(ScenePictures, KindsThatAreNamed) {
#ifndef MMVERIFY_HAS_OPENEXR
  EXPECT_THAT(complaint_of_picture("\x76\x2f\x31\x01 and so on"),
              HasSubstr("built without OpenEXR (Debian: libopenexr-dev)"));
#endif
#ifndef MMVERIFY_HAS_WEBP
  EXPECT_THAT(complaint_of_picture("RIFF....WEBPVP8 "),
              HasSubstr("built without WebP (Debian: libwebp-dev)"));
#endif
#ifndef MMVERIFY_HAS_AVIF
  EXPECT_THAT(complaint_of_picture("....ftypavif...."),
              HasSubstr("built without AVIF (Debian: libavif-dev)"));
#endif
}

// ---- The image of a texture that has several

/// The square with a second image, of an extension; the first is its fallback.
GltfFile with_alternative(const char* name, const std::string& bytes) {
  GltfFile file = with_image(small_png());
  file.add("images", {{"bufferView", file.add_view(bytes)}, {"mimeType", "image/any"}});
  file.json["textures"][0]["extensions"][name] = {{"source", 1}};
  file.set_buffer_length();
  return file;
}

TEST(ScenePictures, TheImageOfTheExtensionIsJudgedAndSaid) {
  const GltfFile file = with_alternative("MSFT_texture_dds", dds(4, 4, "DXT5", bc3_block(255, 0, 0)));
  const Scene scene = load_glb(file);
  EXPECT_EQ(scene.materials[0].texture->image, 1u);
  EXPECT_TRUE(scene.images[1].decoded());
  EXPECT_FALSE(scene.images[0].decoded());
  EXPECT_THAT(scene.notes,
              ElementsAre("texture 0: image 1 of MSFT_texture_dds is judged; not judged: the fallback "
                          "image 0"));
}

TEST(ScenePictures, TheFallbackIsJudgedAndSaid) {
  for (const auto& [name, bytes, why] :
       {std::tuple{"MSFT_texture_dds", dds(4, 4, "DX10", std::string(16, '\0'), 2),
                   "a DDS of DXGI format 2 is not read here"},
        {"KHR_texture_basisu", dds(4, 4, "DX10", std::string(16, '\0'), 3),
         "a DDS of DXGI format 3 is not read here"}}) {
    GltfFile file = with_alternative(name, bytes);
    const Scene scene = load_glb(file);
    EXPECT_EQ(scene.materials[0].texture->image, 0u);
    EXPECT_THAT(scene.notes,
                ElementsAre("texture 0: the fallback image 0 is judged; not judged: image 1 of " +
                            std::string(name) + " (" + why + ")"));
    // Without one the primitive is left out, and the reason said.
    file.json["textures"][0].erase("source");
    file.json["extensionsRequired"] = {name};
    const Scene without = load_glb(file);
    EXPECT_FALSE(without.materials[0].texture->image);
    EXPECT_EQ(plan(without).left_out.at(0).why, LeftOut::no_image);
    EXPECT_THAT(without.notes, ElementsAre("texture 0: no image of it is read: image 1 of " +
                                           std::string(name) + " (" + why + ")"));
  }
}

// A texture with one image, or without alpha test, needs no note.
TEST(ScenePictures, NoNoteWhereThereIsNoChoice) {
  EXPECT_TRUE(load_glb(square()).notes.empty());
  GltfFile file = with_alternative("MSFT_texture_dds", dds(4, 4, "DXT5", bc3_block(255, 0, 0)));
  file.json["textures"][0].erase("source");
  EXPECT_TRUE(load_glb(file).notes.empty());
  file = with_alternative("KHR_texture_basisu", "\xabKTX 20\xbb\r\n\x1a\n");
  file.json["materials"][0]["alphaMode"] = "OPAQUE";
  EXPECT_TRUE(load_glb(file).notes.empty());
  file.json["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = 9;
  EXPECT_THAT(complaint(file), HasSubstr("KHR_texture_basisu/source: 9 is due to be an index into images"));
}

}  // namespace scene_pictures_test
