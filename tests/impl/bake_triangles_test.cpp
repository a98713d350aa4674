// [release, night] impl/bake/triangles.hpp: every state as spec/bake/state.hpp has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "impl/bake/exact/base.hpp"
#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "tests/sanitized.hpp"

namespace impl_bake_triangles_test {

namespace spec = mmverify::spec::bake;
using namespace mmverify::impl::bake;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;
using Codes = std::vector<int>;

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

struct Picture {
  std::uint32_t width, height;
  std::vector<std::uint8_t> alpha;

  AlphaView view() const { return {alpha.data(), width, height, width}; }
};

spec::Wrap specified(Wrap wrap) { return static_cast<spec::Wrap>(wrap); }
static_assert(static_cast<int>(spec::Wrap::mirror_once) == static_cast<int>(Wrap::mirror_once) &&
              static_cast<int>(spec::Wrap::clamp_to_border) == static_cast<int>(Wrap::clamp_to_border));

struct Baked {
  Codes codes;
  BakeCounts counts;
};

Baked bake(const Picture& picture, Cutoff cutoff, const Addressing& addressing, const BaseTriangle& uv,
           std::uint32_t level) {
  const std::size_t count = std::size_t{1} << (2 * level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  Baked baked;
  baked.counts = TriangleBaker(picture.view(), cutoff, addressing).bake(uv, level, map);
  for (std::size_t k = 0; k < count; ++k) baked.codes.push_back(map[k / 4] >> (2 * (k % 4)) & 3);
  return baked;
}

template <class Q>
int expected(const Picture& picture, Cutoff cutoff, const Addressing& addressing, const BaseTriangle& uv,
             std::uint32_t level, std::uint32_t index) {
  const spec::Texture texture{picture.width,           picture.height,          picture.alpha,
                              specified(addressing.u), specified(addressing.v), addressing.border};
  const auto vertex = [&](std::size_t k) {
    return spec::place<Q>({std::bit_cast<std::uint32_t>(uv[k].u)}, {std::bit_cast<std::uint32_t>(uv[k].v)});
  };
  const spec::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
  const spec::Mask<Q> mask{spec::fraction<Q>(cutoff.numerator, cutoff.denominator)};
  return static_cast<int>(spec::micro_state(texture, base, level, index, mask));
}

/// In 128 bits where they will do.
int expected_state(const Picture& picture, Cutoff cutoff, const Addressing& addressing,
                   const BaseTriangle& uv, std::uint32_t level, std::uint32_t index) {
  try {
    return expected<Rational128>(picture, cutoff, addressing, uv, level, index);
  } catch (const std::overflow_error&) {
  } catch (const std::range_error&) {
  }
  return expected<Rational>(picture, cutoff, addressing, uv, level, index);
}

std::string named(const Picture& picture, Cutoff cutoff, const Addressing& addressing, const BaseTriangle& uv,
                  std::uint32_t level) {
  std::ostringstream out;
  out << std::hexfloat << picture.width << 'x' << picture.height << ':';
  for (const auto byte : picture.alpha) out << ' ' << int{byte};
  out << " cutoff " << cutoff.numerator << '/' << cutoff.denominator << " wrap " << int(addressing.u) << ' '
      << int(addressing.v) << " border " << int{addressing.border} << " level " << level << " uv";
  for (const TexturePoint& p : uv) out << " (" << p.u << ", " << p.v << ')';
  return out.str();
}

/// What the whole numbers say, asked always.
int exact_state(const detail::ExactBase& base, std::uint32_t index) {
  const auto [marks, leans_to_opaque] = base(index);
  return marks == detail::both ? (leans_to_opaque ? 3 : 2) : marks == detail::opaque ? 1 : 0;
}

void expect_specified(const Picture& picture, Cutoff cutoff, const Addressing& addressing,
                      const BaseTriangle& uv, std::uint32_t level, std::uint32_t step = 1) {
  const Baked baked = bake(picture, cutoff, addressing, uv, level);
  const detail::TexturePropertiesOf<std::uint8_t> sides(
      picture.view(), detail::limits_of(cutoff, {1, 1}, 255), addressing.u, addressing.v, addressing.border);
  const detail::ExactBase exact(sides, uv, picture.width, picture.height, level);
  ASSERT_LE(baked.counts.exact, baked.counts.leaves);
  ASSERT_EQ(baked.counts.micro_triangles, baked.codes.size());
  for (std::uint32_t index = 0; index < baked.codes.size(); index += step) {
    const int state = expected_state(picture, cutoff, addressing, uv, level, index);
    ASSERT_EQ(baked.codes[index], state)
        << named(picture, cutoff, addressing, uv, level) << " index " << index;
    ASSERT_EQ(exact_state(exact, index), state)
        << named(picture, cutoff, addressing, uv, level) << " index " << index;
  }
}

Picture random_picture(std::mt19937& random, std::uint32_t most) {
  Picture p{
      1 + static_cast<std::uint32_t>(random() % most), 1 + static_cast<std::uint32_t>(random() % most), {}};
  const auto kind = random() % 4;
  for (std::uint32_t k = 0; k < p.width * p.height; ++k) {
    const std::uint32_t r = static_cast<std::uint32_t>(random());
    p.alpha.push_back(static_cast<std::uint8_t>(kind == 0   ? r % 256
                                                : kind == 1 ? 126 + r % 4
                                                : kind == 2 ? r % 2 * 255
                                                            : 51 * (r % 6)));
  }
  return p;
}

Addressing random_addressing(std::mt19937& random) {
  return {every_wrap[random() % 5], every_wrap[random() % 5], static_cast<std::uint8_t>(random())};
}

constexpr Cutoff cutoffs[] = {
    {1, 2}, {1, 2}, {128, 255}, {51, 255}, {1, 1}, {0, 1}, {1, 3}, {3, 2}, {0x7fffffff, 0xffffffff}};

// Corners on eighths: on texel lines, on centres, and between; lines and points among them.
TEST(ImplBakeTriangles, StatesOnAGridAreTheSpecifications) {
  std::mt19937 random(2);
  for (int round = 0; round < (sanitized ? 150 : 1500); ++round) {
    const Picture picture = random_picture(random, 4);
    BaseTriangle uv;
    for (TexturePoint& p : uv) {
      p.u = static_cast<float>(static_cast<int>(random() % 25) - 8) / 8;
      p.v = static_cast<float>(static_cast<int>(random() % 25) - 8) / 8;
    }
    ASSERT_NO_FATAL_FAILURE(expect_specified(picture, cutoffs[random() % 9], random_addressing(random), uv,
                                             static_cast<std::uint32_t>(random() % 3)));
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// A family, all of it
// ---------------------------------------------------------------------------------------------------------------------

constexpr std::uint8_t letters[] = {0, 128, 255};
constexpr Cutoff middle_letter{128, 255};

/// The part of a micro-triangle within one cell, and what the specification says of it for each of the 81
/// fillings of the cell's texels with letters.
struct Part {
  std::int64_t i, j;
  std::array<spec::State, 81> state;
};
/// The same of the centroid: whether it is opaque.
struct Center {
  std::int64_t i, j;
  std::array<bool, 81> opaque;
};

int filling(int a, int right, int below, int across) { return a + 3 * right + 9 * below + 27 * across; }

spec::Cell<Rational> filled(int filling) {
  const auto letter = [&filling] {
    const std::uint8_t byte = letters[filling % 3];
    filling /= 3;
    return byte;
  };
  spec::Texture t{2, 2, {}};
  for (int k = 0; k < 4; ++k) t.alpha.push_back(letter());
  return spec::Cell<Rational>(t, 0, 0);
}

struct Judged {
  std::vector<Part> parts;
  Center center;

  Judged(const BaseTriangle& uv, std::uint32_t level, std::uint32_t index) {
    const auto vertex = [&](std::size_t k) {
      return spec::place<Rational>({std::bit_cast<std::uint32_t>(uv[k].u)},
                                   {std::bit_cast<std::uint32_t>(uv[k].v)});
    };
    const Rational half = spec::fraction<Rational>(1, 2);
    const spec::Mask<Rational> mask{spec::fraction<Rational>(128, 255)};
    const auto polygon = spec::micro_triangle(spec::BaseTriangle<Rational>{vertex(0), vertex(1), vertex(2)},
                                              level, index, 2, 2);
    spec::for_each_square(polygon, half, [&](std::int64_t i, std::int64_t j, spec::Polygon<Rational> part) {
      for (auto& p : part) p = {p.x - half - i, p.y - half - j};
      Part judged{i, j, {}};
      for (int f = 0; f < 81; ++f)
        judged.state[static_cast<std::size_t>(f)] = spec::state_in(mask, spec::range(filled(f), part));
      parts.push_back(judged);
    });
    const auto at = spec::centroid(polygon);
    center = {spec::cell_at(at.x), spec::cell_at(at.y), {}};
    for (int f = 0; f < 81; ++f)
      center.opaque[static_cast<std::size_t>(f)] =
          mask.rather_opaque(filled(f).alpha({at.x - half - center.i, at.y - half - center.j}));
  }

  /// `letter`: of texel (i, j), before wrapping.
  template <class Letter>
  int state(Letter letter) const {
    const auto of = [&letter](std::int64_t i, std::int64_t j) {
      return static_cast<std::size_t>(
          filling(letter(i, j), letter(i + 1, j), letter(i, j + 1), letter(i + 1, j + 1)));
    };
    spec::State all = parts.at(0).state[of(parts[0].i, parts[0].j)];
    for (const Part& p : parts) all = spec::merged(all, p.state[of(p.i, p.j)]);
    if (all != spec::State::C) return all == spec::State::O ? 1 : 0;
    return center.opaque[of(center.i, center.j)] ? 3 : 2;
  }
};

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

/// On texel lines and centres of 2x2 textures, ulps off them, flipped, over several repeats, slivers, lines,
/// points.
const std::vector<BaseTriangle> family_triangles{
    {{{0, 0}, {1, 0}, {0, 1}}},
    {{{1, 1}, {0, 1}, {1, 0}}},
    {{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}},
    {{{up(0.25f), down(0.25f)}, {down(0.75f), 0.25f}, {0.25f, up(0.75f)}}},
    {{{down(0.5f), 0.5f}, {up(1.5f), down(0.5f)}, {-0.5f, down(1.0f)}}},
    {{{-1, -1}, {2, -0.5f}, {-0.25f, 1.75f}}},
    {{{0.125f, 0.875f}, {0.625f, 0.375f}, {0.375f, 0.125f}}},
    {{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.8f}}},
    {{{0.25f, 0.25f}, {1.25f, up(0.25f)}, {0.25f, 0.25f}}},
    {{{-0.75f, 1.25f}, {1.25f, -0.75f}, {0.25f, up(0.25f)}}},
    {{{-0.5f, 0.75f}, {1, 0.75f}, {0.5f, 0.75f}}},
    {{{0.75f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.25f}}},
};

TEST(ImplBakeTriangles, AllTexturesOf2x2LettersAreTheSpecifications) {
  std::uint64_t cases = 0, exact = 0, leaves = 0;
  for (std::size_t t = 0; t < (sanitized ? 2 : family_triangles.size()); ++t)
    for (std::uint32_t level = 0; level <= 3; ++level) {
      const BaseTriangle& uv = family_triangles[t];
      std::vector<Judged> judged;
      for (std::uint32_t index = 0; index < 1u << (2 * level); ++index) judged.emplace_back(uv, level, index);
      for (int f = 0; f < 81; ++f) {
        const int letter[] = {f % 3, f / 3 % 3, f / 9 % 3, f / 27};
        const Picture picture{
            2, 2, {letters[letter[0]], letters[letter[1]], letters[letter[2]], letters[letter[3]]}};
        for (const Wrap x : every_wrap)
          for (const Wrap y : every_wrap) {
            const int border = (f + static_cast<int>(y)) % 3;
            const Addressing addressing{x, y, letters[border]};
            const Baked baked = bake(picture, middle_letter, addressing, uv, level);
            exact += baked.counts.exact;
            leaves += baked.counts.leaves;
            const auto at = [&](std::int64_t i, std::int64_t j) {
              const auto a = spec::wrapped(specified(x), i, 2), b = spec::wrapped(specified(y), j, 2);
              return a && b ? letter[*a + 2 * *b] : border;
            };
            for (std::uint32_t index = 0; index < judged.size(); ++index, ++cases)
              ASSERT_EQ(baked.codes[index], judged[index].state(at))
                  << named(picture, middle_letter, addressing, uv, level) << " index " << index;
          }
      }
    }
  EXPECT_EQ(cases, (sanitized ? 2 : family_triangles.size()) * 81 * 25 * (1 + 4 + 16 + 64));
  // Both ways of deciding were taken.
  EXPECT_GT(exact, 0u);
  EXPECT_LT(exact, leaves);
}

// ---------------------------------------------------------------------------------------------------------------------
// Random and hostile
// ---------------------------------------------------------------------------------------------------------------------

TEST(ImplBakeTriangles, StatesOfAnyFloatsAreTheSpecifications) {
  std::mt19937 random(3);
  const auto unit = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  for (int round = 0; round < (sanitized ? 40 : 400); ++round) {
    const Picture picture = random_picture(random, 9);
    const float size = std::ldexp(1.0f, -static_cast<int>(random() % 8)), x = 4 * unit() - 2,
                y = 4 * unit() - 2;
    BaseTriangle uv;
    for (TexturePoint& p : uv) p = {x + size * unit(), y + size * unit()};
    const auto level = static_cast<std::uint32_t>(random() % 4);
    ASSERT_NO_FATAL_FAILURE(expect_specified(picture, cutoffs[random() % 9], random_addressing(random), uv,
                                             level, 1 + static_cast<std::uint32_t>(random() % 7)));
  }
}

// Corners an ulp off texel lines and centres, of sizes that are no powers of two.
TEST(ImplBakeTriangles, StatesUlpsOffTheLinesAreTheSpecifications) {
  std::mt19937 random(4);
  for (int round = 0; round < (sanitized ? 30 : 300); ++round) {
    const Picture picture = random_picture(random, 6);
    const auto near = [&random](std::uint32_t size) {
      const float x =
          (static_cast<float>(static_cast<int>(random() % (4 * size))) - static_cast<float>(size)) /
          static_cast<float>(2 * size);
      const auto way = random() % 3;
      return way == 0 ? x : way == 1 ? up(x) : down(x);
    };
    BaseTriangle uv;
    for (TexturePoint& p : uv) p = {near(picture.width), near(picture.height)};
    ASSERT_NO_FATAL_FAILURE(expect_specified(picture, cutoffs[random() % 9], random_addressing(random), uv,
                                             static_cast<std::uint32_t>(random() % 4), 3));
  }
}

// A million times as long as wide, on a texture with one row of difference.
TEST(ImplBakeTriangles, StatesOfSliversAreTheSpecifications) {
  std::mt19937 random(5);
  for (int round = 0; round < (sanitized ? 10 : 100); ++round) {
    const Picture picture = random_picture(random, 4);
    const float x = static_cast<float>(random() % 8) / 8, y = static_cast<float>(random() % 8) / 8,
                thin = 0x1p-20f * static_cast<float>(1 + random() % 3);
    const float length = 1 + static_cast<float>(random() % 3);
    const bool slanted = random() % 2 != 0, turned = random() % 2 != 0;
    BaseTriangle uv{{{x, y}, {x + length, slanted ? y + length : y}, {x, y + thin}}};
    if (turned)
      for (TexturePoint& p : uv) std::swap(p.u, p.v);
    ASSERT_NO_FATAL_FAILURE(expect_specified(picture, cutoffs[random() % 9], random_addressing(random), uv,
                                             static_cast<std::uint32_t>(random() % 3)));
  }
}

// Coordinates of the least and the greatest size: numbers of all widths.
TEST(ImplBakeTriangles, StatesOfExtremeCoordinatesAreTheSpecifications) {
  constexpr float least = std::numeric_limits<float>::denorm_min();
  const float greatest = down(0x1p20f), normal = std::numeric_limits<float>::min();
  const std::vector<BaseTriangle> triangles{
      {{{least, 0}, {0, -least}, {1, 1}}},
      {{{0.25f, 0.25f}, {1, least}, {-normal, 1}}},
      {{{0.25f, 0.25f}, {0.75f, 0x1p-60f}, {-0x1p-40f, 0.75f}}},
      {{{0.25f, 0.25f}, {0.75f, 0x1p-30f}, {-0x1p-28f, 0.75f}}},
      {{{least, least}, {least, 2 * least}, {3 * least, least}}},
      {{{greatest, -greatest}, {down(greatest), -greatest}, {greatest, -down(down(greatest))}}},
      {{{greatest, least}, {greatest, 1}, {down(greatest), 0.5f}}},
      {{{100000.25f, 7.5f}, {100001, 7.25f}, {100000, 8}}},
  };
  std::mt19937 random(6);
  for (const BaseTriangle& uv : triangles)
    for (int round = 0; round < (sanitized ? 2 : 8); ++round) {
      const Picture picture = random_picture(random, 3);
      ASSERT_NO_FATAL_FAILURE(expect_specified(picture, round % 2 == 0 ? Cutoff{1, 2} : cutoffs[8],
                                               random_addressing(random), uv,
                                               static_cast<std::uint32_t>(round % 3)));
    }
}

// Real sizes, at a level where micro-triangles are about a texel.
TEST(ImplBakeTriangles, StatesAtDeepLevelsAreTheSpecifications) {
  std::mt19937 random(7);
  Picture picture{61, 47, {}};
  for (std::uint32_t k = 0; k < 61 * 47; ++k) {
    const double x = k % 61 - 30.0, y = k / 61 - 23.0;
    picture.alpha.push_back(static_cast<std::uint8_t>(
        std::clamp(128 + 12 * (20 - std::hypot(x, y)) + static_cast<double>(random() % 20), 0.0, 255.0)));
  }
  for (const BaseTriangle& uv :
       {BaseTriangle{{{0, 0}, {1, 0}, {0, 1}}}, BaseTriangle{{{1, 1}, {0, 1}, {1, 0}}},
        BaseTriangle{{{0.11f, 0.07f}, {0.93f, 0.31f}, {0.38f, 0.97f}}}})
    ASSERT_NO_FATAL_FAILURE(expect_specified(picture, {1, 2}, {}, uv, 6, sanitized ? 211 : 17));
}

TEST(ImplBakeTriangles, AMillionRepeats) {
  const BaseTriangle vast{{{-500000, -500000}, {500000, -500000}, {-500000, 500000}}};
  const Addressing repeat{Wrap::repeat, Wrap::repeat};
  for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{0, 127, 128, 255})
    EXPECT_EQ(bake({2, 1, {byte, byte}}, {1, 2}, repeat, vast, 2).codes, Codes(16, byte < 128 ? 0 : 1));
  for (const int code : bake({2, 2, {0, 255, 0, 0}}, {1, 2}, repeat, vast, 3).codes) EXPECT_GE(code, 2);
  for (const int code :
       bake({2, 2, {0, 255, 0, 0}}, {1, 2}, {Wrap::mirrored_repeat, Wrap::repeat}, vast, 3).codes)
    EXPECT_GE(code, 2);
}

TEST(ImplBakeTriangles, FlatAlphaAtTheCutoffIsOpaque) {
  for (const Cutoff cutoff : {Cutoff{128, 255}, {256, 510}}) {
    for (const BaseTriangle& uv : family_triangles)
      for (const Wrap wrap : every_wrap) {
        EXPECT_EQ(bake({2, 2, {128, 128, 128, 128}}, cutoff, {wrap, wrap, 128}, uv, 2).codes, Codes(16, 1));
        EXPECT_EQ(bake({2, 2, {127, 127, 127, 127}}, cutoff, {wrap, wrap, 127}, uv, 2).codes, Codes(16, 0));
      }
  }
  // 0 and 255 meet at 127.5, in a line; beyond the outer centres the texture is flat.
  const BaseTriangle left{{{0, 0}, {0.5f, 0}, {0, 1}}}, right{{{1, 0}, {1, 1}, {up(0.5f), 0}}};
  const Addressing clamp{Wrap::clamp_to_edge, Wrap::clamp_to_edge};
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, left, 0).codes, Codes{1});
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, right, 0).codes, Codes{0});
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, {{{0, 0}, {up(0.5f), 0}, {0, 1}}}, 0).codes, Codes{3});
}

TEST(ImplBakeTriangles, WholeNumberShiftsChangeNothingWithRepeat) {
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round) {
    const Picture picture = random_picture(random, 7);
    BaseTriangle uv, shifted;
    const bool mirrored = round % 2 != 0;
    const float by_u = static_cast<float>(static_cast<int>(random() % 2001) - 1000) * (mirrored ? 2 : 1),
                by_v = static_cast<float>(static_cast<int>(random() % 9) - 4) * (mirrored ? 2 : 1);
    for (std::size_t k = 0; k < 3; ++k) {
      uv[k] = {static_cast<float>(random() % 3001) / 1024, static_cast<float>(random() % 3001) / 1024};
      shifted[k] = {uv[k].u + by_u, uv[k].v + by_v};
    }
    const Wrap wrap = mirrored ? Wrap::mirrored_repeat : Wrap::repeat;
    const Cutoff cutoff = cutoffs[random() % 9];
    ASSERT_EQ(bake(picture, cutoff, {wrap, wrap}, uv, 4).codes,
              bake(picture, cutoff, {wrap, wrap}, shifted, 4).codes)
        << round;
  }
}

TEST(ImplBakeTriangles, RefusesWhatIsNone) {
  const Picture picture{2, 2, {0, 0, 0, 0}};
  const TriangleBaker baker(picture.view(), {});
  std::vector<std::uint8_t> map(4, 0xee);
  const BaseTriangle fine{{{0, 0}, {1, 0}, {0, 1}}};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 0x1p20f, -0x1p20f})
    for (std::size_t k = 0; k < 3; ++k)
      for (const bool u : {true, false}) {
        BaseTriangle uv = fine;
        (u ? uv[k].u : uv[k].v) = bad;
        EXPECT_THROW(baker.bake(uv, 2, map), std::invalid_argument);
      }
  EXPECT_THROW(baker.bake(fine, 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 3, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, max_bake_level + 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 0xffffffff, map), std::invalid_argument);
  EXPECT_EQ(map, std::vector<std::uint8_t>(4, 0xee));
  EXPECT_NO_THROW(baker.bake(fine, 2, map));
  for (const auto& [width, height] : {std::pair{0u, 2u}, {2u, 0u}, {16385u, 1u}, {1u, 0xffffffffu}})
    EXPECT_THROW(TriangleBaker({picture.alpha.data(), width, height, 2}, {}), std::invalid_argument);
  EXPECT_THROW(TriangleBaker(picture.view(), {1, 0}), std::invalid_argument);
}

}  // namespace impl_bake_triangles_test
