// impl/bake/triangles.hpp: every kind of texel, mode, filter, factor, mip and margin as spec/bake/state.hpp
// has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "tests/every_target.hpp"
#include "tests/sanitized.hpp"

namespace {

namespace spec = mmverify::spec::bake;
using namespace mmverify::impl::bake;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;
using mmverify::tests::on_every_target;

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

template <class Texel>
struct Image {
  std::uint32_t width, height;
  std::vector<Texel> texels;
};

/// A bake, for both sides.
template <class Texel>
struct Job {
  std::vector<Image<Texel>> mips;
  AlphaMode mode;
  Sampling sampling;
  BaseTriangle uv;
  std::uint32_t level;
};

spec::Binary32 bits(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

template <class Texel>
auto specified(Texel r) {
  if constexpr (std::is_same_v<Texel, float>)
    return bits(r);
  else
    return r;
}

template <class Texel>
struct Expected {
  using Stored = decltype(specified(Texel{}));
  const Job<Texel>& job;
  std::vector<spec::TextureOf<Stored>> mips;

  explicit Expected(const Job<Texel>& j) : job(j) {
    const Sampling& s = job.sampling;
    for (const Image<Texel>& image : job.mips) {
      spec::TextureOf<Stored> t{image.width, image.height};
      for (const Texel r : image.texels) t.alpha.push_back(specified(r));
      t.wrap_x = static_cast<spec::Wrap>(s.u);
      t.wrap_y = static_cast<spec::Wrap>(s.v);
      t.border = specified(static_cast<Texel>(s.border));
      t.factor = bits(s.factors[0]);
      t.vertex_factor = bits(s.factors[1]);
      t.filter = s.filter == Filter::nearest ? spec::Filter::nearest : spec::Filter::bilinear;
      mips.push_back(t);
    }
  }

  template <class Q>
  int in(std::uint32_t index) const {
    const auto vertex = [&](std::size_t k) { return spec::place<Q>(bits(job.uv[k].u), bits(job.uv[k].v)); };
    const spec::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
    const auto state = [&](const auto& mode) {
      return static_cast<int>(spec::micro_state(std::span<const spec::TextureOf<Stored>>(mips), base,
                                                job.level, index, mode,
                                                spec::number<Q>(bits(job.sampling.margin))));
    };
    if (const auto* const mask = std::get_if<Mask>(&job.mode))
      return state(spec::Mask<Q>{spec::number<Q>(bits(mask->cutoff))});
    if (const auto* const cutoff = std::get_if<Cutoff>(&job.mode))
      return state(spec::Mask<Q>{spec::fraction<Q>(cutoff->numerator, cutoff->denominator)});
    return state(spec::Blend<Q>{});
  }

  /// In 128 bits where they will do.
  int operator()(std::uint32_t index) const {
    try {
      return in<Rational128>(index);
    } catch (const std::overflow_error&) {
    } catch (const std::range_error&) {
    }
    return in<Rational>(index);
  }
};

template <class Texel>
std::string named(const Job<Texel>& job) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Image<Texel>& image : job.mips) {
    out << image.width << 'x' << image.height << ':';
    for (const Texel r : image.texels) out << ' ' << +r;
    out << "; ";
  }
  const Sampling& s = job.sampling;
  out << "mode " << job.mode.index();
  if (const auto* const mask = std::get_if<Mask>(&job.mode)) out << ' ' << mask->cutoff;
  out << " wrap " << int(s.u) << ' ' << int(s.v) << " filter " << int(s.filter) << " border " << s.border
      << " factors " << s.factors[0] << ' ' << s.factors[1] << " margin " << s.margin << " level "
      << job.level << " uv";
  for (const TexturePoint& p : job.uv) out << " (" << p.u << ", " << p.v << ')';
  return out.str();
}

template <class Texel>
TriangleBaker baker(const Job<Texel>& job) {
  std::vector<Texels> mips;
  for (const Image<Texel>& image : job.mips)
    mips.push_back(TexelView<Texel>{image.texels.data(), image.width, image.height, image.width});
  return TriangleBaker(mips, job.mode, job.sampling);
}

struct Seen {
  std::uint64_t cases = 0, leaves = 0, exact = 0;
  std::array<std::uint64_t, 4> states{};
};

template <class Texel>
void expect_specified(const Job<Texel>& job, Seen& seen, std::uint32_t step = 1) {
  const std::uint32_t count = std::uint32_t{1} << (2 * job.level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  const BakeCounts counts = baker(job).bake(job.uv, job.level, map);
  ASSERT_EQ(counts.micro_triangles, count);
  seen.leaves += counts.leaves;
  seen.exact += counts.exact;
  const Expected<Texel> expected(job);
  for (std::uint32_t index = 0; index < count; index += step, ++seen.cases) {
    const int code = map[index / 4] >> (2 * (index % 4)) & 3;
    ++seen.states[static_cast<std::size_t>(code)];
    ASSERT_EQ(code, expected(index)) << named(job) << " index " << index;
  }
}

/// The code was wrong about none, and every state and both ways of deciding were among them.
void expect_varied(const Seen& seen) {
  if (sanitized) return;  // too few for that
  for (const std::uint64_t n : seen.states) EXPECT_GT(n, 0u);
  EXPECT_GT(seen.exact, 0u);
  EXPECT_LT(seen.exact, seen.leaves);
}

// ---------------------------------------------------------------------------------------------------------------------
// Random
// ---------------------------------------------------------------------------------------------------------------------

using Random = std::mt19937;

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

template <class Texel>
Texel random_texel(Random& random, int kind) {
  const auto r = static_cast<std::uint32_t>(random());
  if constexpr (std::is_same_v<Texel, float>) {
    constexpr float letters[] = {0, 1, 0.5f, -1, 2, -0.0f, 0x1p-149f, 0x1.fffffep-1f, 0x1.000002p0f};
    switch (kind) {
      case 0:
        return letters[r % 9];
      case 1:
        return letters[r % 3];
      case 2:
        return static_cast<float>(r >> 8) * 0x1p-24f;
      default: {  // any finite one
        const std::uint32_t any = r % 255 << 23 | static_cast<std::uint32_t>(random()) >> 9 | (r >> 31 << 31);
        return std::bit_cast<float>(any);
      }
    }
  } else {
    constexpr auto full = std::numeric_limits<Texel>::max();
    switch (kind) {
      case 0:
        return static_cast<Texel>(full / 5 * (r % 6));
      case 1:
        return static_cast<Texel>(r % 2 * full);
      case 2:
        return static_cast<Texel>(full / 2 - 1 + r % 4);
      default:
        return static_cast<Texel>(r);
    }
  }
}

template <class Texel>
Image<Texel> random_image(Random& random, std::uint32_t width, std::uint32_t height) {
  Image<Texel> image{width, height, {}};
  const int kind = static_cast<int>(random() % (std::is_same_v<Texel, float> ? 8 : 4)) % 7;
  for (std::uint32_t k = 0; k < width * height; ++k)
    image.texels.push_back(random_texel<Texel>(random, std::min(kind, 6) % 4));
  return image;
}

AlphaMode random_mode(Random& random) {
  constexpr float cutoffs[] = {0.5f, 0.5f, 0.2f, 1, 0, -0.5f, 2, 0x1.0101p-1f, 0x1p-149f, 0x1p120f};
  switch (random() % 3) {
    case 0:
      return Blend{};
    case 1:
      return Mask{cutoffs[random() % 10]};
    default:
      return random() % 2 == 0 ? Cutoff{128, 255} : Cutoff{1 + static_cast<std::uint32_t>(random() % 7), 5};
  }
}

template <class Texel>
Sampling random_sampling(Random& random) {
  constexpr float factors[] = {1, 1, 1, 0.5f, 0.8f, 2, 0, 0x1.fffffep-1f, 0x1p-140f, 3e30f};
  Sampling s;
  s.u = every_wrap[random() % 5];
  s.v = every_wrap[random() % 5];
  s.filter = random() % 2 == 0 ? Filter::bilinear : Filter::nearest;
  s.border = static_cast<float>(random_texel<Texel>(random, static_cast<int>(random() % 3)));
  for (float& factor : s.factors)
    if (random() % 2 == 0) factor = factors[random() % 10];
  return s;
}

/// Corners on a grid of `per` to a texel of a `size`, an ulp to either side of it, or anywhere.
float random_coordinate(Random& random, std::uint32_t size, int kind) {
  if (kind == 0) return static_cast<float>(random() >> 8) * 0x1p-23f - 0.5f;
  const auto on = static_cast<float>(static_cast<int>(random() % (8 * size)) - static_cast<int>(2 * size)) /
                  static_cast<float>(4 * size);
  if (kind == 1) return on;
  const auto way = random() % 3;
  return way == 0 ? on : way == 1 ? up(on) : down(on);
}

template <class Texel>
Job<Texel> random_job(Random& random) {
  const auto width = 1 + static_cast<std::uint32_t>(random() % 4),
             height = 1 + static_cast<std::uint32_t>(random() % 4);
  Job<Texel> job{{random_image<Texel>(random, width, height)},
                 random_mode(random),
                 random_sampling<Texel>(random),
                 {},
                 static_cast<std::uint32_t>(random() % 3)};
  const int kind = static_cast<int>(random() % 3);
  for (TexturePoint& p : job.uv)
    p = {random_coordinate(random, width, kind), random_coordinate(random, height, kind)};
  if (random() % 8 == 0) job.uv[2] = job.uv[random() % 2];
  return job;
}

template <class Texel>
class ImplBakeKinds : public testing::Test {};
using Kinds = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ImplBakeKinds, Kinds);

TYPED_TEST(ImplBakeKinds, StatesAreTheSpecifications) {
  Random random(1);
  Seen seen;
  for (int round = 0; round < (sanitized ? 60 : 800); ++round)
    ASSERT_NO_FATAL_FAILURE(expect_specified(random_job<TypeParam>(random), seen));
  expect_varied(seen);
}

TYPED_TEST(ImplBakeKinds, SeveralMipsAreTheSpecifications) {
  Random random(2);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    job.mips.push_back(random_image<TypeParam>(random, 2, 1));
    if (random() % 2 == 0) job.mips.push_back(random_image<TypeParam>(random, 1, 1));
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

TYPED_TEST(ImplBakeKinds, DilatedTheyAreTheSpecifications) {
  constexpr float margins[] = {0.25f, 1, 0.5f, 0x1p-8f, 1.0f / 3, 2.5f, 0x1p-149f, 0x1.fffffep-2f};
  Random random(3);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    job.sampling.margin = margins[random() % 8];
    if (random() % 4 == 0) job.mips.push_back(random_image<TypeParam>(random, 2, 2));
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

// ---------------------------------------------------------------------------------------------------------------------
// Families, all of them
// ---------------------------------------------------------------------------------------------------------------------

const std::vector<BaseTriangle> family_triangles{
    {{{0, 0}, {1, 0}, {0, 1}}},
    {{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}},
    {{{up(0.25f), down(0.25f)}, {down(0.75f), 0.25f}, {0.25f, up(0.75f)}}},
    {{{-0.75f, 1.25f}, {1.25f, -0.75f}, {0.25f, up(0.25f)}}},
    {{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.8f}}},
    {{{0.75f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.25f}}},
};

TEST(ImplBakeFamily, AllTexturesOf2x2ThreeLettersAreTheSpecifications) {
  Seen seen;
  std::uint64_t turn = 0;
  for (const AlphaMode& mode : {AlphaMode{Blend{}}, AlphaMode{Mask{0.5f}}})
    for (int filling = 0; filling < 81; ++filling)
      for (const Filter filter : {Filter::bilinear, Filter::nearest})
        for (const Wrap x : every_wrap) {
          if (sanitized && ++turn % 10 != 0) continue;
          Job<std::uint8_t> job{{{2, 2, {}}}, mode, {}, {}, 0};
          constexpr std::uint8_t letters[] = {0, 128, 255};
          for (int k = 0, rest = filling; k < 4; ++k, rest /= 3)
            job.mips[0].texels.push_back(letters[rest % 3]);
          job.sampling = {x, every_wrap[(filling + static_cast<int>(x)) % 5], filter,
                          static_cast<float>(letters[filling % 3])};
          for (std::size_t t = 0; t < family_triangles.size(); ++t) {
            job.uv = family_triangles[t];
            // Each of the levels for each of the triangles, over the fillings.
            job.level = static_cast<std::uint32_t>((static_cast<std::size_t>(filling) + t) % 3);
            ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
          }
        }
  expect_varied(seen);
}

// A third of a cutoff and of 1, and 0 itself: flat alpha at a limit is opaque there, and transparent at 0.
TEST(ImplBakeFamily, FlatAlphaAtALimitIsOnItsSide) {
  const auto states = [](float texel, const AlphaMode& mode, std::array<float, 2> factors, float margin) {
    Job<float> job{{{2, 2, {texel, texel, texel, texel}}}, mode, {}, family_triangles[2], 2};
    job.sampling.border = texel;
    job.sampling.factors = factors;
    job.sampling.margin = margin;
    std::vector<std::uint8_t> map(4);
    baker(job).bake(job.uv, job.level, map);
    for (const std::uint8_t byte : map) EXPECT_EQ(byte, map[0]);
    return map[0];
  };
  constexpr std::uint8_t T = 0, O = 0x55, UT = 0xaa, UO = 0xff;
  for (const float margin : {0.0f, 0.75f}) {
    EXPECT_EQ(states(0.5f, Mask{0.25f}, {0.5f, 1}, margin), O);
    EXPECT_EQ(states(down(0.5f), Mask{0.25f}, {0.5f, 1}, margin), T);
    EXPECT_EQ(states(0.5f, Mask{0.25f}, {down(0.5f), 1}, margin), T);
    EXPECT_EQ(states(0x1p-100f, Mask{0x1p-149f}, {0x1p-49f, 1}, margin), O);
    EXPECT_EQ(states(0x1p-100f, Mask{0x1p-149f}, {0x1p-25f, down(0x1p-24f)}, margin), T);
    EXPECT_EQ(states(0, Mask{0}, {0, 1}, margin), O);
    EXPECT_EQ(states(1, Mask{0x1p-149f}, {0, 1}, margin), T);
    EXPECT_EQ(states(-1, Mask{-1}, {1, 1}, margin), O);
    EXPECT_EQ(states(4, Blend{}, {0.5f, 0.5f}, margin), O);
    EXPECT_EQ(states(down(4.0f), Blend{}, {0.5f, 0.5f}, margin), UO);
    EXPECT_EQ(states(down(2.0f), Blend{}, {0.5f, 0.5f}, margin), UT);
    EXPECT_EQ(states(2, Blend{}, {0.5f, 0.5f}, margin), UO);
    EXPECT_EQ(states(0x1p-149f, Blend{}, {0x1p-149f, 1}, margin), UT);
    EXPECT_EQ(states(-0.0f, Blend{}, {1, 1}, margin), T);
    EXPECT_EQ(states(-3, Blend{}, {1, 1}, margin), T);
    EXPECT_EQ(states(3, Blend{}, {0, 1}, margin), T);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Hostile
// ---------------------------------------------------------------------------------------------------------------------

TYPED_TEST(ImplBakeKinds, SliversAreTheSpecifications) {
  Random random(4);
  Seen seen;
  for (int round = 0; round < (sanitized ? 10 : 100); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    const float x = static_cast<float>(random() % 8) / 8, y = static_cast<float>(random() % 8) / 8,
                thin = 0x1p-20f * static_cast<float>(1 + random() % 3),
                length = 1 + static_cast<float>(random() % 3);
    job.uv = {{{x, y}, {x + length, random() % 2 == 0 ? y + length : y}, {x, y + thin}}};
    if (random() % 2 == 0)
      for (TexturePoint& p : job.uv) std::swap(p.u, p.v);
    if (random() % 4 == 0) job.sampling.margin = 0x1p-20f;
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
}

TYPED_TEST(ImplBakeKinds, ExtremeCoordinatesAreTheSpecifications) {
  constexpr float least = std::numeric_limits<float>::denorm_min();
  const float greatest = down(0x1p20f), normal_one = std::numeric_limits<float>::min();
  const std::vector<BaseTriangle> triangles{
      {{{least, 0}, {0, -least}, {1, 1}}},
      {{{0.25f, 0.25f}, {1, least}, {-normal_one, 1}}},
      {{{0.25f, 0.25f}, {0.75f, 0x1p-30f}, {-0x1p-28f, 0.75f}}},
      {{{greatest, -greatest}, {down(greatest), -greatest}, {greatest, -down(down(greatest))}}},
      {{{100000.25f, 7.5f}, {100001, 7.25f}, {100000, 8}}},
  };
  Random random(5);
  Seen seen;
  for (const BaseTriangle& uv : triangles)
    for (int round = 0; round < (sanitized ? 2 : 12); ++round) {
      Job<TypeParam> job = random_job<TypeParam>(random);
      job.uv = uv;
      ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
    }
}

// Real sizes, at a level where micro-triangles are about a texel.
TYPED_TEST(ImplBakeKinds, DeepLevelsAreTheSpecifications) {
  Random random(6);
  Seen seen;
  constexpr bool floats = std::is_same_v<TypeParam, float>;
  constexpr double full = floats ? 1 : static_cast<double>(std::numeric_limits<TypeParam>::max());
  Job<TypeParam> job{{{61, 47, {}}}, Mask{0.5f}, {}, {{{0.11f, 0.07f}, {0.93f, 0.31f}, {0.38f, 0.97f}}}, 6};
  for (std::uint32_t k = 0; k < 61 * 47; ++k) {
    const double alpha = 0.5 + 0.05 * (20 - std::hypot(k % 61 - 30.0, k / 61 - 23.0)) +
                         static_cast<int>(random() % 20) * 0.005;
    const double stored = full * std::clamp(alpha, 0.0, 1.0);
    job.mips[0].texels.push_back(static_cast<TypeParam>(floats ? stored : std::floor(stored)));
  }
  for (const AlphaMode& mode : {AlphaMode{Mask{0.5f}}, AlphaMode{Blend{}}})
    for (const Filter filter : {Filter::bilinear, Filter::nearest})
      for (const float margin : {0.0f, 0.5f}) {
        job.mode = mode;
        job.sampling.filter = filter;
        job.sampling.margin = margin;
        ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, sanitized ? 997 : 83));
      }
  for (const std::uint64_t n : seen.states) EXPECT_GT(n, 0u);
  EXPECT_LT(seen.exact, seen.leaves);
}

// ---------------------------------------------------------------------------------------------------------------------
// Vectors
// ---------------------------------------------------------------------------------------------------------------------

/// A texture that has room around most micro-triangles, which the vector code asks for: noise, flat but for a
/// few texels, or slanted; at a limit or across it.
template <class Texel>
Image<Texel> roomy_image(Random& random) {
  const auto side = [&random] { return 24 + static_cast<std::uint32_t>(random() % 30); };
  Image<Texel> image{side(), side(), {}};
  constexpr bool floats = std::is_same_v<Texel, float>;
  constexpr double full = floats ? 1 : static_cast<double>(std::numeric_limits<Texel>::max());
  const auto kind = random() % 4;
  // At a cutoff, or far above it: what differs inside of a micro-triangle may then be all that tells.
  const Texel flat = static_cast<Texel>(random() % 2 == 0 ? full : floats ? 0.5 : full / 2 + 1);
  const double slope_x = static_cast<int>(random() % 9) - 4, slope_y = static_cast<int>(random() % 9) - 4;
  for (std::uint32_t k = 0; k < image.width * image.height; ++k) {
    const double slant = 0.5 + (slope_x * (k % image.width - 20.0) + slope_y * (k / image.width - 20.0)) / 64;
    const double alpha = std::clamp(slant, 0.0, 1.0) * full;
    image.texels.push_back(kind == 0   ? random_texel<Texel>(random, 2)
                           : kind == 1 ? random_texel<Texel>(random, 1)
                           : kind == 2 ? (random() % 40 == 0 ? random_texel<Texel>(random, 1) : flat)
                                       : static_cast<Texel>(floats ? alpha : std::floor(alpha)));
  }
  return image;
}

/// Of one shape, from slivers to right angles, on texel lines, on centres and off them.
template <class Texel>
Job<Texel> roomy_job(Random& random) {
  Job<Texel> job{{roomy_image<Texel>(random)},
                 random() % 3 == 0 ? AlphaMode{Blend{}} : AlphaMode{Mask{0.5f}},
                 {},
                 {},
                 2 + static_cast<std::uint32_t>(random() % 3)};
  // At the flat texels.
  if (random() % 3 == 0 && std::is_same_v<Texel, std::uint8_t>) job.mode = Cutoff{128, 255};
  if (random() % 3 == 0 && std::is_same_v<Texel, std::uint16_t>) job.mode = Cutoff{32768, 65535};
  job.sampling.u = every_wrap[random() % 5];
  job.sampling.v = every_wrap[random() % 5];
  if (random() % 4 == 0) job.sampling.factors[0] = 0.75f;
  const auto near = [&](std::uint32_t size) {
    const int kind = static_cast<int>(random() % 4);
    if (kind == 0) return 0.1f + 0.8f * (static_cast<float>(random() >> 8) * 0x1p-24f);
    const auto on = static_cast<float>(4 + random() % (2 * size - 8)) / static_cast<float>(2 * size);
    return kind == 1 ? on : kind == 2 ? up(on) : down(on);
  };
  for (TexturePoint& p : job.uv) p = {near(job.mips[0].width), near(job.mips[0].height)};
  if (random() % 6 == 0) job.uv[2] = {up(job.uv[0].u), down(job.uv[1].v)};
  if (random() % 12 == 0) job.uv[2] = job.uv[0];
  if (random() % 4 == 0)
    for (TexturePoint& p : job.uv) p = {p.u + 3, p.v - 5};
  return job;
}

TYPED_TEST(ImplBakeKinds, TexturesWithRoomAreTheSpecifications) {
  Random random(7);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    const Job<TypeParam> job = roomy_job<TypeParam>(random);
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 7 + static_cast<std::uint32_t>(random() % 5)));
  }
  expect_varied(seen);
}

// Micro-triangles of forty texels, most of them alike, which are judged by their parts.
TYPED_TEST(ImplBakeKinds, LargeMicroTrianglesAreTheSpecifications) {
  Random random(9);
  Seen seen;
  for (int round = 0; round < (sanitized ? 2 : 12); ++round) {
    constexpr std::uint32_t side = 180;
    Job<TypeParam> job{{{side, side, {}}}, Mask{0.5f}, {}, {}, 2};
    const auto full = random_texel<TypeParam>(random, 1);
    constexpr TypeParam most =
        std::is_same_v<TypeParam, float> ? TypeParam{1} : std::numeric_limits<TypeParam>::max();
    const TypeParam other = full > 0 ? TypeParam{0} : most;
    // Half of it, or ten texels of it, are different.
    for (std::uint32_t k = 0; k < side * side; ++k)
      job.mips[0].texels.push_back(round % 2 == 0 && k % side + k / side > side ? other : full);
    for (int k = 0; k < 10; ++k) job.mips[0].texels[random() % (side * side)] = other;
    for (TexturePoint& p : job.uv)
      p = {static_cast<float>(random() % 1001) / 1000, static_cast<float>(random() % 1001) / 1000};
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 5));
  }
}

// Whatever the vectors' width, and at levels where micro-triangles are far smaller than a texel.
TYPED_TEST(ImplBakeKinds, EveryTargetMakesTheSameMap) {
  using Maps = std::vector<std::vector<std::uint8_t>>;
  const auto bake = [] {
    Random random(8);
    Maps maps;
    for (int round = 0; round < (sanitized ? 10 : 60); ++round) {
      Job<TypeParam> job = roomy_job<TypeParam>(random);
      job.level = static_cast<std::uint32_t>(random() % 8);
      maps.emplace_back(job.level == 0 ? 1 : std::size_t{1} << (2 * job.level - 2));
      baker(job).bake(job.uv, job.level, maps.back());
    }
    return maps;
  };
  const Maps expected = bake();
  on_every_target([&] { EXPECT_EQ(bake(), expected); });
}

// ---------------------------------------------------------------------------------------------------------------------
// Errors
// ---------------------------------------------------------------------------------------------------------------------

template <class Make>
std::string error_of(Make make) {
  try {
    make();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

TEST(ImplBakeErrors, NameWhatIsWrong) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity();
  const Job<float> fine{{{2, 2, {0, 1, 0, 1}}}, Mask{0.5f}, {}, family_triangles[0], 1};
  const auto error = [&](auto change) {
    Job<float> job = fine;
    change(job);
    return error_of([&] { baker(job); });
  };
  EXPECT_EQ(error([](auto&) {}), "none");
  EXPECT_EQ(error([](auto& job) { job.mips.clear(); }), "bake: no mip level");
  for (const float bad : {nan, infinite, -infinite}) {
    EXPECT_EQ(error([&](auto& job) { job.mips[0].texels[2] = bad; }), "bake: texel (0, 1) is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.border = bad; }), "bake: a border that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.factors[1] = bad; }), "bake: a factor that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.sampling.margin = bad; }), "bake: a margin that is not finite");
    EXPECT_EQ(error([&](auto& job) { job.mode = Mask{bad}; }), "bake: a cutoff that is not finite");
  }
  EXPECT_EQ(error([](auto& job) { job.sampling.factors[0] = -1; }), "bake: a factor below 0");
  EXPECT_EQ(error([](auto& job) { job.sampling.margin = -1; }), "bake: a margin below 0");
  EXPECT_EQ(error([](auto& job) { job.sampling.margin = 0x1p20f; }), "bake: a margin of 2^20 texels or more");
  EXPECT_EQ(error([](auto& job) { job.mode = Cutoff{1, 0}; }), "bake: a cutoff over 0");
  const std::vector<std::uint8_t> bytes(4);
  const auto of_bytes = [&](const AlphaView& view, float border) {
    const Texels mip = view;
    return error_of([&] {
      TriangleBaker({&mip, 1}, Mask{}, {Wrap::repeat, Wrap::repeat, Filter::bilinear, border});
    });
  };
  EXPECT_EQ(of_bytes({bytes.data(), 2, 2, 2}, 255), "none");
  for (const float border : {-1.0f, 256.0f, 0.5f})
    EXPECT_EQ(of_bytes({bytes.data(), 2, 2, 2}, border), "bake: a border that is no such texel");
  EXPECT_EQ(of_bytes({nullptr, 2, 2, 2}, 0), "bake: a texture without texels");
  EXPECT_EQ(of_bytes({bytes.data(), 2, 2, ~std::size_t{0} / 2}, 0),
            "bake: a texture larger than memory can be");
  for (const auto& [width, height] : {std::pair{0u, 2u}, {2u, 0u}, {16385u, 1u}, {1u, 0xffffffffu}})
    EXPECT_EQ(of_bytes({bytes.data(), width, height, 2}, 0),
              "bake: a texture has 1 to 16384 texels along each side");
}

}  // namespace
