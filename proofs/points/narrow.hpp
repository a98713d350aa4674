// The specification's numbers in as few bits as hold them.
#pragma once

#include <compare>
#include <concepts>
#include <stdexcept>
#include <utility>

#include "spec/rational.hpp"

namespace mmverify::proofs {

/// A whole number of 64 bits that throws std::overflow_error instead of wrapping.
class Whole64 {
 public:
  constexpr Whole64(std::integral auto x) : x_(static_cast<std::int64_t>(x)) {
    if (!std::in_range<std::int64_t>(x)) overflow();
  }
  explicit Whole64(const spec::Integer& x) : x_(static_cast<std::int64_t>(x)) {
    if (x_ != x) overflow();
  }
  explicit constexpr operator std::int64_t() const { return x_; }

  friend constexpr Whole64 operator+(Whole64 a, Whole64 b) {
    std::int64_t r = 0;
    return __builtin_add_overflow(a.x_, b.x_, &r) ? overflow() : Whole64(r);
  }
  friend constexpr Whole64 operator-(Whole64 a, Whole64 b) {
    std::int64_t r = 0;
    return __builtin_sub_overflow(a.x_, b.x_, &r) ? overflow() : Whole64(r);
  }
  friend constexpr Whole64 operator*(Whole64 a, Whole64 b) {
    std::int64_t r = 0;
    return __builtin_mul_overflow(a.x_, b.x_, &r) ? overflow() : Whole64(r);
  }
  constexpr Whole64 operator-() const { return Whole64(0) - *this; }
  /// Rounds towards zero.  Domain: b > 0.
  friend constexpr Whole64 operator/(Whole64 a, Whole64 b) { return a.x_ / b.x_; }
  friend constexpr Whole64 operator%(Whole64 a, Whole64 b) { return a.x_ % b.x_; }
  constexpr Whole64& operator/=(Whole64 b) { return *this = *this / b; }
  friend constexpr Whole64 operator<<(Whole64 a, int places) {
    return places > 62 ? overflow() : a * Whole64(std::int64_t{1} << places);
  }
  friend constexpr bool operator==(Whole64, Whole64) = default;
  friend constexpr auto operator<=>(Whole64, Whole64) = default;

  [[noreturn]] static Whole64 overflow() { throw std::overflow_error("more than 64 bits"); }

 private:
  std::int64_t x_;
};

/// Rationals with a numerator and a denominator of 63 bits and a sign.  Beyond them it throws std::overflow_error,
/// and it never rounds.  Has the operations of boost::rational that the specification uses, many times as fast; a
/// test compares the two.  Always in lowest terms, the denominator positive.
class Rational64 {
 public:
  using int_type = Whole64;

  constexpr Rational64() = default;
  constexpr Rational64(std::integral auto x) : Rational64(Whole64(x)) {}
  constexpr Rational64(Whole64 x) : n_(static_cast<std::int64_t>(x)) {}
  /// Domain: d != 0.
  Rational64(Whole64 n, Whole64 d);
  constexpr Whole64 numerator() const { return n_; }
  constexpr Whole64 denominator() const { return d_; }

  /// floor(q) for 0 <= q < 2^32; beyond it throws std::range_error.
  friend std::uint32_t whole(const Rational64& q);

  Rational64 operator-() const;
  friend Rational64 operator+(const Rational64& a, const Rational64& b);
  friend Rational64 operator-(const Rational64& a, const Rational64& b);
  friend Rational64 operator*(const Rational64& a, const Rational64& b);
  /// Domain: b != 0.
  friend Rational64 operator/(const Rational64& a, const Rational64& b);
  Rational64& operator+=(const Rational64& b) { return *this = *this + b; }
  Rational64& operator*=(const Rational64& b) { return *this = *this * b; }

  friend constexpr bool operator==(const Rational64&, const Rational64&) = default;
  friend constexpr std::strong_ordering operator<=>(const Rational64& a, const Rational64& b) {
    if (a.d_ == b.d_) return a.n_ <=> b.n_;
    return Wide{a.n_} * b.d_ <=> Wide{b.n_} * a.d_;
  }

 private:
  using Half = std::int64_t;
  __extension__ using Wide = __int128;

  /// Wraps a fraction that is in lowest terms.  Domain: d > 0.
  static Rational64 reduced(Wide n, Wide d);
  static Rational64 of(Half n, Half d);
  /// a + n/d.
  static Rational64 sum(const Rational64& a, Wide n, Half d);

  Half n_ = 0, d_ = 1;
};

/// Rationals within 255 bits, without allocations: twice as fast as unbounded ones.
using Rational256 = boost::rational<boost::multiprecision::checked_int256_t>;

/// f.operator()<Q>() with the first of these rationals that holds all numbers on the way; the last one holds any.
template <class Q, class... Wider, class F>
auto in_first_of(F f) {
  if constexpr (sizeof...(Wider) != 0) {
    try {
      return f.template operator()<Q>();
    } catch (const std::overflow_error&) {
    } catch (const std::range_error&) {
    }
    return in_first_of<Wider...>(f);
  } else {
    return f.template operator()<Q>();
  }
}
/// f.operator()<Q>() with the smallest of all rationals that suffices.
template <class F>
auto in_smallest(F f) {
  return in_first_of<Rational64, spec::Rational128, Rational256, spec::Rational>(f);
}

}  // namespace mmverify::proofs
