// Exact values of binary32 numbers: words of 184 bits that count units of 2^-149, the least positive number.
#pragma once

#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Term;

/// A number in [0, 2^31) that is a multiple of 2^-149; sums and differences in that range are exact.
/// 2^31 units of 1 are 2^180 units of 2^-149; the bits above show a negative number.
class Exact {
 public:
  static constexpr unsigned fraction_bits = 149, bits = 184;
  static std::string sort() { return proofs::induction::word_sort(bits); }

  explicit Exact(std::uint32_t k) : Exact(proofs::induction::Word<32>(k)) {}
  explicit Exact(Term t) : term(std::move(t)) {}
  template <unsigned others>
  explicit Exact(const proofs::induction::Word<others>& k)
      : term(proofs::induction::apply(
            "bvshl",
            {proofs::induction::Word<bits>(k).term, proofs::induction::Word<bits>(fraction_bits).term},
            sort())) {}
  Term term;

  friend Exact operator+(const Exact& a, const Exact& b) {
    return Exact(proofs::induction::apply("bvadd", {a.term, b.term}, sort()));
  }
  friend Exact operator-(const Exact& a, const Exact& b) {
    return Exact(proofs::induction::apply("bvsub", {a.term, b.term}, sort()));
  }
};

/// a < b, as a formula.
inline Term is_less(const Exact& a, const Exact& b) {
  return proofs::induction::apply("bvslt", {a.term, b.term}, proofs::induction::boolean);
}

/// An exact number as a Coordinate of the specification's templates, with whole parts of `word_bits` bits.
template <unsigned word_bits>
class ExactIn : public Exact {
 public:
  using Exact::Exact;
  explicit ExactIn(const Exact& e) : Exact(e) {}
  friend ExactIn operator+(const ExactIn& a, const ExactIn& b) { return ExactIn(Exact(a) + Exact(b)); }
  friend ExactIn operator-(const ExactIn& a, const ExactIn& b) { return ExactIn(Exact(a) - Exact(b)); }
  friend ExactIn times(std::uint32_t k, const ExactIn& a) {
    return ExactIn(
        proofs::induction::apply("bvmul", {proofs::induction::Word<bits>(k).term, a.term}, sort()));
  }
  friend bool operator<(const ExactIn& a, const ExactIn& b) {
    return proofs::induction::decided(is_less(a, b));
  }
  friend bool operator==(const ExactIn& a, const ExactIn& b) {
    return proofs::induction::decided(equal(a.term, b.term));
  }
  /// The floor.
  friend proofs::induction::Word<word_bits> whole(const ExactIn& a) {
    using proofs::induction::Word;
    const Word<bits> shifted(
        proofs::induction::apply("bvlshr", {a.term, Word<bits>(fraction_bits).term}, sort()));
    return Word<word_bits>(shifted);
  }
};

/// Defines the value of a finite binary32 number without a sign from its bits, by three functions:
///   significand   with its leading 1, which a subnormal number has not
///   exponent      of the last bit, above -149
///   exact         significand 2^(exponent + n), in units of 2^-149: x 2^n
/// Source: IEEE 754-2019, 3.4.
void define_binary32(proofs::induction::Script& script);

/// x 2^n in units of 2^-149, from x's bits and a byte n.
Term exact_times(const Term& x_bits, const Term& n);
/// x in units of 2^-149.
Term exactly(const Term& x_bits);

}  // namespace mmverify::proofs::index::binary32
