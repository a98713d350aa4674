// Numbers, bits and words that are names: the specification's templates run on them and leave formulas.
// Each operator writes down its own SMT-LIB counterpart and nothing else; a comparison asks `decided`.
#pragma once

#include <concepts>

#include "proofs/induction/paths.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::induction {

/// An integer without bounds.  NOT x = -x-1, as in two's complement of any width.
class Integer {
 public:
  Integer(long long k) : term(whole_number(k)) {}
  explicit Integer(Term t) : term(std::move(t)) {}
  Term term;

  friend Integer operator+(const Integer& a, const Integer& b) { return make("+", a, b); }
  friend Integer operator-(const Integer& a, const Integer& b) { return make("-", a, b); }
  friend Integer operator*(const Integer& a, const Integer& b) { return make("*", a, b); }
  /// SMT-LIB's div by a positive number rounds down.
  friend Integer operator/(const Integer& a, const Integer& b) { return make("div", a, b); }
  friend Integer operator~(const Integer& a) {
    return Integer(apply("-", {apply("-", {a.term}, integer), whole_number(1)}, integer));
  }
  friend bool operator<(const Integer& a, const Integer& b) {
    return decided(apply("<", {a.term, b.term}, boolean));
  }
  friend bool operator>(const Integer& a, const Integer& b) { return b < a; }

 private:
  static Integer make(const char* head, const Integer& a, const Integer& b) {
    return Integer(apply(head, {a.term, b.term}, integer));
  }
};

/// One itself: numbers as they are.
struct UnitOne {
  static Term times(std::uint32_t k) { return to_real(whole_number(k)); }
};

/// A real number x in units of 1/Unit: the formula is x * Unit, so that the number 1 is written `Unit`. All
/// that a Coordinate can do (order, sums, whole multiples) commutes with this scaling.
template <class Unit>
class Real {
 public:
  explicit Real(std::uint32_t k) : term(Unit::times(k)) {}
  explicit Real(const Integer& k) requires std::same_as<Unit, UnitOne> : term(to_real(k.term)) {}
  explicit Real(Term t) : term(std::move(t)) {}
  Term term;

  friend Real operator+(const Real& a, const Real& b) { return Real(apply("+", {a.term, b.term}, real)); }
  friend Real operator-(const Real& a, const Real& b) { return Real(apply("-", {a.term, b.term}, real)); }
  friend Real times(std::uint32_t k, const Real& a) {
    return Real(apply("*", {to_real(whole_number(k)), a.term}, real));
  }
  friend bool operator<(const Real& a, const Real& b) {
    return decided(apply("<", {a.term, b.term}, boolean));
  }
  friend bool operator==(const Real& a, const Real& b) { return decided(equal(a.term, b.term)); }
  /// SMT-LIB's to_int is the floor.
  friend Integer whole(const Real& a) requires std::same_as<Unit, UnitOne> {
    return Integer(apply("to_int", {a.term}, integer));
  }
};

/// A word of one bit: what a bitwise operator does at each place by itself.
class Bit {
 public:
  explicit Bit(Term t) : term(std::move(t)) {}
  Term term;

  friend Bit operator^(const Bit& a, const Bit& b) { return Bit(apply("xor", {a.term, b.term}, boolean)); }
  friend Bit operator&(const Bit& a, const Bit& b) { return Bit(apply("and", {a.term, b.term}, boolean)); }
  friend Bit operator|(const Bit& a, const Bit& b) { return Bit(apply("or", {a.term, b.term}, boolean)); }
  friend Bit operator~(const Bit& a) { return Bit(no(a.term)); }
};

/// An unsigned word of so many bits that wraps.
template <unsigned bits>
class Word {
 public:
  Word(std::uint64_t k) : term("(_ bv" + std::to_string(k) + " " + std::to_string(bits) + ")", sort()) {}
  explicit Word(Term t) : term(std::move(t)) {}
  /// Zeros above, or the low bits, as C++ converts unsigned words.
  template <unsigned others>
  explicit Word(const Word<others>& w)
      : term(apply(others < bits ? "(_ zero_extend " + std::to_string(bits - others) + ")"
                                 : "(_ extract " + std::to_string(bits - 1) + " 0)",
                   {w.term}, sort())) {}
  Term term;
  static std::string sort() { return word_sort(bits); }

  friend Word operator+(const Word& a, const Word& b) { return make("bvadd", a, b); }
  friend Word operator-(const Word& a, const Word& b) { return make("bvsub", a, b); }
  friend Word operator/(const Word& a, const Word& b) { return make("bvudiv", a, b); }
  friend Word operator&(const Word& a, const Word& b) { return make("bvand", a, b); }
  friend Word operator|(const Word& a, const Word& b) { return make("bvor", a, b); }
  friend Word operator^(const Word& a, const Word& b) { return make("bvxor", a, b); }
  friend Word operator~(const Word& a) { return Word(apply("bvnot", {a.term}, sort())); }
  friend Word operator<<(const Word& a, unsigned k) { return make("bvshl", a, Word(k)); }
  friend Word operator>>(const Word& a, unsigned k) { return make("bvlshr", a, Word(k)); }
  friend bool operator<(const Word& a, const Word& b) {
    return decided(apply("bvult", {a.term, b.term}, boolean));
  }

 private:
  static Word make(const char* head, const Word& a, const Word& b) {
    return Word(apply(head, {a.term, b.term}, sort()));
  }
};

}  // namespace mmverify::proofs::induction

template <unsigned bits>
inline constexpr unsigned mmverify::spec::index::word_bits<mmverify::proofs::induction::Word<bits>> = bits;
