// The cutoff of MASK, and BLEND's three thresholds.
#include "tests/foreign/bake/thresholds.hpp"

#include <algorithm>

#include "tests/foreign/bake/faults.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

Threshold threshold_of_mask(const mmverify_bake_case_t& c, const Big& full) {
  Big n = c.cutoff_numerator, d = c.cutoff_denominator;
  if (d == 0) throw Declined{};
  if (has(cutoff_in_float) || has(cutoff_in_double)) {
    double q = static_cast<double>(c.cutoff_numerator) / static_cast<double>(c.cutoff_denominator);
    if (has(cutoff_in_float))
      q = static_cast<double>(static_cast<float>(c.cutoff_numerator) /
                              static_cast<float>(c.cutoff_denominator));
    const Dyadic r = dyadic(q);
    const int down = std::max(0, -r.exponent);
    n = shifted(r, down);
    d = power(down);
  }
  if (has(cutoff_in_31_bits) && c.cutoff_denominator >= 0x80000000u) {
    n = n / 2;
    d = d / 2;
  }
  if (has(cutoff_in_texel_steps) && c.texel != MMVERIFY_FLOAT32) {
    n = (n * full + d - 1) / d;
    d = full;
  }
  if (has(cutoff_numerator_in_8_bits)) n = c.cutoff_numerator & 255u;
  if (has(cutoff_to_a_byte)) {
    n = static_cast<unsigned>(2 * Big(256) * n / d + 1) / 2 & 255u;
    d = 256;
  }
  if (has(cutoff_shift_overflows)) {
    n = (c.cutoff_numerator << 24) / c.cutoff_denominator;
    d = 1u << 24;
  }
  if (has(cutoff_high_greater) && 4 * n >= 3 * d && n <= d) n = d - n;
  if (has(cutoff_above_1) && n > d) n = d;
  return {n, d, true};
}

}  // namespace

std::vector<Threshold> thresholds_of(const mmverify_bake_case_t& c, const Big& full) {
  if (c.alpha_mode == MMVERIFY_MASK) return {threshold_of_mask(c, full)};
  Threshold opaque{1, 1}, clear{0, 1}, centre{1, 2};
  if (has(blend_O_at_254)) opaque = {254, 255};
  if (has(blend_T_below_a_step)) clear = {1, 255};
  if (has(blend_uses_cutoff) && c.cutoff_numerator != 0 && c.cutoff_denominator != 0)
    opaque = {c.cutoff_numerator, c.cutoff_denominator};
  if (has(centroid_blend_cutoff) && c.cutoff_denominator != 0)
    centre = {c.cutoff_numerator, c.cutoff_denominator};
  if (has(centroid_blend_1) || (has(two_state_blend_1) && c.format == MMVERIFY_2_STATE)) centre = {1, 1};
  return {opaque, clear, centre};
}

}  // namespace mmverify::tests::foreign::bake
