// The index of a point, by Vulkan's words or by Algorithm 4.
#include "tests/foreign/tree/point.hpp"

#include <algorithm>
#include <cmath>

#include "tests/foreign/tree/faults.hpp"

namespace mmverify::tests::foreign::tree {
namespace {

/// Algorithm 4 as printed, in the given arithmetic.
template <class Real>
std::uint32_t stepped(unsigned level, Real u, Real v, bool ties = true) {
  Real w = 1 - u - v;
  std::uint32_t index = 0;
  bool mid = false, top = false;
  for (unsigned depth = 0; depth < level; ++depth) {
    const std::uint32_t left = top ? 2 : 0, right = top ? 0 : 2;
    const Real half = Real(1) / 2;
    if (w > half) {
      const Real next = w - u - v;
      u = 2 * u, v = 2 * v, w = next, index = 4 * index + left;
    } else if (v >= half && !(ties && v == half && mid)) {
      const Real next = v - u - w;
      u = 2 * u, w = 2 * w, v = next, index = 4 * index + 3, top = !top;
    } else if (u >= half && !(ties && v == half && mid)) {
      const Real next = u - v - w;
      v = 2 * v, w = 2 * w, u = next, index = 4 * index + right;
    } else {
      const Real nu = u + v - w, nv = w + u - v, nw = v + w - u;
      u = nu, v = nv, w = nw, index = 4 * index + 1, mid = !mid;
    }
  }
  return index;
}

std::uint32_t spread(std::uint32_t x) {
  std::uint32_t wide = 0;
  for (unsigned b = 0; b < 16; ++b) wide |= (x >> b & 1u) << (2 * b);
  return wide;
}

/// A number cut to `bits` significant bits.
float shortened(float x, int bits) {
  int exponent = 0;
  const float significand = std::frexp(x, &exponent);
  return std::ldexp(std::trunc(std::ldexp(significand, bits)), exponent - bits);
}

}  // namespace

std::uint32_t index_of(unsigned level, float u, float v) {
  if (has(point_of_16_bits)) u = std::floor(u * 65536) / 65536, v = std::floor(v * 65536) / 65536;
  if (has(point_of_binary16)) u = shortened(u, 11), v = shortened(v, 11);
  if (has(point_of_20_significant_bits)) u = shortened(u, 20), v = shortened(v, 20);
  if (has(point_nudged)) u += 1.0f / 16777216, v += 1.0f / 16777216;
  if (has(point_by_steps_in_binary32)) return stepped<float>(level, u, v);
  if (has(point_by_steps_in_binary32_from_level_4) && level >= 4) return stepped<float>(level, u, v);
  if (has(point_by_steps_without_ties)) return stepped<double>(level, u, v, false);
  const std::uint32_t n = 1u << level;
  const double un = std::clamp<double>(u, 0, 1) * n, vn = std::clamp<double>(v, 0, 1) * n;
  std::uint32_t iu = std::min(static_cast<std::uint32_t>(un), n - 1);
  std::uint32_t iv = std::min(static_cast<std::uint32_t>(vn), n - 1);
  const double uf = un - std::floor(un), vf = vn - std::floor(vn);
  const std::uint32_t sum = iu + iv;
  if (sum >= n) {
    if (has(point_lowers_v))
      iv -= std::min(iv, sum - n + 1);
    else if (!has(point_leaves_the_triangle))
      iu -= std::min(iu, sum - n + 1);
  }
  bool beyond = vf >= 1 - uf;
  if (has(point_sum_in_binary32)) beyond = static_cast<float>(uf) + static_cast<float>(vf) >= 1;
  if (has(point_diagonal_is_below)) beyond = uf + vf > 1;
  if (has(point_diagonal_is_below_from_level_3) && level >= 3) beyond = uf + vf > 1;
  if (has(point_w_in_binary32))
    beyond = n - 1 - sum != static_cast<std::uint32_t>(std::max(0.0f, (1 - u - v) * static_cast<float>(n)));
  std::uint32_t iw = ~(iu + iv);
  const bool on_hypotenuse = has(point_hypotenuse_as_inside) ? sum < n : sum < n - 1;
  if (beyond && on_hypotenuse) --iw;
  const std::uint32_t b0 = ~(iu ^ iw) & (n - 1), t = (iu ^ iv) & b0;
  std::uint32_t f = t;
  f ^= f >> 1;
  f ^= f >> 2;
  f ^= f >> 4;
  if (!has(point_prefix_of_8_bits)) f ^= f >> 8;
  const std::uint32_t b1 = ((f ^ iu) & ~b0 & (n - 1)) | t;
  return spread(b0) | spread(b1) << 1;
}

}  // namespace mmverify::tests::foreign::tree
