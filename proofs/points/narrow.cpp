#include "proofs/points/narrow.hpp"

#include <bit>

namespace mmverify::proofs {
namespace {

using Bits = std::uint64_t;

Bits size(std::int64_t x) { return x < 0 ? Bits{0} - static_cast<Bits>(x) : static_cast<Bits>(x); }

/// gcd(0, b) = b.  Domain: b > 0.
Bits gcd(Bits a, Bits b) {
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

}  // namespace

Rational64::Rational64(Whole64 n, Whole64 d) {
  if (d == 0) throw std::domain_error("a quotient over 0");
  *this = of(static_cast<std::int64_t>(n), static_cast<std::int64_t>(d));
}

std::uint32_t whole(const Rational64& q) {
  const std::int64_t floor = q.n_ < 0 ? -1 : q.n_ / q.d_;
  if (!std::in_range<std::uint32_t>(floor)) throw std::range_error("no whole number of 32 bits");
  return static_cast<std::uint32_t>(floor);
}

Rational64 Rational64::operator-() const { return reduced(-Wide{n_}, d_); }
Rational64 operator+(const Rational64& a, const Rational64& b) { return Rational64::sum(a, b.n_, b.d_); }
Rational64 operator-(const Rational64& a, const Rational64& b) {
  return Rational64::sum(a, -Rational64::Wide{b.n_}, b.d_);
}
Rational64 operator*(const Rational64& a, const Rational64& b) {
  using Half = Rational64::Half;
  using Wide = Rational64::Wide;
  const Bits p = gcd(size(a.n_), Bits(b.d_)), q = gcd(size(b.n_), Bits(a.d_));
  return Rational64::reduced(Wide{a.n_ / Half(p)} * (b.n_ / Half(q)),
                             Wide{a.d_ / Half(q)} * (b.d_ / Half(p)));
}
Rational64 operator/(const Rational64& a, const Rational64& b) {
  if (b.n_ == 0) throw std::domain_error("a quotient over 0");
  return a * Rational64::of(b.d_, b.n_);
}

Rational64 Rational64::reduced(Wide n, Wide d) {
  Rational64 q;
  q.n_ = static_cast<Half>(n);
  q.d_ = static_cast<Half>(d);
  if (q.n_ != n || q.d_ != d) Whole64::overflow();
  return q;
}

Rational64 Rational64::of(Half n, Half d) {
  const auto g = Wide{static_cast<Wide>(gcd(size(n), size(d)))};
  return d < 0 ? reduced(-(n / g), -(d / g)) : reduced(n / g, d / g);
}

/// Knuth, The Art of Computer Programming 2, 4.5.1: only a divisor of both denominators can be lost.
Rational64 Rational64::sum(const Rational64& a, Wide n, Half d) {
  const auto g = static_cast<Half>(gcd(Bits(a.d_), Bits(d)));
  const Wide total = a.n_ * Wide{d / g} + n * (a.d_ / g);
  if (g == 1) return reduced(total, Wide{a.d_} * d);
  const Half rest =
      static_cast<Half>(static_cast<Half>(total) == total ? static_cast<Half>(total) % g : total % g);
  const auto lost = static_cast<Half>(gcd(size(rest), Bits(g)));
  return reduced(static_cast<Half>(total) == total ? Wide{static_cast<Half>(total) / lost} : total / lost,
                 Wide{a.d_ / g} * (d / lost));
}

}  // namespace mmverify::proofs
