// [memory] Bakers as an engine calls them: interleaved pixels, whole meshes on its own threads.
#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>

#include "impl/bake/mesh.hpp"
#include "tests/complaint.hpp"

namespace impl_bake_engine_test {

using namespace mmverify::impl::bake;

constexpr std::uint32_t width = 13, height = 9;

std::vector<std::uint8_t> random_bytes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random() % 5 < 2 ? 255 : random() % 256);
  return bytes;
}

std::vector<BaseTriangle> random_triangles(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uv(-0.5f, 1.5f);
  std::vector<BaseTriangle> triangles(count);
  for (BaseTriangle& t : triangles)
    for (TexturePoint& p : t) p = {uv(random), uv(random)};
  return triangles;
}

std::vector<std::uint8_t> baked(const TriangleBaker& baker, const BaseTriangle& uv, std::uint32_t level) {
  std::vector<std::uint8_t> map(((std::size_t{1} << 2 * level) + 3) / 4);
  baker.bake(uv, level, map);
  return map;
}

TEST(ImplBakeEngine, AChannelIsBakedAsItsTexelsAlone) {
  for (const std::uint32_t channels : {1u, 2u, 4u, 16u})
    for (std::uint32_t channel = 0; channel < channels; ++channel) {
      const std::size_t pitch = channels * width + 7;
      const auto bytes = random_bytes(pitch * height, channels);
      std::vector<std::uint8_t> alone;
      for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) alone.push_back(bytes[pitch * y + channels * x + channel]);
      const Texels tight = AlphaView{alone.data(), width, height, width};
      const TriangleBaker right({&tight, 1}, Cutoff{1, 2});
      const auto of_pixels = [&] {
        // The pixels are gone when the baker bakes.
        const auto copy = bytes;
        const PixelView view{copy.data(), width, height, pitch, channels, channel};
        return TriangleBaker({&view, 1}, Cutoff{1, 2});
      };
      const TriangleBaker baker = of_pixels();
      for (const BaseTriangle& t : random_triangles(8)) EXPECT_EQ(baked(baker, t, 4), baked(right, t, 4));
    }
}

TEST(ImplBakeEngine, BadPixelsAreRefusedByName) {
  const auto bytes = random_bytes(std::size_t{4} * width * height, 1);
  const auto error = [&](const PixelView& view) {
    return mmverify::tests::complaint_of<std::invalid_argument>([&] { TriangleBaker({&view, 1}, Mask{}); });
  };
  const PixelView fine{bytes.data(), width, height, std::size_t{4} * width};
  const auto with = [&](auto change) {
    PixelView view = fine;
    change(view);
    return error(view);
  };
  EXPECT_EQ(error(fine), "none");
  EXPECT_EQ(with([](PixelView& v) { v.channel = 4; }), "bake: channel 4 of pixels with 4");
  EXPECT_EQ(with([](PixelView& v) { v.channels = 0; }), "bake: pixels of 0 channels, not 1 to 16");
  EXPECT_EQ(with([](PixelView& v) { v.channels = 17; }), "bake: pixels of 17 channels, not 1 to 16");
  EXPECT_EQ(with([](PixelView& v) { v.pitch = 51; }), "bake: a pitch of 51 bytes for rows of 52");
  EXPECT_EQ(with([](PixelView& v) { v.bytes = nullptr; }), "bake: a texture without texels");
  for (const std::uint32_t side : {0u, 16385u, 0xffffffffu})
    EXPECT_EQ(with([&](PixelView& v) { v.height = side; }),
              "bake: a texture has 1 to 16384 texels along each side");
}

/// Jobs by the last first, on four threads.
void on_four_threads(std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> left = count;
  const auto work = [&] {
    for (std::size_t k = left; k > 0; k = left)
      if (left.compare_exchange_strong(k, k - 1)) job(k - 1);
  };
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
}

TEST(ImplBakeEngine, AMeshIsItsTrianglesOnAnyThreads) {
  const auto bytes = random_bytes(std::size_t{width} * height, 9);
  const std::array<Texels, 2> mips{AlphaView{bytes.data(), width, height, width},
                                   AlphaView{bytes.data() + 5, 6, 4, 6}};
  const TriangleBaker baker(mips, Cutoff{1, 3});
  const auto triangles = random_triangles(40);
  std::vector<std::uint32_t> levels;
  for (std::uint32_t k = 0; k < 40; ++k) levels.push_back(k % 6);
  const MeshMaps alone = bake_mesh(baker, triangles, levels),
                 together = bake_mesh(baker, triangles, levels, on_four_threads);
  ASSERT_EQ(alone.maps.size(), 40u);
  std::uint64_t micro_triangles = 0;
  for (std::size_t t = 0; t < 40; ++t) {
    const auto right = baked(baker, triangles[t], levels[t]);
    EXPECT_EQ(alone.maps[t].level, levels[t]);
    EXPECT_TRUE(std::ranges::equal(alone.maps[t].bytes, right)) << t;
    EXPECT_TRUE(std::ranges::equal(together.maps[t].bytes, right)) << t;
    micro_triangles += std::uint64_t{1} << 2 * levels[t];
  }
  EXPECT_EQ(alone.counts.micro_triangles, micro_triangles);
  EXPECT_EQ(together.counts.micro_triangles, micro_triangles);
  EXPECT_EQ(together.counts.leaves, alone.counts.leaves);
  EXPECT_EQ(together.counts.exact, alone.counts.exact);
}

TEST(ImplBakeEngine, AMeshNamesItsFirstTriangleAtFault) {
  const auto bytes = random_bytes(std::size_t{width} * height, 9);
  const TriangleBaker baker(AlphaView{bytes.data(), width, height, width}, Cutoff{});
  auto triangles = random_triangles(9);
  std::vector<std::uint32_t> levels(9, 2);
  const auto error = [&] {
    return mmverify::tests::complaint_of<std::invalid_argument>(
        [&] { bake_mesh(baker, triangles, levels, on_four_threads); });
  };
  EXPECT_EQ(error(), "none");
  triangles[7][1].v = 0x1p20f;
  triangles[4][0].u = -0x1p20f;
  EXPECT_EQ(error(), "bake: triangle 4: a texture coordinate of 2^20 or more");
  levels[2] = 13;
  EXPECT_EQ(error(), "bake: triangle 2: a level above 12");
  levels.pop_back();
  EXPECT_EQ(error(), "bake: 8 levels for 9 triangles");
}

TEST(ImplBakeEngine, RoomIsAMapsSize) {
  const auto bytes = random_bytes(std::size_t{width} * height, 9);
  const Texels mip = AlphaView{bytes.data(), width, height, width};
  const TriangleBaker baker(std::array{mip, mip}, Cutoff{});
  const BaseTriangle uv = random_triangles(1)[0];
  std::vector<std::uint8_t> map(16), room(16), less(15);
  baker.bake(uv, 3, map, room);
  EXPECT_EQ(map, baked(baker, uv, 3));
  EXPECT_THROW(baker.bake(uv, 3, map, less), std::invalid_argument);
}

}  // namespace impl_bake_engine_test
