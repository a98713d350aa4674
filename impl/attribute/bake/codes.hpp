// Codes to whole numbers that are averaged, and means to codes.  Internal to impl/attribute.
//
// A stored code c is averaged as a whole number: linear, c itself; on the sRGB curve 2^24 light(c), to nearest.  A mean
// is code k from its least on: k - 1/2, or 2^24 light at the middle between k - 1 and k, to nearest.
// Source: spec/attribute/colour.hpp, spec/attribute/normal.hpp.
#pragma once

#include <array>
#include <cstdint>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute::detail {

/// The curve of one channel.
struct Curve {
  std::array<std::int32_t, 256> number{};       ///< of a code
  std::array<std::int32_t, 257> twice_least{};  ///< of a code, doubled; one more than any at 256
  std::array<std::uint8_t, 4097> guess{};       ///< the code of the least number with these high bits
  double full = 255;                            ///< the greatest number
  double to_guess = 0;

  static const Curve& linear();
  static const Curve& srgb();

  /// The code of a mean that is within `bound`; `sure` is cleared where another code's middle is that near.
  /// Domain: 0 <= bound < 1/4.
  std::uint8_t code(double mean, double bound, bool& sure) const noexcept {
    if (to_guess == 0) {
      const double up = mean + 0.5;
      const auto whole = static_cast<std::int32_t>(up);  // up >= 1/4
      const double rest = up - whole;
      sure = sure && rest >= bound && rest <= 1 - bound;
      return static_cast<std::uint8_t>(whole);
    }
    const double inside = mean < 0 ? 0 : mean > full ? full : mean;
    std::uint32_t k = guess[static_cast<std::size_t>(inside * to_guess)];
    while (inside >= 0.5 * twice_least[k + 1]) ++k;
    sure =
        sure && (k == 0 || mean - 0.5 * twice_least[k] >= bound) && 0.5 * twice_least[k + 1] - mean >= bound;
    return static_cast<std::uint8_t>(k);
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

/// The codes of mean numbers, each within its `bound`; `sure` is cleared where another code may be right.
Rgba encoded(const std::array<double, 4>& means, const std::array<double, 4>& bound, Meaning meaning,
             const Curves& curves, bool& sure) noexcept;

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
