// Floats as words: sign and size, the size a whole number of units of 2^unit.  What is rounded in IEEE 754 is first exact
// here, and then rounded, so that the exponents of the inputs decide how wide words are.
#pragma once

#include "source/encode/words.hpp"
#include "source/program.hpp"

namespace mmverify::source {

/// IEEE 754's binary32 and binary64: bits of a significand, the exponents of its last bit at the least number and of the
/// power of two that is beyond the greatest.
struct Format {
  unsigned bits;
  unsigned precision;
  int least, beyond;
  unsigned fraction_bits() const { return precision - 1; }
  unsigned exponent_bits() const { return bits - precision; }
};
Format format_of(unsigned bits);

/// size 2^unit, negative or not; where `infinite` or `nan`, of any size.
struct Number {
  Format format;
  Condition nan = "false", infinite = "false", negative = "false";
  Bits size = {};
  int unit = 0;
  std::string bits = {};  ///< the IEEE 754 bits, where they are known
};

/// Mistakes on purpose, for the tests that must find them.
enum class Mistake { none, ties_away, floor_towards_zero };

/// Arithmetic on them.  Domain: numbers of one format where there are two.  Source: IEEE 754-2019, rounding to nearest,
/// ties to even.
class Numbers {
 public:
  explicit Numbers(Definitions& definitions, Mistake mistake = Mistake::none)
      : d(definitions), mistake_(mistake) {}

  Number of_constant(std::uint64_t bits, unsigned width);
  /// Of a word of 32 or 64 bits.
  Number of_bits(const Bits& word);
  /// Of a float's bits whose exponent field is from first to last, with a sign that is known.
  Number of_bits(const Bits& word, bool negative, unsigned first, unsigned last);
  Bits to_bits(const Number& x);

  Number sum(const Number& a, const Number& b);
  Number product(const Number& a, const Number& b);
  /// By a power of two: std::nullopt, another divisor.
  std::optional<Number> quotient(const Number& a, const Number& b);
  Number fused(const Number& a, const Number& b, const Number& c);
  Number negative_of(Number x) const;
  Number size_of(Number x) const;
  Number with_sign_of(Number x, const Number& y);
  Number chosen(const Condition& c, const Number& a, const Number& b);
  Number lesser(const Number& a, const Number& b, bool greater);
  /// Op::floor, ceil, ftrunc, round, roundeven.
  Number whole(Op how, const Number& x);
  Number converted(Number x, Format to);
  /// The word of a whole number; `is_signed`: in two's complement.  `most`: no word is above.
  Number of_word(const Bits& word, std::uint64_t most, bool is_signed, Format to);

  /// LLVM's predicate: 1 equal + 2 greater + 4 less + 8 unordered.
  Condition compared(unsigned predicate, const Number& a, const Number& b);

  struct Word {
    Bits word;
    Condition fits;
    std::uint64_t most;  ///< where it fits
  };
  /// Towards zero, in so many bits.
  Word to_word(const Number& x, unsigned bits, bool is_signed);
  Bits to_word_saturated(const Number& x, unsigned bits, bool is_signed);

 private:
  struct Aligned {
    Bits a, b;
    int unit;
  };
  /// Sizes in one unit, of one width with so many bits to spare.
  Aligned aligned(const Number& a, const Number& b, unsigned spare);
  Number exact_sum(const Number& a, const Number& b);
  Number exact_product(const Number& a, const Number& b);
  Number rounded(Number x);
  Bits whole_part(const Number& x);

  Definitions& d;
  Mistake mistake_;
};

}  // namespace mmverify::source
