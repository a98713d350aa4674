// factors x texel - threshold, brought to whole numbers.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "tests/foreign/bake/faults.hpp"
#include "tests/foreign/bake/thresholds.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

float factor_of(float x) { return has(factor_above_1) && x > 1 ? 1.0F : x; }

/// Both factors as one number.
Dyadic product_of_factors(const mmverify_bake_case_t& c) {
  const float f = factor_of(c.factor);
  float g = factor_of(c.vertex_factor);
  if (has(vertex_factor_lost) && f != 1.0F) g = 1;
  if (has(vertex_factor_of_blend_lost) && c.alpha_mode == MMVERIFY_BLEND) g = 1;
  if (has(factors_in_float)) return dyadic(f * g);
  if (has(factors_in_16_bits))
    return dyadic(std::round(static_cast<double>(f) * static_cast<double>(g) * 65536) / 65536);
  const Dyadic a = dyadic(f), b = dyadic(g);
  if (a.mantissa == 0 || b.mantissa == 0) return {};
  return {a.mantissa * b.mantissa, a.exponent + b.exponent};
}

/// factor value 2^e / full - n / d has the sign of  value (m 2^e d) - full n, both times a power of two
std::pair<Big, Big> scale_and_offset(const Dyadic& factor, const Stored& s, const Threshold& t) {
  Big scale = factor.mantissa * t.denominator, offset = s.full * t.numerator;
  const int e = factor.exponent + s.exponent;
  if (e >= 0)
    scale <<= static_cast<unsigned>(e);
  else
    offset <<= static_cast<unsigned>(-e);
  Big common = mp::gcd(mp::abs(scale), mp::abs(offset));
  if (common == 0) common = 1;
  return {scale / common, offset / common};
}

std::vector<Big> scaled_texels(const Stored& s, const Big& scale, const Big& offset) {
  std::vector<Big> values(s.values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0 && s.values[k] == s.values[k - 1])
      values[k] = values[k - 1];
    else
      values[k] = s.values[k] * scale - offset;
  }
  return values;
}

/// The same where binary32 holds each product of factors and texel.
std::vector<Big> texels_scaled_in_float(const Stored& s, const Threshold& t, const Dyadic& f) {
  const double full = real(s.full), factors = std::ldexp(real(f.mantissa), f.exponent);
  int least = 0;
  std::vector<Dyadic> all;
  for (const Big& v : s.values) {
    all.push_back(dyadic(static_cast<float>(std::ldexp(real(v), s.exponent) / full * factors)));
    least = std::min(least, all.back().exponent);
  }
  std::vector<Big> values(s.values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = shifted(all[k], -least) * t.denominator - (t.numerator << static_cast<unsigned>(-least));
  return values;
}

/// Gives the border's value, the last, as without factors; the others have `offset` for the threshold.
void take_factors_off_border(std::vector<Big>& values, const Stored& s, const Threshold& t,
                             const Big& offset) {
  const auto [plain, under] = scale_and_offset(Dyadic{1, 0}, s, t);
  // brought to the scale of the others, which is at least that of both products
  const Big other = s.values.back() * plain - under;
  if (offset != 0 && under != 0) {
    const Big a = mp::abs(offset), b = mp::abs(under);
    for (Big& v : values) v *= b;
    values.back() = other * a;
  } else {
    values.back() = other;
  }
}

Field field_with(std::vector<Big> values) {
  Field field;
  Big greatest = 0;
  for (const Big& v : values) {
    if (v > greatest) greatest = v;
    if (-v > greatest) greatest = -v;
  }
  field.size_bits = bits(greatest);
  field.fits = field.size_bits <= 100;
  const double unit = greatest == 0 ? 1 : real(greatest);
  for (const Big& v : values) {
    field.approximate.push_back(real(v) / unit);
    field.signs.push_back(static_cast<unsigned char>(sign_bit(v.sign())));
    if (field.fits) field.small.push_back(to<Wide>(v));
  }
  if (!field.fits) field.large = std::move(values);
  return field;
}

}  // namespace

Field field_of(const mmverify_bake_case_t& c, const Stored& s, const Threshold& t, bool at_centroid) {
  const Dyadic f = product_of_factors(c);
  auto [scale, offset] = scale_and_offset(f, s, t);
  if (has(centroid_without_factor) && at_centroid && c.alpha_mode == MMVERIFY_BLEND)
    std::tie(scale, offset) = scale_and_offset(Dyadic{1, 0}, s, t);

  const bool rounds = has(factor_times_texel_in_float) && (c.factor != 1.0F || c.vertex_factor != 1.0F);
  std::vector<Big> values = rounds ? texels_scaled_in_float(s, t, f) : scaled_texels(s, scale, offset);
  if (has(border_without_factor)) take_factors_off_border(values, s, t, offset);
  if (has(cutoff_0) && t.is_mask && t.numerator == 0)
    for (Big& v : values)
      if (v == 0) v = -1;
  return field_with(std::move(values));
}

}  // namespace mmverify::tests::foreign::bake
