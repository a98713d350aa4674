// [night] impl/bake/triangles.hpp: what triangles take that are far from the texture, or far wider, does not grow with how far
// and wide they are.  Their states are the laws' to judge (proofs/bake/domains/).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "impl/bake/texture/rows.hpp"
#include "impl/bake/triangles.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::impl::bake;

constexpr std::uint32_t side = 16384;
constexpr float repeats = 0x1p19f;

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
  // Alpha is 0 but for one texel in the last row, which clamp has below the texture: one texel short.
  std::vector<std::uint8_t> texels(std::size_t{side} * side, 0);
  texels[9 + std::size_t{side} * (side - 1)] = 255;
  Sampling sampling;
  const auto baker = [&] {
    const Texels mip = TexelView<std::uint8_t>{texels.data(), side, side, side};
    return TriangleBaker(std::span(&mip, 1), Mask{0.5f}, sampling);
  };
  for (const Filter filter : {Filter::bilinear, Filter::nearest}) {
    sampling.filter = filter;
    for (const Wrap wrap : {Wrap::clamp_to_edge, Wrap::clamp_to_border, Wrap::mirror_once}) {
      sampling.u = sampling.v = wrap;
      const TriangleBaker clamped = baker();
      const unsigned seen = wrap == Wrap::clamp_to_border ? T : T + UT;
      // From column 0 on, all that is below.
      EXPECT_EQ(codes_of(clamped, {{{0, 2}, {repeats, 2}, {0, repeats}}}, 3), seen);
      // Right of it, and below.
      EXPECT_EQ(codes_of(clamped, {{{2, 2}, {repeats, 2.5f}, {2.5f, repeats}}}, 3), T);
      // Everything: some see the texture's last row, most do not.
      EXPECT_EQ(codes_of(clamped, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), T + UT);
    }
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat}) {
      sampling.u = sampling.v = wrap;
      const TriangleBaker repeated = baker();
      EXPECT_EQ(codes_of(repeated, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), UT);
      // A line along the diagonal, which comes back to where it was, beside the texel in column 9.
      if (filter == Filter::bilinear) {
        EXPECT_EQ(codes_of(repeated, {{{-repeats, -repeats}, {repeats, repeats}, {0, 0}}}, 3), T);
      }
      // Rows 1 to 2 of each texture, all along.
      const float row = 1.0f / side;
      EXPECT_EQ(codes_of(repeated, {{{-repeats, row}, {repeats, row}, {0, 2 * row}}}, 3), T);
      // Clamped along one axis alone.
      sampling.v = Wrap::clamp_to_edge;
      const TriangleBaker below = baker();
      EXPECT_EQ(codes_of(below, {{{-repeats, 2}, {repeats, 3}, {repeats, repeats}}}, 3), UT);
      EXPECT_EQ(codes_of(below, {{{-repeats, -2}, {repeats, -3}, {repeats, -repeats}}}, 3), T);
      EXPECT_EQ(codes_of(below, {{{-repeats, -repeats}, {repeats, -repeats}, {0, repeats}}}, 3), T + UT);
      sampling.u = Wrap::clamp_to_edge;
      sampling.v = wrap;
      const TriangleBaker beside = baker();
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
  std::mt19937 random(11);
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
