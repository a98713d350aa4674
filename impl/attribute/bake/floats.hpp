// Texels of binary32 as whole numbers over a common power of two, and means as binary32.  Internal to impl/attribute.
//
// A mean known within a bound is sure if both ends of that interval round to the same number.
// Whole numbers: a texel t counts t / 2^e, where e is the exponent of the lowest bit of any texel of the texture, or of
// its border.  They have 277 bits at most, from 2^-149 to 2^128: the widest arithmetic of exact.cpp suffices for all
// sums.
// Source: IEEE 754, 4.3.1; spec/attribute/colour.hpp, Rounded<Binary32>.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "impl/attribute/bake/codes.hpp"
#include "impl/common/binary.hpp"
#include "impl/common/wide.hpp"

namespace mmverify::impl::attribute::detail {

/// sum / count 2^exponent to nearest, ties to even; 0 is +0.
/// Domain: count > 0; the number within the range of binary32; exponent in -149..127; Int holds count 2^26 and 2 sum.
template <class Int>
float nearest_float(const Int& sum, const Int& count, int exponent) {
  const bool negative = sum < Int(0);
  const Int size = negative ? Int(0) - sum : sum;
  if (size == Int(0)) return 0;
  // 2^top <= size / count < 2^(top + 1)
  int top = bit_width(size) - bit_width(count);
  if (top >= 0 ? size < (count << top) : (size << -top) < count) --top;
  // The exponent of the result's last place, less `exponent`: 23 below the top, or that of the least number.
  const int last = std::max(top - 23, -149 - exponent);
  const Int unit = last > 0 ? count << last : count, all = last < 0 ? size << -last : size;
  std::int64_t whole = last_code((1 << 24) - 1, [&](int k) { return Int(k) * unit <= all; });
  const Int rest = all - Int(whole) * unit, twice = rest + rest;
  if (unit < twice || (unit == twice && whole % 2 != 0)) ++whole;
  // The leading bit of a normal number adds one to the exponent field, and so does a carry.
  const std::int64_t bits = (std::int64_t{last + exponent + 149} << 23) + whole;
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits) | (negative ? 0x80000000u : 0u));
}

/// The coding of floats: each texel is itself the number that is averaged.
template <>
class Coding<float> {
 public:
  /// The whole number of a texel's channel, which may need all bits.
  template <class Int>
  using Number = Int;
  int number_bits() const noexcept { return std::max(above_ - below_, 26) + 1; }
  static constexpr int code_bits = 4;

  /// Errors: std::invalid_argument for a meaning that is not linear, a number that is not finite.
  Coding(const RgbaViewOf<float>& texture, const AttributeSamplingOf<float>& sampling) {
    if (sampling.meaning != Meaning::linear)
      throw std::invalid_argument("attribute: texels of binary32 are linear, no other meaning is defined");
    for (const float x : sampling.border) take_in(x);
    for (std::size_t y = 0; y < texture.height; ++y) {
      const float* const row = texture.texels + 4 * y * texture.pitch;
      for (std::size_t k = 0; k < 4 * std::size_t{texture.width}; ++k) take_in(row[k]);
    }
    if (above_ < below_) below_ = above_ = 0;  // zeros alone
  }

  static constexpr bool normal() noexcept { return false; }

  static double value(float x, std::size_t) noexcept { return double{x}; }
  template <class Int>
  Int number(float x, std::size_t) const noexcept {
    const Binary parts = binary(x);
    return parts.m == 0 ? Int(0) : Int(parts.m) << (parts.e - below_);
  }

  /// The means rounded to binary32, each within its `bound`; `sure` is cleared if another number may be right.
  static RgbaFloat encoded(const std::array<double, 4>& means, const std::array<double, 4>& bound,
                           bool& sure) noexcept {
    // No mean is beyond the greatest number.
    constexpr double most = std::numeric_limits<float>::max();
    RgbaFloat numbers;
    for (std::size_t k = 0; k < 4; ++k) {
      const double mean = means[k] + 0.0;  // no -0
      numbers[k] = static_cast<float>(std::clamp(mean - bound[k], -most, most));
      const auto other = static_cast<float>(std::clamp(mean + bound[k], -most, most));
      sure = sure && std::bit_cast<std::uint32_t>(numbers[k]) == std::bit_cast<std::uint32_t>(other);
    }
    return numbers;
  }

  /// sums / count 2^e, exactly.  Domain: count > 0.
  template <class Int>
  RgbaFloat exactly_encoded(const std::array<Int, 4>& sums, const Int& count) const {
    RgbaFloat numbers;
    for (std::size_t k = 0; k < 4; ++k) numbers[k] = nearest_float(sums[k], count, below_);
    return numbers;
  }

 private:
  void take_in(float x) {
    if (!std::isfinite(x))
      throw std::invalid_argument("attribute: a texel, or the border, is infinite or not a number");
    const Binary parts = binary(x);
    if (parts.m == 0) return;
    below_ = std::min(below_, parts.e);
    above_ = std::max(above_, parts.e + bits(parts.m));
  }

  /// All texels are multiples of 2^below, and smaller than 2^above.
  int below_ = 1000, above_ = -1000;
};

}  // namespace mmverify::impl::attribute::detail
