// The point at which a ray hits a triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mmverify::render {

/// u and v belong to the second and the third vertex, as in Embree; w = 1 - u - v belongs to the first.
struct Barycentrics {
  float u, v;
  friend constexpr bool operator==(const Barycentrics&, const Barycentrics&) = default;
};

/// Moves a hit that rounding put beside its triangle into the triangle.  u and v are clamped to [0,1]; then u
/// is lowered to the greatest float with u + v <= 1, exactly.  A point of the triangle stays as it is.
/// Texture and micromap thus decide about the same point.  The rule beyond the diagonal is the reference
/// code's.
/// Domain: every bit pattern; NaN counts as 0.
inline Barycentrics in_triangle(float u, float v) noexcept {
  u = std::min(std::max(0.0f, u), 1.0f);
  v = std::min(std::max(0.0f, v), 1.0f);
  // 1 - v is exact in double for v >= 2^-29, and v = 0; below, only u = 1 is too much.
  const double room = 1.0 - double{v};
  if (v > 0 && v < 0x1p-29f) return {std::min(u, 1.0f - 0x1p-24f), v};
  if (!(double{u} > room)) return {u, v};
  const float most = static_cast<float>(room);
  return {double{most} > room ? std::nextafter(most, 0.0f) : most, v};
}

/// The grid cell of a barycentric b = w, u or v (number 0, 1, 2), N = 2^n: floor(N b), at most N - 1, and
/// ceil(N b) - 1, at least 0.
/// Both are exact: N u and N v are exact, and a fraction only drops leading bits.  The test whether two
/// fractions sum to 1 is lesser <= 1 - greater, as in impl/index/index.hpp.
/// Domain: a point of the triangle, n in 0..16.
struct GridPlace {
  std::uint32_t floor, below;
};
inline GridPlace grid_place(const Barycentrics& b, unsigned number, unsigned n) noexcept {
  const std::int32_t N = std::int32_t{1} << n;
  const float side = static_cast<float>(N);
  const float un = b.u * side, vn = b.v * side;
  const auto iu = static_cast<std::int32_t>(un), iv = static_cast<std::int32_t>(vn);
  const float uf = un - static_cast<float>(iu), vf = vn - static_cast<float>(iv);
  std::int32_t low = 0, high = 0;
  if (number == 0) {
    // N w = N - (iu + iv) - (uf + vf).
    const float lesser = std::min(uf, vf), greater = std::max(uf, vf);
    const std::int32_t up = greater == 0 ? 0 : lesser <= 1.0f - greater ? 1 : 2;
    const std::int32_t down = lesser >= 1.0f - greater ? 1 : 0;
    low = N - (iu + iv) - up;
    high = N - (iu + iv) - down;
  } else {
    const std::int32_t whole = number == 1 ? iu : iv;
    low = whole;
    high = whole + ((number == 1 ? uf : vf) > 0 ? 1 : 0);
  }
  return {static_cast<std::uint32_t>(std::clamp(low, 0, N - 1)),
          static_cast<std::uint32_t>(std::clamp(high - 1, 0, N - 1))};
}

}  // namespace mmverify::render
