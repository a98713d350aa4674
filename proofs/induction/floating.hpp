// Binary32 numbers that are names, and the signed words that they convert to and from: code's templates run on them
// and leave formulas of SMT-LIB's floating point, every operation rounded to nearest, ties to even.
#pragma once

#include <bit>
#include <cstdint>

#include "proofs/induction/paths.hpp"

namespace mmverify::proofs::induction {

inline const std::string binary32 = "(_ FloatingPoint 8 24)";

/// A word of 32 bits in two's complement, so far as conversions go.
class SignedWord {
 public:
  explicit SignedWord(Term t) : term(std::move(t)) {}
  Term term;
};

class Binary32 {
 public:
  explicit Binary32(Term t) : term(std::move(t)) {}
  explicit Binary32(float x)
      : Binary32(
            of_bits({"(_ bv" + std::to_string(std::bit_cast<std::uint32_t>(x)) + " 32)", word_sort(32)})) {}
  explicit Binary32(const SignedWord& k) : term(apply("(_ to_fp 8 24) RNE", {k.term}, binary32)) {}
  /// C++'s conversion: towards zero.
  explicit operator SignedWord() const {
    return SignedWord(apply("(_ fp.to_sbv 32) RTZ", {term}, word_sort(32)));
  }
  /// The number of these 32 bits.
  static Binary32 of_bits(const Term& word) { return Binary32(apply("(_ to_fp 8 24)", {word}, binary32)); }
  Term term;

  friend Binary32 operator+(const Binary32& a, const Binary32& b) { return rounded("fp.add RNE", a, b); }
  friend Binary32 operator-(const Binary32& a, const Binary32& b) { return rounded("fp.sub RNE", a, b); }
  friend Binary32 operator*(const Binary32& a, const Binary32& b) { return rounded("fp.mul RNE", a, b); }
  friend bool operator<(const Binary32& a, const Binary32& b) { return asked("fp.lt", a, b); }
  friend bool operator>(const Binary32& a, const Binary32& b) { return asked("fp.gt", a, b); }
  friend bool operator<=(const Binary32& a, const Binary32& b) { return asked("fp.leq", a, b); }
  friend bool operator>=(const Binary32& a, const Binary32& b) { return asked("fp.geq", a, b); }

 private:
  static Binary32 rounded(const char* head, const Binary32& a, const Binary32& b) {
    return Binary32(apply(head, {a.term, b.term}, binary32));
  }
  static bool asked(const char* head, const Binary32& a, const Binary32& b) {
    return decided(apply(head, {a.term, b.term}, boolean));
  }
};

}  // namespace mmverify::proofs::induction
