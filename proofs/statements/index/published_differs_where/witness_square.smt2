; Not vacuous: some squares and rests fulfil what `square` supposes, and the published code errs
; there: uf + vf < 1, not below 1 - 2^-25, and iu + iv < N-1.
; Written by the program itself from the specification's templates (./run statements); a test compares.
(set-logic ALL)
(set-info :status sat)

; IEEE 754: what 32 bits without a sign, finite, stand for, in units of 2^-149.
(define-fun significand ((x (_ BitVec 32))) (_ BitVec 184)
  ((_ zero_extend 160)
    (concat (ite (= ((_ extract 30 23) x) #x00) #b0 #b1) ((_ extract 22 0) x))))
(define-fun exponent ((x (_ BitVec 32))) (_ BitVec 8)
  (ite (= ((_ extract 30 23) x) #x00) #x00 (bvsub ((_ extract 30 23) x) #x01)))
(define-fun exact ((x (_ BitVec 32)) (n (_ BitVec 8))) (_ BitVec 184)
  (bvshl (significand x) ((_ zero_extend 176) (bvadd (exponent x) n))))
(declare-const N (_ BitVec 32))
(declare-const iu (_ BitVec 32))
(declare-const iv (_ BitVec 32))
(assert (bvule N (_ bv65536 32)))
(assert (bvule iu N))
(assert (bvule iv N))
(declare-const uf_bits (_ BitVec 32))
(declare-const vf_bits (_ BitVec 32))
(assert
  (and
    (bvult (bvand uf_bits (_ bv2147483647 32)) (_ bv1065353216 32))
    (bvule uf_bits (_ bv2147483648 32))))
(assert
  (and
    (bvult (bvand vf_bits (_ bv2147483647 32)) (_ bv1065353216 32))
    (bvule vf_bits (_ bv2147483648 32))))
(assert
  (bvslt
    (bvadd
      (exact (bvand uf_bits (_ bv2147483647 32)) (_ bv0 8))
      (exact (bvand vf_bits (_ bv2147483647 32)) (_ bv0 8)))
    (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))))
(assert
  (not
    (bvslt
      (bvadd
        (exact (bvand uf_bits (_ bv2147483647 32)) (_ bv0 8))
        (exact (bvand vf_bits (_ bv2147483647 32)) (_ bv0 8)))
      (bvsub
        (bvshl ((_ zero_extend 152) (_ bv1 32)) (_ bv149 184))
        (bvshl (_ bv1 184) (_ bv124 184))))))
(assert (bvult (bvadd (bvadd iu iv) (_ bv1 32)) N))
(check-sat)
