// A bake of any kind, for both sides: what impl makes of it, and the specification; drawn at random.
#pragma once

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
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {

using namespace mmverify::impl::bake;
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

/// Bakes, and holds every `step`-th state against spec/bake/state.hpp.  Texel: uint8_t, uint16_t or float; compiled once,
/// in bake_jobs.cpp.
template <class Texel>
void expect_specified(const Job<Texel>& job, Seen& seen, std::uint32_t step = 1);

/// The code was wrong about none, and every state and both ways of deciding were among them.
inline void expect_varied(const Seen& seen) {
  if (sanitized) return;  // too few for that
  for (const std::uint64_t n : seen.states) EXPECT_GT(n, 0u);
  EXPECT_GT(seen.exact, 0u);
  EXPECT_LT(seen.exact, seen.leaves);
}

// ---------------------------------------------------------------------------------------------------------------------
// Random
// ---------------------------------------------------------------------------------------------------------------------

using Random = std::mt19937;

inline float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
inline float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

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

inline AlphaMode random_mode(Random& random) {
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
inline float random_coordinate(Random& random, std::uint32_t size, int kind) {
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

}  // namespace mmverify::tests
