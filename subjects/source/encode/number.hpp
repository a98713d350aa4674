// Floats as words: a sign, and a size in whole units of 2^unit. Operations compute the exact result and then
// round it, as IEEE 754 defines them, so the exponents of the inputs decide the widths of words.
#pragma once

#include "subjects/source/encode/words.hpp"
#include "subjects/source/program.hpp"

namespace mmverify::source {

/// IEEE 754's binary32 or binary64: `precision` is the number of bits in a significand, 2^least the least
/// number, and 2^beyond the least power of two above all finite numbers.
struct Format {
  unsigned bits;
  unsigned precision;
  int least, beyond;
  unsigned fraction_bits() const { return precision - 1; }
  unsigned exponent_bits() const { return bits - precision; }
};
Format format_of(unsigned bits);

/// The number size * 2^unit with a sign; if `infinite` or `nan` holds, size is arbitrary.
struct Number {
  Format format;
  Condition nan = "false", infinite = "false", negative = "false";
  Bits size = {};
  int unit = 0;
  std::string bits = {};  ///< the IEEE 754 bits, if they are known
};

/// Deliberate mistakes, for the tests that must find them.
enum class Mistake { none, ties_away, floor_towards_zero };

/// Arithmetic on numbers. Domain: two operands have the same format. Source: IEEE 754-2019, rounding to
/// nearest, ties to even.
class Numbers {
 public:
  explicit Numbers(Definitions& definitions, Mistake mistake = Mistake::none)
      : d(definitions), mistake_(mistake) {}

  Number of_constant(std::uint64_t bits, unsigned width);
  /// The number with the bits of a 32-bit or 64-bit word.
  Number of_bits(const Bits& word);
  /// The number with these bits, if its sign is known and its exponent field is in first..last.
  Number of_bits(const Bits& word, bool negative, unsigned first, unsigned last);
  Bits to_bits(const Number& x);

  Number sum(const Number& a, const Number& b);
  Number product(const Number& a, const Number& b);
  /// a / b for a power of two b; std::nullopt for any other divisor.
  std::optional<Number> quotient(const Number& a, const Number& b);
  Number fused(const Number& a, const Number& b, const Number& c);
  Number negative_of(Number x) const;
  Number size_of(Number x) const;
  Number with_sign_of(Number x, const Number& y);
  Number chosen(const Condition& c, const Number& a, const Number& b);
  Number lesser(const Number& a, const Number& b, bool greater);
  /// Rounds to a whole number by Op::floor, ceil, ftrunc, round, roundeven.
  Number whole(Op how, const Number& x);
  Number converted(Number x, Format to);
  /// The number of an integer word, in two's complement if `is_signed`. `most`: an upper bound on the word.
  Number of_word(const Bits& word, std::uint64_t most, bool is_signed, Format to);

  /// Compares by LLVM's predicate: 1 equal + 2 greater + 4 less + 8 unordered.
  Condition compared(unsigned predicate, const Number& a, const Number& b);

  struct Word {
    Bits word;
    Condition fits;
    std::uint64_t most;  ///< an upper bound if it fits
  };
  /// The number rounded towards zero, as a word of `bits` bits.
  Word to_word(const Number& x, unsigned bits, bool is_signed);
  Bits to_word_saturated(const Number& x, unsigned bits, bool is_signed);

 private:
  struct Aligned {
    Bits a, b;
    int unit;
  };
  /// Sizes in a common unit and width, with `spare` bits to spare.
  Aligned aligned(const Number& a, const Number& b, unsigned spare);
  Number exact_sum(const Number& a, const Number& b);
  Number exact_product(const Number& a, const Number& b);
  Number rounded(Number x);
  Bits whole_part(const Number& x);

  Definitions& d;
  Mistake mistake_;
};

}  // namespace mmverify::source
