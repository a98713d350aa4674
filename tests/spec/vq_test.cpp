// [release] spec/vq/vq.hpp and spec/vq/block.hpp: counts, table 1, codes and blocks by hand.
#include "spec/vq/vq.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "spec/vq/block.hpp"

namespace spec_vq_test {

using namespace mmverify::spec::vq;
using mmverify::spec::Rational;

constexpr State T = State::T, C = State::C, O = State::O;

/// Base 3, the first region least.
template <std::size_t side>
Vector<side> numbered(std::uint32_t number) {
  Vector<side> v{};
  for (State& s : v) {
    s = static_cast<State>(number % 3);
    number /= 3;
  }
  return v;
}

// 3^4 less those with both: with j of four regions C, 2 (of all T, all O) for 4-j > 0 others: 1 + 2 (2^4 - 1)
// = 31.
TEST(SpecVq, ThereAre31VectorsOfFour) {
  int count = 0;
  for (std::uint32_t k = 0; k < 81; ++k) count += valid<2>(numbered<2>(k)) ? 1 : 0;
  EXPECT_EQ(count, 31);
}

// Counted a second way, row after row, from how many valid rows pairs there are.
TEST(SpecVq, ThereAre231713VectorsOfSixteen) {
  int count = 0;
  for (std::uint32_t k = 0; k < 43'046'721; ++k) {
    // Most fail in the first two rows: skip what they begin.
    Vector<4> v = numbered<4>(k);
    count += valid<4>(v) ? 1 : 0;
    if (k % 6561 == 0) {
      for (std::size_t r = 0; r < 8; ++r) v[r] = C;
      if (!valid<4>(v)) k += 6560;
    }
  }
  EXPECT_EQ(count, 231'713);

  std::array<std::uint32_t, 81> ways{};
  ways.fill(1);
  for (int row = 1; row < 4; ++row) {
    std::array<std::uint32_t, 81> next{};
    for (std::uint32_t below = 0; below < 81; ++below)
      for (std::uint32_t above = 0; above < 81; ++above) {
        bool fits = true;
        const auto a = numbered<2>(below), b = numbered<2>(above);
        for (std::size_t x = 0; x < 3; ++x) fits = fits && valid<2>({a[x], a[x + 1], b[x], b[x + 1]});
        if (fits) next[above] += ways[below];
      }
    ways = next;
  }
  std::uint32_t sum = 0;
  for (const std::uint32_t w : ways) sum += w;
  EXPECT_EQ(sum, 231'713u);
}

// 4.1 applies LR, TB and R90 "in turn", the caption of table 1 "right to left": R90 first.  By matrices over
// (x, y), of an axis y that points up or down on the page; "anticlockwise" is what one sees there.
TEST(SpecVq, TheCaptionOfTable1FitsWithYUpwardsAndTheTextWithYDownwards) {
  using Matrix = std::array<int, 4>;  // x' = a x + b y, y' = c x + d y
  const auto after = [](const Matrix& f, const Matrix& g) {
    return Matrix{f[0] * g[0] + f[1] * g[2], f[0] * g[1] + f[1] * g[3], f[2] * g[0] + f[3] * g[2],
                  f[2] * g[1] + f[3] * g[3]};
  };
  const Matrix identity{1, 0, 0, 1}, lr{-1, 0, 0, 1}, tb{1, 0, 0, -1}, half_turn{-1, 0, 0, -1},
      x_is_y{0, 1, 1, 0}, x_is_minus_y{0, -1, -1, 0};
  for (const bool upwards : {false, true})
    for (const bool rotation_first : {false, true}) {
      const Matrix r90 = upwards ? Matrix{0, -1, 1, 0} : Matrix{0, 1, -1, 0},
                   r270 = upwards ? Matrix{0, 1, -1, 0} : Matrix{0, -1, 1, 0};
      const Matrix named[8] = {identity, r90, tb, x_is_minus_y, lr, x_is_y, half_turn, r270};
      int misnamed = 0;
      for (int row = 0; row < 8; ++row) {
        const Matrix first = rotation_first ? (row & 1 ? r90 : identity) : (row & 4 ? lr : identity),
                     last = rotation_first ? (row & 4 ? lr : identity) : (row & 1 ? r90 : identity);
        if (after(last, after(row & 2 ? tb : identity, first)) != named[row]) {
          EXPECT_TRUE(row == 3 || row == 5);
          ++misnamed;
        }
      }
      EXPECT_EQ(misnamed, upwards == rotation_first ? 0 : 2) << upwards << rotation_first;
    }
}

// Table 1's names, by what each does to the corners and edges of 4x4 regions, y upwards.
TEST(SpecVq, Table1HoldsWithYUpwards) {
  const std::uint32_t last = 3;
  using To = Region (*)(Region);
  const To named[8] = {
      [](Region r) { return r; },  // identity
      [](Region r) -> Region {
        return {last - r.y, r.x};
      },  // 90 degrees anticlockwise
      [](Region r) -> Region {
        return {r.x, last - r.y};
      },  // top and bottom exchanged
      [](Region r) -> Region {
        return {last - r.y, last - r.x};
      },  // about x = -y
      [](Region r) -> Region {
        return {last - r.x, r.y};
      },  // left and right exchanged
      [](Region r) -> Region {
        return {r.y, r.x};
      },  // about x = y
      [](Region r) -> Region {
        return {last - r.x, last - r.y};
      },  // 180 degrees
      [](Region r) -> Region {
        return {r.y, last - r.x};
      },  // 270 degrees anticlockwise
  };
  for (std::uint32_t row = 0; row < 8; ++row)
    for (std::uint32_t y = 0; y < 4; ++y)
      for (std::uint32_t x = 0; x < 4; ++x) {
        const Region to = moved<4>(Transform::of(row), {x, y});
        EXPECT_EQ(to, named[row]({x, y})) << row << ": " << x << ", " << y;
        EXPECT_EQ(filled_from<4>(Transform::of(row), to), (Region{x, y})) << row;
      }
}

// Downwards, row 3 would be the reflection about x = y: the table's names fix the axis.
TEST(SpecVq, WithYDownwardsTable1WouldNameOthers) {
  const auto downwards = [](Region r) { return Region{r.x, 3 - r.y}; };
  const Region r{1, 0}, seen = downwards(moved<4>(Transform::of(3), downwards(r)));
  EXPECT_EQ(seen, (Region{0, 1}));
}

TEST(SpecVq, TheTransformsAreTheSymmetriesOfTheSquare) {
  std::set<std::array<std::uint32_t, 8>> rows;
  for (std::uint32_t a = 0; a < 8; ++a) {
    std::array<std::uint32_t, 8> row{};
    std::set<std::uint32_t> each;
    for (std::uint32_t b = 0; b < 8; ++b) {
      const Transform t = composed(Transform::of(a), Transform::of(b));
      row[b] = t.number();
      each.insert(row[b]);
      for (std::uint32_t k = 0; k < 16; ++k) {
        const Region r{k % 4, k / 4};
        EXPECT_EQ(moved<4>(t, r), moved<4>(Transform::of(a), moved<4>(Transform::of(b), r)));
      }
    }
    EXPECT_EQ(each.size(), 8u) << "each result once";
    rows.insert(row);
  }
  EXPECT_EQ(rows.size(), 8u);
  // Not commutative: a rotation and a reflection.
  EXPECT_FALSE(composed(Transform::of(1), Transform::of(2)) == composed(Transform::of(2), Transform::of(1)));
}

TEST(SpecVq, CodesOfFiveBits) {
  EXPECT_EQ(decode_mini(0b0'0110), (Vector<2>{T, C, C, T}));
  EXPECT_EQ(decode_mini(0b1'0001), (Vector<2>{C, O, O, O}));
  EXPECT_EQ(decode_mini(0b1'1111), decode_mini(0b0'1111));
  std::set<Vector<2>> vectors;
  for (std::uint32_t code = 0; code < 32; ++code) {
    const Vector<2> v = decode_mini(code);
    vectors.insert(v);
    ASSERT_TRUE(encode_mini(v));
    EXPECT_EQ(*encode_mini(v), code == 31 ? 15 : code);
  }
  EXPECT_EQ(vectors.size(), 31u);
  EXPECT_FALSE(encode_mini({T, C, C, O}));
}

// Every code word of every kind: encode gives back the least that means the same.
TEST(SpecVq, CodesOfVectorsOfSixteen) {
  const std::map<Code4, std::size_t> distinct{{Code4::simple, 131'071},    // 2^17, all C twice
                                              {Code4::vertical, 261'121},  // 511^2: halves of 2^9 - 1
                                              {Code4::horizontal, 261'121},
                                              {Code4::generic, 923'521}};  // 31^4
  for (const auto& [how, count] : distinct) {
    std::size_t canonical = 0;
    for (std::uint32_t code = 0; code < 1u << bits_of(how); ++code) {
      const Vector<4> v = decode_vector(how, code);
      const auto again = encode_vector(how, v);
      ASSERT_TRUE(again);
      ASSERT_LE(*again, code);
      if (*again == code)
        ++canonical;
      else
        ASSERT_EQ(decode_vector(how, *again), v);
    }
    EXPECT_EQ(canonical, count) << static_cast<int>(how);
  }
  const Vector<4> left_o_right_t{O, O, T, T, O, C, T, T, O, O, T, T, C, O, T, C};
  EXPECT_FALSE(encode_vector(Code4::simple, left_o_right_t));
  EXPECT_FALSE(encode_vector(Code4::horizontal, left_o_right_t));
  EXPECT_EQ(*encode_vector(Code4::vertical, left_o_right_t), 0b01'1001'0000'0010'0000u);
  EXPECT_TRUE(encode_vector(Code4::generic, left_o_right_t));
}

TEST(SpecVq, AHitFallsInARegion) {
  const Rational third(1, 3);
  EXPECT_EQ(region_of<16>(Half::lower, 0, 0), (Region{0, 0}));
  EXPECT_EQ(region_of<16>(Half::upper, 0, 0), (Region{15, 15}));
  EXPECT_EQ(region_of<16>(Half::lower, 1, 0), (Region{15, 0}));
  EXPECT_EQ(region_of<16>(Half::lower, third, third), (Region{5, 5}));
  // A point of the shared edge, (s, 1-s), from either side.
  for (int k = 0; k <= 33; ++k) {
    const Rational s(k, 33);
    EXPECT_EQ(region_of<32>(Half::lower, s, 1 - s), region_of<32>(Half::upper, 1 - s, s)) << k;
  }
}

template <class Block>
class SpecVqBlock : public testing::Test {};
using Blocks = testing::Types<Vq2, Vq4>;
TYPED_TEST_SUITE(SpecVqBlock, Blocks);

TYPED_TEST(SpecVqBlock, HasABitForEveryFieldAndAFieldForEveryBit) {
  std::uint32_t bits = 0;
  TypeParam block{};
  for_each_field(block, [&](std::uint32_t more, auto&) { bits += more; });
  EXPECT_EQ(bits, TypeParam::bits);
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    BlockBytes<TypeParam> in{};
    for (auto& byte : in) byte = static_cast<std::uint8_t>(random());
    ASSERT_EQ(bytes(from_bytes<TypeParam>(in)), in);
  }
}

TYPED_TEST(SpecVqBlock, DecodesAlikeByVectorsAndByCoordinates) {
  constexpr std::uint32_t side = 8 * TypeParam::side;
  std::mt19937 random(2);
  for (int round = 0; round < 100; ++round) {
    BlockBytes<TypeParam> in{};
    for (auto& byte : in) byte = static_cast<std::uint8_t>(random());
    const auto block = from_bytes<TypeParam>(in);
    const auto map = decode(block);
    for (std::uint32_t k = 0; k < map.size(); ++k)
      ASSERT_EQ(decode_region(block, {k % side, k / side}), map[k]) << round << ": " << k;
  }
}

// Worked by hand: index 6 in each quadrant, TL's own entry C T / T T (bottom row first), the others' O C / C C, and all
// rows but TL's turned by 90 degrees, which takes the corner at the left bottom to the right bottom.
TEST(SpecVq2, ABlockByHand) {
  Vq2 block;
  block.indices.fill(6);
  for (std::size_t q = 1; q < 4; ++q) block.transforms[q] = Transform::of(1);
  block.own[0][0] = 0b0'0001;
  for (std::size_t q = 1; q < 4; ++q) block.own[q][0] = 0b1'1110;
  const auto map = decode(block);
  const auto at = [&map](std::uint32_t x, std::uint32_t y) { return map[x + 16 * y]; };
  EXPECT_EQ(at(0, 8), C);  // TL
  EXPECT_EQ(at(1, 8), T);
  EXPECT_EQ(at(0, 9), T);
  for (const auto& [x, y] : {std::pair{8u, 8u}, {0u, 0u}, {8u, 0u}}) {  // TR, BL, BR
    EXPECT_EQ(at(x, y), C);
    EXPECT_EQ(at(x + 1, y), O);
    EXPECT_EQ(at(x, y + 1), C);
    EXPECT_EQ(at(x + 1, y + 1), C);
  }
  const auto raw = bytes(block);
  EXPECT_EQ(raw[0], 0b10'110'110);   // indices 6, 6 and the first two bits of the third
  EXPECT_EQ(raw[24], 0b01'001'001);  // TR, BL and the first two bits of BR
  EXPECT_EQ(raw[31] >> 3, 0);        // BR's second entry
}

TEST(SpecVq4, TheUniformIndicesNeedNoCodebook) {
  Vq4 block;
  for (std::size_t k = 0; k < 64; ++k) block.indices[k] = static_cast<std::uint8_t>(k % 3);
  const auto map = decode(block);
  EXPECT_EQ(map[0], T);
  EXPECT_EQ(map[4], C);
  EXPECT_EQ(map[8], O);
}

}  // namespace spec_vq_test
