#include "impl/bake/level.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "impl/common/binary.hpp"
#include "impl/common/wide.hpp"

namespace mmverify::impl::bake {
namespace {

/// A vertex in texels: both products are exact, in 24 + 15 bits.
struct Corner {
  TexturePoint uv;
  double x, y;
};

// A coordinate is a multiple of 2^-149 and below 2^128.  So a side in texels is below 2^(128 + 15 + 149) of these units,
// a sum of two squares below 2^586.
constexpr int finest = -149;
using Square = Wide<10>;
static_assert(2 * (128 + 15 - finest) + 1 < 64 * 10);

/// texels (b - a), in units of 2^finest.
Square side(float a, float b, std::uint32_t texels) noexcept {
  const auto whole = [](float x) {
    const Binary taken = binary(x);
    return taken.m == 0 ? Square(0) : Square(taken.m) << (taken.e - finest);
  };
  return (whole(b) - whole(a)) * Square(texels);
}

// The relative error of `square`, doubled: three roundings, and one of each difference, are less than 8 units of 2^-53.
constexpr double slack = 0x1p-49;

/// |b - a|^2 <= 4^n.
bool at_most(const Corner& a, const Corner& b, std::uint32_t width, std::uint32_t height,
             std::uint32_t n) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double bound = std::ldexp(1.0, 2 * static_cast<int>(n));
  if (square * (1 + slack) <= bound) return true;
  if (square * (1 - slack) > bound) return false;
  const Square x = side(a.uv.u, b.uv.u, width), y = side(a.uv.v, b.uv.v, height);
  return x * x + y * y <= Square(1) << (2 * static_cast<int>(n) - 2 * finest);
}

}  // namespace

UsefulLevel useful_level(const BaseTriangle& uv, std::uint32_t width, std::uint32_t height,
                         std::uint32_t limit) noexcept {
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {uv[k], double{uv[k].u} * width, double{uv[k].v} * height};
  const std::uint32_t most = std::min(max_bake_level, limit);
  std::uint32_t level = 0;
  for (std::size_t k = 0; k < 3; ++k)
    while (!at_most(corners[k], corners[(k + 1) % 3], width, height, level)) {
      if (level == most) return {most, true};
      ++level;
    }
  return {level, false};
}

}  // namespace mmverify::impl::bake
