#include "proofs/index/binary32/exact.hpp"

namespace mmverify::proofs::index::binary32 {

using namespace proofs::induction;

void define_binary32(Script& script) {
  script.comment("IEEE 754: what 32 bits without a sign, finite, stand for, in units of 2^-149.");
  script.raw(R"((define-fun significand ((x (_ BitVec 32))) (_ BitVec 184)
  ((_ zero_extend 160)
    (concat (ite (= ((_ extract 30 23) x) #x00) #b0 #b1) ((_ extract 22 0) x))))
(define-fun exponent ((x (_ BitVec 32))) (_ BitVec 8)
  (ite (= ((_ extract 30 23) x) #x00) #x00 (bvsub ((_ extract 30 23) x) #x01)))
(define-fun exact ((x (_ BitVec 32)) (n (_ BitVec 8))) (_ BitVec 184)
  (bvshl (significand x) ((_ zero_extend 176) (bvadd (exponent x) n))))
)");
}

Term exact_times(const Term& x_bits, const Term& n) { return apply("exact", {x_bits, n}, Exact::sort()); }
Term exactly(const Term& x_bits) { return exact_times(x_bits, Word<8>(0).term); }

}  // namespace mmverify::proofs::index::binary32
