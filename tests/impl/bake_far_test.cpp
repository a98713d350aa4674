// [night] impl/bake/triangles.hpp: triangles that are far from the texture, or wider than it, as spec/bake/state.hpp has
// them; and that what they take does not grow with how far and wide they are.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "impl/bake/texture/rows.hpp"
#include "tests/impl/bake_jobs.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
namespace detail = mmverify::impl::bake::detail;

template <class Texel>
class ImplBakeFar : public testing::Test {};
using Kinds = testing::Types<std::uint8_t, float>;
TYPED_TEST_SUITE(ImplBakeFar, Kinds);

/// Up to `repeats` to either side; half of them whole, a quarter halves, so that edges close.
float somewhere(Random& random, int repeats) {
  const int whole = static_cast<int>(random() % static_cast<unsigned>(2 * repeats + 1)) - repeats;
  switch (random() % 4) {
    case 0:
      return static_cast<float>(whole) + static_cast<float>(random() % 64) / 64;
    case 1:
      return static_cast<float>(whole) + 0.5f;
    default:
      return static_cast<float>(whole);
  }
}

/// Mostly one texel: what a walk that ends too early does not see.
template <class Texel>
Image<Texel> sparse_image(Random& random) {
  const auto side = [&] { return 1 + static_cast<std::uint32_t>(random() % 4); };
  Image<Texel> image{side(), side(), {}};
  constexpr auto full = std::is_same_v<Texel, float> ? Texel(1) : std::numeric_limits<Texel>::max();
  const bool dark = random() % 2 == 0;
  for (std::uint32_t k = 0; k < image.width * image.height; ++k)
    image.texels.push_back(dark ? Texel(0) : full);
  for (int n = static_cast<int>(random() % 3); n >= 0; --n)
    image.texels[random() % image.texels.size()] = dark ? full : Texel(0);
  return image;
}

template <class Texel>
Job<Texel> sparse_job(Random& random) {
  Job<Texel> job = random_job<Texel>(random);
  job.mips = {sparse_image<Texel>(random)};
  if (random() % 4 != 0) job.mode = Mask{0.5f};
  job.sampling = random_sampling<Texel>(random);
  job.sampling.factors = {1, 1};
  return job;
}

TYPED_TEST(ImplBakeFar, WideOnesAreTheSpecifications) {
  Random random(11);
  Seen seen;
  for (int round = 0; round < (sanitized ? 40 : 500); ++round) {
    Job<TypeParam> job = sparse_job<TypeParam>(random);
    for (TexturePoint& p : job.uv) p = {somewhere(random, 5), somewhere(random, 5)};
    job.level = static_cast<std::uint32_t>(random() % 3);
    if (random() % 4 == 0) job.sampling.margin = random() % 2 == 0 ? 0.75f : 9;
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

/// Long along one axis, or along both in step, and thin.
TYPED_TEST(ImplBakeFar, StripsAreTheSpecifications) {
  Random random(12);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 250); ++round) {
    Job<TypeParam> job = sparse_job<TypeParam>(random);
    const int length = 20 + static_cast<int>(random() % 60);
    const bool diagonal = random() % 2 == 0;
    for (TexturePoint& p : job.uv) {
      p.u = somewhere(random, length);
      p.v = (diagonal ? p.u : somewhere(random, 1)) + static_cast<float>(random() % 4) / 8;
      if (diagonal && random() % 4 == 0) p.v += 0.25f;
    }
    if (random() % 2 == 0)
      for (TexturePoint& p : job.uv) std::swap(p.u, p.v);
    job.level = static_cast<std::uint32_t>(random() % 3);
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

/// So far away that binary64 cannot say where texels are, and every state is one of whole numbers.
TYPED_TEST(ImplBakeFar, FarOnesAreTheSpecifications) {
  Random random(13);
  Seen seen;
  for (int round = 0; round < (sanitized ? 10 : 100); ++round) {
    Job<TypeParam> job = sparse_job<TypeParam>(random);
    const float far_u = (random() % 2 == 0 ? -1.0f : 1.0f) * 0x1p19f,
                far_v = random() % 2 == 0 ? far_u : 0.0f;
    for (TexturePoint& p : job.uv) p = {far_u + somewhere(random, 4), far_v + somewhere(random, 4)};
    job.level = static_cast<std::uint32_t>(random() % 3);
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Time
// ---------------------------------------------------------------------------------------------------------------------

constexpr std::uint32_t side = 16384;
constexpr float repeats = 0x1p19f;

/// Alpha 0 but for one texel, or 1 but for one.
struct Lone {
  bool dark;
  std::uint32_t column, row;
};
Job<std::uint8_t> lone_job(const Lone& lone, std::uint32_t width, std::uint32_t height) {
  Job<std::uint8_t> job{{{width, height, {}}}, Mask{0.5f}, {}, {}, 0};
  job.mips[0].texels.assign(std::size_t{width} * height, lone.dark ? 0 : 255);
  job.mips[0].texels[lone.column + std::size_t{width} * lone.row] = lone.dark ? 255 : 0;
  return job;
}
/// The states of a map that has each of the two codes or one of them: bit c of the result is of code c.
unsigned codes_of(const TriangleBaker& baker, const BaseTriangle& uv, std::uint32_t level) {
  std::vector<std::uint8_t> map(((std::size_t{1} << (2 * level)) + 3) / 4);
  baker.bake(uv, level, map);
  unsigned codes = 0;
  for (std::size_t k = 0; k < std::size_t{1} << (2 * level); ++k)
    codes |= 1u << (map[k / 4] >> (2 * (k % 4)) & 3);
  return codes;
}
constexpr unsigned T = 1, UT = 4;

/// A footprint of 2^33 texels a side.  Cell by cell, each of these would take hours: that it ends is what is tested.
TEST(ImplBakeFarTime, BesideALargeTextureIsOneRegion) {
  if (sanitized) return;
  // The last row of texels, which clamp has below the texture, is one texel short.
  Job<std::uint8_t> job = lone_job({true, 9, side - 1}, side, side);
  for (const Filter filter : {Filter::bilinear, Filter::nearest}) {
    job.sampling.filter = filter;
    for (const Wrap wrap : {Wrap::clamp_to_edge, Wrap::clamp_to_border, Wrap::mirror_once}) {
      job.sampling.u = job.sampling.v = wrap;
      const TriangleBaker clamped = baker(job);
      const unsigned seen = wrap == Wrap::clamp_to_border ? T : T + UT;
      // From column 0 on, all that is below.
      EXPECT_EQ(codes_of(clamped, {{{0, 2}, {repeats, 2}, {0, repeats}}}, 3), seen);
      // Right of it, and below.
      EXPECT_EQ(codes_of(clamped, {{{2, 2}, {repeats, 2.5f}, {2.5f, repeats}}}, 3), T);
      // Everything: some see the texture's last row, most do not.
      EXPECT_EQ(codes_of(clamped, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), T + UT);
    }
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat}) {
      job.sampling.u = job.sampling.v = wrap;
      const TriangleBaker repeated = baker(job);
      EXPECT_EQ(codes_of(repeated, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), UT);
      // A line along the diagonal, which comes back to where it was, beside the texel in column 9.
      if (filter == Filter::bilinear) {
        EXPECT_EQ(codes_of(repeated, {{{-repeats, -repeats}, {repeats, repeats}, {0, 0}}}, 3), T);
      }
      // Rows 1 to 2 of each texture, all along.
      const float row = 1.0f / side;
      EXPECT_EQ(codes_of(repeated, {{{-repeats, row}, {repeats, row}, {0, 2 * row}}}, 3), T);
      // Clamped along one axis alone.
      job.sampling.v = Wrap::clamp_to_edge;
      const TriangleBaker below = baker(job);
      EXPECT_EQ(codes_of(below, {{{-repeats, 2}, {repeats, 3}, {repeats, repeats}}}, 3), UT);
      EXPECT_EQ(codes_of(below, {{{-repeats, -2}, {repeats, -3}, {repeats, -repeats}}}, 3), T);
      EXPECT_EQ(codes_of(below, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), T + UT);
      job.sampling.u = Wrap::clamp_to_edge;
      job.sampling.v = wrap;
      const TriangleBaker beside = baker(job);
      EXPECT_EQ(codes_of(beside, {{{2, -repeats}, {3, repeats}, {repeats, repeats}}}, 3), T);
      EXPECT_EQ(codes_of(beside, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), T + UT);
    }
  }
}

/// The steps themselves: rows of a wedge of 2^40 rows, which columns 0 and up to 5 are seen of.
TEST(ImplBakeFarTime, RowsThatRepeatAreNotWalked) {
  constexpr std::int64_t rows = std::int64_t{1} << 40;
  for (const std::int64_t period : {std::int64_t{1}, std::int64_t{7}, std::int64_t{1000}}) {
    std::int64_t calls = 0, taken = 0;
    std::vector<std::uint8_t> met(static_cast<std::size_t>(period));
    // It widens for 2^20 texels of which 5 count, keeps its width, and turns at row 2^39.
    const auto columns = [&](std::int64_t j) {
      ++calls;
      const std::int64_t width = j <= rows / 2 ? j >> 19 : (rows - j) >> 19;
      return detail::Columns{0, std::min<std::int64_t>(5, width)};
    };
    const std::array<detail::Bend, 3> bends{{{-1, 1}, {rows / 2 - 1, rows / 2 + 1}, {rows - 1, rows + 1}}};
    detail::each_row(0, rows, period, bends, columns, [&](const detail::Columns& at, std::int64_t j) {
      ++taken;
      if (at.last == 5) met[static_cast<std::size_t>(j % period)] = 1;
      return true;
    });
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), period);
    // Twelve runs of rows that are alike, and six rows at bends.
    EXPECT_LE(taken, 12 * (period + 1) + 6);
    EXPECT_LE(calls, taken + 14 * 42);
    EXPECT_GE(taken, 12);
  }
}

/// Columns whose ends go up and down between bends, and rest: whatever a row says that no row a period away does is said.
TEST(ImplBakeFarTime, RowsThatAreLeftOutSayNothingNew) {
  Random random(11);
  std::uint64_t left_out = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::int64_t rows = 12 + static_cast<std::int64_t>(random() % 50),
                       period = 1 + static_cast<std::int64_t>(random() % 6);
    const unsigned rest = random() % 2 == 0 ? 2 : 6;
    std::vector<std::int64_t> ends[2];
    std::vector<detail::Bend> bends;
    for (std::vector<std::int64_t>& end : ends) {
      std::int64_t at = static_cast<std::int64_t>(random() % 4), way = random() % 2 == 0 ? 1 : -1;
      for (std::int64_t j = 0; j <= rows; ++j) {
        end.push_back(at);
        if (j < rows && random() % 12 == 0) {
          way = -way;
          bends.push_back({j, j + static_cast<std::int64_t>(random() % 2)});
        }
        if (random() % rest == 0) at += way;
      }
    }
    const auto columns = [&](std::int64_t j) {
      const auto k = static_cast<std::size_t>(j);
      return detail::Columns{ends[0][k], ends[1][k]};
    };
    using Said = std::set<std::array<std::int64_t, 3>>;
    Said all, taken;
    for (std::int64_t j = 0; j <= rows; ++j) all.insert({j % period, columns(j).first, columns(j).last});
    std::int64_t count = 0;
    detail::each_row(0, rows, period, bends, columns, [&](const detail::Columns& at, std::int64_t j) {
      taken.insert({j % period, at.first, at.last});
      ++count;
      return true;
    });
    left_out += static_cast<std::uint64_t>(rows + 1 - count);
    ASSERT_EQ(taken, all) << "round " << round;
  }
  EXPECT_GT(left_out, 10000u);
}

TEST(ImplBakeFarTime, RowsWithoutAPeriodAreEachTaken) {
  std::int64_t taken = 0;
  detail::each_row(
      3, 1000, 0, {},
      [](std::int64_t) {
        return detail::Columns{0, 1};
      },
      [&](const detail::Columns&, std::int64_t) { return ++taken < 500; });
  EXPECT_EQ(taken, 500);
}

}  // namespace
