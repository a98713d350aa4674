// Codes to whole numbers that are averaged, and means to codes.  Internal to impl/attribute.
//
// A stored code c is averaged as a whole number: linear, c itself; on the sRGB curve 2^24 light(c), to nearest.  A mean
// is code k from its least on: k - 1/2, or 2^24 light at the middle between k - 1 and k, to nearest.
// Source: spec/attribute/colour.hpp, spec/attribute/normal.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute::detail {

/// The curve of one channel.
struct Curve {
  std::array<std::int32_t, 256> number{};       ///< of a code
  std::array<double, 256> value{};              ///< the same
  std::array<std::int32_t, 257> twice_least{};  ///< of a code, doubled; one more than any at 256
  double full = 255;                            ///< the greatest number
  double most_off = 0.125;                      ///< the greatest bound of a mean

  /// On the sRGB curve, by the first bits of a mean: the one middle that lies among the numbers with these bits or within
  /// most_off of them, or if there is none the next one above.  Middles are halves of whole numbers below 2^31, so that
  /// the lowest bits of their binary64 are free: these hold the code below the middle.
  std::vector<std::uint64_t> middles = {};
  /// Sign, exponent and 7 bits; the first middle is above 2^11.
  static constexpr int bits_below = 45;
  static constexpr double first_number = 0x1p11;
  static constexpr std::uint64_t first_bits = std::bit_cast<std::uint64_t>(first_number) >> bits_below,
                                 code_mask = 0xff;

  static const Curve& linear();
  static const Curve& srgb();

  /// The code of a mean that is within `bound`; `sure` is cleared where a middle is that near.
  /// Domain: 0 <= bound <= most_off; mean within that of 0 .. full.
  std::uint8_t code(double mean, double bound, bool& sure) const noexcept {
    if (middles.empty()) {
      const double up = mean + 0.5;
      const auto whole = static_cast<std::int32_t>(up);  // up >= 1/4
      const double rest = up - whole;
      sure = sure && rest >= bound && rest <= 1 - bound;
      return static_cast<std::uint8_t>(whole);
    }
    const double inside = std::min(std::max(mean, first_number), full);
    const std::uint64_t entry = middles[(std::bit_cast<std::uint64_t>(inside) >> bits_below) - first_bits];
    const auto middle = std::bit_cast<double>(entry & ~code_mask);
    sure = sure && std::fabs(mean - middle) >= bound;
    return static_cast<std::uint8_t>((entry & code_mask) + (mean >= middle ? 1 : 0));
  }

  /// The code of the mean sum / count, exactly.  Domain: count > 0.
  template <class Int>
  std::uint8_t exact_code(const Int& sum, const Int& count) const {
    const Int twice = sum + sum;
    int low = 0, high = 256;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (Int(std::int64_t{twice_least[static_cast<std::size_t>(middle)]}) * count <= twice ? low : high) =
          middle;
    }
    return static_cast<std::uint8_t>(low);
  }
};

/// The curves of a meaning's channels.
using Curves = std::array<const Curve*, 4>;
inline Curves curves_of(Meaning meaning) {
  const Curve *const line = &Curve::linear(), *const rgb = meaning == Meaning::srgb ? &Curve::srgb() : line;
  return {rgb, rgb, rgb, line};
}
constexpr bool is_normal(Meaning m) { return m == Meaning::normal || m == Meaning::normal_and_length; }

/// `encoded` for normals.
Rgba encoded_normal(const std::array<double, 4>& means, const std::array<double, 4>& bound, Meaning meaning,
                    const Curves& curves, bool& sure) noexcept;

/// The codes of mean numbers, each within its `bound`; `sure` is cleared where another code may be right.
inline Rgba encoded(const std::array<double, 4>& means, const std::array<double, 4>& bound, Meaning meaning,
                    const Curves& curves, bool& sure) noexcept {
  if (is_normal(meaning)) return encoded_normal(means, bound, meaning, curves, sure);
  Rgba codes{};
  for (std::size_t k = 0; k < 4; ++k) codes[k] = curves[k]->code(means[k], bound[k], sure);
  return codes;
}

/// Whether a >= t sqrt(square) for whole numbers.  Domain: square >= 0.
template <class Int>
bool reaches(const Int& a, const Int& t, const Int& square) {
  const Int zero(0);
  if (a >= zero) return t <= zero || a * a >= t * t * square;
  return t < zero && a * a <= t * t * square;
}

/// The codes of sums / count, exactly.  Domain: count > 0; of normals Int has twice the sums' bits and 32 more.
template <class Int>
Rgba exactly_encoded(const std::array<Int, 4>& sums, const Int& count, Meaning meaning,
                     const Curves& curves) {
  Rgba codes{};
  for (std::size_t k = 0; k < 4; ++k) codes[k] = curves[k]->exact_code(sums[k], count);
  if (!is_normal(meaning)) return codes;
  // The mean direction is (2 sum - 255 count) / (255 count).
  std::array<Int, 3> m;
  Int square(0);
  for (std::size_t k = 0; k < 3; ++k) {
    m[k] = sums[k] + sums[k] - Int(255) * count;
    square = square + m[k] * m[k];
  }
  const auto last = [](auto begun) {
    int low = 0, high = 256;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (begun(middle) ? low : high) = middle;
    }
    return static_cast<std::uint8_t>(low);
  };
  if (square == Int(0)) {
    codes[0] = codes[1] = 128;
    codes[2] = 255;
  } else {
    for (std::size_t k = 0; k < 3; ++k)
      codes[k] = last([&](int c) { return reaches(Int(255) * m[k], Int(2 * c - 256), square); });
  }
  if (meaning == Meaning::normal_and_length)
    codes[3] = last([&](int c) {  // sqrt(square) / (255 count) >= (2 c - 1) / 510
      const Int least = Int(2 * c - 1) * count;
      return Int(4) * square >= least * least;
    });
  return codes;
}

}  // namespace mmverify::impl::attribute::detail
