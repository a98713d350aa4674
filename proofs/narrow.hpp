// The specification's numbers in as few bits as hold them.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "spec/rational.hpp"

namespace mmverify::proofs {

/// A whole number of 64 bits that throws std::overflow_error where it would wrap.
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
  /// Towards zero.  Domain: b > 0.
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

/// Rationals whose numerator and denominator have 63 bits and a sign: beyond them it throws
/// std::overflow_error, and never rounds.  What of boost::rational the specification asks for, many times as
/// fast; a test holds the two equal.  Always in lowest terms, the denominator positive.
class Rational64 {
 public:
  using int_type = Whole64;

  constexpr Rational64() = default;
  constexpr Rational64(std::integral auto x) : Rational64(Whole64(x)) {}
  constexpr Rational64(Whole64 x) : n_(static_cast<std::int64_t>(x)) {}
  /// Domain: d != 0.
  constexpr Rational64(Whole64 n, Whole64 d) {
    if (d == 0) throw std::domain_error("a quotient over 0");
    *this = of(static_cast<std::int64_t>(n), static_cast<std::int64_t>(d));
  }
  constexpr Whole64 numerator() const { return n_; }
  constexpr Whole64 denominator() const { return d_; }

  /// floor(q) for 0 <= q < 2^32; beyond it throws std::range_error.
  friend constexpr std::uint32_t whole(const Rational64& q) {
    const Half floor = q.n_ < 0 ? -1 : q.n_ / q.d_;
    if (!std::in_range<std::uint32_t>(floor)) throw std::range_error("no whole number of 32 bits");
    return static_cast<std::uint32_t>(floor);
  }

  constexpr Rational64 operator-() const { return reduced(-Wide{n_}, d_); }
  friend constexpr Rational64 operator+(const Rational64& a, const Rational64& b) {
    return sum(a, b.n_, b.d_);
  }
  friend constexpr Rational64 operator-(const Rational64& a, const Rational64& b) {
    return sum(a, -Wide{b.n_}, b.d_);
  }
  friend constexpr Rational64 operator*(const Rational64& a, const Rational64& b) {
    const Bits p = gcd(size(a.n_), Bits(b.d_)), q = gcd(size(b.n_), Bits(a.d_));
    return reduced(Wide{a.n_ / Half(p)} * (b.n_ / Half(q)), Wide{a.d_ / Half(q)} * (b.d_ / Half(p)));
  }
  /// Domain: b != 0.
  friend constexpr Rational64 operator/(const Rational64& a, const Rational64& b) {
    if (b.n_ == 0) throw std::domain_error("a quotient over 0");
    return a * of(b.d_, b.n_);
  }
  constexpr Rational64& operator+=(const Rational64& b) { return *this = *this + b; }
  constexpr Rational64& operator*=(const Rational64& b) { return *this = *this * b; }

  friend constexpr bool operator==(const Rational64&, const Rational64&) = default;
  friend constexpr std::strong_ordering operator<=>(const Rational64& a, const Rational64& b) {
    if (a.d_ == b.d_) return a.n_ <=> b.n_;
    return Wide{a.n_} * b.d_ <=> Wide{b.n_} * a.d_;
  }

 private:
  using Half = std::int64_t;
  using Bits = std::uint64_t;
  __extension__ using Wide = __int128;

  static constexpr Bits size(Half x) { return x < 0 ? Bits{0} - static_cast<Bits>(x) : static_cast<Bits>(x); }

  /// gcd(0, b) = b.  Domain: b > 0.
  static constexpr Bits gcd(Bits a, Bits b) {
    if (a == 0) return b;
    if (a == 1 || b == 1) return 1;
    const int twos = std::countr_zero(a | b);
    a >>= std::countr_zero(a);
    do {
      b >>= std::countr_zero(b);
      if (a > b) std::swap(a, b);
      b -= a;
    } while (b != 0);
    return a << twos;
  }

  /// In lowest terms already; d > 0.
  static constexpr Rational64 reduced(Wide n, Wide d) {
    Rational64 q;
    q.n_ = static_cast<Half>(n);
    q.d_ = static_cast<Half>(d);
    if (q.n_ != n || q.d_ != d) Whole64::overflow();
    return q;
  }
  static constexpr Rational64 of(Half n, Half d) {
    const auto g = Wide{static_cast<Wide>(gcd(size(n), size(d)))};
    return d < 0 ? reduced(-(n / g), -(d / g)) : reduced(n / g, d / g);
  }
  /// Knuth, The Art of Computer Programming 2, 4.5.1: only a divisor of both denominators can be lost.
  static constexpr Rational64 sum(const Rational64& a, Wide n, Half d) {
    const auto g = static_cast<Half>(gcd(Bits(a.d_), Bits(d)));
    const Wide total = a.n_ * Wide{d / g} + n * (a.d_ / g);
    if (g == 1) return reduced(total, Wide{a.d_} * d);
    const Half rest =
        static_cast<Half>(static_cast<Half>(total) == total ? static_cast<Half>(total) % g : total % g);
    const auto lost = static_cast<Half>(gcd(size(rest), Bits(g)));
    return reduced(static_cast<Half>(total) == total ? Wide{static_cast<Half>(total) / lost} : total / lost,
                   Wide{a.d_ / g} * (d / lost));
  }

  Half n_ = 0, d_ = 1;
};

/// Within 255 bits, without memory of their own: twice as fast as those without bounds.
using Rational256 = boost::rational<boost::multiprecision::checked_int256_t>;

/// f.operator()<Q>() over the first of these rationals that holds all numbers on the way; the last one holds any.
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
/// The same over all of them.
template <class F>
auto in_smallest(F f) {
  return in_first_of<Rational64, spec::Rational128, Rational256, spec::Rational>(f);
}

}  // namespace mmverify::proofs
