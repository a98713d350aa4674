// Codes as whole numbers that are averaged, and means as codes.  Internal to impl/attribute.
//
// A stored code c is averaged as a whole number: linear, c itself; on the sRGB curve 2^24 light(c), to nearest.  The
// means of code k begin at its least one: k - 1/2, or 2^24 light at the middle between k - 1 and k, to nearest.
// Source: spec/attribute/colour.hpp, spec/attribute/normal.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute::detail {

/// The greatest code of a channel: 255 or 65535.
template <class Channel>
inline constexpr int greatest = std::numeric_limits<Channel>::max();

/// The last code in 0..full with begun(code).  Domain: begun is true of 0 and up to some code, and false beyond.
template <class Begun>
int last_code(int full, Begun begun) {
  int low = 0, high = full + 1;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (begun(middle) ? low : high) = middle;
  }
  return low;
}

/// The code of a linear mean, half up.  The mean is within `bound`; `sure` is cleared if a middle is as near.
/// Domain: mean >= -1/4; below 2^16.
template <class Channel>
Channel linear_code(double mean, double bound, bool& sure) noexcept {
  const double up = mean + 0.5;
  const auto whole = static_cast<std::int32_t>(up);  // up >= 1/4
  const double rest = up - whole;
  sure = sure && rest >= bound && rest <= 1 - bound;
  return static_cast<Channel>(whole);
}

/// The code of the linear mean sum / count, exactly.  Domain: count > 0.
template <class Channel, class Int>
Channel exact_linear_code(const Int& sum, const Int& count) {
  const Int twice = sum + sum;
  return static_cast<Channel>(
      last_code(greatest<Channel>, [&](int c) { return Int(std::int64_t{2 * c - 1}) * count <= twice; }));
}

/// The curve of one channel of 8 bits.
struct Curve {
  std::array<std::int32_t, 256> number{};       ///< the whole number of a code
  std::array<double, 256> value{};              ///< the same in binary64
  std::array<std::int32_t, 257> twice_least{};  ///< twice the least mean of a code; at 256 beyond every mean
  double full = 255;                            ///< the greatest whole number
  double most_off = 0.125;                      ///< the greatest allowed bound of a mean

  /// The middles between codes on the sRGB curve, by the first bits of a mean: the one middle among the numbers with
  /// these bits or within most_off of them, or the next one above if there is none.  Middles are halves of whole
  /// numbers below 2^31, so that the lowest bits of their binary64 are free: these store the code below the middle.
  std::vector<std::uint64_t> middles = {};
  /// The bits below sign, exponent and 7 more; the first middle is above 2^11.
  static constexpr int bits_below = 45;  // check-magic: 45 == 52 - 7
  static constexpr double first_number = 0x1p11;
  static constexpr std::uint64_t first_bits = std::bit_cast<std::uint64_t>(first_number) >> bits_below,
                                 code_mask = 0xff;

  static const Curve& linear();
  static const Curve& srgb();

  /// The code of a mean that is within `bound`; `sure` is cleared if a middle between codes is as near.
  /// Domain: 0 <= bound <= most_off; mean within that of 0 .. full.
  std::uint8_t code(double mean, double bound, bool& sure) const noexcept {
    if (middles.empty()) return linear_code<std::uint8_t>(mean, bound, sure);
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
    return static_cast<std::uint8_t>(last_code(255, [&](int c) {
      return Int(std::int64_t{twice_least[static_cast<std::size_t>(c)]}) * count <= twice;
    }));
  }
};

/// The curves of a meaning's channels.
using Curves = std::array<const Curve*, 4>;
inline Curves curves_of(Meaning meaning) {
  const Curve *const line = &Curve::linear(), *const rgb = meaning == Meaning::srgb ? &Curve::srgb() : line;
  return {rgb, rgb, rgb, line};
}
constexpr bool is_normal(Meaning m) { return m == Meaning::normal || m == Meaning::normal_and_length; }

/// The codes of mean normals, each within its `bound`; `sure` is cleared if another code may be right.
template <class Channel>
RgbaOf<Channel> encoded_normal(const std::array<double, 4>& means, const std::array<double, 4>& bound,
                               Meaning meaning, bool& sure) noexcept;

/// Whether a >= t sqrt(square) for whole numbers.  Domain: square >= 0.
template <class Int>
bool reaches(const Int& a, const Int& t, const Int& square) {
  const Int zero(0);
  if (a >= zero) return t <= zero || a * a >= t * t * square;
  return t < zero && a * a <= t * t * square;
}

/// Writes to `codes` the direction, and the length, of the mean normal sums / count, exactly.
/// Domain: count > 0; Int has twice the sums' bits and 32 more.
template <class Channel, class Int>
void encode_normal_exactly(const std::array<Int, 4>& sums, const Int& count, Meaning meaning,
                           RgbaOf<Channel>& codes) {
  constexpr int full = greatest<Channel>;
  // The mean direction is (2 sum - full count) / (full count).
  std::array<Int, 3> m;
  Int square(0);
  for (std::size_t k = 0; k < 3; ++k) {
    m[k] = sums[k] + sums[k] - Int(full) * count;
    square = square + m[k] * m[k];
  }
  if (square == Int(0)) {
    codes[0] = codes[1] = (full + 1) / 2;
    codes[2] = full;
  } else {
    // Code c begins at (2 c - 1 - full) / full.
    for (std::size_t k = 0; k < 3; ++k)
      codes[k] = static_cast<Channel>(
          last_code(full, [&](int c) { return reaches(Int(full) * m[k], Int(2 * c - 1 - full), square); }));
  }
  if (meaning == Meaning::normal_and_length)
    codes[3] = static_cast<Channel>(
        last_code(full, [&](int c) {  // sqrt(square) / (full count) >= (2 c - 1) / (2 full)
          const Int least = Int(2 * c - 1) * count;
          return Int(4) * square >= least * least;
        }));
}

/// The coding of a texture's channels: texels as numbers, means as values of a map.  floats.hpp has that of floats.
template <class Channel>
class Coding {
 public:
  /// The whole number of a texel's channel.
  template <class Int>
  using Number = std::int64_t;
  /// The bits of such a number, and the bits that a comparison with a code adds.
  int number_bits() const noexcept { return sizeof(Channel) == 1 ? 25 : 17; }
  static constexpr int code_bits = sizeof(Channel) == 1 ? 10 : 18;

  /// Errors: std::invalid_argument for the sRGB curve of 16 bits.
  Coding(const RgbaViewOf<Channel>&, const AttributeSamplingOf<Channel>& sampling)
      : meaning_(sampling.meaning), curves_(curves_of(sampling.meaning)) {
    if (sizeof(Channel) != 1 && meaning_ == Meaning::srgb)
      throw std::invalid_argument("attribute: only textures of 8 bits are on the sRGB curve");
  }

  bool normal() const noexcept { return is_normal(meaning_); }

  /// The number of channel k of a texel, in binary64.
  double value(Channel code, std::size_t k) const noexcept {
    if constexpr (sizeof(Channel) == 1)
      return curves_[k]->value[code];
    else
      return code;
  }
  template <class Int>
  Number<Int> number(Channel code, std::size_t k) const noexcept {
    if constexpr (sizeof(Channel) == 1)
      return curves_[k]->number[code];
    else
      return code;
  }
  /// The greatest value of channel k.
  double full(std::size_t k) const noexcept {
    return sizeof(Channel) == 1 ? curves_[k]->full : double{greatest<Channel>};
  }
  /// The greatest bound of a mean that encoded() takes.
  double most_off(std::size_t k) const noexcept {
    return sizeof(Channel) == 1 ? curves_[k]->most_off : 0.125;
  }

  /// The codes of means, each within its `bound`; `sure` is cleared if another code may be right.
  RgbaOf<Channel> encoded(const std::array<double, 4>& means, const std::array<double, 4>& bound,
                          bool& sure) const noexcept {
    if (normal()) return encoded_normal<Channel>(means, bound, meaning_, sure);
    RgbaOf<Channel> codes{};
    for (std::size_t k = 0; k < 4; ++k)
      if constexpr (sizeof(Channel) == 1)
        codes[k] = curves_[k]->code(means[k], bound[k], sure);
      else
        codes[k] = linear_code<Channel>(means[k], bound[k], sure);
    return codes;
  }

  /// The codes of sums / count, exactly.  Domain: count > 0; for normals Int has twice the sums' bits and 32 more.
  template <class Int>
  RgbaOf<Channel> exactly_encoded(const std::array<Int, 4>& sums, const Int& count) const {
    RgbaOf<Channel> codes{};
    const auto line = [&](std::size_t k) {
      if constexpr (sizeof(Channel) == 1)
        return curves_[k]->exact_code(sums[k], count);
      else
        return exact_linear_code<Channel>(sums[k], count);
    };
    if (normal()) {
      codes[3] = line(3);
      encode_normal_exactly<Channel>(sums, count, meaning_, codes);
    } else {
      for (std::size_t k = 0; k < 4; ++k) codes[k] = line(k);
    }
    return codes;
  }

 private:
  Meaning meaning_;
  Curves curves_;
};

}  // namespace mmverify::impl::attribute::detail
