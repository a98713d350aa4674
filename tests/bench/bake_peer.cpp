// Times meshopt_opacityMapRasterize and TriangleBaker::bake() by direct calls, on one thread, for triangles of several
// sizes on three textures.  Both get the same texels and coordinates: 4-state, 8 bits, bilinear, clamp, cutoff 1/2.
// Each texture is prepared once for TriangleBaker, before its times are taken; meshoptimizer prepares none.
// scripts/bake-cells builds and runs it; it writes one line for each cell:
//   TEXTURE EDGE LEVEL OURS THEIRS RATIO
// EDGE: a triangle's edge in texels; OURS and THEIRS: the median ns a micro-triangle; RATIO: the median of
// THEIRS / OURS, round by round.
// usage: cells [ROUNDS [TEXTURE [EDGE [LEVEL]]]]     a part alone; 0 for all
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/rounds.hpp"
#include "impl/bake/triangles.hpp"

namespace {

using mmverify::bench::Work;
namespace bake = mmverify::impl::bake;

constexpr std::uint32_t side = 1024, levels = 9;
constexpr std::array<int, 4> edges{8, 16, 64, 256};
using Texels = std::vector<std::uint8_t>;

template <class Alpha>
Texels texture(Alpha alpha) {
  Texels texels(std::size_t{side} * side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      texels[x + std::size_t{side} * y] =
          static_cast<std::uint8_t>(std::lround(std::fmin(255, std::fmax(0, alpha(x, y)))));
  return texels;
}

/// Leaves of 100 by 40 texels at any angle, one in each square of 128 texels.  Their edges ramp over two texels.
Texels leaves() {
  std::mt19937 random(1);
  constexpr std::uint32_t cell = 128;
  std::array<double, (side / cell) * (side / cell)> angles;
  for (double& angle : angles) angle = static_cast<double>(random() % 360) * std::numbers::pi / 180;
  return texture([&](std::uint32_t x, std::uint32_t y) {
    const double angle = angles[x / cell + side / cell * (y / cell)], c = std::cos(angle),
                 s = std::sin(angle);
    const double dx = x % cell - 63.5, dy = y % cell - 63.5, along = (dx * c + dy * s) / 50,
                 across = std::fabs(dy * c - dx * s);
    return 127.5 + 127.5 * (20 * (1 - along * along) - across);
  });
}

/// A contour every 16 texels across and every 11 down, as in examples/adapters/time_bakes.cpp.
Texels waves() {
  return texture([](std::uint32_t x, std::uint32_t y) {
    return 127.5 + 127.5 * std::sin(x * 0.2) * std::sin(y * 0.28);
  });
}

/// A contour in nearly each texel.
Texels noise() {
  std::mt19937 random(2);
  return texture([&](std::uint32_t, std::uint32_t) { return random() % 256; });
}

/// Equilateral triangles of this edge in texels, anywhere in the texture, at any angle.
std::vector<bake::BaseTriangle> triangles(int edge, std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<bake::BaseTriangle> all(count);
  const double radius = edge / std::sqrt(3.0);
  for (bake::BaseTriangle& uv : all) {
    const double x = radius + any(random) * (side - 2 * radius),
                 y = radius + any(random) * (side - 2 * radius), turn = any(random) * 2 * std::numbers::pi;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = turn + static_cast<double>(k) * 2 * std::numbers::pi / 3;
      uv[k] = {static_cast<float>((x + radius * std::cos(angle)) / side),
               static_cast<float>((y + radius * std::sin(angle)) / side)};
    }
  }
  return all;
}

void measure(const char* name, const Texels& texels, int edge, std::uint32_t level, std::size_t rounds) {
  const std::size_t micro = std::size_t{1} << 2 * level,
                    count = std::clamp<std::size_t>((1 << 18) / micro, 4, 1024);
  const std::vector<bake::BaseTriangle> all = triangles(edge, count);
  const bake::TriangleBaker baker(bake::AlphaView{texels.data(), side, side, side}, bake::Cutoff{1, 2},
                                  bake::Addressing{bake::Wrap::clamp_to_edge, bake::Wrap::clamp_to_edge});
  std::vector<std::uint8_t> ours(micro / 4), theirs(micro / 4);
  const std::vector<Work> works{{count * micro,
                                 [&] {
                                   for (const bake::BaseTriangle& uv : all) baker.bake(uv, level, ours);
                                 }},
                                {count * micro, [&] {
                                   for (const bake::BaseTriangle& uv : all)
                                     meshopt_opacityMapRasterize(theirs.data(), static_cast<int>(level), 4,
                                                                 &uv[0].u, &uv[1].u, &uv[2].u, texels.data(),
                                                                 1, side, side, side);
                                 }}};
  const mmverify::bench::RoundTimes times = mmverify::bench::times_in_rounds(works, rounds);
  std::printf("%s %d %u %.2f %.2f %.2f\n", name, edge, level, mmverify::bench::median(times[0]),
              mmverify::bench::median(times[1]), mmverify::bench::median_ratio(times[1], times[0]));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int k) { return count > k ? std::atoi(arguments[k]) : 0; };
  const std::size_t rounds = number(1) > 0 ? static_cast<std::size_t>(number(1)) : 15;
  const std::string only = count > 2 ? arguments[2] : "0";
  const std::array<std::pair<const char*, Texels (*)()>, 3> textures{
      {{"leaves", leaves}, {"waves", waves}, {"noise", noise}}};
  for (const auto& [name, made] : textures) {
    if (only != "0" && only != name) continue;
    const Texels texels = made();
    for (const int edge : edges)
      for (std::uint32_t level = 1; level <= levels; ++level)
        if ((number(3) == 0 || number(3) == edge) &&
            (number(4) == 0 || static_cast<std::uint32_t>(number(4)) == level))
          measure(name, texels, edge, level, rounds);
  }
}
