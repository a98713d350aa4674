// IEEE 754 binary16 as an ordinary number type: every operation rounds to nearest, ties to even.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>

namespace mmverify::impl {

/// A binary16 number, for running templates over the number type in half precision.
///   a op b = round(a op b) for + - *;  comparisons are IEEE's, NaN unordered
/// Range: subnormals down to 2^-24 are kept, 65520 and above overflow to infinity; a NaN stays a NaN, quiet.
/// Sums and products of two are exact in binary64 (all bits lie between 2^-48 and 2^32), so each result
/// rounds once.
/// Source: IEEE 754-2019, clauses 3.4 and 4.3.1.
class Binary16 {
 public:
  constexpr Binary16() = default;

  /// round(k): exact up to 2048, infinity from 65520.
  /// Test: impl_binary16_test
  constexpr explicit Binary16(std::uint32_t k) : Binary16(static_cast<double>(k)) {}

  /// round(x), in one step from either format.  A template, so that a plain int takes the constructor above.
  /// Test: impl_binary16_test
  template <class F>
  requires std::same_as<F, float> || std::same_as<F, double>
  constexpr explicit Binary16(F x) : bits_(rounded(static_cast<double>(x))) {}

  static constexpr Binary16 from_bits(std::uint16_t bits) {
    Binary16 q;
    q.bits_ = bits;
    return q;
  }
  constexpr std::uint16_t bits() const { return bits_; }

  constexpr explicit operator double() const {
    const std::uint64_t sign = std::uint64_t{bits_} >> 15 << 63, magnitude = bits_ & 0x7fffu;
    if (magnitude < smallest_normal) {
      const double x = static_cast<double>(magnitude) * 0x1p-24;
      return sign != 0 ? -x : x;
    }
    const std::uint64_t wide = magnitude << widening;
    // An infinity or NaN takes the last exponent of binary64 instead of a rebased one.
    return std::bit_cast<double>(sign | (magnitude < infinity ? wide + rebase : wide | 0x7ffull << 52));
  }
  constexpr explicit operator float() const { return static_cast<float>(static_cast<double>(*this)); }

  friend constexpr Binary16 operator+(Binary16 a, Binary16 b) {
    return Binary16(static_cast<double>(a) + static_cast<double>(b));
  }
  friend constexpr Binary16 operator-(Binary16 a, Binary16 b) {
    return Binary16(static_cast<double>(a) - static_cast<double>(b));
  }
  friend constexpr Binary16 operator*(Binary16 a, Binary16 b) {
    return Binary16(static_cast<double>(a) * static_cast<double>(b));
  }
  friend constexpr bool operator==(Binary16 a, Binary16 b) {
    return static_cast<double>(a) == static_cast<double>(b);
  }
  friend constexpr std::partial_ordering operator<=>(Binary16 a, Binary16 b) {
    return static_cast<double>(a) <=> static_cast<double>(b);
  }

  /// floor(q) for q >= 0.  Negative numbers and NaN give 0, infinity the greatest word.
  /// Test: impl_binary16_test
  friend constexpr std::uint32_t whole(const Binary16& q) {
    const double x = static_cast<double>(q);
    if (!(x > 0)) return 0;
    return x < 65536 ? static_cast<std::uint32_t>(x) : std::numeric_limits<std::uint32_t>::max();
  }

 private:
  static constexpr unsigned widening = 52 - 10;  // significand bits of binary64 beyond those of binary16
  static constexpr std::uint64_t rebase = std::uint64_t{1023 - 15}
                                          << 52;  // difference of the exponents' biases
  static constexpr std::uint32_t smallest_normal = 0x0400, infinity = 0x7c00, quiet_nan = 0x7e00;

  static constexpr std::uint16_t rounded(double x) {
    const std::uint64_t all = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t sign = all >> 63 << 15, wide = all & ~(std::uint64_t{1} << 63);
    const double magnitude = std::bit_cast<double>(wide);
    std::uint64_t bits = 0;
    if (magnitude < 0x1p-14) {
      // Beside 2^28 the spacing of binary64 is 2^-24: the addition itself rounds to a whole number of
      // subnormal steps.
      bits = std::bit_cast<std::uint64_t>(magnitude + 0x1p28) & 0xffff;
    } else if (magnitude < 65520) {  // check-magic: 65520 == (2 ** 11 - 1) * 2 ** 5 + 2 ** 4
      // Adds just under half of the last place, and the rest when that place is odd; a carry runs into the
      // exponent.
      const std::uint64_t odd = wide >> widening & 1, half = std::uint64_t{1} << (widening - 1);
      bits = (wide + (half - 1) + odd - rebase) >> widening;
    } else {
      bits = magnitude >= 65520 ? infinity : quiet_nan | (wide >> widening & 0x1ff);
    }
    return static_cast<std::uint16_t>(sign | bits);
  }

  std::uint16_t bits_ = 0;
};

}  // namespace mmverify::impl
