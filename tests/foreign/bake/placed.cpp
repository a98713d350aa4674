// A triangle and its margin, from texture coordinates to texels of a mip.
#include "tests/foreign/bake/placed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "tests/foreign/bake/addressing.hpp"
#include "tests/foreign/bake/faults.hpp"

namespace mmverify::tests::foreign::bake {

bool is_far(const mmverify_bake_case_t& c) {
  return std::any_of(c.uv, c.uv + 6, [](float x) { return std::abs(x) > 1000; });
}

namespace {

std::array<Dyadic, 6> coordinates_of(const mmverify_bake_case_t& c) {
  std::array<Dyadic, 6> uv;
  float whole[2] = {};
  if (has(far_repeats_in_float) && is_far(c))
    for (int a = 0; a < 2; ++a) whole[a] = std::floor(c.uv[a] / 2) * 2;
  for (std::size_t k = 0; k < 6; ++k) {
    float x = c.uv[k];
    if (!std::isfinite(x)) throw Declined{};
    if (has(far_repeats_in_float) && is_far(c)) x = x - whole[k % 2];
    if (has(far_repeats_off_each_vertex)) x = std::clamp(x, -0x1p22F, 0x1p22F);
    uv[k] = dyadic(x);
  }
  return uv;
}

float margin_of(const mmverify_bake_case_t& c, Index width, unsigned mip, bool nearest) {
  float margin = c.margin;
  if (!(margin >= 0)) throw Declined{};
  if (has(margin_of_first_mip)) margin = std::ldexp(margin, -static_cast<int>(mip));
  if (has(margin_in_first_mip_only) && mip > 0) margin = 0;
  if (has(margin_not_nearest) && nearest) margin = 0;
  if (has(margin_up_to_1)) margin = std::min(margin, 1.0F);
  if (has(margin_up_to_4)) margin = std::min(margin, 4.0F);
  if (has(margin_fraction) && margin > 1) margin -= std::floor(margin);
  if (has(margin_over_2) && margin > 2) margin = 0;
  if (has(margin_over_size) && 2 * margin > static_cast<float>(width)) margin = 0;
  if (has(margin_in_64ths)) margin = std::round(margin * 64) / 64;
  if (has(margin_not_of_lines)) {
    const auto d = [&](int k) { return static_cast<double>(c.uv[k]); };
    if ((d(2) - d(0)) * (d(5) - d(1)) == (d(3) - d(1)) * (d(4) - d(0))) margin = 0;
  }
  return margin;
}

}  // namespace

Placed place(const mmverify_bake_case_t& c, Index width, Index height, unsigned mip, bool nearest) {
  const std::array<Dyadic, 6> uv = coordinates_of(c);
  const float margin = margin_of(c, width, mip, nearest);
  const Dyadic grown = dyadic(margin);
  Dyadic grown_y = grown;
  if (has(margin_in_uv_of_width))
    grown_y = dyadic(static_cast<double>(margin) * static_cast<double>(height) / static_cast<double>(width));
  if (has(margin_along_u_only)) grown_y = {};

  int fraction = 1;
  for (const Dyadic& d : uv) fraction = std::max(fraction, -d.exponent);
  fraction = std::max({fraction, -grown.exponent, -grown_y.exponent});

  Placed p;
  const auto level = static_cast<int>(c.level);
  p.unit = power(fraction + level);
  p.margin[0] = shifted(grown, fraction + level);
  p.margin[1] = shifted(grown_y, fraction + level);
  p.size_bits = bits(p.unit);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Index size = axis == 0 ? width : height;
    bool half = !nearest || has(nearest_half_texel);
    if (has(bilinear_no_half_texel_when_1) && size == 1 &&
        (axis == 0 ? c.wrap_u : c.wrap_v) == MMVERIFY_CLAMP_TO_BORDER)
      half = false;
    Big v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = shifted(uv[2 * k + axis], fraction) * size;
    p.start[axis] = (v[0] << c.level) - (half ? Big(p.unit / 2) : Big(0));
    p.along_u[axis] = v[1] - v[0];
    p.along_v[axis] = v[2] - v[0];
    const bool turned = has(curve_exchanges_uv) || (has(curve_exchanges_uv_of_8) && c.level >= 8);
    if (turned) std::swap(p.along_u[axis], p.along_v[axis]);
    const Big far_u = p.start[axis] + (p.along_u[axis] << c.level),
              far_v = p.start[axis] + (p.along_v[axis] << c.level);
    const Big least = std::min({p.start[axis], far_u, far_v});
    const Big base = floor_div(least, p.unit);
    if (bits(base) > 60) throw Declined{};
    p.origin[axis] = static_cast<Index>(base);
    p.start[axis] -= base * p.unit;
    const Big most =
        std::max({p.start[axis], Big(far_u - base * p.unit), Big(far_v - base * p.unit)}) + p.margin[axis];
    if (bits(floor_div(most, p.unit)) > 60) throw Declined{};
    p.size_bits = std::max(p.size_bits, bits(most));
    const unsigned mode = axis == 0 ? c.wrap_u : c.wrap_v;  // lines of clamped axes may lie far off
    if (period(size, mode) == endless)
      p.size_bits = std::max(p.size_bits, bits(mp::abs(base) + size + 2) + bits(p.unit));
  }
  return p;
}

}  // namespace mmverify::tests::foreign::bake
