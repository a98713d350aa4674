// [memory] impl/bake/blocks: alpha of BC1 to BC4 and BC7 at any size and pitch, and maps baked from blocks, also from C.
#include <gmock/gmock.h>

#include <array>
#include <random>

#include "impl/mmverify.h"
#include "impl/mmverify.hpp"
#include "tests/complaint.hpp"

namespace impl_blocks_test {

using namespace mmverify::impl::bake;
using Bytes = std::vector<std::uint8_t>;
using Alphas = std::vector<std::uint16_t>;

/// A block of a format whose texel k has the alpha that its name says, worked out by hand.
struct Sample {
  BlockFormat format;
  Bytes block;
  std::array<std::uint16_t, 16> alpha;
};

constexpr std::uint16_t one = 65535;

std::vector<Sample> samples() {
  std::vector<Sample> all;
  // Colours 0 < 1; the codes 0, 1, 2, 3 in each row: 3 is transparent.
  Sample bc1{BlockFormat::bc1, {1, 0, 2, 0, 0xe4, 0xe4, 0xe4, 0xe4}, {}};
  for (std::size_t k = 0; k < 16; ++k) bc1.alpha[k] = k % 4 == 3 ? 0 : one;
  all.push_back(bc1);
  // Colours 0 > 1: no code is transparent.
  Sample opaque{BlockFormat::bc1, {2, 0, 1, 0, 0xe4, 0xe4, 0xe4, 0xe4}, {}};
  opaque.alpha.fill(one);
  all.push_back(opaque);
  // Texel k has the number k, of 15: k 4369 of 65535.
  Sample bc2{BlockFormat::bc2, {0x10, 0x32, 0x54, 0x76, 0x98, 0xba, 0xdc, 0xfe, 1, 2, 3, 4, 5, 6, 7, 8}, {}};
  for (std::size_t k = 0; k < 16; ++k) bc2.alpha[k] = static_cast<std::uint16_t>(k * 4369);
  all.push_back(bc2);
  // Ends 255 and 0; the codes 0 to 7, twice: 7/7, 0/7, 6/7, 5/7, ... 1/7.  Octal 76543210 from the lowest bit on.
  const Bytes sevenths{255, 0, 0x88, 0xc6, 0xfa, 0x88, 0xc6, 0xfa};
  Sample bc4{BlockFormat::bc4, sevenths, {65535, 0, 56173, 46811, 37449, 28086, 18724, 9362}};
  std::copy_n(bc4.alpha.begin(), 8, bc4.alpha.begin() + 8);
  all.push_back(bc4);
  Sample bc3{BlockFormat::bc3, sevenths, bc4.alpha};
  bc3.block.insert(bc3.block.end(), {9, 9, 9, 9, 9, 9, 9, 9});
  all.push_back(bc3);
  // Ends 0 and 255: fifths, then 0 and 1.
  Sample fifths{BlockFormat::bc4, sevenths, {0, 65535, 13107, 26214, 39321, 52428, 0, 65535}};
  std::swap(fifths.block[0], fifths.block[1]);
  std::copy_n(fifths.alpha.begin(), 8, fifths.alpha.begin() + 8);
  all.push_back(fifths);
  // Mode 6: both ends of alpha are 127 with a parity of 1, which is 255.  Then the ends 0, with parities of 0.
  all.push_back({BlockFormat::bc7, {0x40, 0, 0, 0, 0, 0, 0xfe, 0xff, 1, 0, 0, 0, 0, 0, 0, 0}, {}});
  all.back().alpha.fill(one);
  all.push_back({BlockFormat::bc7, {0x40, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {}});
  return all;
}

TEST(Blocks, EachFormatHasTheAlphaOfItsSpecification) {
  for (const Sample& s : samples()) {
    const BlockView view{s.format, s.block.data(), 4, 4, s.block.size()};
    EXPECT_EQ(alpha_of(view), Alphas(s.alpha.begin(), s.alpha.end())) << static_cast<int>(s.format);
    EXPECT_EQ(s.block.size(), block_bytes(s.format));
  }
}

/// A picture of random BC2 blocks, and their alpha texel by texel.
struct Picture {
  Bytes bytes;
  Alphas alpha;
  std::uint32_t width, height;
  std::size_t pitch;

  Picture(std::uint32_t across, std::uint32_t down, std::size_t more, unsigned seed)
      : alpha(std::size_t{across} * down), width(across), height(down), pitch((across + 3) / 4 * 16 + more) {
    std::mt19937 random(seed);
    bytes.resize(pitch * ((down + 3) / 4));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    for (std::uint32_t y = 0; y < down; ++y)
      for (std::uint32_t x = 0; x < across; ++x) {
        const std::uint32_t texel = y % 4 * 4 + x % 4;
        const std::uint8_t byte = bytes[pitch * (y / 4) + 16 * (x / 4) + texel / 2];
        alpha[x + across * y] = static_cast<std::uint16_t>((texel % 2 == 0 ? byte & 15 : byte >> 4) * 4369);
      }
  }
  BlockView view() const { return {BlockFormat::bc2, bytes.data(), width, height, pitch}; }
};

TEST(Blocks, AnySizeAndPitch) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {4u, 4u}, {5u, 6u}, {16u, 3u}, {7u, 64u}})
    for (const std::size_t more : {0u, 16u, 5u}) {
      const Picture p(width, height, more, 8 * width + height);
      EXPECT_EQ(alpha_of(p.view()), p.alpha)
          << width << " x " << height << ", " << more << " bytes between rows";
    }
}

constexpr BaseTriangle triangle{{{-0.25f, 0.125f}, {1.5f, 0.25f}, {0.5f, 1.25f}}};
constexpr std::uint32_t level = 4;
using Map = std::array<std::uint8_t, 64>;

TEST(Blocks, MapsAreThoseOfTheirTexels) {
  const Picture p(13, 10, 16, 3);
  const Texels texels = TexelView<std::uint16_t>{p.alpha.data(), p.width, p.height, p.width};
  Map due{}, map{};
  TriangleBaker({&texels, 1}, Cutoff{1, 3}).bake(triangle, level, due);
  const BlockView view = p.view();
  std::optional<TriangleBaker> baker(std::in_place, std::span(&view, 1), Cutoff{1, 3});
  TriangleBaker moved = std::move(*baker);
  baker.reset();
  moved.bake(triangle, level, map);
  EXPECT_EQ(map, due);
  EXPECT_NE(map, Map{});

  const mmverify_blocks blocks{MMVERIFY_BLOCKS_BC2, p.bytes.data(), p.width, p.height, p.pitch};
  mmverify_sampling how{};
  how.texel = MMVERIFY_TEXEL_UNORM16;
  how.factor = how.vertex_factor = 1;
  how.cutoff_numerator = 1, how.cutoff_denominator = 3;
  mmverify_baker* const in_c = mmverify_baker_of_blocks(&blocks, 1, &how);
  ASSERT_NE(in_c, nullptr) << mmverify_error();
  map = {};
  ASSERT_EQ(mmverify_bake(in_c, &triangle[0].u, level, map.data()), 1) << mmverify_error();
  EXPECT_EQ(map, due);
  mmverify_baker_free(in_c);
}

TEST(Blocks, EachFormatOfCIsThatOfCpp) {
  const std::array<std::pair<std::uint32_t, BlockFormat>, 5> formats{
      {{MMVERIFY_BLOCKS_BC1, BlockFormat::bc1},
       {MMVERIFY_BLOCKS_BC2, BlockFormat::bc2},
       {MMVERIFY_BLOCKS_BC3, BlockFormat::bc3},
       {MMVERIFY_BLOCKS_BC4, BlockFormat::bc4},
       {MMVERIFY_BLOCKS_BC7, BlockFormat::bc7}}};
  const Picture p(16, 16, 0, 5);
  mmverify_sampling how{};
  how.texel = MMVERIFY_TEXEL_UNORM16;
  how.factor = how.vertex_factor = 1;
  how.cutoff_numerator = 1, how.cutoff_denominator = 3;
  for (const auto& [number, format] : formats) {
    const BlockView view{format, p.bytes.data(), p.width, p.height, p.pitch};
    const mmverify_blocks blocks{number, p.bytes.data(), p.width, p.height, p.pitch};
    mmverify_baker* const in_c = mmverify_baker_of_blocks(&blocks, 1, &how);
    ASSERT_NE(in_c, nullptr) << mmverify_error();
    Map due{}, map{};
    TriangleBaker({&view, 1}, Cutoff{1, 3}).bake(triangle, level, due);
    ASSERT_EQ(mmverify_bake(in_c, &triangle[0].u, level, map.data()), 1) << mmverify_error();
    EXPECT_EQ(map, due) << number;
    mmverify_baker_free(in_c);
  }
}

TEST(Blocks, RefusesEachFault) {
  const Picture p(8, 8, 0, 4);
  const auto complaint = [&](auto change) {
    BlockView view = p.view();
    change(view);
    return mmverify::tests::complaint_of<std::invalid_argument>([&] { alpha_of(view); });
  };
  EXPECT_EQ(complaint([](BlockView& v) { v.pitch = 31; }),
            "a row of blocks has 32 bytes, and the pitch is 31");
  for (const std::uint32_t side : {0u, 16385u}) {
    EXPECT_EQ(complaint([&](BlockView& v) { v.width = side; }),
              "a texture of blocks has 1 to 16384 texels along each side");
    EXPECT_EQ(complaint([&](BlockView& v) { v.height = side; }),
              "a texture of blocks has 1 to 16384 texels along each side");
  }
  EXPECT_EQ(complaint([](BlockView& v) { v.bytes = nullptr; }), "a texture of blocks has no bytes");
  EXPECT_EQ(complaint([](BlockView& v) { v.format = static_cast<BlockFormat>(5); }),
            "blocks are of the formats BC1, BC2, BC3, BC4 or BC7");

  mmverify_sampling how{};
  how.factor = how.vertex_factor = 1;
  how.cutoff_numerator = 1, how.cutoff_denominator = 2;
  how.texel = MMVERIFY_TEXEL_UNORM16;
  mmverify_blocks blocks{5, p.bytes.data(), p.width, p.height, p.pitch};
  EXPECT_EQ(mmverify_baker_of_blocks(&blocks, 1, &how), nullptr);
  EXPECT_STREQ(mmverify_error(), "blocks are of format 1, 2, 3, 4 or 7, as BC1 to BC4 and BC7");
  blocks.format = MMVERIFY_BLOCKS_BC3;
  how.texel = MMVERIFY_TEXEL_UNORM8;
  EXPECT_EQ(mmverify_baker_of_blocks(&blocks, 1, &how), nullptr);
  EXPECT_STREQ(mmverify_error(), "texels of blocks are of 2, 16 bits");
}

}  // namespace impl_blocks_test
