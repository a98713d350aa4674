// [release] Bakes with room: textures far larger than a micro-triangle, and micro-triangles of many texels, as
// spec/bake/state.hpp has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_bake_room_test {

namespace spec = mmverify::spec::bake;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;
using namespace mmverify::impl::bake;
using Random = std::mt19937;

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
  Image<Texel> image;
  AlphaMode mode;
  Sampling sampling;
  BaseTriangle uv;
  std::uint32_t level;
};

// ---- The specification's side

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
  using Texture = spec::TextureOf<decltype(specified(Texel{}))>;
  const Job<Texel>& job;
  std::vector<Texture> mips;

  explicit Expected(const Job<Texel>& j) : job(j) {
    const Sampling& s = job.sampling;
    Texture t{job.image.width, job.image.height};
    for (const Texel r : job.image.texels) t.alpha.push_back(specified(r));
    t.wrap_x = static_cast<spec::Wrap>(s.u);
    t.wrap_y = static_cast<spec::Wrap>(s.v);
    t.border = specified(static_cast<Texel>(s.border));
    t.factor = bits(s.factors[0]);
    t.vertex_factor = bits(s.factors[1]);
    mips.push_back(t);
  }

  template <class Q>
  int in(std::uint32_t index) const {
    const auto vertex = [&](std::size_t k) { return spec::place<Q>(bits(job.uv[k].u), bits(job.uv[k].v)); };
    const spec::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
    const auto state = [&](const auto& mode) {
      return static_cast<int>(spec::micro_state(std::span<const Texture>(mips), base, job.level, index, mode,
                                                spec::number<Q>(bits(job.sampling.margin))));
    };
    if (const auto* const mask = std::get_if<Mask>(&job.mode))
      return state(spec::Mask<Q>{spec::number<Q>(bits(mask->cutoff))});
    if (const auto* const cutoff = std::get_if<Cutoff>(&job.mode))
      return state(spec::Mask<Q>{spec::fraction<Q>(cutoff->numerator, cutoff->denominator)});
    return state(spec::Blend<Q>{});
  }

  /// The state, in 128 bits where they will do.
  int operator()(std::uint32_t index) const {
    try {
      return in<Rational128>(index);
    } catch (const std::overflow_error&) {
    } catch (const std::range_error&) {
    }
    return in<Rational>(index);
  }
};

struct Seen {
  std::uint64_t leaves = 0, exact = 0;
  std::array<std::uint64_t, 4> states{};
};

/// Bakes, and holds every `step`-th state against the specification.
template <class Texel>
void expect_specified(const Job<Texel>& job, Seen& seen, std::uint32_t step) {
  const std::uint32_t count = std::uint32_t{1} << (2 * job.level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  const Texels texels =
      TexelView<Texel>{job.image.texels.data(), job.image.width, job.image.height, job.image.width};
  const BakeCounts counts = TriangleBaker({&texels, 1}, job.mode, job.sampling).bake(job.uv, job.level, map);
  ASSERT_EQ(counts.micro_triangles, count);
  seen.leaves += counts.leaves;
  seen.exact += counts.exact;
  const Expected<Texel> expected(job);
  for (std::uint32_t index = 0; index < count; index += step) {
    const int code = map[index / 4] >> (2 * (index % 4)) & 3;
    ++seen.states[static_cast<std::size_t>(code)];
    ASSERT_EQ(code, expected(index)) << "index " << index;
  }
}

/// The code was wrong about none, and every state and both ways of deciding were among them.
void expect_varied(const Seen& seen) {
  if (sanitized) return;  // too few for that
  for (const std::uint64_t n : seen.states) EXPECT_GT(n, 0u);
  EXPECT_GT(seen.exact, 0u);
  EXPECT_LT(seen.exact, seen.leaves);
}

// ---- Random

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

/// The least or the greatest, for floats also a half; with `anywhere` any in [0, 1), for whole numbers about the middle.
template <class Texel>
Texel random_texel(Random& random, bool anywhere) {
  const auto r = static_cast<std::uint32_t>(random());
  if constexpr (std::is_same_v<Texel, float>) {
    constexpr float letters[] = {0, 1, 0.5f};
    return anywhere ? static_cast<float>(r >> 8) * 0x1p-24f : letters[r % 3];
  } else {
    constexpr auto full = std::numeric_limits<Texel>::max();
    return static_cast<Texel>(anywhere ? full / 2 - 1 + r % 4 : r % 2 * full);
  }
}

template <class Texel>
class ImplBakeRoom : public testing::Test {};
using TexelTypes = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ImplBakeRoom, TexelTypes);

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
    image.texels.push_back(kind == 0   ? random_texel<Texel>(random, true)
                           : kind == 1 ? random_texel<Texel>(random, false)
                           : kind == 2 ? (random() % 40 == 0 ? random_texel<Texel>(random, false) : flat)
                                       : static_cast<Texel>(floats ? alpha : std::floor(alpha)));
  }
  return image;
}

/// One shape, from slivers to right angles, on texel lines, on centres and off them.
template <class Texel>
Job<Texel> roomy_job(Random& random) {
  Job<Texel> job{roomy_image<Texel>(random),
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
  for (TexturePoint& p : job.uv) p = {near(job.image.width), near(job.image.height)};
  if (random() % 6 == 0) job.uv[2] = {up(job.uv[0].u), down(job.uv[1].v)};
  if (random() % 12 == 0) job.uv[2] = job.uv[0];
  if (random() % 4 == 0)
    for (TexturePoint& p : job.uv) p = {p.u + 3, p.v - 5};
  return job;
}

TYPED_TEST(ImplBakeRoom, TexturesWithRoomAreTheSpecifications) {
  mmverify::tests::on_every_target([] {
    Random random(7);
    Seen seen;
    for (int round = 0; round < (sanitized ? 20 : 300); ++round) {
      Job<TypeParam> job = roomy_job<TypeParam>(random);
      if (round % 2 == 0)
        job.level = static_cast<std::uint32_t>(round % 3);  // more rows than a vector has lanes
      ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 7 + static_cast<std::uint32_t>(random() % 5)));
    }
    expect_varied(seen);
  });
}

// Micro-triangles of forty texels, most of them alike, which are judged by their parts.
TYPED_TEST(ImplBakeRoom, LargeMicroTrianglesAreTheSpecifications) {
  Random random(9);
  Seen seen;
  for (int round = 0; round < (sanitized ? 2 : 12); ++round) {
    constexpr std::uint32_t side = 180;
    Job<TypeParam> job{{side, side, {}}, Mask{0.5f}, {}, {}, 2};
    const auto full = random_texel<TypeParam>(random, false);
    constexpr TypeParam most =
        std::is_same_v<TypeParam, float> ? TypeParam{1} : std::numeric_limits<TypeParam>::max();
    const TypeParam other = full > 0 ? TypeParam{0} : most;
    // Half of it, or ten texels of it, are different.
    for (std::uint32_t k = 0; k < side * side; ++k)
      job.image.texels.push_back(round % 2 == 0 && k % side + k / side > side ? other : full);
    for (int k = 0; k < 10; ++k) job.image.texels[random() % (side * side)] = other;
    for (TexturePoint& p : job.uv)
      p = {static_cast<float>(random() % 1001) / 1000, static_cast<float>(random() % 1001) / 1000};
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 5));
  }
}

}  // namespace impl_bake_room_test
