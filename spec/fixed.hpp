// Exact fixed point: the rationals k / 2^F that a sweep visits, as integers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

namespace mmverify::spec {

// __int128 is not ISO C++, but both compilers of this project have it; __extension__ silences -Wpedantic for this line.
__extension__ typedef __int128 Int128;

/// An integer of 256 bits on the stack; overflow throws std::overflow_error.
using Int256 = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    256, 256, boost::multiprecision::signed_magnitude, boost::multiprecision::checked, void>>;

/// The number raw / 2^F.  Sums, differences and products with integers are exact as long as |raw| stays below the
/// word's limit; docs/SOUNDNESS.md ("No sum overflows") bounds every value that the index algorithms form.
template <class Word, unsigned F>
class Fixed {
 public:
  using word_type = Word;
  static constexpr unsigned fraction_bits = F;

  constexpr Fixed() = default;
  constexpr explicit Fixed(std::uint32_t k) : raw_(Word(Word(k) << F)) {}

  /// The number k / 2^bits.  Domain: bits <= F and |k| 2^(F-bits) within the word.
  static constexpr Fixed dyadic(Word k, unsigned bits) {
    return from_raw(Word(k * Word(Word(1) << (F - bits))));
  }
  static constexpr Fixed from_raw(Word raw) {
    Fixed q;
    q.raw_ = raw;
    return q;
  }
  constexpr Word raw() const { return raw_; }

  friend constexpr Fixed operator+(const Fixed& a, const Fixed& b) { return from_raw(Word(a.raw_ + b.raw_)); }
  friend constexpr Fixed operator-(const Fixed& a, const Fixed& b) { return from_raw(Word(a.raw_ - b.raw_)); }
  friend constexpr Fixed times(std::uint32_t k, const Fixed& q) {
    return from_raw(Word(static_cast<Word>(k) * q.raw_));
  }
  friend constexpr bool operator==(const Fixed& a, const Fixed& b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator<(const Fixed& a, const Fixed& b) { return a.raw_ < b.raw_; }

  /// floor(q) for 0 <= q < 2^32.
  friend constexpr std::uint32_t whole(const Fixed& q) {
    return static_cast<std::uint32_t>(Word(q.raw_ >> F));
  }

 private:
  Word raw_ = 0;
};

/// The type for every point k/(4 2^g) of the grids up to level g = 28, and every binary16 number (they end at 2^-24).
using Fixed64 = Fixed<std::int64_t, 30>;

/// The type for every binary32 number that is zero or at least 2^-76 in size (24 significant bits end at 2^-99).
using Fixed128 = Fixed<Int128, 100>;

/// The type for every finite binary32 number of size at most 2 (subnormal ones end at 2^-149).
using Fixed256 = Fixed<Int256, 150>;

}  // namespace mmverify::spec
